#pragma once
/// What the stability laboratory finds out about a case, as plain data.
///
/// z = h * lambda: a step times a rate of the network, 0 for a uniform state, h * lambda_max for the stiffest
/// mode. R(z): what one step makes of a mode; |R| > 1 means growth.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace superstep {

/// One method with one parameter set: its stability function, and the same measured on the network.
struct MethodStability {
  std::string family;            ///< "sts", "rkc2", ...
  std::string parameters;        ///< "n=10,nu=1e-3", "s=20", "phi=0.5"
  std::string order;             ///< how STS carries out its substeps, else empty
  std::string spec;              ///< as it was run
  int stages = 1;                ///< sweeps in a step of an explicit method
  double step = 0;               ///< s
  double z_stiff = 0;            ///< step * lambda_max
  std::optional<double> beta;    ///< declared end of stability in z; none = stable everywhere
  std::optional<double> limit;   ///< z at which |R| first exceeds 1, found numerically
  double largest = 0;            ///< max |R| over [0, z_stiff]
  double damping = 0;            ///< max |R| over the stiffer half of [0, z_stiff]
  double stiff = 0;              ///< R at z_stiff
  double stiff_measured = 0;     ///< the same from the stiffest mode of the network
  double difference = 0;         ///< worst |measured - R| over steps up to `step`
  double tolerance = 0;          ///< that `difference` may have
  double growth = 0;             ///< measured: factor per step of a white perturbation, after several steps
  std::optional<double> beyond;  ///< |R| at a step that is too long
  std::optional<double> beyond_measured;  ///< growth per step of a white perturbation there
  bool agrees = false;                    ///< measured = theory
};

/// Notes of step estimates that verdicts look for.
inline constexpr const char* certified_bound = "certified";
inline constexpr const char* published_rule = "published rule";

/// What a perturbation does step by step: a factor within 1e-4 of 1 can not be told apart from it.
enum class Tendency { decays, grows, unclear };

/// One estimate of forward Euler's critical step.
struct StepEstimate {
  std::string name;
  double step = 0;              ///< s
  std::optional<double> alpha;  ///< of the pairwise step without interface
  double of_limit = 0;          ///< of the limit found by bisection
  double growth = 0;            ///< measured: factor per step at that step
  Tendency tendency = Tendency::decays;
  std::string note;
};
[[nodiscard]] const char* stable_word(Tendency tendency);  ///< "yes", "no" or "can not be told apart"

struct CriticalStepStudy {
  double limit = 0;  ///< s, longest step without growth; infinite when nothing limits the step
  int runs = 0;
  int steps_per_run = 0;
  double lanczos_ratio = 0;  ///< (2/lambda_max) / limit
  bool agrees = false;       ///< within 1 %
  std::vector<StepEstimate> estimates;
};

/// Rounding of STS with one parameter set and order, on a chain with known modes.
struct RoundingGrowth {
  int n = 0;
  double nu = 0;
  std::string order;
  double amplification = 0;    ///< largest partial product over the spectrum: what can become of one rounding
  double superstep_error = 0;  ///< of one superstep against its polynomial, in units of machine epsilon
  double rounding_error = 0;   ///< of a whole run against its polynomial, in spans
  double end_error = 0;        ///< of the same run against the exact solution, in spans
  bool right = false;          ///< rounding stays far below the span
};

/// How far values leave the range of initial and fixed values in the first steps of a method [spans].
struct Overshoot {
  std::string method;
  double spans = 0;
};

/// One point of a sweep over random networks; the worst of several networks.
struct SweepPoint {
  std::string sweep;      ///< "contrast", "size ratio" or "nu"
  double contrast = 1;    ///< largest/smallest conductance law constant
  double size_ratio = 1;  ///< largest/smallest radius; capacities go with its cube
  double nu = 0;          ///< of the STS runs
  int n = 0;              ///< of the STS runs
  std::size_t nodes = 0;
  int networks = 0;
  double edge_ratio = 0;              ///< certified edge bound / true spectral radius
  double gershgorin_ratio = 0;        ///< Gershgorin / true spectral radius
  double bound_ratio = 0;             ///< the smaller of both / true
  double alpha = 0;                   ///< smallest true critical step / pairwise step
  std::vector<Overshoot> overshoots;  ///< the same methods in the same order at every point
};

/// Where a method is safe and where not, in plain words.
struct Verdict {
  enum class Grade { safe, careful, unsafe };
  std::string method;
  Grade grade = Grade::safe;
  std::string text;
};
[[nodiscard]] const char* grade_name(Verdict::Grade grade);

/// Longest stable step of one method at one frozen state.
struct FrozenLimit {
  enum class Verdict { agrees, differs, not_predicted };
  std::string family, parameters;             ///< as in MethodStability
  std::string spec;                           ///< at the measured limit
  std::optional<double> predicted;            ///< s, from eigenvalues
  double measured = 0;                        ///< s, longest step without growth; infinite when none grows
  std::optional<double> growth_at_predicted;  ///< measured factor per step
  Verdict verdict = Verdict::agrees;          ///< within 2 %
};
[[nodiscard]] const char* verdict_name(FrozenLimit::Verdict verdict);

/// A scene frozen at one state of a run: what its Jacobian allows.
struct FrozenState {
  double part = 0;  ///< of t_end [-]
  double time = 0;  ///< s
  std::size_t unknowns = 0;
  std::string spectrum;         ///< "symmetric", "real" or "complex"
  std::string found_by;         ///< "Lanczos", "all eigenvalues" or "Arnoldi"
  double lambda_max = 0;        ///< modulus of the eigenvalue that limits forward Euler [1/s]
  double lambda_imaginary = 0;  ///< its imaginary part [1/s]
  double lambda_residual = 0;   ///< 1/s
  /// Rate at which some perturbation grows by itself, 0 where none does; not a number where that is not known
  /// [1/s].
  double rising = 0;
  double certified_bound = 0;  ///< of the spectral radius [1/s]
  std::vector<FrozenLimit> limits;
};

struct StabilityResults {
  std::string case_name, title;
  bool quick = false;
  /// Modes are the same at all times: `methods` and `critical_step` say something only then.
  bool linear = true;
  std::size_t unknowns = 0;
  double lambda_max = 0;       ///< 1/s, the largest among the states
  double lambda_residual = 0;  ///< 1/s
  std::vector<MethodStability> methods;
  CriticalStepStudy critical_step;
  std::vector<RoundingGrowth> rounding;
  std::vector<SweepPoint> sweeps;
  std::vector<FrozenState> states;
  std::vector<std::string> notes;  ///< about the states: what was left out, and why
  std::vector<Verdict> verdicts;
};

}  // namespace superstep
