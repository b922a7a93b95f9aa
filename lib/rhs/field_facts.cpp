/// What is known about a field beforehand: ranges, source rates, breakpoints.

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/index.hpp"
#include "rhs/kernels/field_operator.hpp"

namespace superstep {
namespace {

/// Adds up what rows take from one table, rate of change per unit of the table; rows come in order. Each
/// counts by itself, so that the sum is the same whoever has the rows.
class Weights {
 public:
  void add(std::int32_t row, double weight) noexcept {
    if (row != row_) finish();
    row_ = row;
    of_row_ += weight;
  }
  [[nodiscard]] double rms(std::size_t rows, Communicator* among) {
    finish();
    const double sum = among ? among->sum(sum_) : sum_.value();
    return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, rows)));
  }

 private:
  void finish() noexcept {
    if (of_row_ != 0) sum_.add(of_row_ * of_row_);
    of_row_ = 0;
  }
  std::int32_t row_ = -1;
  double of_row_ = 0;
  ExactSum sum_;
};

/// A table that acts on no row may still act through a product: its knots are never taken for nothing.
double effect(double weight, double change) noexcept {
  if (change == 0) return 0;
  return weight > 0 ? weight * change : std::numeric_limits<double>::infinity();
}

}  // namespace

void add_knots(const TimeTable& table, double weight, std::size_t field, std::vector<Breakpoint>& points) {
  const auto& time = table.time;
  const auto& value = table.value;
  const auto slope = [&](std::size_t k) {  // of the interval that ends at knot k
    const bool inside = k > 0 && k < time.size() && time[k] > time[k - 1];
    return inside ? (value[k] - value[k - 1]) / (time[k] - time[k - 1]) : 0.0;
  };
  for (std::size_t k = 0; k < time.size();) {
    std::size_t next = k + 1;  // behind the values that belong to this instant
    while (next < time.size() && time[next] == time[k]) ++next;
    Breakpoint point{.t = time[k]};
    point.jump[field] = effect(weight, std::abs(value[next - 1] - value[k]));
    point.kink[field] = effect(weight, std::abs(slope(next) - slope(k)));
    points.push_back(point);
    k = next;
  }
}

void FieldOperator::find_facts() {
  std::vector<double> largest_rate(sources_.empty() && tabled_.empty() ? 0 : size(), 0.0);
  for (const auto& source : sources_) largest_rate[at(source.row)] += std::abs(source.rate);
  const auto& tables = inputs_.tables();
  for (const auto& source : tabled_) {
    const auto& table = tables[at(source.table)];
    largest_rate[at(source.row)] +=
        std::max(std::abs(table.lowest()), std::abs(table.highest())) / network_.capacity[at(source.row)];
  }
  for (const double rate : largest_rate) facts_.source_rate = std::max(facts_.source_rate, rate);
  auto* among = network_.among();
  if (among) facts_.nonzeros = among->sum(facts_.nonzeros);
  if (among) facts_.source_rate = among->max(facts_.source_rate);
  facts_.has_sources = facts_.source_rate > 0;
  const auto take = [&](double value, std::int32_t table) {
    if (table < 0) return facts_.ambient.take(value);
    facts_.ambient.take(tables[at(table)].lowest());
    facts_.ambient.take(tables[at(table)].highest());
  };
  for (std::size_t g = 0; g < network_.ghost_node.size(); ++g)
    if (network_.ghost_node[g] < 0) take(network_.ghost_value[g], network_.ghost_table[g]);
  for (const auto& exchange : network_.radiation) take(exchange.ambient, exchange.table);
  if (among) facts_.ambient = {among->min(facts_.ambient.low), among->max(facts_.ambient.high)};
}

void FieldOperator::add_breakpoints(std::size_t field, std::vector<Breakpoint>& points) const {
  if (constant_inputs_) return;
  const auto& tables = inputs_.tables();
  std::vector<Weights> weights(tables.size());
  for (const auto& edge : network_.ghost_edges)
    if (const auto table = network_.ghost_table[at(edge.ghost)]; table >= 0)
      weights[at(table)].add(edge.row, edge.conductance / network_.capacity[at(edge.row)]);
  for (const auto& source : tabled_)
    weights[at(source.table)].add(source.row, 1 / network_.capacity[at(source.row)]);
  for (const auto& radiation : radiation_)
    if (radiation.table >= 0) {
      const auto& table = tables[at(radiation.table)];
      const double largest = std::max(std::abs(table.lowest()), std::abs(table.highest()));
      weights[at(radiation.table)].add(radiation.row, 4 * radiation.rate * largest * largest * largest);
    }
  for (std::size_t k = 0; k < tables.size(); ++k)
    add_knots(tables[k], weights[k].rms(network_.all_rows(), network_.among()), field, points);
}

std::vector<InputShape> FieldOperator::input_shapes() const {
  const auto& tables = inputs_.tables();
  std::vector<InputShape> shapes;
  if (tables.empty()) return shapes;  // then nobody need have said which table a ghost follows
  for (const auto& table : tables) shapes.push_back({.table = &table, .rates = {}});
  const auto add = [&](std::int32_t table, std::int32_t row, double rate) {
    if (table >= 0) shapes[at(table)].rates.push_back({row, rate});
  };
  for (const auto& ghost : ghosts_) add(network_.ghost_table[at(ghost.ghost)], ghost.row, ghost.rate);
  for (const auto& source : tabled_) add(source.table, source.row, 1 / network_.capacity[at(source.row)]);
  auto* among = network_.among();
  std::erase_if(shapes, [&](const auto& shape) {
    const bool here = !shape.rates.empty();
    return !(among ? among->any(here) : here);
  });
  return shapes;
}

}  // namespace superstep
