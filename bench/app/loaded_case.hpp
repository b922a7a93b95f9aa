#pragma once
/// A case with everything that can be wrong about it checked.

#include <string>
#include <vector>

#include "case/case.hpp"

namespace superstep {

struct LoadedCase {
  Case content;
  double cpu_setup = 0;  ///< CPU time of reading and building it [s]

  [[nodiscard]] const CaseHead& head() const { return head_of(content); }
};

/// What goes on meanwhile is said on a terminal, unless `quiet`.
[[nodiscard]] Case load_case_watched(TomlTable root, bool quiet);

/// Loads a case and checks the SPECs that it states. Throws InputError.
[[nodiscard]] LoadedCase load_checked_case(const std::string& file, bool quiet = true);
/// The same for a run, which needs no more of a scene than each of several processes can build for itself.
[[nodiscard]] LoadedCase load_case_to_run(const std::string& file, bool quiet = true);

/// The same for a benchmark: without output times of its own a scene is judged at 2, 10 and 100 % of the run,
/// because at a steady end any damped method looks exact. Throws InputError, also for sizes that must be a
/// slip in a unit: such a benchmark would not end.
[[nodiscard]] LoadedCase load_bench_case(const std::string& file, bool quiet = true);

/// What `load_bench_case` does with the scene of a case that is loaded already, `root`. Throws InputError.
void prepare_for_bench(Scene& scene, const TomlTable& root);

/// SPECs out of a case: what is wrong with them is the case's fault, at its line. Throws InputError.
void check_specs_of(const CaseHead& head);

/// The scene of a case. Throws InputError where particles move.
///   command  that needs a network which stays as it is, as in "stability"
[[nodiscard]] const Scene& scene_of(const Case& one, const std::string& command);

/// Throws UsageError when two cases of one command share a name: results go by it.
void require_distinct_names(const std::vector<std::string>& files);

/// Throws UsageError when two SPECs of the command line say the same.
void require_distinct_specs(const std::vector<std::string>& specs);
/// Checks SPECs of the command line, which must differ. Throws UsageError.
void check_specs(const std::vector<std::string>& specs);

}  // namespace superstep
