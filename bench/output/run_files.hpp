#pragma once
/// The files of `superstep run`.

#include <span>
#include <string>

#include "bench/measure/probe_set.hpp"
#include "bench/measure/run_one.hpp"
#include "case/scene.hpp"
#include "results/results.hpp"

namespace superstep {

/// final.csv: every node in the user's order: id, then x,y,z,r [m] when there is a packing, then one column
/// per field.
[[nodiscard]] std::string final_csv(const Scene& scene, double t, std::span<const double> state);
/// The same in pieces: the text of a large scene needs more room than the scene.
void write_final_csv(const Scene& scene, double t, std::span<const double> state,
                     const std::function<void(std::string_view)>& write);

/// probes.csv: time [s] and one column per probe and field, at the method's own step ends, from the initial
/// state to t_end.
[[nodiscard]] std::string probes_csv(const ProbeSet& probes, const ProbeHistory& history, double t_end);

/// What run.json says; set-up time, threads and files are filled in by those who know them.
[[nodiscard]] RunRecord record_run(const Scene& scene, const MethodSpec& spec, const RunResult& run,
                                   std::span<const double> final_state);

/// Removes run.json, which speaks for the other files, before the first of them changes.
void begin_run_files(const std::string& folder) noexcept;

/// Removes what only a run of moving particles leaves, before a network that does not move is run.
void remove_files_of_motion(const std::string& folder) noexcept;

/// Writes final.csv and, when there are probes, probes.csv if the run succeeded, and run.json in any case and
/// last; removes those of an earlier run that this one did not produce. Returns the text of run.json. Throws
/// OutputError.
std::string write_run_files(const std::string& folder, const Scene& scene, const ProbeSet& probes,
                            const RunResult& run, std::span<const double> final_state, RunRecord record);

}  // namespace superstep
