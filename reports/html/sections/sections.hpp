#pragma once
/// The sections of the report; each is markup, or empty when there is nothing to show.

#include <span>
#include <string>
#include <vector>

#include "reports/html/report_input.hpp"

namespace superstep {

/// A field of a case as its columns see it.
struct CaseField {
  std::string name, unit;  ///< "temperature", "K"
  bool twin = false;       ///< in the `_potential` columns
  [[nodiscard]] const FieldErrors* errors(const BenchRow& row) const {
    return twin ? (row.potential ? &*row.potential : nullptr) : &row.errors;
  }
};
[[nodiscard]] std::vector<CaseField> fields_of(const BenchCase& one);

/// Value of a key of a row's parameters as a number; empty when it is not there or not a number.
[[nodiscard]] Number parameter(const BenchRow& row, const std::string& key);

/// Factor and unit that make times up to `t_end` [s] readable.
struct TimeUnit {
  double factor = 1;  ///< of seconds
  std::string name = "s";
};
[[nodiscard]] TimeUnit time_unit(double t_end);

/// Which method for which accuracy: the answer in words and a small table.
[[nodiscard]] std::string answer_section(const CaseInput& input, const std::string& id);
[[nodiscard]] std::string case_section(const CaseInput& input, const std::string& id);
[[nodiscard]] std::string results_section(const CaseInput& input, const std::string& id);
[[nodiscard]] std::string speed_section(const CaseInput& input, const std::string& id);
[[nodiscard]] std::string work_precision_section(const WorkPrecision& study, const std::string& id);
[[nodiscard]] std::string probe_section(const CaseInput& input, const std::string& id);
[[nodiscard]] std::string error_section(const CaseInput& input, const std::string& id);
[[nodiscard]] std::string sts_section(const CaseInput& input, const std::string& id);
/// Published values beside ours, for cases whose source is in reports/published.
[[nodiscard]] std::string paper_section(const CaseInput& input, const std::string& id);
[[nodiscard]] std::string skipped_section(const CaseInput& input, const std::string& id);
[[nodiscard]] std::string stability_section(const StabilityInput& input);
/// Everything about a corpus; the rows must outlive the call.
[[nodiscard]] std::string corpus_article(std::span<const CorpusRow> rows);
/// Presses of several beds: springback over hold and densification.
[[nodiscard]] std::string press_table_article(std::span<const PressTableRow> rows);
[[nodiscard]] std::string runs_section(std::span<const RunInput> runs);
/// Articles of the runs with moving particles, and one that compares them when there are several.
[[nodiscard]] std::string sintering_articles(std::span<const RunInput> runs);
[[nodiscard]] std::string machine_section(const ReportInput& input);

}  // namespace superstep
