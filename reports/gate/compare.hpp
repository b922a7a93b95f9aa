#pragma once
/// Two sets of results side by side.

#include <optional>
#include <string>
#include <vector>

#include "reports/gate/results_file.hpp"

namespace superstep {

/// One method on one case, in both.
struct ComparedRow {
  std::string case_name, spec, status_a, status_b;
  std::optional<RatioInterval> time;        ///< CPU of stepping, B over A; empty = fewer than two rounds
  bool in_yardsticks = false;               ///< each in units of the yardstick of its own rounds
  std::optional<double> work, error;        ///< network sweeps and rms error, B over A
  [[nodiscard]] const char* words() const;  ///< "B is faster", "B is slower" or "no clear difference"
};

/// Rows that both have, in A's order.
[[nodiscard]] std::vector<ComparedRow> compare(const ResultsFile& a, const ResultsFile& b);

[[nodiscard]] std::string compare_markdown(const ResultsFile& a, const ResultsFile& b,
                                           const std::vector<ComparedRow>& rows);

}  // namespace superstep
