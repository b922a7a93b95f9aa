#include "reports/gate/results_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/text/text_file.hpp"

namespace superstep {
namespace {

using Json = nlohmann::json;

std::string text_of(const Json& json, const char* key) {
  const auto entry = json.find(key);
  return entry != json.end() && entry->is_string() ? entry->get<std::string>() : std::string{};
}

std::vector<double> times_of(const Json& row, const char* key) {
  const auto entry = row.find(key);
  if (entry == row.end()) return {};
  std::vector<double> times;
  for (const auto& time : *entry) {
    times.push_back(time.get<double>());
    if (!(times.back() > 0)) return {};
  }
  return times;
}

MeasuredRow row_of(const Json& json) {
  MeasuredRow row;
  row.integrator = json.at("integrator").get<std::string>();
  const std::string params = json.at("params").get<std::string>();
  row.spec = json.value("spec", params.empty() ? row.integrator : row.integrator + ":" + params);
  row.status = json.at("status").get<std::string>();
  for (const auto& [key, value] : json.items())
    if (value.is_number()) row.numbers[key] = value.get<double>();
  row.cpu_stepping = times_of(json, "cpu_stepping_samples_s");
  row.yardstick = times_of(json, "yardstick_samples_s");
  return row;
}

ResultsFile from_json(const Json& json) {
  ResultsFile file;
  if (text_of(json, "schema") != "superstep.results" || json.at("schema_version").get<int>() != 1)
    throw std::runtime_error("its schema is not superstep.results, version 1");
  file.revision = text_of(json, "revision");
  file.processor = text_of(json.at("machine"), "processor");
  file.flags = text_of(json.at("machine"), "flags");
  file.threads = json.at("threads").get<int>();
  for (const auto& entry : json.at("cases")) {
    MeasuredCase one{entry.at("case").get<std::string>(), entry.at("baseline").get<std::string>(), {}};
    for (const auto& row : entry.at("rows")) one.rows.push_back(row_of(row));
    file.cases.push_back(std::move(one));
  }
  return file;
}

}  // namespace

std::optional<double> MeasuredRow::number(const std::string& column) const {
  const auto entry = numbers.find(column);
  return entry == numbers.end() ? std::nullopt : std::optional(entry->second);
}

const MeasuredRow* MeasuredCase::find(const std::string& spec) const {
  const auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& r) { return r.spec == spec; });
  return row == rows.end() ? nullptr : &*row;
}

const MeasuredCase* ResultsFile::find(const std::string& name) const {
  const auto one = std::find_if(cases.begin(), cases.end(), [&](const auto& c) { return c.name == name; });
  return one == cases.end() ? nullptr : &*one;
}

ResultsFile read_results(const std::string& path) {
  const std::string file = std::filesystem::is_directory(path) ? path + "/results.json" : path;
  const std::string text = read_text_file(file);
  try {
    ResultsFile results = from_json(Json::parse(text));
    results.path = file;
    return results;
  } catch (const std::exception& error) {
    throw InputError(
        fmt::format("{}: is no results.json of superstep bench: {}; write one with 'superstep "
                    "bench CASE --out DIR'",
                    file, error.what()));
  }
}

PairedTimings relative_timings(const MeasuredCase& one, const MeasuredRow& row) {
  const MeasuredRow* baseline = one.find(one.baseline);
  const bool is_baseline = baseline == &row;
  if (!is_baseline && !baseline) return {};
  const auto& yardstick = is_baseline ? row.yardstick : baseline->cpu_stepping;
  if (row.cpu_stepping.size() != yardstick.size()) return {};
  return {row.cpu_stepping, yardstick};
}

}  // namespace superstep
