#include "results/schema/json_schema.hpp"

#include "results/results_json.hpp"
#include "results/schema/bench_fields.hpp"
#include "results/schema/run_fields.hpp"
#include "results/schema/stability_fields.hpp"
#include "results/study/stability_tables.hpp"

namespace superstep {
namespace {

JsonSchemaFile schema_file(const char* name, const char* title, int version, Json body) {
  Json out = {{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", title}};
  out["type"] = "object";
  out["properties"] = {{"schema", {{"const", name}}}, {"schema_version", {{"const", version}}}};
  out["properties"].update(body["properties"]);
  out["required"] = {"schema", "schema_version"};
  for (const auto& key : body["required"]) out["required"].push_back(key);
  return {name, json_text(out)};
}

}  // namespace

std::vector<JsonSchemaFile> json_schema_files() {
  return {
      schema_file(schema_of_results, "results.json of superstep bench", results_schema_version,
                  record_schema(fields_of<BenchReport>())),
      schema_file(schema_of_runs, "run.json of superstep run", results_schema_version,
                  record_schema(fields_of<RunRecord>())),
      schema_file(schema_of_stability, "stability.json of superstep stability", stability_schema_version,
                  record_schema(fields_of<StabilityResults>())),
  };
}

}  // namespace superstep
