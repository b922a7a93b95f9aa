#pragma once
/// The truth about a scene. It reads what is stated, evaluates the physics by itself and integrates by means
/// of its own: nothing here comes from the right-hand sides or the integrators that it judges.
///
///   linear scenes   eigenvectors of the dense problem, exact on every piece between knots of time tables,
///                   in extended precision
///   all others      collocation at five Radau points (order 9) with Newton's method and dense matrices,
///   begun
///                   anew at every knot and wherever a temperature passes a corner of a conductivity table;
///                   repeated at finer tolerances until two runs agree

#include <string>
#include <vector>

#include "audit/scenes/random_scene.hpp"

namespace superstep::audit {

/// One field of the truth.
struct FieldTruth {
  std::string name;
  std::vector<std::vector<double>> values;  ///< [output times][nodes] K or V
  double low = 0, high = 0;  ///< over all nodes and the whole run, start and fixed values included
  double error = 0;          ///< what the oracle itself may be wrong by, largest over nodes [K or V]
  [[nodiscard]] double span() const noexcept { return high - low; }
  /// Largest magnitude of a value: roundings are relative to it.
  [[nodiscard]] double size() const noexcept;
};

struct Truth {
  std::vector<FieldTruth> fields;  ///< as stated; a steady potential is there, too
  bool exact = false;              ///< found by eigenvectors
  std::size_t steps = 0;           ///< of the finest run, or pieces
};

/// True where eigenvectors give the solution.
[[nodiscard]] bool is_linear(const StatedScene& scene);

struct OracleSettings {
  double accuracy = 1e-11;  ///< of a field's span: two runs must agree to this
  bool by_steps = false;    ///< integrate even where eigenvectors would do
};

/// Throws std::runtime_error when the accuracy cannot be reached.
[[nodiscard]] Truth find_truth(const StatedScene& scene, const OracleSettings& settings = {});

}  // namespace superstep::audit
