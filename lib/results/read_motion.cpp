#include "results/read_motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>

#include "core/error.hpp"
#include "core/text/text_file.hpp"
#include "results/text/csv_table.hpp"
#include "results/text/json_object.hpp"
#include "results/thinning.hpp"

namespace superstep {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_instants = 1000, most_frames = 6, most_spheres = 1500;

/// Columns of history.csv by name.
class History {
 public:
  explicit History(const std::string& path) : table_(path) {
    if (table_.rows() == 0) throw InputError(path + ": it has no rows; write it anew with superstep run");
  }
  [[nodiscard]] std::size_t rows() const noexcept { return table_.rows(); }
  [[nodiscard]] double at(std::size_t row, const char* name) const {
    return table_.required(row, table_.column(name));
  }
  [[nodiscard]] std::uint64_t count_at(std::size_t row, const char* name) const {
    return table_.count(row, table_.column(name)).value_or(0);
  }
  [[nodiscard]] std::string phase(std::size_t row) const { return table_.text(row, table_.column("phase")); }

  [[nodiscard]] std::vector<double> column(const char* name, const std::vector<std::size_t>& kept) const {
    const std::size_t c = table_.column(name);
    std::vector<double> out;
    for (const std::size_t row : kept) out.push_back(table_.required(row, c));
    return out;
  }
  /// The same where the column is there; what it has gained since the first row.
  [[nodiscard]] std::vector<double> gained(const char* name, const std::vector<std::size_t>& kept) const {
    if (!table_.find(name)) return {};
    const double first = at(0, name);
    std::vector<double> out = column(name, kept);
    for (double& value : out) value -= first;
    return out;
  }

 private:
  CsvTable table_;
};

MotionHistory thinned(const History& all) {
  const auto kept = evenly_thinned(all.rows(), most_instants);
  return {.time = all.column("time", kept),
          .volume_fraction = all.column("volume_fraction", kept),
          .mean_temperature = all.column("mean_temperature", kept),
          .max_temperature = all.column("max_temperature", kept),
          .wall_force = all.column("wall_force", kept),
          .bonds = all.column("bonds", kept),
          .contacts = all.column("contacts", kept),
          .wall_work = all.gained("wall_work", kept),
          .kinetic = all.gained("kinetic_energy", kept),
          .potential = all.gained("potential_energy", kept),
          .elastic = all.gained("elastic_energy", kept),
          .dissipated = all.gained("dissipated", kept),
          .joule_heat = all.gained("joule_heat", kept),
          .heat_lost = all.gained("heat_lost", kept),
          .heat_gained = all.gained("heat_content", kept)};
}

/// The first row is the initial state: it belongs to the first phase but is no step.
std::vector<MotionPhase> phases_of(const History& all) {
  std::vector<MotionPhase> phases;
  for (std::size_t row = 0; row < all.rows(); ++row) {
    const std::string name = all.phase(row);
    if (phases.empty() || phases.back().name != name) {
      const double begin = phases.empty() ? all.at(row, "time") : phases.back().end;
      phases.push_back({.name = name, .begin = begin});
    }
    MotionPhase& phase = phases.back();
    phase.end = all.at(row, "time");
    phase.steps += row > 0 ? 1 : 0;
    phase.volume_fraction = all.at(row, "volume_fraction");
    phase.mean_temperature = all.at(row, "mean_temperature");
    phase.max_temperature = all.at(row, "max_temperature");
    phase.wall_force = all.at(row, "wall_force");
    phase.largest_wall_force = std::max(phase.largest_wall_force, phase.wall_force);
    phase.bonds = all.count_at(row, "bonds");
    phase.contacts = all.count_at(row, "contacts");
  }
  return phases;
}

void find_largest_fraction(const History& all, MotionInput& motion) {
  for (std::size_t row = 0; row < all.rows(); ++row)
    if (const double fraction = all.at(row, "volume_fraction"); fraction > motion.largest_fraction) {
      motion.largest_fraction = fraction;
      motion.largest_fraction_at = all.at(row, "time");
    }
}

/// The half behind the plane, and of many particles those nearest to it: they hide the others.
MotionFrame read_frame(const CsvTable& table, const std::string& of_current, double time, double upper_wall,
                       double plane) {
  const auto electric = table.find(of_current);
  const auto id = table.column("id"), x = table.column("x"), y = table.column("y"), z = table.column("z"),
             r = table.column("r"), temperature = table.column("temperature");
  MotionFrame frame{.time = time, .upper_wall = upper_wall, .behind = 0, .spheres = {}};
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double depth = table.required(row, y) - plane;
    if (depth < 0) continue;
    frame.spheres.push_back({table.whole(row, id), table.required(row, x), table.required(row, z), depth,
                             table.required(row, r), table.required(row, temperature),
                             electric ? table.required(row, *electric) : 0});
  }
  frame.behind = frame.spheres.size();
  std::stable_sort(frame.spheres.begin(), frame.spheres.end(),
                   [](const auto& a, const auto& b) { return a.depth > b.depth; });
  if (frame.behind > most_spheres)
    frame.spheres.erase(frame.spheres.begin(),
                        frame.spheres.end() - static_cast<std::ptrdiff_t>(most_spheres));
  return frame;
}

/// Which of the snapshots taken at `times` are shown: the first one, the last one of each phase, and where
/// there is room left those furthest in time from the others.
std::vector<std::size_t> shown_frames(const std::vector<double>& times,
                                      const std::vector<MotionPhase>& phases) {
  std::set<std::size_t> chosen;
  if (!times.empty()) chosen.insert(0);
  for (const auto& phase : phases)
    for (std::size_t k = times.size(); k-- > 0;)
      if (times[k] > phase.begin && times[k] <= phase.end) {
        chosen.insert(k);
        break;
      }
  const auto distance = [&](std::size_t k) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const std::size_t other : chosen) nearest = std::min(nearest, std::abs(times[k] - times[other]));
    return nearest;
  };
  while (chosen.size() < std::min(most_frames, times.size())) {
    std::size_t furthest = *chosen.begin();
    for (std::size_t k = 0; k < times.size(); ++k)
      if (!chosen.contains(k) && (chosen.contains(furthest) || distance(k) > distance(furthest)))
        furthest = k;
    chosen.insert(furthest);
  }
  const std::vector<std::size_t> all(chosen.begin(), chosen.end());
  std::vector<std::size_t> out;
  for (const std::size_t k : evenly_thinned(all.size(), most_frames)) out.push_back(all[k]);
  return out;
}

std::array<double, 3> point_in(const JsonObject& box, const char* key) {
  const auto numbers = box.numbers(key);
  if (numbers.size() != 3) box.reject(key, "it must be three numbers");
  return {numbers[0], numbers[1], numbers[2]};
}

double required(const JsonObject& object, const char* key) {
  const auto value = object.number(key);
  if (!value) object.reject(key, "it must be a number");
  return *value;
}

// What is needed of "motion" in run.json, as `superstep run` writes it. A folder of an older program has no
// box and no snapshots there: then there are no pictures.
void read_frames(const std::string& folder, const JsonObject& motion, MotionInput& out) {
  const auto box = motion.object("box");
  if (!box || !motion.find("snapshots")) return;
  const auto snapshots = motion.objects("snapshots");
  out.box_min = point_in(*box, "min");
  out.box_max = point_in(*box, "max");
  const double plane = 0.5 * (out.box_min[1] + out.box_max[1]);
  std::vector<double> times;
  for (const auto& one : snapshots) times.push_back(required(one, "time"));
  for (const std::size_t k : shown_frames(times, out.phases)) {
    const auto& one = snapshots[k];
    // Only what is inside the folder: the name comes from a file.
    const std::filesystem::path name = one.text("file");
    const auto goes_up = [](const std::filesystem::path& part) { return part == ".."; };
    if (name.empty() || name.is_absolute() || std::any_of(name.begin(), name.end(), goes_up))
      one.reject("file", "it must name a file inside the folder");
    const CsvTable table(folder + "/" + name.string());
    for (const char* column : {"current", "potential"})
      if (table.find(column)) out.electric = column;
    out.frames.push_back(read_frame(table, out.electric, times[k], required(one, "upper_wall"), plane));
  }
}

}  // namespace

std::optional<MotionInput> read_motion(const std::string& folder) {
  const std::string path = folder + "/run.json", history_path = folder + "/history.csv";
  const Json json = parse_json_file(path);
  if (!json.is_object() || !json.contains("motion") || !is_regular_file(history_path)) return std::nullopt;
  const History all(history_path);
  MotionInput motion;
  motion.history = thinned(all);
  motion.phases = phases_of(all);
  find_largest_fraction(all, motion);
  read_frames(folder, JsonObject(path, json.at("motion"), "motion"), motion);
  return motion;
}

}  // namespace superstep
