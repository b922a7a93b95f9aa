#include "bench/output/run_files.hpp"

#include <fmt/format.h>

#include <limits>
#include <vector>

#include "bench/host/machine.hpp"
#include "bench/measure/scene_facts.hpp"
#include "bench/measure/shared/part_lines.hpp"
#include "bench/output/output_folder.hpp"
#include "bench/output/snapshot_files.hpp"
#include "case/checks/effective.hpp"
#include "core/atomic_file.hpp"
#include "core/stopwatch.hpp"
#include "core/text/append.hpp"
#include "core/text/options.hpp"
#include "packing/formats/stated.hpp"
#include "results/results_json.hpp"
#include "results/text/csv_text.hpp"

namespace superstep {
namespace {

void append_particle(std::string& out, const Packing& packing, std::size_t i) {
  const Vec3& centre = packing.centre[i];
  append(out, ",{},{},{},{}", centre.x, centre.y, centre.z, packing.radius[i]);
}

// Fields in the order of the contract.
std::vector<std::size_t> field_order(const Scene& scene) {
  std::vector<std::size_t> order;
  for (const char* name : {"potential", "temperature"})
    for (std::size_t f = 0; f < scene.fields.size(); ++f)
      if (scene.fields[f].name == name) order.push_back(f);
  return order;
}

double value_at(const ProbeColumn& column, const ProbeHistory& history, double t) {
  if (column.slot < 0) return column.known_at(t);
  return history.at(t, static_cast<std::size_t>(column.slot)) + column.origin;
}

void append_probes(std::string& out, const ProbeSet& probes, const ProbeHistory& history, double t) {
  append(out, "{}", t);
  for (const auto& column : probes.columns()) append(out, ",{}", value_at(column, history, t));
  append(out, "\n");
}

std::string head_of_values(const Scene& scene) {
  std::string head = "id";
  if (scene.has_places()) head += ",x,y,z,r";
  for (const std::size_t f : field_order(scene)) append(head, ",{}", scene.fields[f].name);
  return head + "\n";
}

/// By all processes at once where they can reach the file, else through the root.
void write_final_file(const std::string& path, const Scene& scene, double t, std::span<const double> state) {
  const auto together = [&](const std::string& temporary) {
    const auto [reached, failure] = write_part_lines(scene, state, head_of_values(scene), temporary);
    if (failure) throw write_error(path, *failure);
    return reached;
  };
  if (scene.own_nodes && fill_file_atomically(path, together)) return;
  write_file_atomically(path, [&](const PieceWriter& write) { write_final_csv(scene, t, state, write); });
}

/// Resistance, current and heat of a scene whose potential is steady, as it ends: they cost one solve more.
std::optional<SteadyCurrent> steady_current(const Scene& scene, const RunResult& run,
                                            std::span<const double> final_state) {
  for (const auto& field : scene.fields) {
    if (!field.steady || !run.outcome.ok()) continue;
    const auto facts = electrode_facts(field, field_at(scene, field, run.t_reached, final_state));
    if (!facts) return std::nullopt;
    return SteadyCurrent{facts->voltage, facts->current_in, facts->current_out,
                         facts->resistance.value_or(std::numeric_limits<double>::infinity()),
                         facts->joule_heat};
  }
  return std::nullopt;
}

}  // namespace

void write_final_csv(const Scene& scene, double t, std::span<const double> state, const PieceWriter& write) {
  constexpr std::size_t piece = std::size_t{1} << 20;  // bytes
  std::string out;
  if (scene.own_nodes) {
    write(head_of_values(scene));
    return for_part_lines(scene, state, write);
  }
  if (scene.packed && scene.packed->packing.cell && scene.packed->packing.cell->is_periodic())
    append(out, "{}",
           cell_comment(*scene.packed->packing.cell));  // so that it reads back with the same contacts
  out += head_of_values(scene);
  std::vector<std::vector<double>> values;
  for (const std::size_t f : field_order(scene)) values.push_back(scene.values_on_nodes(f, t, state));
  const auto& ids = scene.fields.front().graph.id;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    append(out, "{}", ids[i]);
    if (scene.packed) append_particle(out, scene.packed->packing, i);
    for (const auto& value : values) append(out, ",{}", value[i]);
    append(out, "\n");
    if (out.size() < piece) continue;
    write(out);
    out.clear();
  }
  write(out);
}

std::string final_csv(const Scene& scene, double t, std::span<const double> state) {
  std::string text;
  write_final_csv(scene, t, state, [&](std::string_view piece) { text += piece; });
  return text;
}

std::string probes_csv(const ProbeSet& probes, const ProbeHistory& history, double t_end) {
  std::string out;
  append(out, "time");
  for (const auto& column : probes.columns()) append(out, ",{}", csv_cell(column.name));
  append(out, "\n");
  double last = -1;
  for (std::size_t k = 0; k < history.size() && history.time(k) <= t_end; ++k) {
    last = history.time(k);
    append_probes(out, probes, history, last);
  }
  // A method with dense output may step past the end; a scene whose probes never change has no history at
  // all.
  if (history.size() == 0) append_probes(out, probes, history, 0.0);
  if (last < t_end) append_probes(out, probes, history, t_end);
  return out;
}

RunRecord record_run(const Scene& scene, const MethodSpec& spec, const RunResult& run,
                     std::span<const double> final_state) {
  return {.version = program_version(),
          .revision = program_revision(),
          .case_name = scene.name,
          .title = scene.title,
          .source = scene.source,
          .integrator = spec.name(),
          .params = spec.parameters(),
          .choice = run.choice,
          .status = status_name(run.outcome.status),
          .reason = run.outcome.reason,
          .t_end = scene.t_end,
          .t_reached = run.t_reached,
          .nodes = scene.nodes(),
          .contacts = scene.edges(),
          .unknowns = scene.rhs->reduction().total(),
          .steps = run.statistics.steps,
          .rejected = run.statistics.rejected,
          .rhs = run.sweeps,
          .jacobians = run.jacobians,
          .factorizations = run.statistics.factorizations,
          .solves = run.statistics.solves,
          .potential_solves = run.potential_solves,
          .verified_by = {},
          .delivered = std::nullopt,
          .error_bound = error_bound_of(run),
          .rounding_bound = rounding_bound_of(run),
          .spans = run.spans,
          .cpu_pilot = run.cpu_pilot,
          .settled_at = run.settled_at,
          .electrodes = steady_current(scene, run, final_state),
          .max_stages = run.statistics.max_stages,
          .cpu_prepare = run.cpu_prepare,
          .cpu_stepping = run.cpu_stepping,
          .wall_stepping = run.wall_stepping,
          .peak_memory_mb = run.peak_memory_mb > 0 ? run.peak_memory_mb : peak_memory_megabytes(),
          .processes = run.processes,
          .distributed = run.distributed,
          .reductions = run.reductions,
          .halo_messages = run.halo_messages,
          .halo_bytes = run.halo_bytes,
          .imbalance = run.imbalance,
          .files = {},
          .warnings = scene.warnings,
          .skips = skipped_work(scene, run),
          .machine = machine_facts(),
          .libraries = library_facts(),
          .motion = {}};
}

void begin_run_files(const std::string& folder) noexcept {
  remove_stale_file(folder + "/run.json");
}

void remove_files_of_motion(const std::string& folder) noexcept {
  for (const char* name : {"/history.csv", "/history.svg"}) remove_stale_file(folder + name);
  remove_snapshots(folder, 0);
}

std::string write_run_files(const std::string& folder, const Scene& scene, const ProbeSet& probes,
                            const RunResult& run, std::span<const double> final_state, RunRecord record) {
  const auto write_or_remove = [&](const std::string& name, bool wanted, auto write) {
    const std::string path = folder + "/" + name;
    if (!wanted) return remove_stale_file(path);
    write(path);
    record.files.push_back(name);
  };
  const bool ok = run.outcome.ok();
  write_or_remove("final.csv", ok, [&](const std::string& path) {
    write_final_file(path, scene, run.t_reached, final_state);
  });
  write_or_remove("probes.csv", ok && !probes.columns().empty(), [&](const std::string& path) {
    write_file_atomically(path, probes_csv(probes, run.history, scene.t_end));
  });
  record.files.emplace_back("run.json");
  std::string json = run_json(record);
  write_file_atomically(folder + "/run.json", json);
  return json;
}

}  // namespace superstep
