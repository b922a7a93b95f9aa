#include "integrators/press/switches.hpp"

#include <algorithm>
#include <cmath>

#include "core/index.hpp"
#include "dynamics/contacts/bond_registry.hpp"

namespace superstep::dynamics {
namespace {

/// A quantity at both ends of a step and its change per step there.
struct Course {
  double begin, end, begin_slope, end_slope;

  [[nodiscard]] double at(double t) const noexcept {
    const double s = 1 - t;
    return s * s * ((1 + 2 * t) * begin + t * begin_slope) + t * t * ((1 + 2 * s) * end - s * end_slope);
  }
  /// Where it passes zero; the ends lie on different sides.
  [[nodiscard]] double zero() const noexcept {
    double low = 0, high = 1;
    const bool falls = begin > end;
    for (int k = 0; k < 60; ++k) {
      const double middle = 0.5 * (low + high);
      ((at(middle) > 0) == falls ? low : high) = middle;
    }
    return high;
  }
};

/// What all searches look at.
struct Step {
  const MovingNetwork& network;
  const State &begin, &end;
  const Phase& phase;
  double h;

  [[nodiscard]] double strain_at_begin(std::size_t k) const {
    const ContactTable& table = network.contacts().table();
    return pair_strain(norm(begin.position[at(table.j[k])] - begin.position[at(table.i[k])]),
                       table.radius_sum[k]);
  }
  /// Where a quantity of the strain of pair k passes zero. It is `first` and `last` at the ends and changes
  /// by `sense` per strain.
  [[nodiscard]] double part(std::size_t k, double first, double last, double sense) const {
    const ContactTable& table = network.contacts().table();
    const std::size_t i = at(table.i[k]), j = at(table.j[k]);
    const auto strain_rate = [&](const State& state) {
      const Vec3 between = state.position[j] - state.position[i];
      return dot(state.velocity[j] - state.velocity[i], between) / (norm(between) * table.radius_sum[k]);
    };
    return Course{first, last, sense * h * strain_rate(begin), sense * h * strain_rate(end)}.zero();
  }
  [[nodiscard]] Electrodes electrodes() const { return {phase.lower, phase.upper}; }
};

/// Margins of bonds that have come to an end.
void find_bond_switches(const Step& step, std::vector<Switch>& out) {
  const BondLaw& law = step.network.model().bond;
  const BondKind& kind = bond_kind(law.rule);
  if (!law.acts() || kind.smooth) return;
  const ContactTable& table = step.network.contacts().table();
  const BondArrays& bonds = step.network.contacts().bonded();
  if (!kind.any_switches(law, bonds, table)) return;
  std::size_t b = 0;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const bool bonded = b < bonds.size() && bonds.pair[b] == k;
    const BondMemory now = bonded ? bonds.now[b] : BondMemory{},
                     before = bonded ? bonds.begin[b] : BondMemory{};
    b += bonded ? 1 : 0;
    const double strain = table.strain[k];
    const double margin = kind.margin(law, strain, now, bonded);
    if (!switches(margin, bonded)) continue;
    constexpr double little = 1e-7;
    const double sense = (kind.margin(law, strain + little, now, bonded) - margin) / little;
    const double first = kind.margin(law, step.strain_at_begin(k), before, bonded);
    out.push_back({first > 0 ? step.part(k, first, margin, sense) : 0, table.i[k], table.j[k]});
  }
}

/// Particles that touch an electrified wall at one end of the step only.
void find_wall_switches(const Step& step, std::vector<Switch>& out) {
  const Box& box = step.network.model().box;
  const Phase& phase = step.phase;
  const double height = phase.wall_height(step.begin.time);
  const double height_end = phase.wall_height(std::min(step.begin.time + step.h, phase.end));
  for (std::size_t i = 0; i < step.begin.size(); ++i)
    for (const Wall wall : {lower, upper}) {
      if (!step.electrodes().of(wall)) continue;
      const double r = step.network.particles().radius[i];
      const double gap = wall_distance(box, height, wall, step.begin.position[i]) - r;
      const double gap_end = wall_distance(box, height_end, wall, step.end.position[i]) - r;
      if ((gap < 0) == (gap_end < 0)) continue;
      const auto speed = [&](const State& state) {
        return wall == lower ? state.velocity[i].z : phase.wall_velocity() - state.velocity[i].z;
      };
      const Course course{gap, gap_end, step.h * speed(step.begin), step.h * speed(step.end)};
      out.push_back({course.zero(), static_cast<std::int32_t>(i), -1});
    }
}

/// Pairs that join somebody to the current, or cut somebody off.
void find_path_switches(const Step& step, std::vector<Switch>& out) {
  const auto before = step.network.current().carrying();
  const auto now = step.network.current().reachable(step.network.placement(), step.electrodes());
  if (std::equal(now.begin(), now.end(), before.begin(), before.end())) return;
  const BondLaw& law = step.network.model().bond;
  const BondKind& kind = bond_kind(law.rule);
  const ContactTable& table = step.network.contacts().table();
  const BondArrays& bonds = step.network.contacts().bonded();
  std::size_t b = 0;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const bool bonded = b < bonds.size() && bonds.pair[b] == k;
    const BondMemory memory = bonded ? bonds.now[b] : BondMemory{};
    b += bonded ? 1 : 0;
    const std::size_t i = at(table.i[k]), j = at(table.j[k]);
    const bool joins = before[i] != before[j] && now[i] && now[j], cuts = before[i] && before[j];
    if (!joins && !cuts) continue;
    const double strain = table.strain[k], first = step.strain_at_begin(k);
    if (!bonded && (first < 0) != (strain < 0) && (strain < 0 ? joins : cuts)) {
      out.push_back({step.part(k, first, strain, 1), table.i[k], table.j[k]});
    } else if (bonded && kind.smooth && cuts && kind.margin(law, strain, memory, true) < 0) {
      const double margin = kind.margin(law, first, memory, true);
      out.push_back({margin > 0 ? step.part(k, margin, kind.margin(law, strain, memory, true), -1) : 0,
                     table.i[k], table.j[k]});
    }
  }
}

}  // namespace

bool has_switches(const Model& model) noexcept {
  return (model.bond.acts() && !bond_kind(model.bond.rule).smooth) || holds_temperatures(model) ||
         model.electric.model == CurrentModel::averaging;
}

std::vector<Switch> find_switches(const MovingNetwork& network, const State& begin, const State& end,
                                  const Phase& phase, double h) {
  const Step step{network, begin, end, phase, h};
  std::vector<Switch> found;
  find_bond_switches(step, found);
  const Model& model = network.model();
  if (step.electrodes().any()) {
    // A potential changes with the area of the new contact, a particle's current at once.
    const bool averages = model.electric.model == CurrentModel::averaging;
    if (averages || holds_temperatures(model)) find_wall_switches(step, found);
    if (averages) find_path_switches(step, found);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Switch& a, const Switch& b) { return a.part < b.part; });
  return found;
}

}  // namespace superstep::dynamics
