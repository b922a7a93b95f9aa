#include "results/answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace superstep {
namespace {

/// Below its error bar a reference cannot tell how large an error is.
bool can_be_told(const BenchRow& row, double level) {
  const auto known = [&](const FieldErrors& errors) {
    return !errors.reference_error || *errors.reference_error <= level * errors.span.value_or(0) ||
           !(errors.span.value_or(0) > 0);
  };
  return known(row.errors) && (!row.potential || known(*row.potential));
}

bool within(const BenchRow& row, double level) {
  const auto error = relative_error(row);
  return row.ok() && error && *error <= level && can_be_told(row, level);
}

/// The fastest repetition of one is no slower than the slowest of the other. One repetition has no spread,
/// and tells what is clearly slower alone.
bool cannot_be_told_apart(const BenchRow& best, const BenchRow& other) {
  constexpr double clearly = 1.1;  // as in a corpus
  if (!best.cpu_stepping || !other.cpu_stepping) return false;
  const double own = best.cpu_prepare.value_or(0) + best.cpu_stepping->max,
               its = other.cpu_prepare.value_or(0) + other.cpu_stepping->min;
  return own * (std::min(best.repetitions, other.repetitions) > 1 ? 1 : clearly) >= its;
}

const BenchRow* cvode_with_klu(const BenchCase& one) {
  const BenchRow* best = nullptr;
  for (const auto& row : one.rows)
    if (row.integrator == "cvode" && row.params.find("linsol=klu") != std::string::npos &&
        prepared_cpu(row) && (!best || *prepared_cpu(row) < *prepared_cpu(*best)))
      best = &row;
  return best;
}

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (std::size_t k = 0; k < words.size(); ++k)
    out += (k == 0 ? "" : k + 1 == words.size() ? " and " : ", ") + words[k];
  return out;
}

/// By how much the best one leads, and which others are as good.
std::string lead_text(const BenchCase& one, const BenchRow& best, double level) {
  std::vector<std::string> slower, tied;
  const auto is_tied = [&](const BenchRow& row) {
    return &row != &best && within(row, level) && cannot_be_told_apart(best, row);
  };
  const auto compare = [&](const BenchRow& row) {
    if (&row == &best || is_tied(row) || !(*prepared_cpu(best) > 0)) return;
    const double ratio = *prepared_cpu(row) / *prepared_cpu(best);
    if (ratio > 1) slower.push_back(fmt::format("{:.3g} times faster than {}", ratio, row.spec));
  };
  const BenchRow* klu = cvode_with_klu(one);
  for (const auto& row : one.rows)
    if (row.spec == one.baseline && prepared_cpu(row)) compare(row);
  if (klu && klu->spec != one.baseline) compare(*klu);
  for (const auto& row : one.rows)
    if (is_tied(row)) tied.push_back(row.spec);
  std::string out;
  if (!slower.empty()) out += ", " + joined(slower);
  if (!tied.empty()) out += fmt::format("; {} cannot be told apart from it in this run", joined(tied));
  return out;
}

/// Why no method is the fastest with an error up to `level`.
std::string nobody_text(const BenchCase& one, double level) {
  const auto any = [&](const auto& of) { return std::any_of(one.rows.begin(), one.rows.end(), of); };
  const double percent = 100 * level;
  if (any([&](const BenchRow& row) { return within(row, level); }))
    return fmt::format("No method that kept its error below {:g} % of the span was timed.", percent);
  if (any([&](const BenchRow& row) { return row.ok() && !can_be_told(row, level); }))
    return fmt::format("The reference cannot tell which method kept its error below {:g} % of the span.",
                       percent);
  return fmt::format("No method kept its error below {:g} % of the span.", percent);
}

}  // namespace

Number prepared_cpu(const BenchRow& row) {
  if (!row.cpu_stepping) return std::nullopt;
  return row.cpu_prepare.value_or(0) + row.cpu_stepping->median;
}

Number relative_error(const BenchRow& row) {
  Number error = row.errors.relative_rms;
  if (error && row.potential && row.potential->relative_rms)
    error = std::max(*error, *row.potential->relative_rms);
  return error;
}

const BenchRow* fastest_within(const BenchCase& one, double level) {
  const BenchRow* best = nullptr;
  for (const auto& row : one.rows)
    if (within(row, level) && prepared_cpu(row) && (!best || *prepared_cpu(row) < *prepared_cpu(*best)))
      best = &row;
  return best;
}

std::string answer_text(const BenchCase& one) {
  const auto any = [&](const auto& of) { return std::any_of(one.rows.begin(), one.rows.end(), of); };
  if (any([](const BenchRow& row) { return row.ok(); }) &&
      !any([](const BenchRow& row) { return prepared_cpu(row).has_value(); }))
    return "No method was timed, so that none is the fastest.";
  if (!any([](const BenchRow& row) { return relative_error(row).has_value(); })) return "";
  std::string out;
  for (const double level : {1e-3, 1e-2, 1e-1}) {
    if (const BenchRow* best = fastest_within(one, level))
      return out + fmt::format(
                       "Fastest with an error below {:g} % of the span: {} takes {:.3g} s of CPU, "
                       "preparation included{}.",
                       100 * level, best->spec, *prepared_cpu(*best), lead_text(one, *best, level));
    if (out.empty()) out = nobody_text(one, level) + " ";
  }
  return nobody_text(one, 1e-1);
}

}  // namespace superstep
