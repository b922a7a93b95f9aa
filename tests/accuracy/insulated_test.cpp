/// Bodies that lose no heat, of good and bad conductors: what all values share moves a million times slower
/// than what they do not, and must not be lost in iterations.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numeric>
#include <random>

#include "bench/measure/run_one.hpp"
#include "support/problem.hpp"
#include "support/temporary_case.hpp"

namespace superstep {
namespace {

constexpr std::size_t side = 6, nodes = side * side * side;
constexpr double t_end = 1e3;  // ten thousand million times what the fastest exchange takes

/// A cubic lattice of capacities 1 at 300 K; conductivity(k) of its nodes, some of which are heated.
template <class Conductivity>
Graph lattice(std::size_t along, const Conductivity& conductivity, std::initializer_list<std::size_t> heated,
              double source) {
  Graph graph;
  for (std::size_t k = 0; k < along * along * along; ++k) {
    graph.id.push_back(static_cast<std::int64_t>(k));
    graph.capacity.push_back(1);
    graph.source.push_back(std::find(heated.begin(), heated.end(), k) == heated.end() ? 0 : source);
    graph.initial.push_back(300);
    graph.is_fixed.push_back(0);
    graph.fixed_value.push_back(0);
    const std::array<std::size_t, 3> at = {k % along, k / along % along, k / (along * along)};
    for (std::size_t axis = 0, step = 1; axis < 3; ++axis, step *= along) {
      if (at[axis] + 1 == along) continue;
      const double a = conductivity(k), b = conductivity(k + step);
      graph.i.push_back(static_cast<std::int32_t>(k));
      graph.j.push_back(static_cast<std::int32_t>(k + step));
      graph.conductance.push_back(2 * a * b / (a + b));
    }
  }
  return graph;
}

/// Three of four nodes are a million times the better conductor.
bool is_poor(std::size_t k) {
  return k * 7919 % 4 == 0;
}

class Insulated : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Iterations, Insulated,
                         testing::Values("cvode:rtol=1e-4,linsol=gmres", "cvode:rtol=1e-4,linsol=pcg",
                                         "arkode:rtol=1e-4,linsol=gmres", "petsc:rtol=1e-4,linsol=gmres",
                                         "petsc:rtol=1e-4,linsol=hypre", "esdirk:rtol=1e-4,solver=pcg",
                                         "exprb:rtol=1e-4", "auto:rtol=1e-4"),
                         [](const auto& spec) {
                           std::string name = spec.param;
                           for (char& c : name)
                             if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                           return name;
                         });

TEST_P(Insulated, BodiesKeepTheHeatThatEntersThem) {
  test::Problem problem(lattice(
      side, [](std::size_t k) { return is_poor(k) ? 1.0 : 1e6; }, {5, 100, 200}, 1));
  const auto run = test::run(GetParam(), problem, {t_end});
  if (run.outcome.status == Status::refused) GTEST_SKIP() << run.outcome.reason;
  ASSERT_TRUE(run.outcome.ok()) << run.outcome.reason;
  const auto& end = run.states.back();
  const double mean = std::accumulate(end.begin(), end.end(), 0.0) / static_cast<double>(nodes);
  const double expected = 300 + 3 * t_end / static_cast<double>(nodes);
  EXPECT_NEAR(mean, expected, 3e-4 * (expected - 300));
  EXPECT_LT(run.statistics.steps, 2000U);
}

/// The same of spheres whose conductivity follows the temperature, heated by a pulse in the middle of the
/// run.
TEST_P(Insulated, BodiesWithLawsKeepTheHeatOfAPulse) {
  const test::CaseFolder folder;
  std::string spheres = "id,x,y,z,radius,material\n";
  for (std::size_t k = 0; k < nodes; ++k)
    spheres += fmt::format("{},{},{},{},0.5,{}\n", k, 0.95 * static_cast<double>(k % side),
                           0.95 * static_cast<double>(k / side % side),
                           0.95 * static_cast<double>(k / (side * side)), is_poor(k) ? "poor" : "good");
  folder.write("p.csv", spheres);
  const auto material = [](const char* name, double conductivity) {
    return fmt::format(
        "[[materials]]\nname = \"{}\"\ndensity = 2500.0\nthermal = {{ conductivity = {{ law = \"linear\", "
        "value = "
        "{}, coefficient = 1e-3, reference = 300.0 }}, specific_heat = 800.0 }}\n",
        name, conductivity);
  };
  const Scene scene = load_scene(folder.write(
      "c.toml",
      "t_end = 1e4\noutput_times = [1e4]\n[packing]\nfile = \"p.csv\"\nlength_unit = \"mm\"\n[contact]\n"
      "neck = \"hertz\"\n" +
          material("good", 400) + material("poor", 4e-4) +
          "[thermal]\ninitial = 300.0\nsource = [ { where = { ids = [5, 100, 200] }, value = { times = "
          "[0, 4000, 4000, 5000, 5000, 10000], values = [0, 0, 1e-5, 1e-5, 0, 0] } } ]\n"));
  std::vector<double> end;
  RunRequest request;
  request.observe = [&](std::size_t, double, std::span<const double> state) {
    end.assign(state.begin(), state.end());
  };
  const Outcome outcome = run_one(scene, GetParam(), request).outcome;
  if (outcome.status == Status::refused) GTEST_SKIP() << outcome.reason;
  ASSERT_TRUE(outcome.ok()) << outcome.reason;
  const auto temperature = scene.values_on_nodes(0, 1e4, end);
  double gained = 0, capacity = 0;
  for (std::size_t k = 0; k < nodes; ++k) {
    gained += scene.fields[0].graph.capacity[k] * (temperature[k] - 300);
    capacity += scene.fields[0].graph.capacity[k];
  }
  const double expected = 3 * 1e-5 * 1000;  // J
  EXPECT_NEAR(gained, expected, 3e-4 * expected) << "a mean of " << gained / capacity << " K";
}

/// A space that may hold no more vectors cuts steps short; what it is wrong by in each of them adds up.
TEST(CutShort, ErrorsOfManySpacesDoNotAddUp) {
  constexpr std::size_t along = 9;
  std::mt19937_64 random(5);
  std::vector<double> conductivity;
  for (std::size_t k = 0; k < along * along * along; ++k)
    conductivity.push_back(std::pow(1e6, static_cast<double>(random() >> 11) * 0x1p-53));
  Graph graph = lattice(
      along, [&](std::size_t k) { return conductivity[k]; }, {35, 88, 111}, 1e-3);
  for (double& start : graph.initial) start += 5 * static_cast<double>(random() >> 11) * 0x1p-53;
  test::Problem problem(std::move(graph));
  const auto right = test::run("exponential:basis=shift-invert,rtol=1e-10", problem, {t_end});
  const auto found = test::run("exprb:rtol=1e-4", problem, {t_end});
  ASSERT_TRUE(right.outcome.ok() && found.outcome.ok());
  const auto [low, high] = std::minmax_element(problem.initial.begin(), problem.initial.end());
  EXPECT_LT(test::rms_difference(found.states[0], right.states[0]), 3e-4 * (*high - *low));
  EXPECT_GT(found.statistics.rejected, 100U) << "steps are cut short";
}

}  // namespace
}  // namespace superstep
