#include "packing/relaxation/seat_loners.hpp"

#include <gtest/gtest.h>

namespace superstep {
namespace {

/// A row of touching spheres of radius 1 along x, as many as asked for, then the given ones.
struct Row {
  std::vector<double> radii;
  std::vector<Vec3> centres;

  Row(int touching, const std::vector<std::pair<Vec3, double>>& others) {
    for (int k = 0; k < touching; ++k) add({1.9 * k, 0, 5}, 1.0);
    for (const auto& [centre, radius] : others) add(centre, radius);
  }
  void add(Vec3 centre, double radius) {
    centres.push_back(centre);
    radii.push_back(radius);
  }
  double gap(std::size_t i, std::size_t j) const {
    return norm(centres[i] - centres[j]) - radii[i] - radii[j];
  }
};

Container wide_box() {
  return {.shape = Container::Shape::box, .width = 1000, .depth = 100, .height = 10};
}

TEST(SeatLoners, MovesALonerToItsNearestNeighbour) {
  Row row(40, {{{0, 0, 7}, 0.5}});  // gap 0.5
  seat_loners(wide_box(), 0.04, row.radii, row.centres);
  EXPECT_NEAR(row.gap(0, 40), -0.02, 1e-12);
  EXPECT_EQ(row.centres[40].x, 0.0);
}

TEST(SeatLoners, TwoLonersBothReachTheRow) {
  Row row(40, {{{0, 0, 7}, 0.5}, {{0, 0, 8.5}, 0.5}});  // the second finds the first, seated by then
  seat_loners(wide_box(), 0.04, row.radii, row.centres);
  EXPECT_NEAR(row.gap(0, 40), -0.02, 1e-12);
  EXPECT_NEAR(row.gap(40, 41), -0.02, 1e-12);
}

TEST(SeatLoners, LeavesWhatIsTooFarAndWhatTouches) {
  Row row(40, {{{0, 30, 5}, 0.5}});
  const auto before = row.centres;
  seat_loners(wide_box(), 0.04, row.radii, row.centres);
  for (std::size_t k = 0; k < before.size(); ++k) EXPECT_EQ(norm(row.centres[k] - before[k]), 0.0);
}

TEST(SeatLoners, LeavesALoosePackingAlone) {
  Row row(10, {{{0, 0, 7}, 0.5}});  // one in eleven
  seat_loners(wide_box(), 0.04, row.radii, row.centres);
  EXPECT_EQ(row.centres[10].z, 7.0);
}

}  // namespace
}  // namespace superstep
