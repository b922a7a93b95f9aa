#pragma once
/// What commands do with a case of moving particles.

#include <string>
#include <vector>

#include "bench/app/commands.hpp"
#include "bench/app/loaded_case.hpp"
#include "bench/host/progress.hpp"
#include "case/press/press.hpp"

namespace superstep {

/// superstep run; returns the exit code.
///   cpu_setup [s]  CPU time that reading the case took
int run_press(const RunCommand& command, const Press& press, double cpu_setup);

/// superstep info; returns the exit code.
int info_press(const InfoCommand& command, const Press& press);

/// The part of `superstep bench` that other cases do not have: schemes of the motion over the window that the
/// case names. Writes motion.csv into `folder`; does nothing without a window.
void bench_motion(const BenchCommand& command, const Press& press, const std::string& folder,
                  Progress& progress);

/// superstep bench --press-table: prints the table of all presses and writes press_table.csv into `folder`.
/// Returns the exit code.
int bench_press_tables(const BenchCommand& command, const std::vector<LoadedCase>& cases,
                       const std::string& folder);

/// Checks SPECs that may be "staggered" as well: the phi rule inside the iteration. Throws UsageError.
void check_specs_of_press(const std::vector<std::string>& specs);

}  // namespace superstep
