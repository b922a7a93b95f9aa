#pragma once
/// The files of `superstep run` for a press with moving particles.

#include <span>
#include <string>

#include "bench/app/commands.hpp"
#include "case/press/press.hpp"
#include "integrators/press/motion.hpp"

namespace superstep {

/// history.csv: one row per accepted step, the first one for the initial state; `phase` is the phase's name,
/// `step` the size of the step [s].
[[nodiscard]] std::string history_csv(const Press& one, std::span<const dynamics::HistoryRow> history);

/// Particles by id: id,x,y,z,r [m], temperature [K], current [A] or potential [V] when the case has a
/// current, velocity [m/s]. The columns of final.csv of a fixed network come first.
[[nodiscard]] std::string particles_csv(const Press& one, const dynamics::State& state);

/// A file with the particles of one instant.
struct SnapshotFile {
  std::string file;       ///< relative to the folder of the run
  double time = 0;        ///< s
  double upper_wall = 0;  ///< height of the upper wall [m]
};

/// What a run of moving particles cost and how it ended.
struct SinteringResult {
  Outcome outcome;
  double cpu_setup = 0, cpu_stepping = 0, wall_stepping = 0;  ///< s
  std::vector<std::string> files, warnings;
  std::vector<SnapshotFile> snapshots;  ///< ascending in time
};

/// run.json: as for a fixed network, and under "motion" the state at the end of each phase, the CPU time
/// of each part, the box and when each snapshot was taken.
[[nodiscard]] std::string sintering_json(const Press& one, const dynamics::Motion& motion,
                                         const SinteringResult& result, int threads);

/// The same in words: a table of the phases, the parts with their shares.
[[nodiscard]] std::string sintering_summary(const Press& one, const dynamics::Motion& motion,
                                            const SinteringResult& result, const std::string& folder);

}  // namespace superstep
