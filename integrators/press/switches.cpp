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

/// Where a margin > 0 has come to an end.
double part_of(Course course) noexcept {
  return course.begin > 0 ? course.zero() : 0;  // stood at its end when the step began
}

void find_bond_switches(const MovingNetwork& network, const State& begin, const State& end, double h,
                        std::vector<Switch>& out) {
  const BondLaw& law = network.model().bond;
  const BondKind& kind = bond_kind(law.rule);
  if (!law.acts() || kind.smooth) return;
  const ContactTable& table = network.contacts().table();
  const BondArrays& bonds = network.contacts().bonded();
  std::size_t b = 0;
  for (std::size_t k = 0; k < table.size(); ++k) {
    const bool bonded = b < bonds.size() && bonds.pair[b] == k;
    const BondMemory now = bonded ? bonds.now[b] : BondMemory{},
                     before = bonded ? bonds.begin[b] : BondMemory{};
    b += bonded ? 1 : 0;
    const double strain = table.strain[k];
    const double margin = kind.margin(law, strain, now, bonded);
    if (!(bonded ? margin < 0 : margin <= 0)) continue;
    const std::size_t i = at(table.i[k]), j = at(table.j[k]);
    const double sum = table.radius_sum[k];
    const auto strain_rate = [&](const State& state) {
      const Vec3 between = state.position[j] - state.position[i];
      return dot(state.velocity[j] - state.velocity[i], between) / (norm(between) * sum);
    };
    const double first = (norm(begin.position[j] - begin.position[i]) - sum) / sum;
    constexpr double little = 1e-7;
    const double sense = (kind.margin(law, strain + little, now, bonded) - margin) / little;
    out.push_back({part_of({kind.margin(law, first, before, bonded), margin, sense * h * strain_rate(begin),
                            sense * h * strain_rate(end)}),
                   table.i[k], table.j[k]});
  }
}

void find_holds(const MovingNetwork& network, const State& begin, const State& end, const Phase& phase,
                double h, std::vector<Switch>& out) {
  const Model& model = network.model();
  if (!holds_temperatures(model) || !(phase.lower || phase.upper)) return;
  const auto held = network.held();
  const double height = phase.wall_height(begin.time);
  const double height_end = phase.wall_height(std::min(begin.time + h, phase.end));
  for (std::size_t i = 0; i < begin.size(); ++i)
    for (const Wall wall : {lower, upper}) {
      if (!(wall == lower ? phase.lower : phase.upper)) continue;
      const double r = network.particles().radius[i];
      const bool holds = held[i] == wall;
      const double gap = wall_distance(model.box, height, wall, begin.position[i]) - r;
      const double gap_end = wall_distance(model.box, height_end, wall, end.position[i]) - r;
      if (holds ? !(gap_end >= 0) : !(gap_end < 0 && held[i] < 0)) continue;
      const auto speed = [&](const State& state) {
        return wall == lower ? state.velocity[i].z : phase.wall_velocity() - state.velocity[i].z;
      };
      const double sense = holds ? -1 : 1;
      out.push_back(
          {part_of({sense * gap, sense * gap_end, sense * h * speed(begin), sense * h * speed(end)}),
           static_cast<std::int32_t>(i), -1});
    }
}

}  // namespace

bool has_switches(const Model& model) noexcept {
  return (model.bond.acts() && !bond_kind(model.bond.rule).smooth) || holds_temperatures(model);
}

std::vector<Switch> find_switches(const MovingNetwork& network, const State& begin, const State& end,
                                  const Phase& phase, double h) {
  std::vector<Switch> found;
  find_bond_switches(network, begin, end, h, found);
  find_holds(network, begin, end, phase, h, found);
  std::stable_sort(found.begin(), found.end(),
                   [](const Switch& a, const Switch& b) { return a.part < b.part; });
  return found;
}

Forced together_with_first(const std::vector<Switch>& switches, double width) {
  Forced forced;
  for (const auto& one : switches) {
    if (one.part > switches.front().part + width) break;
    if (one.j >= 0)
      forced.bonds.emplace_back(one.i, one.j);
    else
      forced.particles.push_back(one.i);
  }
  std::sort(forced.bonds.begin(), forced.bonds.end());
  std::sort(forced.particles.begin(), forced.particles.end());
  return forced;
}

}  // namespace superstep::dynamics
