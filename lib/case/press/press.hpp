#pragma once
/// A press: everything that a case with moving particles, i.e. with a table [dynamics], says.

#include <optional>
#include <string>
#include <utility>

#include "case/case_head.hpp"
#include "dynamics/model.hpp"
#include "dynamics/particles.hpp"
#include "dynamics/stepping.hpp"

namespace superstep {

struct Press : CaseHead {
  Press() { bench.baseline = "forward-euler"; }  // of the temperatures

  dynamics::Model model;
  dynamics::Particles particles;
  dynamics::State state;
  dynamics::SteppingSettings stepping;
  /// From when to when `superstep bench` compares schemes for the motion [s]; empty = it does not.
  std::optional<std::pair<double, double>> motion_window;
};

/// Reads a case with moving particles. Throws InputError with file, line, value, rule and way out.
[[nodiscard]] Press load_press(const std::string& path);
/// The same of a file that is parsed already; `root` then knows which keys were asked for.
[[nodiscard]] Press load_press(TomlTable root);

}  // namespace superstep
