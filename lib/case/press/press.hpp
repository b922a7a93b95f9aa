#pragma once
/// A press: everything that a case with moving particles, i.e. with a table [dynamics], says.

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "case/case_head.hpp"
#include "dynamics/model.hpp"
#include "dynamics/particles.hpp"
#include "dynamics/random_addition.hpp"
#include "dynamics/stepping.hpp"

namespace superstep {

struct Press : CaseHead {
  Press() { bench.baseline = "forward-euler"; }  // of the temperatures

  dynamics::Model model;
  dynamics::Particles particles;
  dynamics::State state;
  std::vector<std::string> warnings;  ///< what the user of the packing file should look at
  dynamics::SteppingSettings stepping;
  /// From when to when `superstep bench` compares schemes for the motion [s]; empty = it does not.
  std::optional<std::pair<double, double>> motion_window;
  /// What `superstep bench --press-table` runs; empty = the case names nothing.
  struct Table {
    std::vector<double> holds;        ///< s
    std::vector<double> walls;        ///< lowest heights of the upper wall [m]
    std::vector<std::int64_t> seeds;  ///< of generated particles; none of others
  };
  std::optional<Table> table;
};

/// Reads a case with moving particles. Throws InputError with file, line, value, rule and way out.
[[nodiscard]] Press load_press(const std::string& path);
/// The same with another seed for generated particles.
[[nodiscard]] Press load_press(const std::string& path, std::uint64_t seed);
/// The same of a file that is parsed already; `root` then knows which keys were asked for.
///   placed  told which part of generated particles is placed, where that takes time
[[nodiscard]] Press load_press(TomlTable root, std::optional<std::uint64_t> seed = std::nullopt,
                               const dynamics::Placed& placed = {});

}  // namespace superstep
