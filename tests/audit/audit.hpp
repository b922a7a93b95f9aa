#pragma once
/// Every method on random scenes: what was asked for against what was delivered.

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

#include "audit/oracle/oracle.hpp"
#include "audit/scenes/random_scene.hpp"
#include "audit/time_limit.hpp"

namespace superstep::audit {

/// A method that is judged.
struct Contender {
  std::string label;     ///< SPEC without rtol
  bool adaptive = true;  ///< takes rtol
  [[nodiscard]] std::string name() const { return label.substr(0, label.find(':')); }
  /// True where steps are made as short as the estimated error asks for: then what is delivered is
  /// proportional to what is asked. Expansions into polynomials end between two terms and deliver more.
  [[nodiscard]] bool step_controlled() const { return name() != "exponential" && name() != "auto"; }
  [[nodiscard]] std::string spec(double rtol) const;
};

/// Those of the given SPECs, in this order. Empty: every adaptive integrator by its bare name, the variants
/// that solve or project in ways of their own, and those with fixed steps.
[[nodiscard]] std::vector<Contender> contenders(const std::vector<std::string>& specs);

struct AuditSettings {
  bool true_spans = false;  ///< the runs are told the oracle's spans, else they find them
};

/// One run.
struct Row {
  std::uint64_t seed = 0;
  std::string kind = {}, shape = {};  ///< of the scene
  std::size_t unknowns = 0;
  double t_lambda = 0;     ///< see StatedScene
  std::string label = {};  ///< of the contender
  double rtol = 0;         ///< 0: the method takes none
  /// As in the library; "timeout" when the audit stopped it.
  std::string status = {}, reason = {};
  double error = -1;  ///< rms over free nodes, worst over outputs and fields, over the span; -1 = did not end
  double delivered = -1;  ///< the same over what was allowed; -1 = did not end, or took no rtol
  bool floored = false;   ///< roundings allow more than rtol does
  std::uint64_t steps = 0, rejected = 0, sweeps = 0;
  double seconds = 0;  ///< CPU time, preparation included
};

[[nodiscard]] Row judge(const StatedScene& stated, const Scene& scene, const Truth& truth,
                        const Contender& contender, double rtol, const AuditSettings& settings,
                        TimeLimit& limit);

/// 100 roundings of a field's largest value: no tolerance is tighter [K or V].
[[nodiscard]] double rounding_floor(const FieldTruth& field);

/// True where a field is integrated and moves: only then can anything be right or wrong about it.
[[nodiscard]] bool is_judged(const Scene& scene, const Truth& truth, std::size_t field);

/// rms error over the free nodes at one output [fields of the scene; K or V], 0 in fields that are not
/// judged. Free nodes that are no unknowns have to be right, too: their errors count, their number does not.
[[nodiscard]] std::vector<double> errors_at(const Scene& scene, const Truth& truth, std::size_t output,
                                            std::span<const double> state);
/// The worst of these over all outputs.
[[nodiscard]] std::vector<double> errors_of(const Scene& scene, const Truth& truth,
                                            const std::vector<std::vector<double>>& states);

void write_rows(std::ostream& out, const std::vector<Row>& rows);
[[nodiscard]] std::vector<Row> read_rows(std::istream& in);

}  // namespace superstep::audit
