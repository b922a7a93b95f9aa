#include "integrators/costs/work.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "core/index.hpp"
#include "rhs/network_rhs.hpp"
#include "rhs/nonlinear_rhs.hpp"
#include "rhs/one_way.hpp"

namespace superstep {
namespace {

constexpr std::array physics_names = {"linear", "one-way", "nonlinear", "coupled"};

Physics physics_in(Rhs& rhs) {
  if (rhs.traits().linear && rhs.fields().size() == 1) return Physics::linear;
  if (exactly_solvable(rhs)) return Physics::one_way;
  return rhs.fields().size() > 1 ? Physics::coupled : Physics::nonlinear;
}

/// Whether some rows, here or elsewhere, are joined to no held value and no surroundings. Collective:
/// processes that share a network tell each other what they have reached until nothing is new.
bool some_float(const Network& network) {
  const std::size_t rows = network.size();
  std::vector<double> held(rows + (network.halo ? network.halo->size() : 0), 0.0);
  std::vector<std::size_t> next;
  const auto reach = [&](std::size_t row) {
    if (row >= rows || held[row] > 0) return;
    held[row] = 1;
    next.push_back(row);
  };
  const auto spread = [&] {
    while (!next.empty()) {
      const std::size_t row = next.back();
      next.pop_back();
      for (auto k = network.row_begin[row]; k < network.row_begin[row + 1]; ++k)
        reach(at(network.column[at(k)]));
    }
  };
  for (const auto& edge : network.ghost_edges) reach(at(edge.row));
  spread();
  bool more = network.halo != nullptr;
  while (more) {
    network.halo->fetch(held.data(), held.data() + rows);
    for (std::size_t row = 0; row < rows; ++row)
      for (auto k = network.row_begin[row]; k < network.row_begin[row + 1]; ++k)
        if (const std::size_t other = at(network.column[at(k)]); other >= rows && held[other] > 0) reach(row);
    more = network.halo->among().any(!next.empty());
    spread();
  }
  const bool floats = std::any_of(held.begin(), held.begin() + static_cast<std::ptrdiff_t>(rows),
                                  [](double reached) { return !(reached > 0); });
  return network.halo ? network.halo->among().any(floats) : floats;
}

}  // namespace

const char* physics_name(Physics physics) noexcept {
  return physics_names[static_cast<std::size_t>(physics)];
}

Physics physics_of(const std::string& name) {
  const auto found = std::find(physics_names.begin(), physics_names.end(), name);
  if (found == physics_names.end()) throw std::out_of_range(name);
  return static_cast<Physics>(found - physics_names.begin());
}

Work work_of(Rhs& rhs, double t_begin, std::span<const double> output_times, double memory) {
  const std::vector<double> zero(rhs.size(), 0.0);
  const double end = output_times.empty() ? t_begin : output_times.back(), time = end - t_begin;
  const auto first = std::upper_bound(output_times.begin(), output_times.end(), t_begin);
  const double shortest = first == output_times.end() ? time : *first - t_begin;
  const auto& points = rhs.facts().breakpoints;
  const auto within = [&](const Breakpoint& point) { return point.t > t_begin && point.t < end; };
  double nonzeros = 0;
  for (const auto& field : rhs.facts().fields) nonzeros += static_cast<double>(field.nonzeros);
  const auto* network = dynamic_cast<const NetworkRhs*>(&rhs);
  const auto* nonlinear = dynamic_cast<const NonlinearRhs*>(&rhs);
  const double t_rho = time * rhs.spectral_bound(t_begin, zero);
  const bool fast = t_rho * std::numeric_limits<double>::epsilon() > 1;
  return {.physics = physics_in(rhs),
          .steady = nonlinear && nonlinear->solves_for_potential(),
          .smooth = rhs.traits().smooth,
          .hidden = fast && network && some_float(network->network()),
          .unknowns = static_cast<double>(rhs.reduction().total()),
          .nonzeros = nonzeros,
          .t_rho = t_rho,
          .pieces = 1 + static_cast<double>(std::count_if(points.begin(), points.end(), within)),
          .shapes = rhs.traits().linear ? static_cast<double>(rhs.input_shapes().size()) : 0,
          .output_decades = shortest > 0 && time > shortest ? std::log10(time / shortest) : 0,
          .memory = memory};
}

}  // namespace superstep
