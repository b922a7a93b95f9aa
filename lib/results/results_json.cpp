#include "results/results_json.hpp"

#include <fmt/format.h>

#include <set>

#include "results/schema/bench_fields.hpp"
#include "results/schema/run_fields.hpp"

namespace superstep {
namespace {

template <class Record>
Record record_of(const JsonObject& json) {
  Record record;
  read_record(fields_of<Record>(), record, json);
  return record;
}

/// Results go by the names of cases, and of methods within a case.
void require_own_names(const JsonObject& report) {
  std::set<std::string> cases;
  for (const auto& one : report.objects("cases")) {
    const std::string name = one.text("case");
    if (!cases.insert(name).second)
      one.reject("case", "another case of this file has the same name, and results go by it");
    std::set<std::string> methods;
    for (const auto& row : one.objects("rows")) {
      const std::string params = row.text("params"), spec = row.text("spec");
      const std::string joined = row.text("integrator") + (params.empty() ? "" : ":" + params);
      if (!methods.insert(joined).second)
        row.reject("integrator",
                   fmt::format("another row of this case is of {}, and results go by that", joined));
      if (!spec.empty() && spec != joined) row.reject("spec", fmt::format("the row is of {}", joined));
      if (const std::string of = row.text("case"); !of.empty() && of != name)
        row.reject("case", fmt::format("the row stands in case '{}'", name));
    }
  }
}

}  // namespace

std::string results_json(const BenchReport& report) {
  return json_file_text(schema_of_results, results_schema_version, report);
}

std::string run_json(const RunRecord& record) {
  return json_file_text(schema_of_runs, results_schema_version, record);
}

BenchReport read_results_json(const std::string& path) {
  const Json parsed = parse_results(path, schema_of_results, results_schema_version);
  const JsonObject json(path, parsed);
  auto report = record_of<BenchReport>(json);
  require_own_names(json);
  return report;
}

RunRecord read_run_json(const std::string& path) {
  const Json parsed = parse_results(path, schema_of_runs, results_schema_version);
  return record_of<RunRecord>(JsonObject(path, parsed));
}

}  // namespace superstep
