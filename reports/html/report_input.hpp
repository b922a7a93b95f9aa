#pragma once
/// Everything that a folder of results holds, read for its report.

#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "results/corpus/corpus_row.hpp"
#include "results/motion_input.hpp"
#include "results/press/press_table.hpp"
#include "results/results.hpp"
#include "results/study/work_precision.hpp"
#include "results/text/csv_table.hpp"

namespace superstep {

/// One case of a benchmark with what else is known about it.
struct CaseInput {
  BenchCase bench;                               ///< its observations filled in
  std::optional<nlohmann::ordered_json> health;  ///< what `superstep info --json` says
  std::optional<WorkPrecision> work_precision;
};

/// One folder of `superstep run`.
struct RunInput {
  std::string folder;  ///< name inside the folder of the report; "." = that folder itself
  RunRecord record;
  std::vector<ProbeCurve> curves;
  std::optional<Slice> slice;         ///< the final fields of a fixed network
  std::optional<MotionInput> motion;  ///< of moving particles
};

/// The files of `superstep stability --out`.
struct StabilityInput {
  std::optional<nlohmann::ordered_json> summary;            ///< stability.json
  std::map<std::string, std::unique_ptr<CsvTable>> tables;  ///< by name: methods, critical_step, ...
};

struct ReportInput {
  std::string folder;
  std::optional<BenchReport> bench;  ///< its cases have moved into `cases`
  std::vector<CaseInput> cases;
  std::vector<WorkPrecision> other_studies;  ///< of cases that the benchmark does not hold
  std::optional<StabilityInput> stability;
  std::vector<RunInput> runs;
  std::vector<CorpusRow> corpus;           ///< of `superstep bench --corpus`
  std::vector<PressTableRow> press_table;  ///< of `superstep bench --press-table`
};

/// Throws InputError when the folder holds no results, or broken ones.
[[nodiscard]] ReportInput read_report_input(const std::string& folder);

}  // namespace superstep
