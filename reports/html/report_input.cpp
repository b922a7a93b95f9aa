#include "reports/html/report_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/error.hpp"
#include "core/text/text_file.hpp"
#include "reports/html/read_runs.hpp"
#include "results/corpus/corpus_csv.hpp"
#include "results/observations_csv.hpp"
#include "results/results_json.hpp"
#include "results/study/read_work_precision.hpp"
#include "results/study/stability_tables.hpp"
#include "results/text/json_object.hpp"

namespace superstep {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int health_version = 1;

std::optional<Json> read_json(const std::string& path, const std::string& schema, int version) {
  if (!is_regular_file(path)) return std::nullopt;
  return parse_results(path, schema, version);
}

/// What the page shows of a case's health, so that a value of another type is found while the file is known.
void check_health(const JsonObject& health) {
  if (const auto packing = health.object("packing")) (void)packing->object("overlap");
  for (const auto& field : health.objects("fields")) {
    (void)field.text("field");
    (void)field.object("coordination");
  }
  (void)health.object("published");
}

void check_stability(const JsonObject& summary) {
  (void)summary.text("case");
  for (const auto& verdict : summary.objects("verdicts"))
    for (const char* key : {"grade", "method", "text"}) (void)verdict.text(key);
}

void read_benchmark(ReportInput& input) {
  const std::string path = input.folder + "/results.json";
  if (!is_regular_file(path)) return;
  input.bench = read_results_json(path);
  auto observations = read_observations(input.folder);
  const std::string health_file = input.folder + "/health.json";
  const auto health = read_json(health_file, "superstep.health", health_version);
  for (auto& one : input.bench->cases) {
    CaseInput out{.bench = std::move(one), .health = {}, .work_precision = {}};
    if (auto seen = observations.extract(out.bench.name)) out.bench.observations = std::move(seen.mapped());
    if (health)
      for (const auto& candidate : JsonObject(health_file, *health).objects("cases"))
        if (candidate.text("case") == out.bench.name) {
          check_health(candidate);
          out.health = candidate.json();
        }
    input.cases.push_back(std::move(out));
  }
  if (!observations.empty())
    throw InputError(fmt::format(
        "{}: histories.csv or snapshots.csv speaks of case {}, and results.json does not: they are of two "
        "benchmarks; measure anew, or delete the two",
        input.folder, in_quotes(observations.begin()->first)));
  input.bench->cases.clear();
}

// A sweep over several cases has a folder for each.
std::vector<std::string> study_files(const std::string& folder) {
  std::vector<std::string> files;
  if (is_regular_file(folder + "/work_precision.csv")) files.push_back(folder + "/work_precision.csv");
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (const std::string file = entry.path().string() + "/work_precision.csv"; is_regular_file(file))
      files.push_back(file);
  std::sort(files.begin(), files.end());
  return files;
}

void read_studies(ReportInput& input) {
  for (const auto& file : study_files(input.folder)) {
    WorkPrecision study = read_work_precision_csv(file);
    const auto of_case = std::find_if(input.cases.begin(), input.cases.end(), [&](const CaseInput& one) {
      return one.bench.name == study.case_name;
    });
    if (of_case == input.cases.end()) {
      input.other_studies.push_back(std::move(study));
      continue;
    }
    if (study.output_times != of_case->bench.output_times)
      throw InputError(fmt::format(
          "{}: its errors are not at the output times of case {} in {}/results.json: they are of two "
          "benchmarks, or a column is missing; measure one of them anew",
          file, in_quotes(study.case_name), input.folder));
    study.title = of_case->bench.title;
    study.unit = of_case->bench.unit;
    of_case->work_precision = std::move(study);
  }
}

void read_stability(ReportInput& input) {
  StabilityInput out;
  const std::string file = input.folder + "/stability.json";
  out.summary = read_json(file, "superstep.stability", stability_schema_version);
  if (out.summary) check_stability(JsonObject(file, *out.summary));
  for (const char* name : {"methods", "critical_step", "rounding", "sweeps", "states"})
    if (const std::string table = fmt::format("{}/stability_{}.csv", input.folder, name);
        is_regular_file(table))
      out.tables.emplace(name, std::make_unique<CsvTable>(table));
  if (out.summary || !out.tables.empty()) input.stability = std::move(out);
}

}  // namespace

ReportInput read_report_input(const std::string& folder) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored))
    throw InputError(
        fmt::format("{}: it is not a folder; give the one that superstep bench or run wrote", folder));
  ReportInput input;
  input.folder = folder;
  read_benchmark(input);
  read_studies(input);
  read_stability(input);
  input.runs = read_runs(folder);
  if (const std::string corpus = folder + "/corpus.csv"; is_regular_file(corpus))
    input.corpus = read_corpus_csv(corpus);
  if (const std::string table = folder + "/press_table.csv"; is_regular_file(table))
    input.press_table = read_press_table_csv(table);
  if (!input.bench && input.corpus.empty() && input.press_table.empty() && input.runs.empty() &&
      input.other_studies.empty() && !input.stability)
    throw InputError(fmt::format(
        "{}: there are no results of bench, run or stability; write some with superstep bench CASE --out {}",
        folder, folder));
  return input;
}

}  // namespace superstep
