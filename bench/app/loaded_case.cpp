#include "bench/app/loaded_case.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "case/checks/warnings.hpp"
#include "case/content_hash.hpp"
#include "core/error.hpp"
#include "core/stopwatch.hpp"
#include "core/text/text_file.hpp"
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
  scene.content_hash = content_hash(TomlTable::parse_file(file));
  if (const std::string finding = implausible_sizes(scene); !finding.empty())
    throw InputError(finding +
                     "; a benchmark of it would not end: mend length_unit, or run one method with `run`");
  if (!scene.own_output_times) scene.output_times = {0.02 * scene.t_end, 0.1 * scene.t_end, scene.t_end};
  return one;
}

void require_distinct_names(const std::vector<std::string>& files) {
  std::map<std::string, std::string> file_of;
  for (const auto& file : files) {
    const auto [first, is_new] = file_of.emplace(std::filesystem::path(file).stem().string(), file);
    if (!is_new)
      throw UsageError(
          fmt::format("bench: {} and {} are both named '{}', and results go by the name; rename a file, or "
                      "measure them on their own",
                      superstep::quoted(first->second), superstep::quoted(file), first->first));
  }
}

void check_specs(const std::vector<std::string>& specs) {
  for (const auto& spec : specs) (void)make_integrator(spec);
}

}  // namespace superstep
