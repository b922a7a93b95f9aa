#include "reports/html/read_runs.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/text/text_file.hpp"
#include "results/read_motion.hpp"
#include "results/results_json.hpp"
#include "results/thinning.hpp"

namespace superstep {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_spheres = 4000, most_instants = 400;

struct KnownField {
  const char* name;
  const char* unit;
};
constexpr KnownField known_fields[] = {{"potential", "V"}, {"temperature", "K"}};

std::vector<ProbeCurve> read_probes(const std::string& path, const std::string& spec) {
  std::vector<ProbeCurve> curves;
  const CsvTable table(path);
  const std::size_t time = table.column("time");
  for (std::size_t c = 0; c < table.columns().size(); ++c) {
    for (const auto& field : known_fields) {
      const std::string prefix = std::string(field.name) + "_";
      const std::string& name = table.columns()[c];
      if (!name.starts_with(prefix)) continue;
      ProbeCurve curve{
          .spec = spec, .field = field.name, .unit = field.unit, .probe = name.substr(prefix.size())};
      for (const std::size_t row : evenly_thinned(table.rows(), most_instants)) {
        curve.time.push_back(table.required(row, time));
        curve.value.push_back(table.required(row, c));
      }
      curves.push_back(std::move(curve));
    }
  }
  return curves;
}

/// Spheres of final.csv that the vertical mid-plane cuts; none when the file has no positions.
std::optional<Slice> read_final(const std::string& path, const std::string& spec, double time) {
  const CsvTable table(path);
  if (!table.find("x") || !table.find("r") || table.rows() == 0) return std::nullopt;
  const auto id = table.column("id"), x = table.column("x"), y = table.column("y"), z = table.column("z"),
             r = table.column("r");
  double low = table.required(0, y), high = low;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    low = std::min(low, table.required(row, y) - table.required(row, r));
    high = std::max(high, table.required(row, y) + table.required(row, r));
  }
  const double plane = 0.5 * (low + high);
  std::vector<std::size_t> cut;
  for (std::size_t row = 0; row < table.rows(); ++row)
    if (std::abs(table.required(row, y) - plane) < table.required(row, r)) cut.push_back(row);
  Slice slice{.source = spec, .cut = cut.size()};
  for (const auto& field : known_fields)
    if (table.find(field.name))
      slice.frames.push_back({.field = field.name, .unit = field.unit, .time = time});
  for (const std::size_t k : randomly_thinned(cut.size(), most_spheres)) {
    const std::size_t row = cut[k];
    slice.spheres.push_back({table.whole(row, id), table.required(row, x), table.required(row, z),
                             table.required(row, y) - plane, table.required(row, r)});
    for (auto& frame : slice.frames) frame.value.push_back(table.required(row, table.column(frame.field)));
  }
  return slice;
}

RunInput read_run(const std::string& folder, const std::string& name) {
  RunInput run{.folder = name,
               .record = read_run_json(folder + "/run.json"),
               .curves = {},
               .slice = {},
               .motion = read_motion(folder)};
  const auto& record = run.record;
  const std::string spec = record.integrator + (record.params.empty() ? "" : ":" + record.params);
  if (is_regular_file(folder + "/probes.csv")) run.curves = read_probes(folder + "/probes.csv", spec);
  if (!run.motion && is_regular_file(folder + "/final.csv"))
    run.slice = read_final(folder + "/final.csv", spec, record.t_end);
  return run;
}

}  // namespace

std::vector<RunInput> read_runs(const std::string& folder) {
  std::vector<RunInput> runs;
  if (is_regular_file(folder + "/run.json")) runs.push_back(read_run(folder, "."));
  std::vector<std::string> below;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (is_regular_file(entry.path().string() + "/run.json"))
      below.push_back(entry.path().filename().string());
  std::sort(below.begin(), below.end());
  for (const auto& name : below) runs.push_back(read_run(folder + "/" + name, name));
  return runs;
}

}  // namespace superstep
