#pragma once
/// Random scenes of every kind that a case file can state, one for each seed.

#include <cstdint>
#include <string>
#include <vector>

#include "case/build_rhs.hpp"
#include "case/scene.hpp"

namespace superstep::audit {

/// A scene as a user would state it, before anything is built from it: all that the oracle reads.
struct StatedScene {
  std::uint64_t seed = 0;
  std::string kind;                  ///< class, one of `scene_kinds()`
  std::string shape;                 ///< of the graph: "chain", "grid", ...
  double t_end = 0;                  ///< s
  std::vector<double> output_times;  ///< s, ascending; the last is t_end
  std::vector<FieldScene> fields;    ///< potential before temperature
  Coupling coupling;
  double t_lambda = 0;  ///< t_end times a bound of the spectral radius at the start [-]
};

struct SceneWishes {
  bool steps = true;      ///< steps in time tables: equal neighbouring times
  std::string kind = {};  ///< only this class; empty = all of them
  std::size_t most_nodes = 60;
};

/// "linear-constant", "driven-linear", "radiation-convection", "kappa-T", "one-way", "two-way",
/// "steady-potential".
[[nodiscard]] const std::vector<std::string>& scene_kinds();

/// The same scene for the same seed and wishes.
[[nodiscard]] StatedScene state_scene(std::uint64_t seed, const SceneWishes& wishes = {});

/// True where adding a number to every temperature changes nothing else: no laws, no radiation.
[[nodiscard]] bool may_be_shifted(const StatedScene& scene);
/// Every temperature moved by `by` [K]: initial and fixed values, ambients and their tables.
[[nodiscard]] StatedScene shifted(StatedScene scene, double by);

/// The scene as integrators take it.
[[nodiscard]] Scene build_scene(const StatedScene& stated);
[[nodiscard]] Scene random_scene(std::uint64_t seed, const SceneWishes& wishes = {});

}  // namespace superstep::audit
