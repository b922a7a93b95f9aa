#include "case/checks/law_ranges.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"

namespace superstep {
namespace {

/// Lowest and highest value of a temperature within the run.
using Range = std::pair<double, double>;

/// Checks one field's laws against the temperatures of its particles.
class LawCheck {
 public:
  LawCheck(const ConductionLaws& laws, const Graph& thermal, double t_end) : laws_(laws), thermal_(thermal) {
    for (const auto& table : thermal.tables) of_table_.push_back(table.range(0, t_end));
  }

  void check_particles() const {
    for (std::size_t node = 0; node < thermal_.nodes(); ++node) {
      const bool fixed = thermal_.is_fixed[node] != 0;
      const auto table = fixed && !thermal_.fixed_table.empty() ? thermal_.fixed_table[node] : -1;
      check(static_cast<std::int32_t>(node),
            range(fixed ? thermal_.fixed_value[node] : thermal_.initial[node], table),
            fixed ? "fixed temperature" : "start temperature");
    }
  }

  /// Only particles that are not fixed approach their surroundings.
  void check_ambients(const std::vector<AmbientExchange>& exchanges, const char* what) const {
    for (const auto& exchange : exchanges)
      if (!thermal_.is_fixed[static_cast<std::size_t>(exchange.node)])
        check(exchange.node, range(exchange.ambient, exchange.table), what);
  }

 private:
  [[nodiscard]] Range range(double value, std::int32_t table) const {
    return table < 0 ? Range(value, value) : of_table_[static_cast<std::size_t>(table)];
  }

  void check(std::int32_t node, const Range& range, const char* what) const {
    const auto& law = laws_.of_node(node);
    if (!law.limited()) return;
    for (const double temperature : {range.first, range.second})
      if (!law.covers(temperature))
        throw InputError(law.explain(
            fmt::format("the {} of particle {} is", what, thermal_.id[static_cast<std::size_t>(node)]),
            temperature));
  }

  const ConductionLaws& laws_;
  const Graph& thermal_;
  std::vector<Range> of_table_;
};

}  // namespace

void require_laws_to_hold(const Scene& scene) {
  const auto thermal = std::find_if(scene.fields.begin(), scene.fields.end(),
                                    [](const FieldScene& field) { return field.name == "temperature"; });
  if (thermal == scene.fields.end()) return;
  for (const auto& field : scene.fields) {
    const auto& laws = field.laws.of_material;
    if (std::none_of(laws.begin(), laws.end(), [](const auto& law) { return law.limited(); })) continue;
    const LawCheck check(field.laws, thermal->graph, scene.t_end);
    check.check_particles();
    check.check_ambients(thermal->graph.convection, "ambient (convection)");
    check.check_ambients(thermal->graph.radiation, "ambient (radiation)");
  }
}

}  // namespace superstep
