#include "bench/app/loaded_case.hpp"

#include <fmt/format.h>

#include "case/checks/warnings.hpp"
#include "core/error.hpp"
#include "core/stopwatch.hpp"
#include "integrators/registry.hpp"

namespace superstep {

LoadedCase load_case(const std::string& file) {
  const double begin = process_cpu_seconds();
  Scene scene = load_scene(file);
  const double cpu_setup = process_cpu_seconds() - begin;
  try {
    check_specs(scene.bench.integrators);
    check_specs({scene.bench.baseline});
  } catch (const UsageError& error) {  // in a case file it is the file that has to be mended
    throw InputError(fmt::format("{}: [bench]: {}", file, error.what()));
  }
  return {std::move(scene), cpu_setup};
}

LoadedCase load_bench_case(const std::string& file) {
  LoadedCase one = load_case(file);
  Scene& scene = one.scene;
  if (const std::string finding = implausible_sizes(scene); !finding.empty())
    throw InputError(finding +
                     "; a benchmark of it would not end: mend length_unit, or run one method with `run`");
  if (!scene.own_output_times) scene.output_times = {0.02 * scene.t_end, 0.1 * scene.t_end, scene.t_end};
  return one;
}

void check_specs(const std::vector<std::string>& specs) {
  for (const auto& spec : specs) (void)make_integrator(spec);
}

}  // namespace superstep
