#include "bench/app/loaded_case.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <utility>

#include "bench/host/progress.hpp"
#include "bench/host/terminal.hpp"
#include "bench/measure/shared/shared_parts.hpp"
#include "case/checks/warnings.hpp"
#include "case/content_hash.hpp"
#include "core/error.hpp"
#include "core/stopwatch.hpp"
#include "core/text/options.hpp"
#include "core/text/text_file.hpp"
#include "integrators/method_spec.hpp"

namespace superstep {

namespace {

/// `begin` [s]: CPU time before the file was parsed.
LoadedCase load(TomlTable root, double begin, bool quiet) {
  LoadedCase one{.content = load_case_watched(std::move(root), quiet)};
  one.cpu_setup = process_cpu_seconds() - begin;
  check_specs_of(one.head());
  return one;
}

}  // namespace

Case load_case_watched(TomlTable root, bool quiet) {
  Progress progress(!quiet && stderr_is_terminal());
  bool begun = false;
  return load_case(std::move(root), [&](double part) {
    if (!begun) progress.begin("placing particles", 1);
    begun = true;
    progress.reached(part);
  });
}

void check_specs_of(const CaseHead& head) {
  for (const auto& stated : head.stated_specs) try {
      check_specs({stated.spec});
    } catch (const UsageError& error) {
      throw InputError(fmt::format("{}: {}", stated.where, error.what()));
    }
}

void prepare_for_bench(Scene& scene, const TomlTable& root) {
  scene.content_hash = content_hash(root);
  if (const std::string finding = implausible_sizes(scene); !finding.empty())
    throw InputError(finding +
                     "; a benchmark of it would not end: mend length_unit, or run one method with `run`");
  if (!scene.own_output_times) scene.output_times = {0.02 * scene.t_end, 0.1 * scene.t_end, scene.t_end};
}

LoadedCase load_checked_case(const std::string& file, bool quiet) {
  const double begin = process_cpu_seconds();
  return load(parse_case(file), begin, quiet);
}

LoadedCase load_case_to_run(const std::string& file, bool quiet) {
  const double begin = process_cpu_seconds();
  TomlTable root = parse_case(file);
  auto scene = share_in_parts(file, quiet);
  if (!scene) return load(std::move(root), begin, quiet);
  LoadedCase one{.content = std::move(*scene)};
  one.cpu_setup = process_cpu_seconds() - begin;
  check_specs_of(one.head());
  return one;
}

LoadedCase load_bench_case(const std::string& file, bool quiet) {
  const double begin = process_cpu_seconds();
  const TomlTable root = parse_case(file);
  LoadedCase one = load(root, begin, quiet);
  if (auto* scene = std::get_if<Scene>(&one.content)) prepare_for_bench(*scene, root);
  return one;
}

const Scene& scene_of(const Case& one, const std::string& command) {
  if (const auto* scene = std::get_if<Scene>(&one)) return *scene;
  throw InputError(
      fmt::format("{}: its particles move ([dynamics]), and {} needs a network that stays as it is",
                  head_of(one).file, command));
}

void require_distinct_names(const std::vector<std::string>& files) {
  std::map<std::string, std::string> file_of;
  for (const auto& file : files) {
    const auto [first, is_new] = file_of.emplace(std::filesystem::path(file).stem().string(), file);
    if (!is_new)
      throw UsageError(
          fmt::format("bench: {} and {} are both named '{}', and results go by the name; rename a file, or "
                      "measure them on their own",
                      superstep::in_quotes(first->second), superstep::in_quotes(file), first->first));
  }
}

void require_distinct_specs(const std::vector<std::string>& specs) {
  if (const auto twice = repeated_spec(specs); !twice.empty())
    throw UsageError(fmt::format("{} stands twice among the integrators; leave one of the two out",
                                 superstep::in_quotes(twice)));
}

void check_specs(const std::vector<std::string>& specs) {
  require_distinct_specs(specs);
  for (const auto& spec : specs) (void)MethodSpec(spec);
}

}  // namespace superstep
