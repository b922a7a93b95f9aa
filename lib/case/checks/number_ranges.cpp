#include "case/checks/number_ranges.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"
#include "core/text/toml.hpp"

namespace superstep {
namespace {

constexpr double smallest = 1 / largest_number, largest = largest_number;

bool is_workable(double value) noexcept {
  return value >= smallest && value <= largest;
}

/// Checks one field; messages begin with the case's file.
class Check {
 public:
  Check(const std::string& file, const FieldScene& field, const Graph& graph)
      : file_(file), field_(field), graph_(graph) {}

  void nodes() const {
    for (std::size_t node = 0; node < graph_.nodes(); ++node) {
      const bool needs_none = field_.steady || (graph_.is_fixed[node] && graph_.capacity[node] == 0);
      if (!needs_none && !is_workable(graph_.capacity[node]))
        reject(of_node("capacity", node), graph_.capacity[node], "J/K or F");
      size("initial value", node, graph_.initial[node], field_.unit);
      if (graph_.is_fixed[node]) size("fixed value", node, graph_.fixed_value[node], field_.unit);
      size("source", node, graph_.source[node], "W or A");
    }
  }
  void edges() const {
    for (std::size_t edge = 0; edge < graph_.edges(); ++edge)
      if (graph_.conductance[edge] != 0 && !is_workable(graph_.conductance[edge]))
        reject(fmt::format("the conductance {}-{}", id(graph_.i[edge]), id(graph_.j[edge])),
               graph_.conductance[edge], "W/K or S");
  }
  void exchanges() const {
    for (const auto* list : {&graph_.convection, &graph_.radiation})
      for (const auto& exchange : *list) {
        const auto node = static_cast<std::size_t>(exchange.node);
        if (exchange.coefficient != 0 && !is_workable(exchange.coefficient))
          reject(of_node("exchange with the surroundings", node), exchange.coefficient, "W/K or W/K4");
        if (exchange.table < 0) size("ambient temperature", node, exchange.ambient, field_.unit);
      }
  }
  void tables() const {
    for (const auto& table : graph_.tables)
      for (const double value : table.value)
        if (is_too_large(value)) reject_size("a value of a table of time", value, "");
  }

 private:
  [[nodiscard]] std::int64_t id(std::int32_t node) const { return graph_.id[static_cast<std::size_t>(node)]; }
  [[nodiscard]] std::string of_node(const char* what, std::size_t node) const {
    return fmt::format("the {} of node {}", what, graph_.id[node]);
  }
  [[nodiscard]] static bool is_too_large(double value) noexcept { return std::abs(value) > largest; }
  void size(const char* what, std::size_t node, double value, const std::string& unit) const {
    if (is_too_large(value)) reject_size(of_node(what, node), value, unit);
  }
  [[noreturn]] void reject_size(const std::string& what, double value, const std::string& unit) const {
    throw InputError(fmt::format("{}: {}: {} is {} {}; it must not exceed {:g} in size", file_, field_.name,
                                 what, value, unit, largest));
  }
  [[noreturn]] void reject(const std::string& what, double value, const char* unit) const {
    throw InputError(
        fmt::format("{}: {}: {} is {} {}; it must lie between {:g} and {:g}, where every method can compute; "
                    "check the units, or choose others",
                    file_, field_.name, what, value, unit, smallest, largest));
  }

  const std::string& file_;
  const FieldScene& field_;
  const Graph& graph_;
};

}  // namespace

void require_workable_numbers(const std::string& file, const FieldScene& field, const Graph& graph) {
  const Check check(file, field, graph);
  check.nodes();
  check.edges();
  check.exchanges();
  check.tables();
}

void require_workable_numbers(const Scene& scene) {
  for (const auto& field : scene.fields) require_workable_numbers(scene.file, field, field.graph);
}

}  // namespace superstep
