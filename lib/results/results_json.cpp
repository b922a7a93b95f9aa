#include "results/results_json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "results/columns.hpp"

namespace superstep {
namespace {

using Json = nlohmann::ordered_json;

// Raised when a key changes its meaning or goes; new keys alone do not raise it.
constexpr int schema_version = 1;

struct CellJson {
  Json operator()(std::monostate) const { return nullptr; }
  template <class Value>
  Json operator()(const Value& value) const {
    return value;
  }
};

Json facts_json(const std::vector<Fact>& facts) {
  Json out = Json::object();
  for (const auto& fact : facts) out[fact.name] = fact.value;
  return out;
}

Json skips_json(const std::vector<SkippedWork>& skips) {
  Json out = Json::array();
  for (const auto& skip : skips) out.push_back({{"what", skip.what}, {"because", skip.because}});
  return out;
}

Json spread_json(const std::optional<Timing>& timing) {
  if (!timing) return nullptr;
  return {{"median", timing->median}, {"min", timing->min}, {"max", timing->max}};
}

Json row_json(const std::vector<Column>& columns, const BenchRow& row) {
  Json out;
  for (const auto& column : columns) out[column.name] = std::visit(CellJson{}, column.cell(row));
  out["spec"] = row.spec;
  out["choice"] = row.choice;
  out["spread"] = {{"cpu_total_s", spread_json(row.cpu_total)},
                   {"cpu_stepping_s", spread_json(row.cpu_stepping)},
                   {"wall_stepping_s", spread_json(row.wall_stepping)}};
  out["cpu_stepping_samples_s"] = row.cpu_stepping_samples;
  out["yardstick_samples_s"] = row.yardstick_samples;
  return out;
}

Json reference_json(const std::optional<ReferenceFacts>& reference) {
  if (!reference) return nullptr;
  return {
      {"spec", reference->spec}, {"from_cache", reference->from_cache}, {"cpu_s", reference->cpu_seconds}};
}

Json sampled_json(const std::optional<SampledMeasure>& sampled) {
  if (!sampled) return nullptr;
  return {{"field", sampled->field},
          {"every", sampled->every},
          {"from", sampled->from},
          {"to", sampled->to},
          {"as_written", sampled->as_written}};
}

Json number_json(const Number& number) {
  return number ? Json(*number) : Json(nullptr);
}

Json case_json(const BenchCase& one) {
  Json out = {{"case", one.name},
              {"title", one.title},
              {"source", one.source},
              {"nodes", one.nodes},
              {"contacts", one.contacts},
              {"unknowns", one.unknowns},
              {"t_end", one.t_end},
              {"output_times", one.output_times},
              {"error_unit", one.unit},
              {"baseline", one.baseline},
              {"cpu_setup_s", one.cpu_setup},
              {"reference", reference_json(one.reference)},
              {"reference_from_cache", one.reference && one.reference->from_cache},
              {"errors_as_published", sampled_json(one.sampled)},
              {"cpu_joule_s", number_json(one.cpu_joule)},
              {"skips", skips_json(one.skips)},
              {"warnings", one.warnings},
              {"rows", Json::array()}};
  const auto columns = bench_columns({&one, 1});
  for (const auto& row : one.rows) out["rows"].push_back(row_json(columns, row));
  return out;
}

// Reasons quote user input, which need not be UTF-8: replace what is not instead of failing.
std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json electrodes_json(const std::optional<SteadyCurrent>& facts) {
  if (!facts) return nullptr;
  return {{"voltage_v", facts->voltage},
          {"current_in_a", facts->current_in},
          {"current_out_a", facts->current_out},
          {"resistance_ohm", std::isfinite(facts->resistance) ? Json(facts->resistance) : Json(nullptr)},
          {"joule_heat_w", facts->joule_heat}};
}

}  // namespace

std::string results_json(const BenchReport& report) {
  Json out = {{"schema", "superstep.results"},
              {"schema_version", schema_version},
              {"version", report.version},
              {"revision", report.revision},
              {"machine", facts_json(report.machine)},
              {"libraries", facts_json(report.libraries)},
              {"repetitions", report.repetitions},
              {"threads", report.threads},
              {"interrupted", report.interrupted},
              {"cases", Json::array()}};
  for (const auto& one : report.cases) out["cases"].push_back(case_json(one));
  return text_of(out);
}

std::string run_json(const RunRecord& record) {
  const Json out = {
      {"schema", "superstep.run"},
      {"schema_version", schema_version},
      {"version", record.version},
      {"revision", record.revision},
      {"case", record.case_name},
      {"title", record.title},
      {"source", record.source},
      {"integrator", record.integrator},
      {"params", record.params},
      {"choice", record.choice},
      {"outcome", {{"status", record.status}, {"reason", record.reason}, {"t_reached", record.t_reached}}},
      {"t_end", record.t_end},
      {"nodes", record.nodes},
      {"contacts", record.contacts},
      {"unknowns", record.unknowns},
      {"threads", record.threads},
      {"counts",
       {{"steps", record.steps},
        {"rejected", record.rejected},
        {"rhs", record.rhs},
        {"jacobians", record.jacobians},
        {"factorizations", record.factorizations},
        {"solves", record.solves},
        {"max_stages", record.max_stages},
        {"potential_solves", record.potential_solves},
        {"skips", record.skips.size()}}},
      {"potential_settled_at_s", record.settled_at ? Json(*record.settled_at) : Json(nullptr)},
      {"electrodes", electrodes_json(record.electrodes)},
      {"cpu_setup_s", record.cpu_setup},
      {"cpu_prepare_s", record.cpu_prepare},
      {"cpu_stepping_s", record.cpu_stepping},
      {"cpu_pilot_s", record.cpu_pilot},
      {"cpu_verify_s", record.cpu_verify},
      {"verified_by", record.verified_by},
      {"delivered", number_json(record.delivered)},
      {"error_bound", record.error_bound > 0 ? Json(record.error_bound) : Json(nullptr)},
      {"spans", record.spans},
      {"wall_stepping_s", record.wall_stepping},
      {"peak_memory_mb", record.peak_memory_mb},
      {"files", record.files},
      {"skips", skips_json(record.skips)},
      {"warnings", record.warnings},
      {"machine", facts_json(record.machine)},
      {"libraries", facts_json(record.libraries)}};
  return text_of(out);
}

}  // namespace superstep
