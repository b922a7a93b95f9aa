#pragma once
/// The commands of the program as plain structs: the command line fills them, `execute` carries them out.

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "bench/harness/corpus/corpus_sweep.hpp"
#include "bench/harness/harness.hpp"
#include "bench/harness/work_precision.hpp"
#include "bench/host/terminal.hpp"
#include "packing/generate.hpp"
#include "packing/lattice.hpp"
#include "packing/read_options.hpp"

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
  std::string export_packing;  ///< packing file to write at the end; empty = none; moving particles only
  std::string restart;         ///< checkpoint to go on from; empty = none; moving particles only
  RunLimits limits;            ///< of each run
};

struct BenchCommand {
  CommonOptions common;
  bool press_table = false;  ///< springback over hold and densification instead
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

/// What the command line says about a packing file and its material, instead of a case.
struct FileOptions {
  PackingOptions reading;
  std::string length_unit;  ///< as it was given; empty = not
  char axis = 0;            ///< 'x', 'y', 'z'; 0 = the longest open one
  std::string neck;         ///< law; empty = hertz
  std::optional<double> conductivity, density, specific_heat;
  std::vector<std::string> given;  ///< names of the options that stand on the line
};

/// superstep bench --corpus
struct CorpusCommand {
  CommonOptions common;
  std::string corpus;  ///< a set, or a folder of cases
  CorpusOptions options;
  std::string out;        ///< folder; empty = default_output_folder
  bool report = false;    ///< write report.html as well
  bool markdown = false;  ///< tables in Markdown
};

struct InfoCommand {
  CommonOptions common;
  std::string case_file;  ///< or a packing or network file
  FileOptions file;
  std::string matrix;  ///< folder that the system is written to; empty = none
};

/// superstep init
struct InitCommand {
  CommonOptions common;
  std::string packing_file, case_file;
  FileOptions file;
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

/// superstep fit
struct FitCommand {
  CommonOptions common;
  std::vector<std::string> files;  ///< corpus.csv
  std::string header;              ///< that constants are written to; empty = none
};

struct PackCommand {
  CommonOptions common;
  PackSettings settings;
  std::optional<Lattice> lattice;  ///< instead of a container that is filled
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

using Command = std::variant<RunCommand, BenchCommand, WorkPrecisionCommand, CorpusCommand, InfoCommand,
                             InitCommand, StabilityCommand, GateCommand, CompareCommand, FitCommand,
                             PackCommand, ListCommand, ReportCommand, CompletionCommand, ShowText>;

/// Each returns the exit code and throws `Error` for what the user has to mend.
int execute(const RunCommand& command);
int execute(const BenchCommand& command);
int execute(const WorkPrecisionCommand& command);
int execute(const CorpusCommand& command);
int execute(const InfoCommand& command);
int execute(const InitCommand& command);
int execute(const StabilityCommand& command);
int execute(const GateCommand& command);
int execute(const CompareCommand& command);
int execute(const FitCommand& command);
int execute(const PackCommand& command);
int execute(const ListCommand& command);
int execute(const ReportCommand& command);
int execute(const CompletionCommand& command);
int execute(const ShowText& command);

}  // namespace superstep
