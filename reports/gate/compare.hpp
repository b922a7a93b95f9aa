#pragma once
/// Two sets of results side by side.

#include <optional>
#include <string>
#include <vector>

#include "reports/gate/results_file.hpp"
#include "reports/gate/timing_rule.hpp"

namespace superstep {

/// One method on one case, in both.
struct ComparedRow {
  std::string case_name, spec, status_a, status_b;
  std::optional<RatioInterval> time;        ///< CPU of stepping, B over A; empty = one of them was not timed
  std::optional<TimingDoubt::Kind> doubt;   ///< why the interval tells nothing; empty = it does
  bool in_yardsticks = false;               ///< each in units of the yardstick of its own rounds
  std::optional<double> work, error;        ///< network sweeps and rms error, B over A
  [[nodiscard]] const char* words() const;  ///< "B is faster", "B is slower", or why neither
};

/// Rows that both have, in A's order. Faster and slower are what they are to the gate.
[[nodiscard]] std::vector<ComparedRow> compare(const ResultsFile& a, const ResultsFile& b);

/// The rows as a table; what stands in one of them only is named below it.
[[nodiscard]] std::string compare_markdown(const ResultsFile& a, const ResultsFile& b,
                                           const std::vector<ComparedRow>& rows);

}  // namespace superstep
