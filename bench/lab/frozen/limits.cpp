#include "bench/lab/frozen/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "bench/lab/catalogue.hpp"
#include "bench/lab/frozen/growth.hpp"
#include "bench/lab/frozen/spectrum.hpp"
#include "bench/lab/frozen/states_of_run.hpp"
#include "bench/lab/function.hpp"

namespace superstep {
namespace {

constexpr double agreement = 0.02;           // of the predicted and the measured limit
constexpr double width = 1e-4;               // at which bisection ends
constexpr double accuracy_of_states = 1e-6;  // of the run they come from

using Kind = Spectrum::Kind;

GrowthMeter::Modes modes_of(Kind kind) {
  switch (kind) {
    case Kind::symmetric:
      return GrowthMeter::Modes::orthogonal;
    case Kind::real:
      return GrowthMeter::Modes::real;
    case Kind::complex:
      return GrowthMeter::Modes::complex;
  }
  return GrowthMeter::Modes::complex;
}

std::string kind_name(Kind kind) {
  switch (kind) {
    case Kind::symmetric:
      return "symmetric";
    case Kind::real:
      return "real";
    case Kind::complex:
      return "complex";
  }
  return {};
}

std::optional<double> predicted_limit(const StabilityModel& method, const Spectrum& spectrum) {
  if (method.family == "forward-euler") return spectrum.euler_limit;
  if (spectrum.kind == Kind::complex) return std::nullopt;
  const auto z = growth_limit(method.response, *method.beta, 200 + 40 * method.stages);
  return z ? std::optional(*z / std::abs(spectrum.limiting)) : std::nullopt;
}

FrozenLimit find_limit(const FrozenRhs& rhs, GrowthMeter& meter, const StabilityModel& method,
                       const Spectrum& spectrum) {
  const auto growth = [&](double step) { return meter.growth(method.spec(step), step); };
  FrozenLimit out;
  out.family = method.family;
  out.parameters = method.parameters;
  out.predicted = predicted_limit(method, spectrum);
  const double radius = rhs.frozen().bound > 0 && std::isfinite(rhs.frozen().bound)
                            ? rhs.frozen().bound
                            : std::abs(spectrum.limiting);
  out.measured = longest_stable_step(growth, *method.beta / radius, width);
  out.spec = method.spec(out.measured);
  if (!out.predicted) {
    out.verdict = FrozenLimit::Verdict::not_predicted;
    return out;
  }
  out.growth_at_predicted = growth(*out.predicted);
  const bool agrees = std::abs(*out.predicted / out.measured - 1) <= agreement;
  out.verdict = agrees ? FrozenLimit::Verdict::agrees : FrozenLimit::Verdict::differs;
  return out;
}

std::string at(const StateOfRun& state) {
  return fmt::format("at {:g} % of the run (t = {:.6g} s)", 100 * state.part, state.time);
}

void add_notes(const Scene& scene, std::vector<std::string>& notes) {
  if (scene.rhs->size() == 0) notes.push_back("nothing is stepped: the field is steady and was solved for");
  if (scene.rhs->traits().constant_jacobian && scene.rhs->size() > 0)
    notes.push_back("the Jacobian is constant: one state stands for all");
  if (scene.rhs->one_way())
    notes.push_back(
        "frozen, both fields are stepped as one; sts by itself steps them in turn, potential first, which is "
        "not measured here (its limit is that of the blocks)");
  if (scene.moving_potential)
    notes.push_back(
        "the steady potential is frozen with the state: how it follows the temperatures is not part of the "
        "Jacobian");
}

}  // namespace

FrozenState find_limits(FrozenRhs& rhs, bool quick, const std::function<void()>& done) {
  Spectrum spectrum = spectrum_of(rhs);
  FrozenState out;
  out.unknowns = rhs.size();
  out.spectrum = kind_name(spectrum.kind);
  out.found_by = spectrum.found_by;
  out.lambda_max = std::abs(spectrum.limiting);
  out.lambda_imaginary = std::abs(spectrum.limiting.imag());
  out.lambda_residual = spectrum.residual;
  out.rising = spectrum.rising_is_known ? spectrum.rising : std::numeric_limits<double>::quiet_NaN();
  out.certified_bound = rhs.frozen().bound;
  GrowthMeter meter = spectrum.modes.empty()
                          ? GrowthMeter(rhs, spectrum.shape, modes_of(spectrum.kind), spectrum.rising)
                          : GrowthMeter(rhs, std::move(spectrum.modes));
  for (const auto& method : stability_limits(quick)) {
    out.limits.push_back(find_limit(rhs, meter, method, spectrum));
    if (done) done();
  }
  return out;
}

void study_frozen_states(const Scene& scene, bool quick, Progress& progress, StabilityResults& results) {
  progress.begin("states along a run", 1);
  const StatesOfRun run = states_along_run(scene);
  progress.end();
  add_notes(scene, results.notes);
  results.notes.insert(results.notes.end(), run.notes.begin(), run.notes.end());

  std::vector<std::pair<const StateOfRun*, FrozenJacobian>> kept;
  for (const auto& state : run.states) {
    FrozenJacobian jacobian = freeze(*scene.rhs, state.time, state.y, run.spans);
    if (!(jacobian.largest() > 0)) {
      results.notes.push_back(at(state) + ": left out, the Jacobian is zero and nothing limits the step");
      continue;
    }
    const auto same = std::find_if(kept.begin(), kept.end(), [&](const auto& earlier) {
      return jacobian.equals(earlier.second, accuracy_of_states);
    });
    if (same != kept.end())
      results.notes.push_back(fmt::format("{}: left out, the Jacobian is that {} within {:.0e}", at(state),
                                          at(*same->first), accuracy_of_states));
    else
      kept.emplace_back(&state, std::move(jacobian));
  }
  const auto whole = kept.size() * stability_limits(quick).size();
  progress.begin("limits at frozen states", static_cast<double>(whole));
  double count = 0;
  for (auto& [state, jacobian] : kept) {
    FrozenRhs rhs(*scene.rhs, std::move(jacobian));
    results.states.push_back(find_limits(rhs, quick, [&] { progress.reached(count += 1); }));
    results.states.back().part = state->part;
    results.states.back().time = state->time;
  }
  progress.end();
}

}  // namespace superstep
