#include "results/read_results.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/text/text_file.hpp"
#include "results/columns.hpp"

namespace superstep {
namespace {

using Json = nlohmann::ordered_json;

constexpr int newest_schema = 1;

/// Values of one JSON object by key; null and missing are empty, another type is an error of the file.
class Object {
 public:
  explicit Object(const Json& json) : json_(json) {}

  [[nodiscard]] std::string text(const char* key) const {
    const Json* value = find(key);
    return value ? value->get<std::string>() : std::string();
  }
  [[nodiscard]] Number number(const std::string& key) const {
    const Json* value = find(key);
    return value ? Number(value->get<double>()) : std::nullopt;
  }
  [[nodiscard]] double number_or_zero(const char* key) const { return number(key).value_or(0); }
  template <class Integer>
  [[nodiscard]] std::optional<Integer> count(const char* key) const {
    const Json* value = find(key);
    return value ? std::optional<Integer>(value->get<Integer>()) : std::nullopt;
  }
  [[nodiscard]] bool flag(const char* key) const {
    const Json* value = find(key);
    return value && value->get<bool>();
  }
  [[nodiscard]] const Json* find(const std::string& key) const {
    const auto found = json_.find(key);
    return found == json_.end() || found->is_null() ? nullptr : &*found;
  }

 private:
  const Json& json_;
};

template <class Integer>
Integer count(const Object& object, const char* key) {
  return object.count<Integer>(key).value_or(0);
}

std::vector<Fact> facts(const Object& object, const char* key) {
  std::vector<Fact> out;
  if (const Json* json = object.find(key))
    for (const auto& [name, value] : json->items()) out.push_back({name, value.get<std::string>()});
  return out;
}

template <class Value>
std::vector<Value> list(const Object& object, const char* key) {
  const Json* json = object.find(key);
  return json ? json->get<std::vector<Value>>() : std::vector<Value>();
}

std::vector<SkippedWork> skips(const Object& object) {
  std::vector<SkippedWork> out;
  if (const Json* json = object.find("skips"))
    for (const auto& skip : *json) out.push_back({Object(skip).text("what"), Object(skip).text("because")});
  return out;
}

std::optional<Timing> timing(const Object& row, const char* key) {
  const Json* spread = row.find("spread");
  const Json* json = spread ? Object(*spread).find(key) : nullptr;
  if (!json) return std::nullopt;
  const Object one(*json);
  return Timing{one.number_or_zero("median"), one.number_or_zero("min"), one.number_or_zero("max")};
}

FieldErrors errors(const Object& row, const std::string& suffix) {
  FieldErrors out;
  for (const auto& [key, value] : error_measures()) out.*value = row.number(key + suffix);
  return out;
}

bool any(const FieldErrors& errors) {
  for (const auto& [key, value] : error_measures())
    if ((errors.*value).has_value()) return true;
  return false;
}

BenchRow row_of(const Object& json) {
  BenchRow row;
  row.case_name = json.text("case");
  row.integrator = json.text("integrator");
  row.params = json.text("params");
  row.spec = row.integrator + (row.params.empty() ? "" : ":" + row.params);
  row.status = json.text("status");
  row.reason = json.text("reason");
  row.choice = json.text("choice");
  row.nodes = count<std::size_t>(json, "nodes");
  row.contacts = count<std::size_t>(json, "contacts");
  row.t_end = json.number_or_zero("t_end");
  row.repetitions = count<int>(json, "repetitions");
  row.threads = count<int>(json, "threads");
  row.cpu_total = timing(json, "cpu_total_s");
  row.cpu_stepping = timing(json, "cpu_stepping_s");
  row.wall_stepping = timing(json, "wall_stepping_s");
  row.speedup_total = json.number("speedup_total");
  row.speedup_stepping = json.number("speedup_stepping");
  row.speedup_theory = json.number("speedup_theory");
  row.cpu_prepare = json.number("cpu_prepare_s");
  row.speedup_prepared = json.number("speedup_prepared");
  row.cpu_pilot = json.number("cpu_pilot_s");
  row.steps = json.count<std::uint64_t>("steps");
  row.rejected = json.count<std::uint64_t>("rejected");
  row.rhs = json.count<std::uint64_t>("rhs");
  row.jacobians = json.count<std::uint64_t>("jacobians");
  row.factorizations = json.count<std::uint64_t>("factorizations");
  row.solves = json.count<std::uint64_t>("solves");
  row.max_stages = json.count<std::uint64_t>("max_stages");
  row.peak_memory_mb = json.number("peak_memory_mb");
  row.errors = errors(json, "");
  if (const FieldErrors twin = errors(json, "_potential"); any(twin)) row.potential = twin;
  row.reference = json.text("reference");
  return row;
}

BenchCase case_of(const Object& json) {
  BenchCase one;
  one.name = json.text("case");
  one.title = json.text("title");
  one.source = json.text("source");
  one.baseline = json.text("baseline");
  one.nodes = count<std::size_t>(json, "nodes");
  one.contacts = count<std::size_t>(json, "contacts");
  one.unknowns = count<std::size_t>(json, "unknowns");
  one.t_end = json.number_or_zero("t_end");
  one.cpu_setup = json.number_or_zero("cpu_setup_s");
  one.output_times = list<double>(json, "output_times");
  one.unit = json.text("error_unit");
  if (const Json* reference = json.find("reference")) {
    const Object facts(*reference);
    one.reference =
        ReferenceFacts{facts.text("spec"), facts.flag("from_cache"), facts.number_or_zero("cpu_s")};
  }
  if (const Json* sampled = json.find("errors_as_published")) {
    const Object rule(*sampled);
    one.sampled =
        SampledMeasure{rule.text("field"), rule.number_or_zero("every"), rule.number_or_zero("from"),
                       rule.number_or_zero("to"), rule.flag("as_written")};
  }
  one.cpu_joule = json.number("cpu_joule_s");
  if (const Json* rows = json.find("rows"))
    for (const auto& row : *rows) one.rows.push_back(row_of(Object(row)));
  one.warnings = list<std::string>(json, "warnings");
  one.skips = skips(json);
  return one;
}

Json parse(const std::string& path, const std::string& schema) {
  Json json = Json::parse(read_text_file(path), nullptr, /*allow_exceptions=*/false);
  if (json.is_discarded()) throw InputError(fmt::format("{}: it is not JSON; write it anew", path));
  if (!json.is_object() || json.value("schema", "") != schema)
    throw InputError(fmt::format("{}: its schema is not '{}'; give the folder of a result", path, schema));
  if (json.value("schema_version", 0) > newest_schema)
    throw InputError(
        fmt::format("{}: its schema version is newer than {}; update superstep", path, newest_schema));
  return json;
}

// Values of a wrong type are the file's fault.
template <class Read>
auto read_file(const std::string& path, const std::string& schema, Read read) {
  try {
    const Json json = parse(path, schema);
    return read(Object(json));
  } catch (const Json::exception& error) {
    throw InputError(fmt::format("{}: {}; write it anew", path, error.what()));
  }
}

}  // namespace

BenchReport read_results_json(const std::string& path) {
  return read_file(path, "superstep.results", [](const Object& json) {
    BenchReport report;
    report.version = json.text("version");
    report.revision = json.text("revision");
    report.machine = facts(json, "machine");
    report.libraries = facts(json, "libraries");
    report.repetitions = count<int>(json, "repetitions");
    report.threads = count<int>(json, "threads");
    report.interrupted = json.flag("interrupted");
    if (const Json* cases = json.find("cases"))
      for (const auto& one : *cases) report.cases.push_back(case_of(Object(one)));
    return report;
  });
}

RunRecord read_run_json(const std::string& path) {
  return read_file(path, "superstep.run", [](const Object& json) {
    RunRecord run;
    run.version = json.text("version");
    run.revision = json.text("revision");
    run.case_name = json.text("case");
    run.title = json.text("title");
    run.source = json.text("source");
    run.integrator = json.text("integrator");
    run.params = json.text("params");
    run.choice = json.text("choice");
    if (const Json* outcome = json.find("outcome")) {
      run.status = Object(*outcome).text("status");
      run.reason = Object(*outcome).text("reason");
      run.t_reached = Object(*outcome).number_or_zero("t_reached");
    }
    run.t_end = json.number_or_zero("t_end");
    run.nodes = count<std::size_t>(json, "nodes");
    run.contacts = count<std::size_t>(json, "contacts");
    run.unknowns = count<std::size_t>(json, "unknowns");
    run.threads = count<int>(json, "threads");
    if (const Json* counts = json.find("counts")) {
      const Object work(*counts);
      run.steps = count<std::uint64_t>(work, "steps");
      run.rejected = count<std::uint64_t>(work, "rejected");
      run.rhs = count<std::uint64_t>(work, "rhs");
      run.jacobians = count<std::uint64_t>(work, "jacobians");
      run.factorizations = count<std::uint64_t>(work, "factorizations");
      run.solves = count<std::uint64_t>(work, "solves");
      run.max_stages = count<int>(work, "max_stages");
    }
    run.cpu_setup = json.number_or_zero("cpu_setup_s");
    run.cpu_prepare = json.number_or_zero("cpu_prepare_s");
    run.cpu_stepping = json.number_or_zero("cpu_stepping_s");
    run.wall_stepping = json.number_or_zero("wall_stepping_s");
    run.peak_memory_mb = json.number_or_zero("peak_memory_mb");
    run.files = list<std::string>(json, "files");
    run.warnings = list<std::string>(json, "warnings");
    run.skips = skips(json);
    run.machine = facts(json, "machine");
    run.libraries = facts(json, "libraries");
    return run;
  });
}

}  // namespace superstep
