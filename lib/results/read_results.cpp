#include "results/read_results.hpp"

#include "core/error.hpp"
#include "core/text/options.hpp"
#include "core/text/text_file.hpp"
#include "results/columns.hpp"
#include "results/text/json_object.hpp"

namespace superstep {
namespace {

constexpr int newest_schema = 1;

using Object = JsonObject;

template <class Integer>
Integer count(const Object& object, const char* key) {
  return object.count<Integer>(key).value_or(0);
}

std::vector<Fact> facts(const Object& object, const char* key) {
  std::vector<Fact> out;
  if (const auto described = object.object(key))
    for (const auto& [name, ignored] : described->json().items())
      out.push_back({name, described->text(name)});
  return out;
}

std::vector<SkippedWork> skips(const Object& object) {
  std::vector<SkippedWork> out;
  for (const auto& skip : object.objects("skips")) out.push_back({skip.text("what"), skip.text("because")});
  return out;
}

std::optional<Timing> timing(const Object& row, const char* key) {
  const auto spread = row.object("spread");
  const auto one = spread ? spread->object(key) : std::nullopt;
  if (!one) return std::nullopt;
  return Timing{one->number_or_zero("median"), one->number_or_zero("min"), one->number_or_zero("max")};
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
  try {
    (void)parse_spec(row.spec);
  } catch (const UsageError& error) {  // nobody typed it: it is the file that has to be mended
    json.reject(row.params.empty() ? "integrator" : "params", error.what());
  }
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
  one.output_times = json.numbers("output_times");
  one.unit = json.text("error_unit");
  if (const auto facts = json.object("reference"))
    one.reference =
        ReferenceFacts{facts->text("spec"), facts->flag("from_cache"), facts->number_or_zero("cpu_s")};
  if (const auto rule = json.object("errors_as_published"))
    one.sampled =
        SampledMeasure{rule->text("field"), rule->number_or_zero("every"), rule->number_or_zero("from"),
                       rule->number_or_zero("to"), rule->flag("as_written")};
  one.cpu_joule = json.number("cpu_joule_s");
  for (const auto& row : json.objects("rows")) one.rows.push_back(row_of(row));
  one.warnings = json.texts("warnings");
  one.skips = skips(json);
  return one;
}

}  // namespace

BenchReport read_results_json(const std::string& path) {
  const auto parsed = parse_results(path, "superstep.results", newest_schema);
  const Object json(path, parsed);
  BenchReport report;
  report.version = json.text("version");
  report.revision = json.text("revision");
  report.machine = facts(json, "machine");
  report.libraries = facts(json, "libraries");
  report.repetitions = count<int>(json, "repetitions");
  report.threads = count<int>(json, "threads");
  report.interrupted = json.flag("interrupted");
  for (const auto& one : json.objects("cases")) report.cases.push_back(case_of(one));
  return report;
}

RunRecord read_run_json(const std::string& path) {
  const auto parsed = parse_results(path, "superstep.run", newest_schema);
  const Object json(path, parsed);
  RunRecord run;
  run.version = json.text("version");
  run.revision = json.text("revision");
  run.case_name = json.text("case");
  run.title = json.text("title");
  run.source = json.text("source");
  run.integrator = json.text("integrator");
  run.params = json.text("params");
  run.choice = json.text("choice");
  if (const auto outcome = json.object("outcome")) {
    run.status = outcome->text("status");
    run.reason = outcome->text("reason");
    run.t_reached = outcome->number_or_zero("t_reached");
  }
  run.t_end = json.number_or_zero("t_end");
  run.nodes = count<std::size_t>(json, "nodes");
  run.contacts = count<std::size_t>(json, "contacts");
  run.unknowns = count<std::size_t>(json, "unknowns");
  run.threads = count<int>(json, "threads");
  if (const auto counts = json.object("counts")) {
    const Object& work = *counts;
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
  run.files = json.texts("files");
  run.warnings = json.texts("warnings");
  run.skips = skips(json);
  run.machine = facts(json, "machine");
  run.libraries = facts(json, "libraries");
  return run;
}

}  // namespace superstep
