#include "reports/gate/results_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <utility>

#include "core/error.hpp"
#include "core/text/text_file.hpp"
#include "results/results_json.hpp"
#include "results/same_case.hpp"
#include "results/text/json_object.hpp"

namespace superstep {
namespace {

std::string required(const JsonObject& object, const char* key) {
  if (!object.find(key)) object.reject(key, "it must be a string");
  return object.text(key);
}

std::vector<double> times_of(const JsonObject& row, const char* key) {
  auto times = row.numbers(key);
  // A clock too coarse for the work has measured nothing.
  if (std::any_of(times.begin(), times.end(), [](double time) { return !(time > 0); })) times.clear();
  return times;
}

/// A method that ran has counted something.
bool has_counters(const MeasuredRow& row) {
  return std::any_of(std::begin(counter_columns), std::end(counter_columns),
                     [&](const char* counter) { return row.number(counter).has_value(); });
}

/// False for a method that the interrupt came before; where there was none, a method that is ok and has
/// counted nothing is no measurement to compare with.
bool was_reached(const JsonObject& json, const MeasuredRow& row, bool interrupted) {
  if (row.status != "ok" || has_counters(row)) return true;
  if (!interrupted) json.reject("steps", "a method that is ok must have counters, to be judged by them");
  return false;
}

MeasuredRow row_of(const JsonObject& json) {
  MeasuredRow row;
  row.integrator = required(json, "integrator");
  const std::string params = required(json, "params");
  const std::string spec = json.text("spec");
  row.spec = !spec.empty() ? spec : params.empty() ? row.integrator : row.integrator + ":" + params;
  row.status = required(json, "status");
  for (const auto& [key, value] : json.json().items())
    if (value.is_number()) row.numbers[key] = value.get<double>();
  row.cpu_stepping = times_of(json, "cpu_stepping_samples_s");
  row.yardstick = times_of(json, "yardstick_samples_s");
  return row;
}

ResultsFile read_from(const std::string& path) {
  BenchReport report = read_results_json(path);  // refuses what bench cannot have written
  const auto parsed = parse_results(path, schema_of_results, results_schema_version);
  const JsonObject json(path, parsed);
  ResultsFile file;
  file.path = path;
  file.revision = json.text("revision");
  if (const auto machine = json.object("machine")) {
    file.processor = machine->text("processor");
    file.flags = machine->text("flags");
    if (const std::string counter = machine->text("callgrind"); !counter.empty()) {
      file.counted_by =
          counter + "; " + machine->text("compiler") + "; " + file.flags + "; " + machine->text("blas");
      if (const auto libraries = json.object("libraries"))
        for (const auto& [name, version] : libraries->json().items())
          file.counted_by += "; " + name + " " + libraries->text(name);
    }
  }
  file.threads = json.count<int>("threads").value_or(1);
  file.interrupted = json.flag("interrupted");
  if (!json.find("cases")) json.reject("cases", "it must list what was measured");
  for (const auto& entry : json.objects("cases")) {
    MeasuredCase one{required(entry, "case"), required(entry, "baseline"), {}, {}};
    one.head = std::move(report.cases[file.cases.size()]);
    one.head.rows.clear();
    if (!entry.find("rows")) entry.reject("rows", "it must list the methods");
    for (const auto& object : entry.objects("rows"))
      if (MeasuredRow row = row_of(object); was_reached(object, row, file.interrupted))
        one.rows.push_back(std::move(row));
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

const MeasuredCase* ResultsFile::find_same(const MeasuredCase& one, const std::string& other_path) const {
  const MeasuredCase* here = find(one.name);
  if (here) require_same_case(here->head, path, one.head, other_path);
  return here;
}

bool ResultsFile::has_samples() const {
  for (const auto& one : cases)
    for (const auto& row : one.rows)
      if (!row.cpu_stepping.empty()) return true;
  return false;
}

ResultsFile read_results(const std::string& path) {
  std::error_code ignored;
  const std::string file = std::filesystem::is_directory(path, ignored) ? path + "/results.json" : path;
  return read_from(file);
}

PairedTimings relative_timings(const MeasuredCase& one, const MeasuredRow& row) {
  const MeasuredRow* baseline = one.find(one.baseline);
  const bool is_baseline = baseline == &row;
  if (!is_baseline && !baseline) return {};
  const auto& yardstick = is_baseline ? row.yardstick : baseline->cpu_stepping;
  PairedTimings paired{row.cpu_stepping, yardstick};
  const std::size_t rounds = std::min(paired.work.size(), paired.yardstick.size());
  paired.work.resize(rounds);
  paired.yardstick.resize(rounds);
  return paired;
}

}  // namespace superstep
