/// Every integrator on coupled and nonlinear scenes, and against solutions in closed form.

#include "support/thermoelectric.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "integrators/registry.hpp"
#include "rhs/one_way.hpp"
#include "support/problem.hpp"

namespace superstep {
namespace {

using test::CoupledRun;
using test::run_coupled;
using test::Thermoelectric;

double worst_difference(const CoupledRun& a, const CoupledRun& b) {
  double worst = 0;
  for (std::size_t k = 0; k < b.states.size(); ++k)
    worst = std::max(worst, test::max_difference(a.states[k], b.states[k]));
  return worst;
}

std::vector<std::string> all_specs() {
  std::vector<std::string> specs;
  for (const auto& entry : integrators()) {
    specs.push_back(entry.name);
    specs.insert(specs.end(), entry.examples.begin(), entry.examples.end());
  }
  return specs;
}

class EveryMethod : public ::testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Thermoelectric, EveryMethod, ::testing::ValuesIn(all_specs()), [](const auto& spec) {
  std::string name = spec.param;
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
});

/// Some relaxation times of the slowest mode.
const std::vector<double> times = {1.0, 4.0, 15.0};

void expect_the_answer(const std::string& spec, const Thermoelectric& settings) {
  if (spec.find("step=") != std::string::npos) GTEST_SKIP() << "its fixed step is made for another network";
  const auto rhs = settings.build();
  const auto reference = run_coupled(*rhs, "cvode:rtol=1e-11", times);
  ASSERT_TRUE(reference.outcome.ok()) << reference.outcome.reason;
  const auto result = run_coupled(*rhs, spec, times);
  if (result.outcome.status == Status::refused) {
    EXPECT_GT(result.outcome.reason.size(), 20U);  // says why
    return;
  }
  ASSERT_TRUE(result.outcome.ok()) << result.outcome.reason;
  const bool first_order = spec.find("euler") != std::string::npos || spec.find("sts") != std::string::npos ||
                           spec.find("order=1") != std::string::npos;
  double largest = 0;
  for (const double value : reference.states.back()) largest = std::max(largest, std::abs(value));
  // Default first-order steps reach a good part of the first output; the loosest rtol is 1e-4 and adds up
  // over the steps.
  EXPECT_LT(worst_difference(result, reference) / largest, first_order ? 0.1 : 2e-3) << spec;
}

TEST_P(EveryMethod, OneWay) {
  expect_the_answer(GetParam(), {.nodes = 40});
}

/// Neither field acts on the other, and both follow tables of time.
TEST_P(EveryMethod, FieldsThatLeaveEachOtherAlone) {
  if (GetParam() == "sts" || GetParam() == "sts:n=20,nu=1e-3")
    GTEST_SKIP() << "its superstep is as long as the pieces of the tables";
  expect_the_answer(GetParam(), {.nodes = 40, .joule_heat = false, .convection = true, .tables = true});
}

TEST_P(EveryMethod, SteadyPotentialThatHeatsNothing) {
  expect_the_answer(GetParam(),
                    {.nodes = 40, .steady = true, .joule_heat = false, .convection = true, .tables = true});
}

TEST_P(EveryMethod, TwoWayWithEverything) {
  using Kind = ConductivityLaw::Kind;
  const ConductivityLaw line{.kind = Kind::linear, .value = 2, .coefficient = -0.1, .reference = 0.2};
  const ConductivityLaw rise{
      .kind = Kind::sigmoid, .value = 1, .reference = 0.4, .amplitude = 1, .steepness = 2};
  expect_the_answer(GetParam(), {.nodes = 40,
                                 .thermal = {line, rise},
                                 .electric = {rise, line},
                                 .convection = true,
                                 .radiation = true,
                                 .tables = true});
}

TEST_P(EveryMethod, SteadyPotentialThatFollowsTheTemperature) {
  using Kind = ConductivityLaw::Kind;
  const ConductivityLaw line{.kind = Kind::linear, .value = 2, .coefficient = -0.1, .reference = 0.2};
  const ConductivityLaw rise{
      .kind = Kind::sigmoid, .value = 1, .reference = 0.4, .amplitude = 1, .steepness = 2};
  expect_the_answer(GetParam(), {.nodes = 40, .steady = true, .electric = {rise, line}});
}

TEST_P(EveryMethod, StoresTheHeatThatTheCurrentMakes) {
  if (GetParam().find("step=15") != std::string::npos) GTEST_SKIP() << "steps too long for this transient";
  const auto rhs = Thermoelectric{.nodes = 40}.build();  // insulated
  const auto result = run_coupled(*rhs, GetParam(), times);
  if (result.outcome.status == Status::refused) GTEST_SKIP() << result.outcome.reason;
  ASSERT_TRUE(result.outcome.ok()) << result.outcome.reason;
  const auto& field = rhs->fields()[1];
  const auto stored = [&](const CoupledRun& of) {
    double sum = 0;
    for (std::size_t i = field.offset; i < rhs->size(); ++i)
      sum += rhs->capacities()[i] * of.states.back()[i];
    return sum;
  };
  const auto truth = run_coupled(*rhs, "cvode:rtol=1e-11", times);
  ASSERT_GT(stored(truth), 1);
  EXPECT_NEAR(truth.statistics.inflow / stored(truth), 1.0, 1e-9);  // by its own quadrature
  // Nothing leaves: what is missing or too much is the error of the heat, a few tolerances, or a first-order
  // step's part of the transient.
  EXPECT_NEAR(stored(result) / stored(truth), 1.0, 2e-2);
}

TEST(OneWayExponential, FollowsItsTolerance) {
  const auto rhs = Thermoelectric{.nodes = 60}.build();
  const auto reference = run_coupled(*rhs, "cvode:rtol=1e-12", times);
  double before = 1;
  for (const char* spec : {"exponential:rtol=1e-3", "exponential:rtol=1e-5", "exponential:rtol=1e-7"}) {
    const auto result = run_coupled(*rhs, spec, times);
    ASSERT_TRUE(result.outcome.ok()) << result.outcome.reason;
    const double error = worst_difference(result, reference);
    EXPECT_LT(error, 10 * std::stod(std::string(spec).substr(17)))
        << spec;  // rms is asked for, this is the max
    EXPECT_LT(error, before);
    before = error;
  }
}

TEST(OneWayExponential, KeepsFixedTemperaturesAndSources) {
  // Convection makes ghosts: the affine part of the temperature's half and its share of the heat balance.
  const auto rhs = Thermoelectric{.nodes = 30, .convection = true}.build();
  const auto reference = run_coupled(*rhs, "cvode:rtol=1e-12", times);
  const auto result = run_coupled(*rhs, "exponential:rtol=1e-9", times);
  ASSERT_TRUE(result.outcome.ok()) << result.outcome.reason;
  EXPECT_LT(worst_difference(result, reference), 1e-7);
  double stored = 0;
  for (std::size_t i = rhs->fields()[1].offset; i < rhs->size(); ++i)
    stored += rhs->capacities()[i] * result.states.back()[i];
  EXPECT_NEAR(result.statistics.inflow / stored, 1.0, 1e-8);
}

TEST(OneWayExponential, RefusesWhatIsNotOneWay) {
  const ConductivityLaw line{.kind = ConductivityLaw::Kind::linear, .value = 2, .coefficient = -0.1};
  for (const auto& settings : {Thermoelectric{.electric = {line, line}}, Thermoelectric{.radiation = true}}) {
    const auto rhs = settings.build();
    const auto result = run_coupled(*rhs, "exponential", times);
    EXPECT_EQ(result.outcome.status, Status::refused);
    EXPECT_NE(result.outcome.reason.find("constant"), std::string::npos);
  }
}

TEST(OneWayExponential, FollowsInputsThatChangeInTime) {
  const auto rhs = Thermoelectric{.nodes = 20, .convection = true, .tables = true}.build();
  const auto expected = run_coupled(*rhs, "cvode:rtol=1e-11", {0.2, 0.5, 0.9, 3.0});
  const auto found = run_coupled(*rhs, "exponential:rtol=1e-10", {0.2, 0.5, 0.9, 3.0});
  ASSERT_TRUE(expected.outcome.ok() && found.outcome.ok()) << found.outcome.reason;
  EXPECT_LT(worst_difference(expected, found),
            1e-8);  // both are good to their tolerances, of spans of order 1
}

TEST(SettledPotential, IsNoLongerSteppedAndCostsNoAccuracy) {
  const std::vector<double> late = {60.0};
  for (const char* spec :
       {"forward-euler", "sts:n=5,nu=0.05", "rkc:rtol=1e-5", "rock:rtol=1e-5", "cvode:rtol=1e-5",
        "esdirk:rtol=1e-5", "trapezoidal:rtol=1e-5", "exponential:rtol=1e-5"}) {
    const auto stepped = Thermoelectric{.nodes = 40}.build(), settling = Thermoelectric{.nodes = 40}.build();
    const auto a = run_coupled(*stepped, spec, late), b = run_coupled(*settling, spec, late, {0, 0}, 1e-9);
    ASSERT_TRUE(a.outcome.ok() && b.outcome.ok()) << spec << a.outcome.reason << b.outcome.reason;
    EXPECT_TRUE(b.settled_at.has_value()) << spec;
    EXPECT_FALSE(a.settled_at.has_value()) << spec;
    const bool solves = b.statistics.solves > 0;  // its sweeps are few beside those of the pilot run
    EXPECT_LT(settling->counters().sweeps,
              (solves ? 1.1 : 0.9) * static_cast<double>(stepped->counters().sweeps))
        << spec;
    const double scale = std::abs(a.states[0].back());
    EXPECT_LT(worst_difference(a, b), 1e-3 * scale) << spec;  // other steps, the same answer
  }
}

/// Passes everything on and notes how many probes each preparation was told of.
class CountsProbes final : public Method {
 public:
  CountsProbes(std::unique_ptr<Method> inner, std::vector<std::size_t>& probes)
      : inner_(std::move(inner)), probes_(&probes) {}
  void prepare(Rhs& rhs, const Task& task) override {
    for (const std::size_t entry : task.plan->probes) EXPECT_LT(entry, rhs.size());
    probes_->push_back(task.plan->probes.size());
    inner_->prepare(rhs, task);
  }
  [[nodiscard]] double rtol() const override { return inner_->rtol(); }
  [[nodiscard]] OneStepMethod* one_step() override { return inner_->one_step(); }
  [[nodiscard]] Propagator* propagator() override { return inner_->propagator(); }
  void add_counts(Statistics& statistics) const override { inner_->add_counts(statistics); }
  void reset_counts() override { inner_->reset_counts(); }

 private:
  std::unique_ptr<Method> inner_;
  std::vector<std::size_t>* probes_;
};

/// What remains is a right-hand side of its own: entries of the whole state lie beyond it, and what it knows
/// of its error says nothing of the time before.
TEST(SettledPotential, LeavesNoProbesAndNoBoundToTheRest) {
  for (const char* spec :
       {"exponential:rtol=1e-5", "exponential:basis=chebyshev,rtol=1e-5", "rkc:rtol=1e-5"}) {
    const auto rhs = Thermoelectric{.nodes = 40}.build();
    std::vector<std::size_t> probes;
    ProbeHistory history(1);
    Plan plan;
    plan.output_times = {60, 70};
    plan.ranges = {{0, 1}, {0, 0}};
    plan.spans = {1, 1};
    plan.probes = {rhs->size() - 1};
    plan.history = &history;
    plan.settle_tolerance = 1e-9;
    Integrator integrator(std::make_unique<CountsProbes>(make_method(spec), probes));
    integrator.prepare(*rhs, plan);
    const std::vector<double> rest(rhs->size(), 0.0);
    for (const std::size_t expected : {2, 4}) {  // preparations; started again, the whole is prepared, too
      integrator.start(0, rest);
      ASSERT_TRUE(integrator.advance(60).ok() && integrator.advance(70).ok()) << spec;
      ASSERT_TRUE(integrator.settled_at().has_value()) << spec;
      ASSERT_EQ(probes.size(), expected) << spec;
      EXPECT_EQ(probes[expected - 2], 1U) << spec;
      EXPECT_EQ(probes[expected - 1], 0U) << spec;
      EXPECT_EQ(integrator.statistics().error_bound, 0) << spec;
      EXPECT_EQ(history.value(history.size() - 1, 0), integrator.state().back()) << spec;
    }
  }
}

TEST(Automatic, DeliversItsToleranceOnANonlinearScene) {
  const ConductivityLaw line{
      .kind = ConductivityLaw::Kind::linear, .value = 2, .coefficient = -0.1, .reference = 0.2};
  const auto rhs =
      Thermoelectric{.nodes = 200, .thermal = {line, line}, .electric = {line, line}, .convection = true}
          .build();
  const auto reference = run_coupled(*rhs, "cvode:rtol=1e-11", times);
  for (const char* tolerance : {"1e-2", "1e-3", "1e-4", "1e-5", "1e-6", "1e-7"}) {
    const auto result = run_coupled(*rhs, std::string("auto:rtol=") + tolerance, times);
    ASSERT_TRUE(result.outcome.ok()) << result.outcome.reason;
    for (const auto& field : rhs->fields()) {
      double low = 0, high = field.name == "potential" ? 1 : 0, sum = 0;
      for (std::size_t i = field.offset; i < field.offset + field.count; ++i) {
        low = std::min(low, reference.states.back()[i]);
        high = std::max(high, reference.states.back()[i]);
        const double error = result.states.back()[i] - reference.states.back()[i];
        sum += error * error;
      }
      EXPECT_LE(std::sqrt(sum / static_cast<double>(field.count)), std::stod(tolerance) * (high - low))
          << tolerance << ' ' << field.name;
    }
  }
}

TEST(ForwardEuler, StepsFarBelowASigmoidAsIfThereWereNone) {
  // 700 widths below the rise the law moves nothing, and the cross terms of the Jacobian are some 1e-300.
  const ConductivityLaw rise{
      .kind = ConductivityLaw::Kind::sigmoid, .value = 3, .reference = 700, .amplitude = 2, .steepness = 1};
  const ConductivityLaw constant{.value = 3};
  const Thermoelectric far{
      .nodes = 40, .thermal = {{.value = 2e-3}, {.value = 1e-3}}, .electric = {rise, rise}};
  Thermoelectric without = far;
  without.electric = {constant, constant};
  const auto expected = run_coupled(*without.build(), "forward-euler", {1.0}),
             result = run_coupled(*far.build(), "forward-euler", {1.0});
  ASSERT_TRUE(result.outcome.ok()) << result.outcome.reason;
  // The two bounds of the spectrum are different ones, each within a factor 2 of the truth.
  EXPECT_LE(result.statistics.steps, 2 * expected.statistics.steps);
  EXPECT_LT(test::max_difference(result.states[0], expected.states[0]), 0.1);  // Euler's own error
}

TEST(LinearConductivity, OfASteadyChainHasItsClosedForm) {
  // One free node between 0 and 1 with kappa = 1 + b T: K(T1, T0)(T1 - 0) = K(T1, T2)(1 - T1), arithmetic
  // mean: (1 + b T1/2) T1 = (1 + b (1 + T1)/2)(1 - T1), the quadratic b T1^2 + 2 T1 - (1 + b/2) = 0.
  const double b = 0.8;
  Graph graph = test::chain(3, 0.0, 1.0);
  // Reference conductivity 1 at T = 0.
  const ConductivityLaw law{.kind = ConductivityLaw::Kind::linear, .value = 1, .coefficient = b};
  NonlinearInput input;
  input.temperature.network = build_network(graph, test::plain_roles(graph));
  input.temperature.laws = {{law}, {0, 0, 0}, ConductanceMean::arithmetic};
  for (std::int32_t node = 0; node < 3; node += 2)
    input.temperature.known.push_back({node, graph.fixed_value[static_cast<std::size_t>(node)], -1});
  NonlinearRhs rhs(std::move(input));
  const auto result = run_coupled(rhs, "cvode:rtol=1e-10", {60.0}, {0, 1});
  ASSERT_TRUE(result.outcome.ok());
  EXPECT_NEAR(result.states[0][0], (-1 + std::sqrt(1 + b * (1 + b / 2))) / b, 1e-8);
}

}  // namespace
}  // namespace superstep
