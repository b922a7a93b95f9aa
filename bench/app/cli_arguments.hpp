#pragma once
/// The shape of the command line: commands, options, help texts. CLI11 2.1.2 misreads numbers ("-5" for an
/// unsigned, '' as 0), so it only ever sees strings; cli.cpp makes numbers of them.

#include <optional>
#include <string>
#include <vector>

#include "bench/app/completion.hpp"

namespace superstep {

/// Every value of the command line as it was written; empty = not given.
struct Arguments {
  std::string command;  ///< "run", "bench", ...; empty when there is only `text` to show
  std::string text;     ///< help or version

  std::string threads = "1", color = "auto";
  bool quiet = false, json = false;

  std::vector<std::string> cases, integrators;
  std::string tolerance, out, reference, against, checkpoint, restart, baseline;
  std::optional<std::string> repetitions;
  bool no_cache = false, work_precision = false, quick = false, report = false, vtk = false, verify = false,
       markdown = false;

  std::string container = "cylinder", diameter, width, depth, height, count, relative_density, sizes,
              seed = "1", length_unit = "m", file;
};

/// Arguments without the program's name. Throws UsageError for unknown commands and options and for empty
/// values.
[[nodiscard]] Arguments read_arguments(const std::vector<std::string>& line);

/// Commands and options, as a shell completes them.
[[nodiscard]] std::vector<CommandShape> command_shapes();

}  // namespace superstep
