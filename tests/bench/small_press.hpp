#pragma once
/// A case with moving particles that is over in a moment.

#include <string>

#include "temporary_case.hpp"

namespace superstep::test {

/// Thirty particles in a small press, a few hundredths of a second.
inline std::string small_press(const CaseFolder& folder, const std::string& more = "") {
  return folder.write("press.toml", R"(
title = "small press"
t_end = 0.04
output_times = [0.02, 0.04]
[material]
density = 2000.0
[thermal]
conductivity = 1e5
specific_heat = 100.0
initial = 300.0
walls = { lower = 1000.0, upper = 900.0, sides = 300.0 }
[electric]
conductivity = 0.1
absorption = 0.5
[dynamics]
[dynamics.box]
min = [0.0, 0.0, 0.0]
max = [0.4, 0.4, 0.5]
[dynamics.particles]
count = 30
radius = 0.05
seed = 3
[dynamics.contact]
stiffness = 1e7
damping = 0.2
[dynamics.wall]
stiffness = 1e7
[dynamics.bond]
stiffness = 1e6
threshold = 0.05
[[dynamics.phases]]
name = "press, slowly"
until = 0.04
upper_wall = 0.35
current = { lower = 1e4, upper = 1e4 }
[bench]
integrators = ["forward-euler", "rkc:rtol=1e-5"]
motion_window = [0.01, 0.02]
)" + more);
}

}  // namespace superstep::test
