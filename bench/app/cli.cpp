#include "bench/app/cli.hpp"

#include <fmt/format.h>

#include <limits>
#include <optional>

#include "bench/app/cli_arguments.hpp"
#include "bench/app/cli_values.hpp"
#include "core/error.hpp"
#include "core/text/suggest.hpp"
#include "core/text/text_file.hpp"

namespace superstep {
namespace {

constexpr std::int64_t unlimited = std::numeric_limits<std::int64_t>::max();

CommonOptions common_options(const Arguments& values) {
  return {.threads = static_cast<int>(parse_integer_option("--threads", values.threads, 1, 1024)),
          .quiet = values.quiet,
          .json = values.json,
          .color = parse_color_mode(values.color)};
}

const std::string& single_case(const Arguments& values, const std::string& command) {
  if (values.cases.empty())
    throw UsageError(fmt::format("{0}: a case file is missing; see superstep {0} --help", command));
  if (values.cases.size() > 1)
    throw UsageError(fmt::format("{0}: unexpected argument {1}; see superstep {0} --help", command,
                                 quoted(values.cases[1])));
  return values.cases.front();
}

Command make_run(const Arguments& values) {
  RunCommand command{.common = common_options(values),
                     .case_file = single_case(values, "run"),
                     .integrators = values.integrators,
                     .tolerance = std::nullopt,
                     .out = values.out,
                     .verify = values.verify,
                     .vtk = values.vtk,
                     .checkpoint = std::nullopt,
                     .restart = values.restart};
  if (!values.tolerance.empty()) command.tolerance = parse_positive_option("--tolerance", values.tolerance);
  if (!values.checkpoint.empty())
    command.checkpoint = parse_positive_option("--checkpoint", values.checkpoint);
  return command;
}

int repetitions_of(const Arguments& values, int fallback) {
  if (!values.repetitions) return fallback;
  return static_cast<int>(parse_integer_option("--repetitions", *values.repetitions, 1, 10000));
}

Command make_work_precision(const Arguments& values) {
  if (values.json) throw UsageError("bench: --work-precision writes CSV and a table; leave --json out");
  if (values.reference == "none")
    throw UsageError("bench: --work-precision needs a reference; leave --reference none out");
  WorkPrecisionCommand command;
  command.common = common_options(values);
  command.case_files = values.cases;
  command.out = values.out;
  command.report = values.report;
  command.options.integrators = values.integrators;
  command.options.reference = values.reference;
  command.options.use_cache = !values.no_cache;
  command.options.repetitions = repetitions_of(values, 1);
  return command;
}

Command make_bench(const Arguments& values) {
  if (values.cases.empty()) throw UsageError("bench: a case file is missing; see superstep bench --help");
  if (values.work_precision) return make_work_precision(values);
  BenchCommand command;
  command.common = common_options(values);
  command.case_files = values.cases;
  command.out = values.out;
  command.report = values.report;
  command.harness.integrators = values.integrators;
  if (!values.reference.empty()) command.harness.reference = values.reference;
  command.harness.use_cache = !values.no_cache;
  command.harness.repetitions = repetitions_of(values, command.harness.repetitions);
  return command;
}

Command make_stability(const Arguments& values) {
  return StabilityCommand{.common = common_options(values),
                          .case_file = single_case(values, "stability"),
                          .out = values.out,
                          .quick = values.quick};
}

Command make_gate(const Arguments& values) {
  if (values.cases.size() != 1)
    throw UsageError("gate: give one results.json, or the folder that holds it; see superstep gate --help");
  if (values.baseline.empty())
    throw UsageError("gate: --baseline FILE is missing; see superstep gate --help");
  return GateCommand{common_options(values), values.cases.front(), values.baseline};
}

Command make_compare(const Arguments& values) {
  if (values.cases.size() != 2)
    throw UsageError(
        "compare: give two results.json or folders that hold them; see superstep compare --help");
  if (values.json) throw UsageError("compare: writes a Markdown table; leave --json out");
  return CompareCommand{common_options(values), values.cases[0], values.cases[1]};
}

Container container_of(const Arguments& values, double unit) {
  const auto length = [&](const char* option, const std::string& text) {
    if (text.empty()) throw UsageError(fmt::format("pack: {} is missing for a {}", option, values.container));
    return unit * parse_positive_option(option, text);
  };
  Container container;
  container.height = length("--height", values.height);
  if (values.container == "cylinder") {
    if (!values.width.empty() || !values.depth.empty())
      throw UsageError("pack: --width and --depth belong to a box; a cylinder has --diameter");
    container.diameter = length("--diameter", values.diameter);
  } else if (values.container == "box") {
    if (!values.diameter.empty())
      throw UsageError("pack: --diameter belongs to a cylinder; a box has --width, --depth");
    container.shape = Container::Shape::box;
    container.width = length("--width", values.width);
    container.depth = length("--depth", values.depth);
  } else {
    const std::vector<std::string> shapes = {"cylinder", "box"};
    throw UsageError(fmt::format("--container {} is not valid{}", quoted(values.container),
                                 suggestion(values.container, shapes)));
  }
  return container;
}

Command make_pack(const Arguments& values) {
  PackCommand command{.common = common_options(values), .settings = {}, .file = values.file};
  if (command.file.empty()) throw UsageError("pack: -o FILE is missing; see superstep pack --help");
  if (values.sizes.empty()) throw UsageError("pack: --sizes is missing; see superstep pack --help");
  const double unit = parse_length_unit(values.length_unit);
  PackSettings& settings = command.settings;
  settings.container = container_of(values, unit);
  settings.sizes = parse_sizes(values.sizes, unit);
  if (!values.relative_density.empty())
    settings.relative_density = parse_positive_option("--relative-density", values.relative_density);
  if (!values.count.empty())
    settings.count = static_cast<std::size_t>(parse_integer_option("--count", values.count, 1, unlimited));
  settings.seed = static_cast<std::uint64_t>(parse_integer_option("--seed", values.seed, 0, unlimited));
  return command;
}

Command make_report(const Arguments& values) {
  if (values.cases.empty())
    throw UsageError("report: a folder of results is missing; see superstep report --help");
  if (!values.against.empty() && !values.markdown)
    throw UsageError("report: --against goes with --markdown; add that, or leave it out");
  if (values.markdown && values.json)
    throw UsageError("report: --markdown and --json both want stdout; choose one");
  return ReportCommand{.common = common_options(values),
                       .folder = single_case(values, "report"),
                       .markdown = values.markdown,
                       .against = values.against};
}

Command make_completion(const Arguments& values) {
  if (values.cases.empty()) throw UsageError("completion: the shell is missing: bash, zsh or fish");
  return CompletionCommand{.common = common_options(values), .shell = single_case(values, "completion")};
}

}  // namespace

Command parse_command_line(const std::vector<std::string>& arguments) {
  const Arguments values = read_arguments(arguments);
  if (values.command == "run") return make_run(values);
  if (values.command == "bench") return make_bench(values);
  if (values.command == "info") return InfoCommand{common_options(values), single_case(values, "info")};
  if (values.command == "stability") return make_stability(values);
  if (values.command == "gate") return make_gate(values);
  if (values.command == "compare") return make_compare(values);
  if (values.command == "pack") return make_pack(values);
  if (values.command == "report") return make_report(values);
  if (values.command == "completion") return make_completion(values);
  if (values.command == "list") return ListCommand{common_options(values)};
  return ShowText{values.text};
}

}  // namespace superstep
