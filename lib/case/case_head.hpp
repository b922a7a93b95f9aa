#pragma once
/// What every case says, whatever it is about.

#include <string>
#include <vector>

#include "core/text/toml.hpp"

namespace superstep {

/// What `[bench]` asks for.
struct BenchSettings {
  std::string baseline = "forward-euler:fraction=1,bound=lanczos";  ///< at its true limit
  std::vector<std::string> integrators;                             ///< empty = every family
};

/// A SPEC as a case states it. Readers of cases know no integrators, so that the program checks it.
struct StatedSpec {
  std::string spec;
  std::string where;  ///< "file:line: key 'a.b'", to begin an error message with
};

struct CaseHead {
  std::string file, name;  ///< path of the case; its stem
  std::string title, source;
  double t_end = 0;                  ///< s
  std::vector<double> output_times;  ///< s, ascending; the last is t_end
  bool own_output_times = false;     ///< the case states them; else there is t_end alone
  BenchSettings bench;
  std::vector<StatedSpec> stated_specs;  ///< all that the case names, in the order of reading
};

/// Reads `title`, `source`, `t_end`, `output_times`, and from [bench] `baseline` and `integrators`. Throws
/// InputError.
void read_head(TomlTable& root, CaseHead& head);

}  // namespace superstep
