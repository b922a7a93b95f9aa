#pragma once
/// Parts of the section that shows published values beside ours; each is markup, or empty.

#include <string>

#include "reports/html/html_parts.hpp"
#include "reports/html/published.hpp"
#include "reports/html/sections/sections.hpp"

namespace superstep {

/// Our run with the same n and nu, found by its SPEC; the baseline stands for forward Euler. Runs that
/// evaluate the Joule heat at every substep (heat=substep) are found only when asked for.
[[nodiscard]] const BenchRow* our_run(const BenchCase& one, const PublishedRun& published,
                                      bool heat_every_substep = false);

/// "nu = 1e-3, N = 10", or "forward Euler".
[[nodiscard]] HtmlTable::Cell published_name(const PublishedRun& run);
/// Ours over the published value; empty without both.
[[nodiscard]] HtmlTable::Cell ratio_cell(const Number& ours, const Number& published);

/// Errors at the probe: by the rule of the published table, and true ones.
///   lambda_min  published slowest rate of the network [1/s]; may be empty
[[nodiscard]] std::string paper_errors(const BenchCase& one, const PublishedCase& published,
                                       const CaseField& field, const Number& lambda_min);
[[nodiscard]] std::string paper_error_figure(const BenchCase& one, const PublishedCase& published,
                                             const CaseField& field, const std::string& id);

/// Substeps, CPU times and speedups.
[[nodiscard]] std::string paper_performance(const BenchCase& one, const PublishedCase& published);
[[nodiscard]] std::string paper_speedup_figure(const BenchCase& one, const PublishedCase& published,
                                               const std::string& id);

}  // namespace superstep
