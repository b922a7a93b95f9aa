#include "rhs/joule_heat.hpp"

#include <algorithm>

#include "core/index.hpp"
#include "core/parallel.hpp"
#include "rhs/kernels/sweep.hpp"

namespace superstep {
namespace {

/// Calls end(row, other slot, branch) for each branch end that heats a temperature row.
template <class End>
void for_ends(const Graph& electric, std::span<const std::int32_t> slot_of_node, std::size_t rows, End end) {
  for (std::size_t k = 0; k < electric.edges(); ++k) {
    if (!(electric.conductance[k] > 0)) continue;
    const auto a = at(slot_of_node[at(electric.i[k])]), b = at(slot_of_node[at(electric.j[k])]);
    if (a < rows) end(a, b, k);
    if (b < rows) end(b, a, k);
  }
}

}  // namespace

JouleHeat::JouleHeat(const Graph& electric, std::span<const std::int32_t> slot_of_node, std::size_t rows,
                     std::span<const double> capacity, std::span<const double> conductivity,
                     ConductanceMean mean, std::span<const std::int64_t> order_of_slot)
    : begin_(rows + 1, 0), nodes_(slot_of_node.size()) {
  for_ends(electric, slot_of_node, rows,
           [&](std::size_t row, std::size_t, std::size_t) { ++begin_[row + 1]; });
  for (std::size_t row = 0; row < rows; ++row) {
    begin_[row + 1] += begin_[row];
    inverse_capacity_.push_back(1 / capacity[row]);
  }
  // Filled by ascending slots, so that a sweep reads potentials in order.
  std::vector<std::pair<std::int32_t, std::size_t>> ends(at(begin_.back()));
  std::vector<std::int64_t> next(begin_.begin(), begin_.end() - 1);
  for_ends(electric, slot_of_node, rows, [&](std::size_t row, std::size_t other, std::size_t branch) {
    ends[at(next[row]++)] = {static_cast<std::int32_t>(other), branch};
  });
  with_mean(mean, [&](auto mix) {
    for (std::size_t row = 0; row < rows; ++row) {
      const auto key = [&](const auto& end) {
        return std::pair(order_of_slot.empty() ? end.first : order_of_slot[at(end.first)], end.second);
      };
      std::sort(ends.begin() + begin_[row], ends.begin() + begin_[row + 1],
                [&](const auto& a, const auto& b) { return key(a) < key(b); });
      for (auto k = begin_[row]; k < begin_[row + 1]; ++k) {
        const auto [other, branch] = ends[at(k)];
        const double a = conductivity[row], b = conductivity[at(other)];
        slot_.push_back(other);
        geometry_.push_back(electric.conductance[branch] / mix.value(a, b));
        weight_.push_back(geometry_.back() * mix.heat(a, b));
      }
    }
  });
  sliced_weight_ = SlicedRows(begin_, slot_);
  sliced_weight_.set_values(begin_, [this](std::size_t, std::size_t k) { return weight_[k]; });
  sliced_geometry_ = SlicedRows(begin_, slot_);
  sliced_geometry_.set_values(
      begin_, [&](std::size_t, std::size_t k) { return geometry_factor(mean) * geometry_[k]; });
}

void JouleHeat::rate(std::span<const double> potential, std::span<double> out) const noexcept {
  heat_sweep(sliced_weight_, potential.data(), inverse_capacity_.data(), out.data());
}

/// Potentials side by side with the s of their conductivities.
void JouleHeat::pair_nodes(std::span<const double> potential, const SlotConductivity& conductivity) {
  const auto sigma = conductivity.value();
  const auto mean = conductivity.mean();
  for_each_entry(nodes_.size(), [&](std::size_t s) {
    nodes_[s] = {potential[s], node_factor(mean, sigma[s])};
  });
}

void JouleHeat::rate(std::span<const double> potential, const SlotConductivity& conductivity,
                     std::span<double> out) noexcept {
  pair_nodes(potential, conductivity);
  varying_heat(conductivity.mean(), sliced_geometry_, nodes_.data(), inverse_capacity_.data(), out.data());
}

void JouleHeat::add_row_sums(std::span<const double> potential, const SlotConductivity& conductivity,
                             std::span<const char> temperature_moves, std::span<const double> potential_moves,
                             const HeatSums& out) {
  pair_nodes(potential, conductivity);
  bend_.resize(nodes_.size());
  const auto sigma = conductivity.value(), slope = conductivity.slope();
  for_each_entry(bend_.size(), [&](std::size_t s) {
    bend_[s] = temperature_moves[s] ? node_bend(conductivity.mean(), sigma[s], slope[s]) : 0;
  });
  varying_heat_sums(conductivity.mean(), sliced_geometry_,
                    {nodes_.data(), bend_.data(), potential_moves.data()}, inverse_capacity_.data(), out);
}

double JouleHeat::largest_rate(double span) const noexcept {
  double largest = 0;
  for (std::size_t row = 0; row < inverse_capacity_.size(); ++row) {
    double sum = 0;
    for (auto k = begin_[row]; k < begin_[row + 1]; ++k) sum += weight_[at(k)];
    largest = std::max(largest, sum * span * span * inverse_capacity_[row]);
  }
  return largest;
}

}  // namespace superstep
