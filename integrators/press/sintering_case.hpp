#pragma once
/// A case file with a table [dynamics]: a press with moving particles.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "case/press/read_model.hpp"
#include "integrators/press/motion.hpp"

namespace superstep::dynamics {

struct SinteringCase {
  std::string file, name, title, source;
  double t_end = 0;                  ///< s
  std::vector<double> output_times;  ///< ascending, the last one is t_end [s]
  Model model;
  Particles particles;
  State state;
  SteppingSettings stepping;
  std::string baseline = "forward-euler";  ///< of `superstep bench`
  std::vector<std::string> integrators;    ///< thermal integrators that `superstep bench` compares
  /// From when to when `superstep bench` compares schemes for the motion [s]; empty = it does not.
  std::optional<std::pair<double, double>> motion_window;
};

/// True when the file parses and has a table [dynamics]. Throws InputError when it does not parse.
[[nodiscard]] bool is_sintering_case(const std::string& path);

/// Throws InputError with file, line, value, rule and way out.
[[nodiscard]] SinteringCase load_sintering_case(const std::string& path);
/// The same of a file that is parsed already; `root` then knows which keys were asked for.
[[nodiscard]] SinteringCase load_sintering_case(TomlTable root);

}  // namespace superstep::dynamics
