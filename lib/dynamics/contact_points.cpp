#include "dynamics/contact_points.hpp"

#include <cmath>

#include "dynamics/laws/contact_law.hpp"

namespace superstep::dynamics {

void ContactPoints::place(std::span<const Vec3> position, std::span<const double> radius) {
  if (list_.update(position, radius)) spread_bonds();
  points_.clear();
  pair_of_.clear();
  touching_ = 0;
  const auto pairs = list_.pairs();
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto i = static_cast<std::size_t>(pairs[k].i), j = static_cast<std::size_t>(pairs[k].j);
    const Vec3 between = position[j] - position[i];
    const double square = dot(between, between), sum = radius[i] + radius[j];
    const bool bonded = bond_area_[k] > 0;
    const bool holds_apart = bonded && law_.rule == BondRule::tension;
    // A NaN passes: its force shows which particle it came from.
    if (square >= sum * sum && !holds_apart) continue;
    const double distance = std::sqrt(square);
    const bool touches = distance < sum;
    touching_ += touches ? 1 : 0;
    points_.push_back({pairs[k].i, pairs[k].j, (1 / distance) * between, pair_strain(distance, sum),
                       touches ? pair_area(distance, radius[i], radius[j]) : bond_area_[k], distance, sum,
                       bonded});
    pair_of_.push_back(k);
  }
}

void ContactPoints::update_bonds() {
  if (!(law_.stiffness > 0)) return;
  bonds_.clear();
  for (std::size_t c = 0; c < points_.size(); ++c) {
    auto& point = points_[c];
    double& bond = bond_area_[pair_of_[c]];
    bond = bond_after_step(law_, bond, point.strain, point.strain < 0 ? point.area : 0.0);
    if (bond > 0) bonds_.push_back({point.i, point.j, bond});
    point.bonded = bond > 0;
    if (!point.bonded && point.strain >= 0) point.area = 0;  // torn apart: nothing flows any more
  }
}

void ContactPoints::set_bonds(std::span<const Bond> bonds) {
  bonds_.assign(bonds.begin(), bonds.end());
  if (!list_.pairs().empty()) spread_bonds();
}

// Both are sorted by (i, j). A trial position may throw a bonded pair out of the list; its bond comes back
// with the next list, because `bonds_` changes with accepted steps only.
void ContactPoints::spread_bonds() {
  const auto pairs = list_.pairs();
  bond_area_.assign(pairs.size(), 0.0);
  std::size_t b = 0;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto before = [&](const Bond& bond) {
      return bond.i < pairs[k].i || (bond.i == pairs[k].i && bond.j < pairs[k].j);
    };
    while (b < bonds_.size() && before(bonds_[b])) ++b;
    if (b == bonds_.size()) return;
    if (bonds_[b].i == pairs[k].i && bonds_[b].j == pairs[k].j) bond_area_[k] = bonds_[b].area;
  }
}

}  // namespace superstep::dynamics
