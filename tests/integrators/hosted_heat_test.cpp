/// The door for codes that move their own particles.

#include "integrators/host/hosted_heat.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"

namespace superstep {
namespace {

using Contact = HostedHeat::Contact;

/// A ring with some chords, seeded: n particles, each with about four contacts.
std::vector<Contact> some_contacts(std::int32_t n, std::uint64_t seed) {
  std::vector<Contact> out;
  const auto next = [&] { return seed = seed * 6364136223846793005u + 1442695040888963407u; };
  const auto part = [&] { return static_cast<double>(next() >> 11) * 0x1p-53; };
  for (std::int32_t i = 0; i < n; ++i) {
    out.push_back({i, (i + 1) % n, 0.5 + part()});
    const auto other = static_cast<std::int32_t>(part() * n);
    if (other != i) out.push_back({i, other, 0.1 * part()});
  }
  return out;
}

std::vector<double> rising(std::size_t n, double first, double last) {
  std::vector<double> out(n);
  for (std::size_t k = 0; k < n; ++k)
    out[k] = first + (last - first) * static_cast<double>(k) / static_cast<double>(n - 1);
  return out;
}

std::vector<double> copy(std::span<const double> values) {
  return {values.begin(), values.end()};
}

double largest_difference(std::span<const double> a, std::span<const double> b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
  return largest;
}

TEST(HostedHeat, ManySmallStepsOverContactsThatStandAreOneLargeStep) {
  const auto contacts = some_contacts(60, 1);
  const auto start = rising(60, 300, 400), capacity = rising(60, 1, 3);
  for (const char* spec :
       {"exponential:rtol=1e-9", "rkc:rtol=1e-9", "cvode:rtol=1e-9", "trapezoidal:rtol=1e-6"}) {
    HostedHeat many(capacity, start, spec), once(capacity, start, spec);
    for (auto* heat : {&many, &once}) {
      heat->set_contacts(contacts);
      heat->hold(0, 500);
      heat->set_sources(rising(60, 0, 1));
      heat->set_span(300);
    }
    const int steps = 16;
    for (int k = 0; k < steps; ++k) ASSERT_TRUE(many.advance_temperatures(0.25).ok());
    ASSERT_TRUE(once.advance_temperatures(0.25 * steps).ok());
    const double rtol = std::string(spec).starts_with("trapezoidal") ? 1e-6 : 1e-9;
    // Each call may err by rtol times the span in the mean square; the largest of 60 by some times that.
    EXPECT_LT(largest_difference(many.temperatures(), once.temperatures()), (steps + 1) * 4 * rtol * 300)
        << spec;
    EXPECT_EQ(many.temperatures()[0], 500) << spec;
    EXPECT_GT(largest_difference(many.temperatures(), start), 1) << spec;
  }
}

TEST(HostedHeat, AllCallsTogetherKeepTheTolerance) {
  // A host's steps are short: in each of them nothing changes by more than the tolerance.
  const auto contacts = some_contacts(60, 1);
  const auto start = rising(60, 300, 400), capacity = rising(60, 1, 3);
  HostedHeat exact(capacity, start, "exponential:rtol=1e-12");
  exact.set_contacts(contacts);
  exact.hold(0, 600);
  ASSERT_TRUE(exact.advance_temperatures(2).ok());
  for (const char* spec : {"exponential:rtol=1e-2", "rkc:rtol=1e-2", "cvode:rtol=1e-2", "rock:rtol=1e-2"})
    for (const int steps : {50, 2000}) {
      HostedHeat heat(capacity, start, spec);
      heat.set_contacts(contacts);
      heat.hold(0, 600);
      for (int k = 0; k < steps; ++k) {
        const auto outcome = heat.advance_temperatures(2.0 / steps);
        ASSERT_TRUE(outcome.ok()) << outcome.reason;
      }
      double sum = 0;
      for (std::size_t k = 0; k < start.size(); ++k)
        sum += std::pow(heat.temperatures()[k] - exact.temperatures()[k], 2);
      EXPECT_LT(std::sqrt(sum / 60), 1e-2 * 300) << spec << ", " << steps;
    }
  EXPECT_GT(largest_difference(exact.temperatures(), start), 20) << "there is something to miss";
}

TEST(HostedHeat, ASharedToleranceStaysWithinWhatTheMethodTakes) {
  // A short call after long ones may use up a small part of the tolerance: less than `auto` takes.
  const auto contacts = some_contacts(20, 1);
  const auto start = rising(20, 0, 100), capacity = rising(20, 1, 3);
  HostedHeat heat(capacity, start, "auto:rtol=1e-8"), exact(capacity, start, "exponential:rtol=1e-12");
  for (auto* one : {&heat, &exact}) {
    one->set_contacts(contacts);
    one->hold(0, 200);
  }
  double time = 0;
  for (const double dt : {0.5, 1e-5, 0.5, 1e-6}) {
    const auto outcome = heat.advance_temperatures(dt);
    ASSERT_TRUE(outcome.ok()) << outcome.reason;
    time += dt;
  }
  ASSERT_TRUE(exact.advance_temperatures(time).ok());
  // The largest of 20 by at most sqrt(20) the mean square.
  EXPECT_LT(largest_difference(heat.temperatures(), exact.temperatures()), std::sqrt(20.0) * 1e-8 * 200);
}

TEST(HostedHeat, HeatIsConservedWhileContactsComeAndGo) {
  const auto start = rising(80, 300, 700), capacity = rising(80, 1, 3);
  for (const char* spec : {"forward-euler", "sts:n=5,nu=1e-2", "rkc:rtol=1e-3", "rock:rtol=1e-3",
                           "exponential:rtol=1e-3", "cvode:rtol=1e-3", "esdirk:rtol=1e-3"}) {
    HostedHeat heat(capacity, start, spec);
    const double before = heat.heat();
    for (std::uint64_t k = 0; k < 12; ++k) {
      heat.set_contacts(some_contacts(80, k / 2));  // every other time they stand
      const auto outcome = heat.advance_temperatures(0.1);
      ASSERT_TRUE(outcome.ok()) << outcome.reason;
    }
    EXPECT_NEAR(heat.heat() / before, 1, 1e-12) << spec << ": roundings of twelve calls";
    EXPECT_GT(largest_difference(heat.temperatures(), start), 1) << spec;
  }
}

TEST(HostedHeat, WhatStandsIsPreparedOnce) {
  const auto contacts = some_contacts(60, 1);
  HostedHeat heat(std::vector(60, 2.0), rising(60, 300, 400), "cvode:rtol=1e-4,linsol=klu");
  for (int k = 0; k < 5; ++k) {
    heat.set_contacts(contacts);
    ASSERT_TRUE(heat.advance_temperatures(0.1).ok());
  }
  EXPECT_EQ(heat.stretches().preparations(), 1U);
  auto others = contacts;
  others[3].conductance *= 2;
  heat.set_contacts(others);
  ASSERT_TRUE(heat.advance_temperatures(0.1).ok());
  EXPECT_EQ(heat.stretches().preparations(), 2U) << "a conductance is another";
  ASSERT_TRUE(heat.advance_temperatures(0.2).ok());
  EXPECT_EQ(heat.stretches().preparations(), 3U) << "the step is another";
}

TEST(HostedHeat, NewConductancesInOldPlacesAreThoseOfANewNetwork) {
  const auto start = rising(60, 300, 400), capacity = rising(60, 1, 3);
  auto contacts = some_contacts(60, 1);
  contacts.push_back({7, 8, 0.25});  // twice the same pair
  contacts.push_back({0, 1, 0.25});  // and twice to one that is held
  HostedHeat kept(capacity, start, "rkc:rtol=1e-4");
  kept.hold(0, 350);
  kept.hold(30, 320);
  kept.set_contacts(contacts);
  ASSERT_TRUE(kept.advance_temperatures(0.1).ok());
  auto now = capacity;
  for (auto& contact : contacts) contact.conductance *= 1.5 + 0.01 * contact.i;
  for (auto& one : now) one *= 1.1;
  HostedHeat anew(now, kept.temperatures(), "rkc:rtol=1e-4");
  anew.hold(0, 360);
  anew.hold(30, 320);
  kept.hold(0, 360);
  kept.set_capacities(now);
  for (auto* heat : {&kept, &anew}) {
    heat->set_contacts(contacts);
    heat->set_sources(rising(60, 1, 2));
    heat->set_span(100);
    ASSERT_TRUE(heat->advance_temperatures(0.1).ok());
  }
  // They count from different zeros, so that roundings differ.
  EXPECT_LT(largest_difference(kept.temperatures(), anew.temperatures()), 1e-10);
  EXPECT_EQ(kept.temperatures()[0], 360);
}

TEST(HostedHeat, AnOrderThatIsKeptChangesNoAnswer) {
  const auto start = rising(60, 300, 400), capacity = rising(60, 1, 3);
  HostedHeat kept(capacity, start);
  kept.hold(5, 350);
  for (std::uint64_t k = 0; k < 120; ++k) {  // beyond the networks that share one
    HostedHeat anew(capacity, kept.temperatures());
    anew.hold(5, 350);
    for (auto* heat : {&kept, &anew}) {
      heat->set_span(100);
      heat->set_contacts(some_contacts(60, k));
      ASSERT_TRUE(heat->advance_temperatures(0.01).ok());
    }
    // Each may err by its tolerance, 1e-4 of 100 K; two that take the same steps differ by less.
    ASSERT_LT(largest_difference(kept.temperatures(), anew.temperatures()), 1e-2) << k;
  }
}

TEST(HostedHeat, ParticlesThatTouchNothingTakeTheirSourceExactly) {
  HostedHeat heat(std::vector{2.0, 4.0}, std::vector{10.0, 20.0}, "rkc:rtol=1e-3");
  heat.set_sources(std::vector{1.0, -1.0});
  ASSERT_TRUE(heat.advance_temperatures(2).ok());
  EXPECT_DOUBLE_EQ(heat.temperatures()[0], 11);
  EXPECT_DOUBLE_EQ(heat.temperatures()[1], 19.5);
  heat.set_contacts(std::vector<Contact>{{0, 1, 0.0}});
  ASSERT_TRUE(heat.advance_temperatures(2).ok());
  EXPECT_DOUBLE_EQ(heat.temperatures()[0], 12) << "a conductance of 0 joins nothing";
}

TEST(HostedHeat, OtherParticlesMayTakeTheirPlace) {
  HostedHeat heat(std::vector{1.0, 1.0}, std::vector{0.0, 1.0}, "exponential:rtol=1e-10");
  heat.set_contacts(std::vector<Contact>{{0, 1, 1.0}});
  ASSERT_TRUE(heat.advance_temperatures(1).ok());
  const auto before = copy(heat.temperatures());
  // A third one, far away, changes nothing for the two.
  heat.set_particles(std::vector{1.0, 1.0, 1.0}, std::vector{before[0], before[1], 5.0});
  heat.set_contacts(std::vector<Contact>{{0, 1, 1.0}});
  ASSERT_TRUE(heat.advance_temperatures(1).ok());
  EXPECT_DOUBLE_EQ(heat.temperatures()[2], 5) << "roundings of the method";
  // Two equal capacities: the difference falls as exp(-2 K t / C).
  EXPECT_NEAR(heat.temperatures()[1] - heat.temperatures()[0], std::exp(-4.0), 1e-8);
}

TEST(HostedHeat, WhoDoesNotMoveKeepsEveryBit) {
  const double odd = 300.1 + 0.7;
  HostedHeat heat(std::vector{1.0, 1.0, 1.0}, std::vector{200.3, 210.9, odd}, "forward-euler");
  heat.set_contacts(std::vector<Contact>{{0, 1, 1.0}});
  for (int k = 0; k < 10; ++k) ASSERT_TRUE(heat.advance_temperatures(0.3).ok());
  EXPECT_EQ(heat.temperatures()[2], odd);
  EXPECT_NEAR(heat.temperatures()[0], heat.temperatures()[1], 0.1);
}

TEST(HostedHeat, AMethodThatFailsLeavesTheTemperatures) {
  const auto start = rising(60, 300, 400);
  HostedHeat heat(std::vector(60, 1.0), start, "forward-euler:step=1e3");
  heat.set_contacts(some_contacts(60, 1));
  const auto outcome = heat.advance_temperatures(1e5);
  EXPECT_EQ(outcome.status, Status::unstable) << outcome.reason;
  EXPECT_EQ(copy(heat.temperatures()), start);
}

TEST(HostedHeat, BadInputIsRefusedAndChangesNothing) {
  const std::vector<double> two{1.0, 2.0};
  EXPECT_THROW(HostedHeat(two, std::vector{1.0}), InputError);
  EXPECT_THROW(HostedHeat(std::vector{1.0, 0.0}, two), InputError);
  EXPECT_THROW(HostedHeat(two, std::vector{1.0, std::nan("")}), InputError);
  EXPECT_THROW(HostedHeat(std::vector{1.0, 1e-300}, two), InputError);
  EXPECT_THROW(HostedHeat(two, std::vector{1.0, -1e300}), InputError);
  EXPECT_THROW(HostedHeat(two, two, "rkx"), UsageError);
  HostedHeat heat(two, two, "exponential:rtol=1e-10");
  heat.set_contacts(std::vector<Contact>{{0, 1, 1.0}});
  for (const Contact& wrong :
       {Contact{0, 2, 1.0}, Contact{-1, 0, 1.0}, Contact{1, 1, 1.0}, Contact{0, 1, -1.0},
        Contact{0, 1, std::nan("")}, Contact{0, 1, 1e300}, Contact{0, 1, 1e-300}})
    EXPECT_THROW(heat.set_contacts(std::vector{wrong}), InputError);
  EXPECT_THROW(heat.hold(2, 1), InputError);
  EXPECT_THROW(heat.hold(0, std::nan("")), InputError);
  EXPECT_THROW(heat.release(2), InputError);
  EXPECT_THROW(heat.set_sources(std::vector{1.0}), InputError);
  EXPECT_THROW(heat.set_span(0), InputError);
  for (const double dt : {0.0, -1.0, std::nan(""), 1e-300, 1e300})
    EXPECT_THROW((void)heat.advance_temperatures(dt), InputError);
  ASSERT_TRUE(heat.advance_temperatures(1e3).ok());
  EXPECT_NEAR(heat.temperatures()[0], 5.0 / 3, 1e-8)
      << "the one contact stands: 1 J/K at 1 K and 2 J/K at 2 K";
}

}  // namespace
}  // namespace superstep
