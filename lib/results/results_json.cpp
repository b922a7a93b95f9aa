#include "results/results_json.hpp"

#include "results/schema/bench_fields.hpp"
#include "results/schema/run_fields.hpp"

namespace superstep {
namespace {

template <class Record>
Record read_file(const std::string& path, const char* schema) {
  const Json parsed = parse_results(path, schema, results_schema_version);
  Record record;
  read_record(fields_of<Record>(), record, JsonObject(path, parsed));
  return record;
}

}  // namespace

std::string results_json(const BenchReport& report) {
  return json_file_text(schema_of_results, results_schema_version, report);
}

std::string run_json(const RunRecord& record) {
  return json_file_text(schema_of_runs, results_schema_version, record);
}

BenchReport read_results_json(const std::string& path) {
  return read_file<BenchReport>(path, schema_of_results);
}

RunRecord read_run_json(const std::string& path) {
  return read_file<RunRecord>(path, schema_of_runs);
}

}  // namespace superstep
