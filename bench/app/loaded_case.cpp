#include "bench/app/loaded_case.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <map>

#include "case/checks/warnings.hpp"
#include "case/content_hash.hpp"
#include "core/error.hpp"
#include "core/stopwatch.hpp"
#include "core/text/text_file.hpp"
#include "core/text/toml.hpp"
#include "integrators/registry.hpp"

namespace superstep {

namespace {

/// SPECs out of a case file: what is wrong with them is the file's fault, at its line.
void check_specs_of(const Scene& scene) {
  const auto check = [&](const std::vector<std::string>& specs, const char* key) {
    try {
      check_specs(specs);
    } catch (const UsageError& error) {
      TomlTable root = TomlTable::parse_file(scene.file);
      TomlTable bench = *root.table("bench");
      throw InputError(fmt::format("{}: {}", bench.require(key, "").where(), error.what()));
    }
  };
  check(scene.bench.integrators, "integrators");
  check({scene.bench.baseline}, "baseline");
}

}  // namespace

LoadedCase load_case(const std::string& file) {
  const double begin = process_cpu_seconds();
  Scene scene = load_scene(file);
  const double cpu_setup = process_cpu_seconds() - begin;
  check_specs_of(scene);
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
