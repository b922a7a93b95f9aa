#include "bench/app/cli/command_entry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "bench/app/cli/cli_values.hpp"
#include "core/error.hpp"
#include "core/text/text_file.hpp"

// One line per command: its file in bench/app defines `CommandEntry NAME_command()`.
#define SUPERSTEP_COMMANDS(command)                                                                         \
  command(run) command(bench) command(info) command(init) command(stability) command(gate) command(compare) \
      command(fit) command(pack) command(report) command(completion) command(list)

namespace superstep {

#define SUPERSTEP_DECLARE(name) CommandEntry name##_command();
SUPERSTEP_COMMANDS(SUPERSTEP_DECLARE)
#undef SUPERSTEP_DECLARE

std::span<const CommandEntry> command_entries() {
#define SUPERSTEP_ENTRY(name) name##_command(),
  static const std::vector<CommandEntry> entries = {SUPERSTEP_COMMANDS(SUPERSTEP_ENTRY)};
#undef SUPERSTEP_ENTRY
  return entries;
}

OptionEntry integrator_option(const std::string& fallback) {
  return {"--integrator", &Arguments::integrators,
          "one or several integrators, as in A B; default: " + fallback, "SPEC"};
}

OptionEntry time_limit_option(const std::string& fallback) {
  return {"--time-limit", &Arguments::time_limit,
          "wall time [s] that one run of a method may take; it ends with the step, or the factorization, "
          "that it is "
          "in; default: " +
              fallback,
          "SECONDS"};
}

OptionEntry max_work_option() {
  return {"--max-work", &Arguments::max_work,
          "sweeps over the network that one run of a method may take; default: any", "SWEEPS"};
}

RunLimits run_limits(const Arguments& values, double seconds) {
  constexpr double most_sweeps = 1e18;
  RunLimits limits{.seconds = seconds};
  if (!values.time_limit.empty()) limits.seconds = parse_positive_option("--time-limit", values.time_limit);
  if (!values.max_work.empty())
    limits.sweeps = static_cast<std::uint64_t>(
        std::clamp(std::floor(parse_positive_option("--max-work", values.max_work)), 1.0, most_sweeps));
  if (!values.quiet) limits.say = [](const std::string& forecast) { note(forecast); };
  return limits;
}

namespace {

std::size_t parse_block_rows(const std::string& text) {
  constexpr std::int64_t slice = 8, most = std::int64_t{1} << 30;
  if (text.empty()) return 0;
  const auto rows = parse_integer_option("--block-rows", text, slice, most);
  if (rows % slice != 0)
    throw UsageError(fmt::format("--block-rows {} is not valid; it must be a multiple of {}", rows, slice));
  return static_cast<std::size_t>(rows);
}

}  // namespace

void refuse_given(const std::string& command, std::span<const GivenOption> options,
                  const std::string& reason) {
  for (const auto& [given, name] : options)
    if (given) throw UsageError(fmt::format("{}: {} {}", command, name, reason));
}

void refuse_for_moving(const std::string& command, std::span<const GivenOption> options,
                       const std::string& case_file) {
  refuse_given(
      command, options,
      fmt::format("is for networks that stay as they are, and the particles of {} move ([dynamics]); "
                  "leave it out",
                  case_file));
}

CommonOptions common_options(const Arguments& values) {
  return {.threads = static_cast<int>(parse_integer_option("--threads", values.threads, 1, 1024)),
          .block_rows = parse_block_rows(values.block_rows),
          .quiet = values.quiet,
          .json = values.json,
          .color = parse_color_mode(values.color)};
}

const std::string& single_case(const Arguments& values, const std::string& command, const char* what) {
  if (values.cases.empty())
    throw UsageError(fmt::format("{0}: {1} is missing; see superstep {0} --help", command, what));
  if (values.cases.size() > 1)
    throw UsageError(fmt::format("{0}: unexpected argument {1}; see superstep {0} --help", command,
                                 in_quotes(values.cases[1])));
  return values.cases.front();
}

}  // namespace superstep
