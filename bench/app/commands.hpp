#pragma once
/// The commands of the program as plain structs: the command line fills them, `execute` carries them out.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bench/harness/harness.hpp"
#include "bench/harness/work_precision.hpp"
#include "bench/host/terminal.hpp"
#include "packing/generate.hpp"

namespace superstep {

struct CommonOptions {
  int threads = 1;
  std::size_t block_rows = 0;  ///< rows that processes share out together; 0 = as many as usual
  bool quiet = false;          ///< stderr carries errors only
  bool json = false;           ///< stdout is machine-readable
  ColorMode color = ColorMode::automatic;
};

struct RunCommand {
  CommonOptions common;
  std::string case_file;
  std::vector<std::string> integrators;  ///< SPECs; empty = auto
  std::optional<double> tolerance;       ///< replaces rtol of every SPEC
  std::string out;                       ///< folder; empty = default_output_folder
  bool verify = false;                   ///< run again by another method, ten times tighter, and compare
  bool vtk = false;                      ///< write particles and contacts for ParaView
  std::optional<double> checkpoint;      ///< simulated time between checkpoints [s]; moving particles only
  std::string restart;                   ///< checkpoint to go on from; empty = none; moving particles only
  RunLimits limits;                      ///< of each run
};

struct BenchCommand {
  CommonOptions common;
  std::vector<std::string> case_files;
  HarnessOptions harness;
  std::string out;      ///< folder; empty = default_output_folder
  bool report = false;  ///< write report.html as well
};

/// superstep bench --work-precision
struct WorkPrecisionCommand {
  CommonOptions common;
  std::vector<std::string> case_files;
  WorkPrecisionOptions options;
  std::string out;      ///< folder; empty = default_output_folder
  bool report = false;  ///< write report.html as well
};

struct InfoCommand {
  CommonOptions common;
  std::string case_file;
};

struct StabilityCommand {
  CommonOptions common;
  std::string case_file;
  std::string out;     ///< folder for CSV files; empty = none are written
  bool quick = false;  ///< coarser sets of parameters
};

struct GateCommand {
  CommonOptions common;
  std::string results, baseline;  ///< results.json, or a folder that holds it
};

struct CompareCommand {
  CommonOptions common;
  std::string a, b;
};

struct PackCommand {
  CommonOptions common;
  PackSettings settings;
  std::string file;
};

struct ListCommand {
  CommonOptions common;
  bool keys = false;  ///< those of case files
};

/// superstep report
struct ReportCommand {
  CommonOptions common;
  std::string folder;
  bool markdown = false;  ///< print a summary
  std::string against;    ///< folder of an earlier benchmark that the summary compares with; may be empty
};

/// superstep completion
struct CompletionCommand {
  CommonOptions common;
  std::string shell;
};

/// --help and --version.
struct ShowText {
  std::string text;
};

using Command =
    std::variant<RunCommand, BenchCommand, WorkPrecisionCommand, InfoCommand, StabilityCommand, GateCommand,
                 CompareCommand, PackCommand, ListCommand, ReportCommand, CompletionCommand, ShowText>;

/// Each returns the exit code and throws `Error` for what the user has to mend.
int execute(const RunCommand& command);
int execute(const BenchCommand& command);
int execute(const WorkPrecisionCommand& command);
int execute(const InfoCommand& command);
int execute(const StabilityCommand& command);
int execute(const GateCommand& command);
int execute(const CompareCommand& command);
int execute(const PackCommand& command);
int execute(const ListCommand& command);
int execute(const ReportCommand& command);
int execute(const CompletionCommand& command);
int execute(const ShowText& command);

}  // namespace superstep
