/// What every benchmark shares, whatever it measures: who takes part, in which order, within which limits;
/// what repetitions come to; speedups.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "bench/harness/harness.hpp"
#include "core/median.hpp"
#include "core/text/options.hpp"
#include "integrators/method_spec.hpp"
#include "integrators/registry.hpp"

namespace superstep {

std::vector<std::string> contenders(const BenchSettings& bench, const std::vector<std::string>& asked) {
  std::vector<std::string> specs = asked.empty() ? bench.integrators : asked;
  if (specs.empty()) specs = representatives();
  if (std::find(specs.begin(), specs.end(), bench.baseline) == specs.end()) specs.push_back(bench.baseline);
  return specs;
}

BenchCase begin_case(const CaseHead& head) {
  BenchCase one;
  one.name = head.name;
  one.title = head.title;
  one.source = head.source;
  one.baseline = head.bench.baseline;
  one.t_end = head.t_end;
  one.output_times = head.output_times;
  return one;
}

BenchRow begin_row(const BenchCase& one, const std::string& spec, int threads) {
  const Spec parsed = parse_spec(spec);
  BenchRow row;
  row.spec = spec;
  row.case_name = one.name;
  row.integrator = parsed.name;
  row.params = parsed.parameters();
  row.nodes = one.nodes;
  row.contacts = one.contacts;
  row.t_end = one.t_end;
  row.threads = threads;
  return row;
}

Number quotient(double numerator, double denominator) {
  return numerator > 0 && denominator > 0 ? Number(numerator / denominator) : std::nullopt;
}

void compare_with_baseline(BenchCase& one) {
  const auto found = std::find_if(one.rows.begin(), one.rows.end(),
                                  [&](const BenchRow& row) { return row.spec == one.baseline; });
  if (found == one.rows.end() || !found->cpu_total) return;
  const BenchRow baseline = *found;
  for (auto& row : one.rows) {
    if (!row.cpu_total) continue;
    row.speedup_total = quotient(baseline.cpu_total->median, row.cpu_total->median);
    row.speedup_stepping = quotient(baseline.cpu_stepping->median, row.cpu_stepping->median);
    if (baseline.cpu_prepare && row.cpu_prepare)
      row.speedup_prepared = quotient(*baseline.cpu_prepare + baseline.cpu_stepping->median,
                                      *row.cpu_prepare + row.cpu_stepping->median);
  }
}

void warn_of_untold_tolerances(BenchCase& one) {
  const auto untold = [](const FieldErrors& errors) {
    return errors.rms && errors.span.value_or(0) > 0 && !errors.delivered;
  };
  std::vector<std::string> specs;
  for (const auto& row : one.rows)
    if (row.ok() && MethodSpec(row.spec).rtol() > 0 &&
        (untold(row.errors) || (row.potential && untold(*row.potential))))
      specs.push_back(row.spec);
  if (specs.empty() || !one.reference) return;
  one.warnings.push_back(
      fmt::format("the reference {} is not known well enough to tell whether {} {} the tolerance asked for; "
                  "give a tighter --reference, or none",
                  one.reference->spec, fmt::join(specs, ", "), specs.size() == 1 ? "keeps" : "keep"));
}

RunLimits limits_of_reference(const RunLimits& limits) {
  constexpr double longer = 10;  // tight tolerances, twice
  return {.seconds = longer * limits.seconds, .of_cpu = limits.of_cpu, .sweeps = 0, .say = limits.say};
}

std::vector<std::size_t> round_order(std::size_t n, std::size_t round) {
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < n; ++k) order.push_back((k + round) % n);
  return order;
}

Timing summarize(const std::vector<double>& seconds) {
  const auto [least, most] = std::minmax_element(seconds.begin(), seconds.end());
  return {.median = median_of(seconds), .min = *least, .max = *most};
}

}  // namespace superstep
