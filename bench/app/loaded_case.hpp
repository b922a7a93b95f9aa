#pragma once
/// A case with everything that can be wrong about it checked.

#include <string>
#include <vector>

#include "case/scene.hpp"

namespace superstep {

struct LoadedCase {
  Scene scene;
  double cpu_setup = 0;  ///< CPU time of reading and building it [s]
};

/// Loads the scene and checks the SPECs of its [bench] table. Throws InputError.
[[nodiscard]] LoadedCase load_case(const std::string& file);

/// The same for a benchmark: without output times of its own a case is judged at 2, 10 and 100 % of the run,
/// because at a steady end any damped method looks exact. Throws InputError, also for sizes that must be a
/// slip in a unit: such a benchmark would not end.
[[nodiscard]] LoadedCase load_bench_case(const std::string& file);

/// Throws UsageError when two cases of one command share a name: results go by it.
void require_distinct_names(const std::vector<std::string>& files);

/// Checks SPECs of the command line. Throws UsageError.
void check_specs(const std::vector<std::string>& specs);

}  // namespace superstep
