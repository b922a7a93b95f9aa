#include "dynamics/contacts/contact_points.hpp"

#include <algorithm>
#include <cmath>

#include "core/index.hpp"
#include "core/parallel.hpp"

namespace superstep::dynamics {
namespace {

/// Whether somebody has moved by more than `limit` [m] since. NaN has not: its force tells.
bool moved(std::span<const Vec3> position, std::span<const Vec3> since, double limit) {
  double farthest = 0;
  for (std::size_t i = 0; i < position.size(); ++i) {
    const Vec3 way = position[i] - since[i];
    farthest = std::max(farthest, dot(way, way));
  }
  return farthest > limit * limit;
}

template <class Pair>
bool before(const Pair& a, std::int32_t i, std::int32_t j) noexcept {
  return a.i < i || (a.i == i && a.j < j);
}

}  // namespace

ContactPoints::ContactPoints(const BondLaw& law, double skin, const Particles& particles, double conductivity)
    : law_(law),
      kind_(bond_kind(law.rule)),
      particles_(particles),
      conductivity_(conductivity),
      table_skin_(skin / 8),
      list_(skin) {}

void ContactPoints::place(std::span<const Vec3> position) {
  const bool listed = list_.update(position, particles_.radius);
  if (listed || picked_.empty() || moved(position, picked_, 0.5 * table_skin_)) pick(position);
  points_stand_ = false;
  for_ranges(table_.size(), table_.size() / 4,
             [&](std::size_t first, std::size_t last) { place_pairs(table_, position, first, last); });
}

/// The table from the list and the bonds, all of them sorted by (i, j).
void ContactPoints::pick(std::span<const Vec3> position) {
  const auto& radius = particles_.radius;
  const auto& mass = particles_.mass;
  const auto pairs = list_.pairs();
  table_.resize(pairs.size() + bonds_.size());
  std::size_t k = 0;
  const auto put = [&](std::int32_t i, std::int32_t j) {
    const double r_i = radius[at(i)], r_j = radius[at(j)], m_i = mass[at(i)], m_j = mass[at(j)];
    table_.i[k] = i;
    table_.j[k] = j;
    table_.radius_sum[k] = r_i + r_j;
    table_.square[k] = r_i * r_i;
    table_.square_difference[k] = r_j * r_j - r_i * r_i;
    table_.reduced_mass[k] = m_i * m_j / (m_i + m_j);
    const double h_i = value_of(particles_.hardness, at(i), 1), h_j = value_of(particles_.hardness, at(j), 1);
    table_.hardness[k] = 2 * h_i * h_j / (h_i + h_j);
    table_.conductivity[k] = 0.5 * (value_of(particles_.conductivity, at(i), conductivity_) +
                                    value_of(particles_.conductivity, at(j), conductivity_));
    ++k;
  };
  std::size_t b = 0;
  for (const auto& [i, j] : pairs) {
    for (; b < bonds_.size() && before(bonds_[b], i, j); ++b) put(bonds_[b].i, bonds_[b].j);
    const bool bonded = b < bonds_.size() && bonds_[b].i == i && bonds_[b].j == j;
    b += bonded ? 1 : 0;
    const Vec3 between = position[at(j)] - position[at(i)];
    const double reach = radius[at(i)] + radius[at(j)] + table_skin_;
    if (bonded || !(dot(between, between) >= reach * reach)) put(i, j);
  }
  for (; b < bonds_.size(); ++b) put(bonds_[b].i, bonds_[b].j);
  table_.resize(k);
  std::fill(table_.keep.begin(), table_.keep.end(), 1.0);
  std::fill(table_.pull.begin(), table_.pull.end(), 0.0);
  std::fill(table_.damping.begin(), table_.damping.end(), 0.0);
  picked_.assign(position.begin(), position.end());
  incidence_stands_ = points_stand_ = false;
  find_bonds();
}

/// Where the pairs of the bonds stand in the table; every one of them is there.
void ContactPoints::find_bonds() {
  arrays_.pair.resize(bonds_.size());
  std::size_t k = 0;
  for (std::size_t b = 0; b < bonds_.size(); ++b) {
    while (table_.i[k] != bonds_[b].i || table_.j[k] != bonds_[b].j) ++k;
    arrays_.pair[b] = k;
  }
}

void ContactPoints::act(const BondSurroundings& around) {
  if (bonds_.empty()) return;
  points_stand_ = false;
  for_ranges(bonds_.size(), bonds_.size() / 2,
             [&](std::size_t first, std::size_t last) { kind_.act(around, arrays_, table_, first, last); });
}

void ContactPoints::update_bonds() {
  if (!law_.acts()) return;
  if (kind_.any_switches(law_, arrays_, table_)) {
    switch_bonds();
  } else {
    for (std::size_t n = 0; n < bonds_.size(); ++n) {
      bonds_[n].overlap = arrays_.now[n].overlap;
      bonds_[n].growth = arrays_.now[n].growth;
    }
  }
  begin_bonds();
  points_stand_ = false;
}

void ContactPoints::switch_bonds() {
  std::vector<Bond> kept;
  std::size_t b = 0;
  for (std::size_t k = 0; k < table_.size(); ++k) {
    const bool bonded = b < bonds_.size() && arrays_.pair[b] == k;
    const BondMemory memory = bonded ? arrays_.now[b] : BondMemory{};
    b += bonded ? 1 : 0;
    const bool turns = switches(kind_.margin(law_, table_.strain[k], memory, bonded), bonded);
    const double overlap = bonded ? memory.overlap : std::max(-table_.strain[k], 0.0);
    if (bonded != turns) kept.push_back({table_.i[k], table_.j[k], overlap, memory.growth});
    if (!turns || !bonded) continue;
    table_.keep[k] = 1;  // torn apart: nothing holds or flows any more
    table_.pull[k] = table_.damping[k] = 0;
    table_.flow[k] = table_.area[k] / (table_.radius_sum[k] * (1 + table_.strain[k]));
  }
  bonds_ = std::move(kept);
  arrays_.resize(bonds_.size());
  find_bonds();
}

/// What the bonds remember is what the step begins with.
void ContactPoints::begin_bonds() {
  for (std::size_t n = 0; n < bonds_.size(); ++n) {
    arrays_.begin[n] = arrays_.now[n] = {bonds_[n].overlap, bonds_[n].growth};
    arrays_.rate[n] = 0;
  }
}

void ContactPoints::begin_step() {
  if (kind_.grows) arrays_.rate = arrays_.rate_now;
}

void ContactPoints::set_bonds(std::span<const Bond> bonds) {
  bonds_.assign(bonds.begin(), bonds.end());
  arrays_.resize(bonds_.size());
  begin_bonds();
  picked_.clear();  // the table has to hold their pairs
}

const Incidence& ContactPoints::incidence() const {
  if (!incidence_stands_) incidence_.build(table_, particles_.size());
  incidence_stands_ = true;
  return incidence_;
}

std::span<const ContactPoint> ContactPoints::points() const {
  if (points_stand_) return points_;
  points_.clear();
  std::size_t b = 0;
  for (std::size_t k = 0; k < table_.size(); ++k) {
    const bool bonded = b < bonds_.size() && arrays_.pair[b] == k;
    b += bonded ? 1 : 0;
    // A NaN passes: its force shows which particle it came from.
    if (table_.strain[k] >= 0 && !bonded) continue;
    const double distance = table_.radius_sum[k] * (1 + table_.strain[k]);
    points_.push_back({.i = table_.i[k],
                       .j = table_.j[k],
                       .normal = {table_.nx[k], table_.ny[k], table_.nz[k]},
                       .strain = table_.strain[k],
                       .area = table_.flow[k] * distance,
                       .distance = distance,
                       .radius_sum = table_.radius_sum[k],
                       .conductivity = table_.conductivity[k],
                       .bonded = bonded});
  }
  points_stand_ = true;
  return points_;
}

std::size_t ContactPoints::touching() const noexcept {
  return static_cast<std::size_t>(
      std::count_if(table_.strain.begin(), table_.strain.end(), [](double strain) { return strain < 0; }));
}

}  // namespace superstep::dynamics
