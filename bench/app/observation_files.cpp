#include "bench/app/observation_files.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "bench/output/output_folder.hpp"
#include "case/checks/health.hpp"
#include "core/atomic_file.hpp"
#include "reports/text/health_report.hpp"
#include "results/observations_csv.hpp"
#include "results/text/json_object.hpp"

namespace superstep {
namespace {

std::string all_health(std::span<const BenchCase> cases, std::span<const LoadedCase> loaded) {
  using Json = nlohmann::ordered_json;
  Json out = {{"schema", "superstep.health"}, {"schema_version", 1}, {"cases", Json::array()}};
  for (std::size_t k = 0; k < cases.size(); ++k)
    if (const auto* scene = std::get_if<Scene>(&loaded[k].content))
      out["cases"].push_back(Json::parse(health_json(*scene, assess_network(*scene))));
  return json_text(out);
}

template <class Seen>
bool any_case(const BenchReport& report, Seen seen) {
  return std::any_of(report.cases.begin(), report.cases.end(),
                     [&](const BenchCase& one) { return seen(one.observations); });
}

}  // namespace

void write_observation_files(const std::string& folder, const BenchReport& report,
                             std::span<const LoadedCase> loaded) {
  const std::string histories = folder + "/histories.csv", snapshots = folder + "/snapshots.csv";
  if (any_case(report, [](const auto& seen) { return !seen.curves.empty(); }))
    write_file_atomically(histories, histories_csv(report.cases));
  else
    remove_stale_file(histories);
  if (any_case(report, [](const auto& seen) { return seen.slice.has_value(); }))
    write_file_atomically(snapshots, snapshots_csv(report.cases));
  else
    remove_stale_file(snapshots);
  const bool any_scene = std::any_of(loaded.begin(), loaded.end(), [](const LoadedCase& one) {
    return std::holds_alternative<Scene>(one.content);
  });
  if (any_scene)
    write_file_atomically(folder + "/health.json", all_health(report.cases, loaded));
  else
    remove_stale_file(folder + "/health.json");
}

void remove_observation_files(const std::string& folder) {
  for (const char* name : {"histories.csv", "snapshots.csv", "health.json"})
    remove_stale_file(folder + "/" + name);
}

}  // namespace superstep
