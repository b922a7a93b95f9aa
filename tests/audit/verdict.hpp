#pragma once
/// What the rows of an audit amount to.

#include <iosfwd>
#include <string>
#include <vector>

#include "audit/audit.hpp"

namespace superstep::audit {

/// One method at one tolerance.
struct Tally {
  std::string label;
  double rtol = 0;
  std::size_t runs = 0;  ///< asked for, without those not run
  std::size_t refused = 0, failed = 0, too_long = 0;
  std::size_t scored = 0;  ///< ended, and there was something to deliver
  std::size_t below_2 = 0, below_3 = 0, above_5 = 0, above_10 = 0, above_10_ok = 0;
  std::size_t far_off_ok = 0;  ///< ok with an error above 10 % of the span
  std::size_t floored = 0;
  std::vector<double> delivered;       ///< ascending
  std::vector<double> of_longer_runs;  ///< of runs of ten steps or more, ascending
  std::vector<double> errors;          ///< over the span, ascending
  std::uint64_t sweeps = 0;
};

/// Tallies in the order of first appearance; `kind` empty = all classes.
[[nodiscard]] std::vector<Tally> tally(const std::vector<Row>& rows, const std::string& kind = {});

/// Value that a part of ascending numbers lies below; NaN of nothing.
[[nodiscard]] double quantile(const std::vector<double>& ascending, double part);

/// A part of a whole in per cent, as tables print it.
[[nodiscard]] std::string percent(std::size_t part, std::size_t whole);

/// Largest over smallest median of a method's longer runs over the tolerances; 1 of nothing.
[[nodiscard]] double trend(const std::vector<Tally>& tallies, const std::string& label);

/// Claims that do not hold, one line each; empty when all do.
[[nodiscard]] std::vector<std::string> broken_claims(const std::vector<Tally>& tallies);

void print_tables(std::ostream& out, const std::vector<Row>& rows, bool by_class);
/// Runs that failed, were refused, took too long or miss by more than ten times, each with its reason.
void print_bad(std::ostream& out, const std::vector<Row>& rows);

}  // namespace superstep::audit
