#include "contact/neck.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "contact/search.hpp"
#include "core/error.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

double neck(const std::string& name, double r_i, double r_j, double overlap,
            const NeckParameters& parameters = {}) {
  return find_neck_law(name)->radius(r_i, r_j, overlap, parameters);
}

TEST(NeckLaws, AreFoundByNameAndDescribeThemselves) {
  EXPECT_FALSE(neck_laws().empty());
  for (const auto& law : neck_laws()) {
    EXPECT_EQ(find_neck_law(law.name), &law);
    EXPECT_FALSE(law.formula.empty());
    EXPECT_FALSE(law.source.empty());
  }
  EXPECT_EQ(find_neck_law("glue"), nullptr);
  EXPECT_EQ(find_neck_law("plastic")->parameters, std::vector<std::string>{"hardening"});
}

TEST(NeckLaws, GiveHandComputedValues) {
  // r_eff = 2*2*6/8 = 3
  EXPECT_DOUBLE_EQ(neck("hertz", 2, 6, 0.06), 0.3);
  EXPECT_DOUBLE_EQ(neck("coble", 2, 6, 0.06), 0.6);
  EXPECT_DOUBLE_EQ(neck("plastic", 2, 6, 0.12, {.hardening = 1.0}), 0.6);
  EXPECT_DOUBLE_EQ(neck("plastic", 2, 6, 0.06), std::sqrt(1.45 * 0.18));
  // Radii 3 and 4 at distance 5: a right angle between them, the circle at height 12/5.
  EXPECT_DOUBLE_EQ(neck("geometric", 3, 4, 2), 2.4);
}

TEST(NeckLaws, DoNotCareWhichSphereComesFirst) {
  for (const auto& law : neck_laws())
    for (const double overlap : {1e-12, 1e-3, 0.5, 1.0})
      EXPECT_NEAR(law.radius(1, 7, overlap, {}) / law.radius(7, 1, overlap, {}), 1.0, 1e-12) << law.name;
}

TEST(GeometricNeck, KeepsItsDigitsForTheSmallestOverlaps) {
  // h << r: a^2 = r_eff h; the textbook form of eq. 12 has lost every digit here.
  EXPECT_NEAR(neck("geometric", 1, 3, 1e-15) / std::sqrt(1.5e-15), 1.0, 1e-9);
}

TEST(VolumePreservingNeck, MatchesTheCheckValuesForEqualSpheres) {
  // Printed with five digits.
  EXPECT_NEAR(neck("volume-preserving", 1, 1, 0.01), 0.14119, 1e-5);
  EXPECT_NEAR(neck("volume-preserving", 1, 1, 0.1), 0.43963, 1e-5);
  EXPECT_NEAR(neck("volume-preserving", 1, 1, 0.3), 0.73355, 1e-5);
  EXPECT_NEAR(neck("volume-preserving", 1, 1, 0.5), 0.90681, 1e-5);
}

TEST(VolumePreservingNeck, MatchesTheClosedFormForEqualSpheres) {
  for (const double h : {1e-3, 0.05, 0.2, 0.4, 0.6}) {
    const double p = 1 - 1.5 * h, c = (p + std::sqrt(p * (p + 8))) / 4;
    EXPECT_NEAR(neck("volume-preserving", 1, 1, h) / std::sqrt(1 - c * c), 1.0, 1e-11)
        << h;  // 1 - c^2 cancels
  }
}

/// Volume of two spheres whose caps beyond the neck's rim are cut off, plus the cylinder between the cuts,
/// by the midpoint rule along the axis.
double joined_volume(double r_i, double r_j, double overlap, double a) {
  const double z_i = std::sqrt(r_i * r_i - a * a), z_j = std::sqrt(r_j * r_j - a * a);
  const auto truncated = [](double r, double z) {
    constexpr int slices = 200'000;
    const double step = (r + z) / slices;
    double sum = 0;
    for (int k = 0; k < slices; ++k) {
      const double x = -r + (k + 0.5) * step;
      sum += std::numbers::pi * (r * r - x * x) * step;
    }
    return sum;
  };
  const double length = r_i + r_j - overlap - z_i - z_j;
  return truncated(r_i, z_i) + truncated(r_j, z_j) + std::numbers::pi * a * a * length;
}

TEST(VolumePreservingNeck, ConservesTheVolumeOfUnequalSpheres) {
  for (const double ratio : {1.0, 2.5, 20.0})
    for (const double h : {0.02, 0.1, 0.3}) {  // a small sphere on a plane saturates at 1/3
      const double before = 4.0 / 3.0 * std::numbers::pi * (1 + ratio * ratio * ratio);
      const double after = joined_volume(1, ratio, h, neck("volume-preserving", 1, ratio, h));
      // Relative to the small sphere; the quadrature's own error is of the order 1e-10 of the large one.
      EXPECT_NEAR((after - before) / (4.0 / 3.0 * std::numbers::pi), 0.0, 1e-6) << ratio << ' ' << h;
    }
}

TEST(VolumePreservingNeck, TendsToCobleAndStaysJustBelow) {
  for (const double ratio : {1.0, 10.0, 100.0}) {
    EXPECT_NEAR(neck("volume-preserving", 1, ratio, 1e-15) / neck("coble", 1, ratio, 1e-15), 1.0, 1e-12);
    for (double h = 1e-12; h < 0.6; h *= 3) {
      const double quotient = neck("volume-preserving", 1, ratio, h) / neck("coble", 1, ratio, h);
      EXPECT_LE(quotient, 1.0 + 1e-15) << ratio << ' ' << h;
      EXPECT_GE(quotient, std::sqrt(0.75) - 1e-12) << ratio << ' ' << h;
    }
  }
}

TEST(VolumePreservingNeck, GrowsWithTheOverlapUpToTheSmallerRadius) {
  for (const double ratio : {1.0, 3.0, 100.0}) {
    double last = 0;
    for (double h = 0.01; h < 1.5; h += 0.01) {
      const double a = neck("volume-preserving", 1, ratio, h);
      EXPECT_GE(a, last);
      EXPECT_LE(a, 1.0);
      last = a;
    }
    EXPECT_EQ(last, 1.0);
  }
}

Packing row_of_spheres(const std::vector<double>& radii, double overlap) {
  Packing packing;
  double x = 0;
  for (std::size_t k = 0; k < radii.size(); ++k) {
    if (k > 0) x += radii[k - 1] + radii[k] - overlap;
    packing.id.push_back(static_cast<std::int64_t>(10 * k));
    packing.centre.push_back({x, 0, 0});
    packing.radius.push_back(radii[k]);
    packing.material.push_back(0);
  }
  return packing;
}

TEST(ApplyNeckLaw, LimitsAndCounts) {
  // Volume-preserving necks saturate at 2/3 of the radius between equal spheres, at 0.464 between radii 1
  // and 2.
  const auto packing = row_of_spheres({1, 1, 2, 2}, 0.6);
  auto contacts = find_contacts(packing);
  ASSERT_EQ(contacts.size(), 3u);
  auto report = apply_neck_law(packing, *find_neck_law("coble"), {}, contacts);
  EXPECT_EQ(report.limited, 2u);    // 1-1 and 1-2, where r_eff = 4/3 makes sqrt(1.6); not 2-2: sqrt(2.4) < 2
  EXPECT_EQ(report.saturated, 1u);  // 1-2, whatever the law
  EXPECT_EQ(contacts.neck_radius[0], 1.0);
  EXPECT_DOUBLE_EQ(contacts.neck_radius[2], std::sqrt(2.4));

  const auto deep = row_of_spheres({1, 1}, 0.7);
  contacts = find_contacts(deep);
  report = apply_neck_law(deep, *find_neck_law("volume-preserving"), {}, contacts);
  EXPECT_EQ(report.limited, 1u);
  EXPECT_EQ(report.saturated, 1u);
  EXPECT_EQ(contacts.neck_radius[0], 1.0);
}

TEST(ApplyNeckLaw, RefusesAContactAcrossAGap) {
  const auto packing = row_of_spheres({1, 1}, -0.25);
  auto contacts = find_contacts(packing, 0.5);
  const auto message = test::message_of<InputError>(
      [&] { (void)apply_neck_law(packing, *find_neck_law("hertz"), {}, contacts); });
  EXPECT_NE(message.find("contact 0-10: overlap is -0.25 m"), std::string::npos) << message;
  EXPECT_NE(message.find("contact file"), std::string::npos) << message;
}

}  // namespace
}  // namespace superstep
