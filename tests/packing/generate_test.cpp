#include "packing/generate.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "packing/near_pairs.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

/// The NiAl sample in small: same sizes and density, some 900 spheres.
PackSettings small_cylinder() {
  PackSettings settings;
  settings.container.diameter = 50e-6;
  settings.container.height = 50e-6;
  settings.sizes.kind = SizeDistribution::Kind::lognormal;
  settings.sizes.median = 4e-6;
  settings.sizes.sigma = 0.5;
  settings.sizes.min = 1.5e-6;
  settings.sizes.max = 20e-6;
  settings.relative_density = 0.784;
  settings.seed = 5;
  return settings;
}

PackSettings small_box() {
  PackSettings settings;
  settings.container.shape = Container::Shape::box;
  settings.container.width = 30e-3;
  settings.container.depth = 20e-3;
  settings.container.height = 40e-3;
  settings.sizes.min = settings.sizes.max = 3e-3;
  return settings;
}

struct Packed {
  Packing packing;
  PackReport report;
};

Packed pack(const PackSettings& settings) {
  Packed out;
  out.packing = generate_packing(settings, &out.report);
  return out;
}

void expect_inside(const Packing& packing, const Container& container) {
  constexpr double rounding = 1 + 1e-9;  // centres and radii are rounded to twelve digits
  for (std::size_t k = 0; k < packing.size(); ++k) {
    const auto [x, y, z] = packing.centre[k];
    const double r = packing.radius[k];
    ASSERT_LE(container.height / 2 * -rounding, z - r - container.height / 2);
    ASSERT_LE(z + r, container.height * rounding);
    if (container.shape == Container::Shape::cylinder) {
      ASSERT_LE(std::hypot(x, y) + r, container.diameter / 2 * rounding);
    } else {
      ASSERT_LE(std::abs(x) + r, container.width / 2 * rounding);
      ASSERT_LE(std::abs(y) + r, container.depth / 2 * rounding);
    }
  }
}

void expect_none_swallowed(const Packing& packing) {
  for (const auto [first, second] : near_pairs(packing.centre, packing.radius)) {
    const auto i = static_cast<std::size_t>(first), j = static_cast<std::size_t>(second);
    ASSERT_GT(norm(packing.centre[i] - packing.centre[j]), std::abs(packing.radius[i] - packing.radius[j]));
  }
}

void expect_sound(const Packed& packed, const PackSettings& settings) {
  EXPECT_NEAR(sphere_volume(packed.packing) / (settings.relative_density * settings.container.volume()), 1.0,
              1e-6);
  EXPECT_NEAR(packed.report.relative_density / settings.relative_density, 1.0, 1e-6);
  expect_inside(packed.packing, settings.container);
  expect_none_swallowed(packed.packing);
}

std::pair<double, double> diameter_range(const Packing& packing) {
  const auto [low, high] = std::minmax_element(packing.radius.begin(), packing.radius.end());
  return {2 * *low, 2 * *high};
}

TEST(GeneratePacking, HitsDensityAndSizesInsideACylinder) {
  const auto settings = small_cylinder();
  const auto packed = pack(settings);
  expect_sound(packed, settings);
  EXPECT_EQ(packed.packing.id.back(), static_cast<std::int64_t>(packed.packing.size()) - 1);
  const auto [low, high] = diameter_range(packed.packing);
  EXPECT_NEAR(low, 1.5e-6, 1e-17);  // twelve digits: a lognormal's extremes are its cut-offs
  EXPECT_NEAR(high, 20e-6, 1e-16);
  EXPECT_LT(packed.report.largest_overlap, 1.5);
  EXPECT_GT(packed.report.relaxation_steps, 600u);
  EXPECT_LT(packed.report.imbalance, 1e-2);
}

TEST(GeneratePacking, HonoursTheCountByFittingTheMedian) {
  auto settings = small_cylinder();
  settings.count = 600;
  const auto packed = pack(settings);
  EXPECT_EQ(packed.packing.size(), 600u);
  expect_sound(packed, settings);
  const auto [low, high] = diameter_range(packed.packing);
  EXPECT_NEAR(low, 1.5e-6, 1e-15);
  EXPECT_NEAR(high, 20e-6, 1e-14);
}

TEST(GeneratePacking, KeepsDiametersBetweenTheCutOffsWhileItHitsTheDensity) {
  for (const double height : {20e-3, 25e-3, 31e-3, 40e-3})  // factors above and below one
    for (const double smallest :
         {2e-3, 3.6e-3, 3.8e-3}) {  // of narrow sizes the factor moves the ends furthest
      auto settings = small_box();
      settings.container.height = height;
      settings.sizes.min = smallest;
      settings.sizes.max = 4e-3;
      const auto packed = pack(settings);
      expect_sound(packed, settings);
      const auto [low, high] = diameter_range(packed.packing);
      EXPECT_GE(low, smallest) << height;
      EXPECT_LE(high, 4e-3) << height;
    }
}

TEST(GeneratePacking, LetsCutOffsGiveWayThatAreTooCloseTogetherForTheDensity) {
  auto settings = small_box();
  settings.sizes.max = settings.sizes.min * (1 + 1e-9);
  expect_sound(pack(settings), settings);
}

TEST(GeneratePacking, FillsABoxWithEqualSpheres) {
  const auto settings = small_box();
  const auto packed = pack(settings);
  expect_sound(packed, settings);
  const auto [low, high] = diameter_range(packed.packing);
  EXPECT_EQ(low, high);
  EXPECT_NEAR(high / 3e-3, 1.0, 2e-3);  // 1086 spheres: half a sphere's volume spread over all
}

class AnyDensity : public testing::TestWithParam<double> {};

TEST_P(AnyDensity, SurvivesASizeRatioOfTwenty) {
  auto settings = small_cylinder();
  settings.sizes.min = 1e-6;
  settings.sizes.median = 3e-6;
  settings.sizes.sigma = 0.8;
  settings.relative_density = GetParam();
  expect_sound(pack(settings), settings);
}

TEST_P(AnyDensity, SurvivesASizeRatioOfAHundred) {
  auto settings = small_cylinder();
  settings.container.diameter = settings.container.height = 70e-6;
  settings.sizes.min = 0.3e-6;
  settings.sizes.max = 30e-6;
  settings.sizes.median = 2e-6;
  settings.sizes.sigma = 1.0;
  settings.relative_density = GetParam();
  expect_sound(pack(settings), settings);
}

INSTANTIATE_TEST_SUITE_P(Densities, AnyDensity, testing::Values(0.1, 0.5, 0.64, 0.784, 0.85));

TEST(GeneratePacking, BondsLeaveNoSphereOfADensePackingAlone) {
  const auto loners = [](const Packing& packing) {
    std::vector<char> touches(packing.size(), 0);
    for (const auto [i, j] : near_pairs(packing.centre, packing.radius))
      touches[static_cast<std::size_t>(i)] = touches[static_cast<std::size_t>(j)] = 1;
    return static_cast<double>(std::count(touches.begin(), touches.end(), 0)) /
           static_cast<double>(packing.size());
  };
  auto settings = small_cylinder();
  EXPECT_EQ(loners(pack(settings).packing), 0.0);
  settings.bond_overlap = 0;
  EXPECT_GT(loners(pack(settings).packing), 5e-3);
}

TEST(GeneratePacking, SameSeedSamePackingOtherSeedOther) {
  auto settings = small_cylinder();
  const auto first = generate_packing(settings), second = generate_packing(settings);
  EXPECT_EQ(first.radius, second.radius);
  EXPECT_EQ(first.centre[7].x, second.centre[7].x);
  EXPECT_EQ(first.centre.back().z, second.centre.back().z);
  settings.seed = 6;
  EXPECT_NE(generate_packing(settings).radius, first.radius);
}

TEST(GeneratePacking, LengthsInOtherUnitsGiveTheSamePacking) {
  auto settings = small_cylinder();
  const auto packing = generate_packing(settings);
  constexpr double um = 1e-6;  // 50 * 1e-6 is not the double nearest to 50e-6
  settings.container.diameter = 50 * um;
  settings.container.height = 50 * um;
  settings.sizes.median = 4 * um;
  settings.sizes.min = 1.5 * um;
  settings.sizes.max = 20 * um;
  const auto same = generate_packing(settings);
  EXPECT_EQ(same.radius, packing.radius);
  EXPECT_EQ(same.centre.back().x, packing.centre.back().x);
}

TEST(GeneratePacking, ReportsProgressAndStopsOnRequest) {
  std::vector<double> seen;
  const auto settings = small_box();
  (void)generate_packing(settings, nullptr, [&](double done) {
    seen.push_back(done);
    return true;
  });
  EXPECT_GT(seen.size(), 20u);
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_LE(seen.back(), 1.0);
  EXPECT_THROW((void)generate_packing(settings, nullptr, [](double) { return false; }), NumericalError);
}

struct BadSettings {
  std::string name;
  void (*spoil)(PackSettings&);
  std::string says;
};

class RefusedSettings : public testing::TestWithParam<BadSettings> {};

TEST_P(RefusedSettings, NameTheRule) {
  auto settings = small_cylinder();
  GetParam().spoil(settings);
  const auto message = test::message_of<UsageError>([&] { (void)generate_packing(settings); });
  EXPECT_NE(message.find(GetParam().says), std::string::npos) << message;
}

INSTANTIATE_TEST_SUITE_P(
    Settings, RefusedSettings,
    testing::Values(
        BadSettings{"NoDensity", [](PackSettings& s) { s.relative_density = 0; },
                    "relative density is 0; it must be > 0"},
        BadSettings{"TooDense", [](PackSettings& s) { s.relative_density = 0.95; }, "at most 0.9"},
        BadSettings{"NanDensity", [](PackSettings& s) { s.relative_density = NAN; },
                    "relative density is nan"},
        BadSettings{"NoHeight", [](PackSettings& s) { s.container.height = 0; }, "container height is 0"},
        BadSettings{"InfiniteDiameter", [](PackSettings& s) { s.container.diameter = INFINITY; },
                    "container diameter is inf"},
        BadSettings{"BoxWithoutWidth", [](PackSettings& s) { s.container.shape = Container::Shape::box; },
                    "container width"},
        BadSettings{"HugeDiameter", [](PackSettings& s) { s.container.diameter = 1e300; }, "to 1e9 m"},
        BadSettings{"TinySpheres", [](PackSettings& s) { s.sizes.min = 1e-300; }, "from 1e-15"},
        BadSettings{"NoSigma", [](PackSettings& s) { s.sizes.sigma = 0; }, "sigma is 0"},
        BadSettings{"NarrowSigma", [](PackSettings& s) { s.sizes.sigma = 1e-300; }, "from 1e-3"},
        BadSettings{"WideSigma", [](PackSettings& s) { s.sizes.sigma = 1e300; }, "to 10"},
        BadSettings{"CutOffsSwapped", [](PackSettings& s) { s.sizes.max = 1e-6; },
                    "it must exceed the smallest"},
        BadSettings{"MedianOutside", [](PackSettings& s) { s.sizes.median = 1e-6; }, "between the cut-offs"},
        BadSettings{"TooLarge", [](PackSettings& s) { s.sizes.max = 60e-6; }, "must fit into the container"},
        BadSettings{"TooFew",
                    [](PackSettings& s) {
                      s.sizes.kind = SizeDistribution::Kind::uniform, s.sizes.min = s.sizes.max = 45e-6;
                    },
                    "2 spheres of these sizes miss the relative density 0.784"},
        BadSettings{"TooMany",
                    [](PackSettings& s) { s.sizes.min = 1e-9, s.sizes.median = 2e-9, s.sizes.max = 3e-9; },
                    "spheres; at most"},
        BadSettings{"CountOfUniform",
                    [](PackSettings& s) { s.sizes.kind = SizeDistribution::Kind::uniform, s.count = 5; },
                    "lognormal sizes only"},
        BadSettings{"CountOutOfReach", [](PackSettings& s) { s.count = 3; }, "change the count"},
        BadSettings{"EmptyList", [](PackSettings& s) { s.sizes.kind = SizeDistribution::Kind::list; },
                    "list of diameters is empty"},
        BadSettings{"BondTooDeep", [](PackSettings& s) { s.bond_overlap = 0.8; }, "bond overlap is 0.8"}),
    [](const auto& bad) { return bad.param.name; });

}  // namespace
}  // namespace superstep
