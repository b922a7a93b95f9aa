#include "results/study/stability_tables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "results/text/csv_text.hpp"

namespace superstep {
namespace {

using Cell = StabilityTable::Cell;
using Json = nlohmann::ordered_json;

Cell number(double value) {
  return std::isfinite(value) ? Cell(value) : Cell();
}
Cell number(const std::optional<double>& value) {
  return value ? number(*value) : Cell();
}
template <class Integer>
Cell count(Integer value) {
  return static_cast<std::int64_t>(value);
}

struct CsvText {
  std::string operator()(std::monostate) const { return {}; }
  std::string operator()(const std::string& text) const { return csv_cell(text); }
  std::string operator()(std::int64_t value) const { return fmt::format("{}", value); }
  std::string operator()(double value) const { return csv_cell(value); }
  std::string operator()(bool value) const { return value ? "yes" : "no"; }
};

struct JsonValue {
  Json operator()(std::monostate) const { return nullptr; }
  template <class Value>
  Json operator()(const Value& value) const {
    return value;
  }
};

StabilityTable methods_table(const StabilityResults& results) {
  StabilityTable table{"methods",
                       {"method", "parameters", "order", "spec", "stages", "step_s", "z_stiff", "beta",
                        "limit", "max_response", "damping", "stiff_theory", "stiff_measured", "difference",
                        "tolerance", "growth_measured", "beyond_theory", "beyond_measured", "agrees"},
                       {}};
  for (const auto& m : results.methods)
    table.rows.push_back({m.family, m.parameters, m.order, m.spec, count(m.stages), number(m.step),
                          number(m.z_stiff), number(m.beta), number(m.limit), number(m.largest),
                          number(m.damping), number(m.stiff), number(m.stiff_measured), number(m.difference),
                          number(m.tolerance), number(m.growth), number(m.beyond), number(m.beyond_measured),
                          m.agrees});
  return table;
}

StabilityTable critical_step_table(const StabilityResults& results) {
  StabilityTable table{
      "critical_step", {"estimate", "step_s", "alpha", "of_limit", "stable", "note", "growth"}, {}};
  for (const auto& e : results.critical_step.estimates)
    table.rows.push_back({e.name, number(e.step), number(e.alpha), number(e.of_limit),
                          stable_word(e.tendency), e.note, number(e.growth)});
  return table;
}

StabilityTable rounding_table(const StabilityResults& results) {
  StabilityTable table{"rounding",
                       {"n", "nu", "order", "internal_amplification", "superstep_rounding_eps",
                        "run_rounding_spans", "run_error_spans", "right"},
                       {}};
  for (const auto& r : results.rounding)
    table.rows.push_back({count(r.n), number(r.nu), r.order, number(r.amplification),
                          number(r.superstep_error), number(r.rounding_error), number(r.end_error), r.right});
  return table;
}

StabilityTable sweeps_table(const StabilityResults& results) {
  StabilityTable table{"sweeps",
                       {"sweep", "contrast", "size_ratio", "nu", "n", "nodes", "networks", "edge_over_true",
                        "gershgorin_over_true", "bound_over_true", "alpha_star"},
                       {}};
  if (!results.sweeps.empty())
    for (const auto& overshoot : results.sweeps.front().overshoots)
      table.columns.push_back("overshoot_" + overshoot.method);
  for (const auto& p : results.sweeps) {
    table.rows.push_back({p.sweep, number(p.contrast), number(p.size_ratio), number(p.nu), count(p.n),
                          count(p.nodes), count(p.networks), number(p.edge_ratio), number(p.gershgorin_ratio),
                          number(p.bound_ratio), number(p.alpha)});
    for (const auto& overshoot : p.overshoots) table.rows.back().push_back(number(overshoot.spans));
  }
  return table;
}

StabilityTable states_table(const StabilityResults& results) {
  StabilityTable table{
      "states",
      {"part_of_run", "time_s", "unknowns", "spectrum", "eigenvalues_by", "lambda_max", "lambda_imaginary",
       "lambda_residual", "rising_rate", "certified_bound", "method", "parameters", "spec",
       "limit_predicted_s", "limit_measured_s", "predicted_over_measured", "growth_at_predicted", "verdict"},
      {}};
  for (const auto& s : results.states)
    for (const auto& m : s.limits)
      table.rows.push_back({number(s.part), number(s.time), count(s.unknowns), s.spectrum, s.found_by,
                            number(s.lambda_max), number(s.lambda_imaginary), number(s.lambda_residual),
                            number(s.rising), number(s.certified_bound), m.family, m.parameters, m.spec,
                            number(m.predicted), number(m.measured),
                            m.predicted ? number(*m.predicted / m.measured) : Cell(),
                            number(m.growth_at_predicted), verdict_name(m.verdict)});
  return table;
}

Json rows_json(const StabilityTable& table) {
  Json rows = Json::array();
  for (const auto& row : table.rows) {
    Json object = Json::object();
    for (std::size_t k = 0; k < row.size(); ++k) object[table.columns[k]] = std::visit(JsonValue{}, row[k]);
    rows.push_back(std::move(object));
  }
  return rows;
}

}  // namespace

const char* grade_name(Verdict::Grade grade) {
  switch (grade) {
    case Verdict::Grade::safe:
      return "safe";
    case Verdict::Grade::careful:
      return "careful";
    case Verdict::Grade::unsafe:
      return "unsafe";
  }
  return "";
}

const char* stable_word(Tendency tendency) {
  switch (tendency) {
    case Tendency::decays:
      return "yes";
    case Tendency::grows:
      return "no";
    case Tendency::unclear:
      return "can not be told apart";
  }
  return "";
}

const char* verdict_name(FrozenLimit::Verdict verdict) {
  switch (verdict) {
    case FrozenLimit::Verdict::agrees:
      return "agrees";
    case FrozenLimit::Verdict::differs:
      return "differs";
    case FrozenLimit::Verdict::not_predicted:
      return "no prediction";
  }
  return "";
}

std::string StabilityTable::csv() const {
  std::string out = fmt::format("{}\n", fmt::join(columns, ","));
  for (const auto& row : rows) {
    std::vector<std::string> cells;
    cells.reserve(row.size());
    for (const auto& cell : row) cells.push_back(std::visit(CsvText{}, cell));
    out += fmt::format("{}\n", fmt::join(cells, ","));
  }
  return out;
}

std::vector<StabilityTable> stability_tables(const StabilityResults& results) {
  return {methods_table(results), critical_step_table(results), rounding_table(results),
          sweeps_table(results), states_table(results)};
}

std::string stability_json(const StabilityResults& results) {
  const auto finite = [](double value) { return std::visit(JsonValue{}, number(value)); };
  Json out = {{"schema", "superstep.stability"},
              {"schema_version", stability_schema_version},
              {"case", results.case_name},
              {"title", results.title},
              {"quick", results.quick},
              {"linear", results.linear},
              {"unknowns", results.unknowns},
              {"lambda_max", finite(results.lambda_max)},
              {"lambda_max_residual", finite(results.lambda_residual)},
              {"limit_by_bisection", finite(results.critical_step.limit)},
              {"lanczos_over_bisection", finite(results.critical_step.lanczos_ratio)}};
  for (const auto& table : stability_tables(results)) out[table.name] = rows_json(table);
  out["notes"] = results.notes;
  out["verdicts"] = Json::array();
  for (const auto& verdict : results.verdicts)
    out["verdicts"].push_back(
        {{"method", verdict.method}, {"grade", grade_name(verdict.grade)}, {"text", verdict.text}});
  return out.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace superstep
