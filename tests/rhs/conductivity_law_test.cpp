/// Laws of conductivity inside and outside their range.

#include "rhs/conductivity_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "support/thermoelectric.hpp"

namespace superstep {
namespace {

using Kind = ConductivityLaw::Kind;
using Outside = ConductivityLaw::Outside;
using test::Thermoelectric;

/// 50 at 300 K, 0 at 800 K.
ConductivityLaw falling() {
  return {.kind = Kind::linear, .value = 50, .coefficient = -2e-3, .reference = 300};
}
/// 2 at 300 K, 0 at 50 K.
ConductivityLaw rising() {
  return {.kind = Kind::linear, .value = 2, .coefficient = 4e-3, .reference = 300};
}
ConductivityLaw sampled() {
  ConductivityLaw law{.kind = Kind::table, .value = 4};
  law.temperatures = {300, 400, 800};
  law.values = {4, 3, 1};
  return law;
}
ConductivityLaw sigmoid() {
  return {.kind = Kind::sigmoid, .value = 2, .reference = 400, .amplitude = -0.999, .steepness = 0.1};
}
ConductivityLaw clamped(ConductivityLaw law) {
  law.outside = Outside::clamp;
  return law;
}

TEST(ConductivityLaw, KnowsItsRange) {
  EXPECT_TRUE(falling().covers(799.9));
  EXPECT_FALSE(falling().covers(800));  // nothing conducts there
  EXPECT_FALSE(falling().covers(1000));
  EXPECT_TRUE(falling().covers(-1e6));
  EXPECT_TRUE(rising().covers(50.1));
  EXPECT_FALSE(rising().covers(50));
  EXPECT_TRUE(sampled().covers(300));
  EXPECT_TRUE(sampled().covers(800));
  EXPECT_FALSE(sampled().covers(std::nextafter(300.0, 0.0)));
  EXPECT_FALSE(sampled().covers(std::nextafter(800.0, 1e3)));
  for (const double t : {-1e6, 0.0, 400.0, 1e6}) EXPECT_TRUE(sigmoid().covers(t)) << t;
  // A state that is not a number has another fault than its law.
  for (const auto& law : {falling(), sampled(), sigmoid()}) EXPECT_TRUE(law.covers(std::nan("")));
}

TEST(ConductivityLaw, IsLimitedOnlyWhereSomethingIsAnError) {
  EXPECT_TRUE(falling().limited());
  EXPECT_TRUE(sampled().limited());
  EXPECT_FALSE(clamped(falling()).limited());
  EXPECT_FALSE(clamped(sampled()).limited());
  EXPECT_FALSE(sigmoid().limited());
  EXPECT_FALSE(ConductivityLaw{.value = 1}.limited());
}

TEST(ConductivityLaw, GivesPositiveFiniteValuesFarOutside) {
  for (const auto& law :
       {falling(), rising(), sampled(), sigmoid(), clamped(falling()), clamped(rising()), clamped(sampled())})
    for (const double t : {-1e9, -300.0, 0.0, 50.0, 300.0, 799.9, 800.0, 801.0, 1e9}) {
      EXPECT_GT(law.at(t), 0) << t;
      EXPECT_TRUE(std::isfinite(law.at(t))) << t;
      EXPECT_TRUE(std::isfinite(law.slope(t))) << t;
    }
}

TEST(ConductivityLaw, ALineGoesOnToItsZeroUnlessItIsClamped) {
  EXPECT_NEAR(falling().at(799.9), 50 * 2e-4, 1e-12);  // rounding of 1 - 0.9998, times 50
  EXPECT_EQ(falling().slope(799.9), 50 * -2e-3);
  EXPECT_LT(falling().at(801), 1e-9);
  EXPECT_EQ(falling().slope(801), 0);
  EXPECT_EQ(clamped(falling()).at(799.9), 0.5);
  EXPECT_EQ(clamped(falling()).slope(799.9), 0);
  EXPECT_EQ(clamped(falling()).at(500), falling().at(500));
}

TEST(ConductivityLaw, ATableHoldsItsEndValues) {
  EXPECT_EQ(sampled().at(0), 4);
  EXPECT_EQ(sampled().at(350), 3.5);
  EXPECT_EQ(sampled().at(900), 1);
}

TEST(ConductivityLaw, ExplainsWhereItEndsAndTheWayOut) {
  ConductivityLaw law = falling();
  law.place = "case.toml:9: key 'thermal.conductivity'";
  const auto line = law.explain("the temperature of node 3 has reached", 812.5);
  for (const char* part :
       {"case.toml:9: key 'thermal.conductivity': the temperature of node 3 has reached 812.5 K",
        "below 800 K", "outside = \"clamp\""})
    EXPECT_NE(line.find(part), std::string::npos) << line;
  EXPECT_NE(rising().explain("it is", 20).find("above 50 K"), std::string::npos);
  EXPECT_NE(sampled().explain("it is", 20).find("from 300 K to 800 K"), std::string::npos);
}

/// Scenes of six nodes at 500 K; materials take turns, the even nodes have the first law.
Thermoelectric scene(const ConductivityLaw& thermal, const ConductivityLaw& electric) {
  return {.nodes = 6, .thermal = {thermal, {.value = 1}}, .electric = {electric, {.value = 1}}};
}

TEST(LawViolation, NamesTheNodeWhoseLawEnds) {
  const auto rhs = scene(falling(), sampled()).build();
  std::vector<double> y(rhs->size(), 500.0);
  EXPECT_EQ(rhs->law_violation(y), std::nullopt);
  const auto& temperature = rhs->fields().back();
  for (std::size_t row = 0; row < temperature.count; ++row) {
    // The graph is not renumbered evenly: which rows have which law shows by trying each.
    auto hot = y;
    hot[temperature.offset + row] = 801;
    const auto said = rhs->law_violation(hot);
    auto cold = y;
    cold[temperature.offset + row] = 290;  // below the table of the other field's law
    const auto said_cold = rhs->law_violation(cold);
    ASSERT_EQ(said.has_value(), said_cold.has_value());
    if (!said) continue;
    EXPECT_NE(said->find("has reached 801 K"), std::string::npos) << *said;
    EXPECT_NE(said->find("below 800 K"), std::string::npos) << *said;
    EXPECT_NE(said_cold->find("from 300 K to 800 K"), std::string::npos) << *said_cold;
  }
}

TEST(LawViolation, LeavesRoomForTheErrorOfAMethodAtTheEndsOfATable) {
  const auto rhs = scene(sampled(), {.value = 1}).build();
  const auto complains = [&](double temperature) {
    return rhs->law_violation(std::vector<double>(rhs->size(), temperature)).has_value();
  };
  EXPECT_FALSE(complains(296));  // the table is 500 K wide
  EXPECT_FALSE(complains(804));
  EXPECT_TRUE(complains(294));
  EXPECT_TRUE(complains(806));
}

TEST(LawViolation, CountsOnlyNodesOfTheMaterial) {
  const auto rhs = scene(falling(), {.value = 1}).build();
  std::size_t limited = 0;
  const auto& temperature = rhs->fields().back();
  for (std::size_t row = 0; row < temperature.count; ++row) {
    std::vector<double> y(rhs->size(), 500.0);
    y[temperature.offset + row] = 900;
    limited += rhs->law_violation(y).has_value();
  }
  EXPECT_EQ(limited, 3U);
}

/// One look at all temperatures tells that nothing is wrong only where every law holds.
TEST(LawViolation, AsksEachNodeForItsOwnLaw) {
  const auto rhs = Thermoelectric{.nodes = 6, .thermal = {falling(), rising()}}.build();
  const auto& temperature = rhs->fields().back();
  const auto limited = [&](double value) {
    std::size_t count = 0;
    for (std::size_t row = 0; row < temperature.count; ++row) {
      std::vector<double> y(rhs->size(), 500.0);
      y[temperature.offset + row] = value;
      count += rhs->law_violation(y).has_value();
    }
    return count;
  };
  EXPECT_EQ(limited(50.1), 0U);
  EXPECT_EQ(limited(49.9), 3U);  // those that rise from 50 K on
  EXPECT_EQ(limited(799.9), 0U);
  EXPECT_EQ(limited(800.1), 3U);  // those that fall to nothing at 800 K
  EXPECT_EQ(limited(std::nan("")), 0U);
}

TEST(LawViolation, IsNothingWhereNoLawIsLimited) {
  for (const auto& settings : {scene(clamped(falling()), sigmoid()), scene({.value = 1}, clamped(sampled())),
                               scene({.value = 1}, {.value = 1})}) {
    const auto rhs = settings.build();
    EXPECT_EQ(rhs->law_violation(std::vector<double>(rhs->size(), 1e6)), std::nullopt);
  }
}

TEST(LawViolation, TrialStatesBeyondALawStillHaveAFiniteDerivative) {
  for (const auto mean : {ConductanceMean::harmonic, ConductanceMean::arithmetic}) {
    auto settings = scene(falling(), sampled());
    settings.mean = mean;
    const auto rhs = settings.build();
    std::vector<double> y(rhs->size(), 900.0), rate(rhs->size());
    for (std::size_t i = 0; i < y.size(); i += 2) y[i] = 700;
    (*rhs)(0, y, rate);
    std::vector<double> jacobian(rhs->pattern().row.size());
    rhs->jacobian(0, y, jacobian);
    for (const double value : rate) EXPECT_TRUE(std::isfinite(value));
    for (const double value : jacobian) EXPECT_TRUE(std::isfinite(value));
    EXPECT_TRUE(std::isfinite(rhs->spectral_bound(0, y)));
  }
}

}  // namespace
}  // namespace superstep
