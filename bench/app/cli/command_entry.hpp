#pragma once
/// One command of the program: what stands on its command line, and what becomes of that.

#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "bench/app/commands.hpp"

namespace superstep {

/// Every value of the command line as it was written; empty = not given.
struct Arguments {
  std::string command;  ///< "run", "bench", ...; empty when there is only `text` to show
  std::string text;     ///< help or version

  std::string threads = "1", color = "auto", block_rows;
  bool quiet = false, json = false;

  std::vector<std::string> cases, integrators;
  std::string tolerance, out, reference, against, checkpoint, restart, export_packing, baseline, time_limit,
      max_work, corpus;
  std::optional<std::string> repetitions;
  bool no_cache = false, work_precision = false, instructions = false, press_table = false, quick = false,
       report = false, vtk = false, verify = false, markdown = false, keys = false;

  std::string container, lattice, spacing, diameter, width, depth, height, count, relative_density, sizes,
      seed, length_unit = "m", file;

  std::string conductivity, density, specific_heat, axis, neck, periodic, units, file_unit, matrix;
};

/// One option: its names as in "-o,--output", where its value goes, what it means, and how the help calls its
/// value.
struct OptionEntry {
  using Target = std::variant<std::string Arguments::*, bool Arguments::*,
                              std::vector<std::string> Arguments::*, std::optional<std::string> Arguments::*>;
  std::string name;
  Target target;
  std::string meaning, type;
  std::string implied = {};  ///< value where the option stands without one; empty = it must have one
};

/// How many positional arguments a command takes.
struct PositionalCount {
  std::size_t least = 1, most = 1;  ///< most 0 = any number
};

/// One line of the list of commands; its file command_NAME.cpp holds options, help and execution.
struct CommandEntry {
  std::string name, does;
  std::string examples;                        ///< lines "  superstep ..."
  std::string positional, positional_meaning;  ///< "CASE"; empty = the command takes none
  std::vector<OptionEntry> options;
  PositionalCount takes = {};                ///< of the positional
  Command (*make)(const Arguments& values);  ///< throws UsageError in one line
};

/// Every command, in the order of `superstep --help`.
[[nodiscard]] std::span<const CommandEntry> command_entries();

/// The option that several commands share.
[[nodiscard]] OptionEntry integrator_option(const std::string& fallback);

/// The options that bound what a run may cost.
[[nodiscard]] OptionEntry time_limit_option(const std::string& fallback);
[[nodiscard]] OptionEntry max_work_option();
/// What they say; forecasts go to stderr unless `quiet`. Throws UsageError.
///   seconds  where no time limit is given; 0 = none
[[nodiscard]] RunLimits run_limits(const Arguments& values, double seconds);

/// The options of commands that read a packing without a case, and what they say. Throws UsageError.
[[nodiscard]] std::vector<OptionEntry> file_options();
[[nodiscard]] FileOptions file_options_of(const Arguments& values);

/// An option and whether it stands on the line.
struct GivenOption {
  bool given;
  std::string name;
};
/// Throws UsageError for the first that is given: "bench: --json REASON".
void refuse_given(const std::string& command, std::span<const GivenOption> options,
                  const std::string& reason);
/// The same for what needs a network that stays as it is, where the particles of a case file move.
void refuse_for_moving(const std::string& command, std::span<const GivenOption> options,
                       const std::string& case_file);

/// What every command takes. Throws UsageError.
[[nodiscard]] CommonOptions common_options(const Arguments& values);

/// The one positional argument of a command. Throws UsageError when there is none, or another.
[[nodiscard]] const std::string& single_case(const Arguments& values, const std::string& command,
                                             const char* what = "a case file");

}  // namespace superstep
