/// Contacts across the sides of a periodic cell, and what a periodic packing conducts.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <tuple>

#include "contact/conductance.hpp"
#include "contact/neck.hpp"
#include "contact/search.hpp"
#include "core/error.hpp"
#include "network/cell_problem.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

Packing random_packing(std::size_t count, const Cell& cell, unsigned seed, double small, double large) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> part(0, 1);
  Packing packing;
  packing.cell = cell;
  for (std::size_t k = 0; packing.size() < count && k < 1000 * count; ++k) {
    const Vec3 centre = cell.wrapped(cell.point({part(random), part(random), part(random)}));
    const double radius = small + (large - small) * part(random);
    bool fits = true;
    for (std::size_t j = 0; j < packing.size() && fits; ++j)  // no sphere swallows another
      for (int a = -1; a <= 1; ++a)
        for (int b = -1; b <= 1; ++b)
          for (int c = -1; c <= 1; ++c)
            fits = fits &&
                   norm(packing.centre[j] + cell.shift({a, b, c}) - centre) >
                       0.8 * std::max(packing.radius[j], radius) + 0.3 * std::min(packing.radius[j], radius);
    if (!fits) continue;
    packing.id.push_back(static_cast<std::int64_t>(packing.size()));
    packing.centre.push_back(centre);
    packing.radius.push_back(radius);
    packing.material.push_back(0);
  }
  return packing;
}

using Touch = std::tuple<std::int32_t, std::int32_t, std::array<std::int8_t, 3>>;

/// Every pair with every image: the slow way.
std::set<Touch> slow_contacts(const Packing& packing, double gap, int images, bool own_images) {
  std::set<Touch> out;
  const Cell& cell = *packing.cell;
  for (std::size_t i = 0; i < packing.size(); ++i)
    for (std::size_t j = i; j < packing.size(); ++j)
      for (int a = -images; a <= images; ++a)
        for (int b = -images; b <= images; ++b)
          for (int c = -images; c <= images; ++c) {
            if ((a != 0 && !cell.periodic[0]) || (b != 0 && !cell.periodic[1]) ||
                (c != 0 && !cell.periodic[2]))
              continue;
            const std::array<std::int8_t, 3> image = {
                static_cast<std::int8_t>(a), static_cast<std::int8_t>(b), static_cast<std::int8_t>(c)};
            if (i == j && (!own_images || !(image > std::array<std::int8_t, 3>{}))) continue;
            const double distance = norm(packing.centre[j] + cell.shift({a, b, c}) - packing.centre[i]);
            if (packing.radius[i] + packing.radius[j] - distance > -gap)
              out.insert({static_cast<std::int32_t>(i), static_cast<std::int32_t>(j), image});
          }
  return out;
}

Cell tilted_cell(double size) {
  return {
      .origin = {-1, 2, 0.5},
      .edge = {Vec3{size, 0, 0}, Vec3{0.4 * size, 0.9 * size, 0}, Vec3{-0.3 * size, 0.2 * size, 1.1 * size}},
      .periodic = {true, true, true}};
}

TEST(PeriodicContacts, AreThoseOfAllImages) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    Cell cell = seed % 2 == 0 ? tilted_cell(4.0) : box_cell({0, 0, 0}, {4, 5, 6});
    cell.periodic = {seed % 3 != 0, seed % 4 != 1, true};
    const auto packing = random_packing(40, cell, seed, 0.2, 0.9);
    for (const bool own_images : {false, true}) {
      const double gap = seed % 5 == 0 ? 0.3 : 0.0;
      const auto fast = find_contacts(packing, gap, own_images);
      std::set<Touch> found;
      for (std::size_t k = 0; k < fast.size(); ++k) found.insert({fast.i[k], fast.j[k], fast.image[k]});
      EXPECT_EQ(found.size(), fast.size()) << "no contact twice";
      EXPECT_EQ(found, slow_contacts(packing, gap, 3, own_images)) << "seed " << seed;
    }
  }
}

TEST(PeriodicContacts, OneSphereTouchesItselfAndTwoTouchTwice) {
  Packing one;
  one.id = {0};
  one.centre = {{0.5, 0.5, 0.5}};
  one.radius = {0.6};
  one.material = {0};
  one.cell = box_cell({0, 0, 0}, {1, 1, 1});
  one.cell->periodic = {true, true, true};
  EXPECT_EQ(find_contacts(one).size(), 0u) << "it exchanges nothing with itself";
  EXPECT_EQ(find_contacts(one, 0, true).size(), 3u) << "one along each axis";
  Packing two = one;
  two.id = {0, 1};
  two.centre.push_back({0.5, 0.5, 1.5});
  two.radius.push_back(0.6);
  two.material.push_back(0);
  two.cell = box_cell({0, 0, 0}, {3, 3, 2});
  two.cell->periodic = {true, true, true};
  EXPECT_EQ(find_contacts(two).size(), 2u) << "inside and across the side";
}

TEST(PeriodicContacts, ACellThinnerThanASphereIsRefused) {
  Packing packing;
  packing.id = {0};
  packing.centre = {{0, 0, 0}};
  packing.radius = {1};
  packing.material = {0};
  packing.cell = box_cell({0, 0, 0}, {1e-3, 10, 10});
  packing.cell->periodic = {true, false, false};
  EXPECT_NE(test::message_of<InputError>([&] { (void)find_contacts(packing); }).find("too thin"),
            std::string::npos);
}

ConductivityTensor conductivity_of(const Packing& packing) {
  auto contacts = find_contacts(packing, 0, true);
  (void)apply_neck_law(packing, *find_neck_law("hertz"), {}, contacts);
  std::vector<double> conductance;
  for (const double neck : contacts.neck_radius) conductance.push_back(series_conductance(2.0, 2.0, neck));
  return periodic_conductivity(packing, contacts, conductance);
}

/// The packing and its images in a cell of twice the edges.
Packing copied(const Packing& packing) {
  Packing out;
  out.cell = packing.cell;
  for (auto& edge : out.cell->edge) edge = 2.0 * edge;
  for (int a = 0; a < 2; ++a)
    for (int b = 0; b < 2; ++b)
      for (int c = 0; c < 2; ++c)
        for (std::size_t k = 0; k < packing.size(); ++k) {
          out.id.push_back(static_cast<std::int64_t>(out.size()));
          out.centre.push_back(out.cell->wrapped(packing.centre[k] + packing.cell->shift({a, b, c})));
          out.radius.push_back(packing.radius[k]);
          out.material.push_back(0);
        }
  return out;
}

TEST(PeriodicConductivity, EqualsThatOfTwoByTwoByTwoCopies) {
  for (const auto& cell : {tilted_cell(3.0), [] {
                             Cell box = box_cell({0, 0, 0}, {3, 2.5, 3.5});
                             box.periodic = {true, true, true};
                             return box;
                           }()}) {
    const auto packing = random_packing(60, cell, 7, 0.3, 0.5);
    ASSERT_GT(packing.size(), 30u);
    const auto one = conductivity_of(packing), many = conductivity_of(copied(packing));
    double largest = 0;
    for (const auto& row : one)
      for (const double value : row) largest = std::max(largest, std::abs(value));
    ASSERT_GT(largest, 0.1) << "it percolates";
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b) {
        // A direct solver leaves some 1e-13; the copy's other solutions are shifted by constants alone.
        EXPECT_NEAR(one[a][b], many[a][b], 1e-10 * largest) << a << b;
        EXPECT_NEAR(one[a][b], one[b][a], 1e-10 * largest) << "it is symmetric";
      }
  }
}

TEST(PeriodicConductivity, IsZeroAlongAxesThatNoContactsLeadThrough) {
  // A ring of three spheres and a column that touches its own image above: z alone leads on.
  Packing packing;
  packing.centre = {{1, 1, 1}, {1.9, 1, 1.3}, {1.4, 1.8, 1}, {6, 6, 1}, {6, 6, 2.9}, {6.3, 6, 4.6}};
  packing.id = {0, 1, 2, 3, 4, 5};
  packing.radius = {0.5, 0.5, 0.5, 1, 1, 1.2};
  packing.material.assign(6, 0);
  packing.cell = box_cell({0, 0, 0}, {9, 9, 5.5});
  packing.cell->periodic = {true, true, true};
  const auto tensor = conductivity_of(packing);
  EXPECT_GT(tensor[2][2], 0);
  for (std::size_t a = 0; a < 3; ++a)
    for (std::size_t b = 0; b < 3; ++b) EXPECT_EQ(a == 2 && b == 2 ? 0 : tensor[a][b], 0) << a << b;
}

TEST(PeriodicConductivity, OfACubicLatticeIsConductanceOverSpacing) {
  // One sphere in a unit cell: a contact with its own image along each axis, of conductance K, gives K / 1 m.
  Packing one;
  one.id = {0};
  one.centre = {{0.2, 0.7, 0.1}};
  one.radius = {0.55};
  one.material = {0};
  one.cell = box_cell({0, 0, 0}, {1, 1, 1});
  one.cell->periodic = {true, true, true};
  const double neck = find_neck_law("hertz")->radius(0.55, 0.55, 0.1, {});
  const auto tensor = conductivity_of(one);
  for (std::size_t a = 0; a < 3; ++a) EXPECT_NEAR(tensor[a][a], series_conductance(2, 2, neck), 1e-12);
}

}  // namespace
}  // namespace superstep
