/// The laboratory on scenes of every class, frozen at states of a run: limits predicted and measured.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/lab/frozen/limits.hpp"
#include "bench/lab/frozen/spectrum.hpp"
#include "bench/lab/frozen/states_of_run.hpp"
#include "support/problem.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

using test::Problem;
using test::TemporaryFolder;

/// Spheres on a simple cubic lattice of 1 mm that overlap a little; every third one of the second material
/// where there are two.
std::string block(int n, int height, bool two_materials = false) {
  std::string rows = two_materials ? "id,x,y,z,radius,material\n" : "id,x,y,z,radius\n";
  int id = 0;
  for (int z = 0; z < height; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x, ++id) {
        rows += fmt::format("{},{},{},{},0.51", id, x, y, z);
        rows += two_materials ? (id % 3 == 0 ? ",polymer\n" : ",metal\n") : "\n";
      }
  return rows;
}

struct SceneText {
  std::string name;
  std::string kind;                    ///< of the spectrum after the start: "symmetric" or "real"
  std::size_t states = 1;              ///< that are left when equal ones are dropped
  std::string toml;                    ///< beside packing and contact
  std::string nodes = {}, edges = {};  ///< of a network given directly
  std::string packing = block(3, 8);
  std::string materials = "[material]\ndensity = 7800.0\n";
};

void PrintTo(const SceneText& scene, std::ostream* out) {
  *out << scene.name;
}

Scene build(const TemporaryFolder& folder, const SceneText& text) {
  std::string toml = text.toml;
  if (!text.nodes.empty()) {
    folder.write("nodes.csv", "id,capacity,source,initial,fixed\n" + text.nodes);
    folder.write("edges.csv", "i,j,conductance\n" + text.edges);
    toml += "[network]\nnodes = \"nodes.csv\"\nedges = \"edges.csv\"\nfield = \"temperature\"\n";
  } else {
    folder.write("block.csv", text.packing);
    const auto split = toml.find('[');  // keys of the case stand before the first table
    toml.insert(split, "[packing]\nfile = \"block.csv\"\nlength_unit = \"mm\"\n" + text.materials +
                           "[contact]\nneck = \"hertz\"\n");
  }
  return load_scene(folder.write("scene.toml", toml));
}

std::string held(double top, double bottom) {
  return fmt::format(
      "fixed = [ {{ where = {{ layer = {{ side = \"top\", thickness = 0.9 }} }}, value = {} }}, {{ where = "
      "{{ "
      "layer = {{ side = \"bottom\", thickness = 0.9 }} }}, value = {} }} ]\n",
      top, bottom);
}

const std::string metal = "conductivity = 50.0\nspecific_heat = 460.0\ninitial = 300.0\n";
const std::string sigmoid =
    "conductivity = { law = \"sigmoid\", value = 1e4, amplitude = 1.5, steepness = 0.05, reference = 330.0 "
    "}\n";

std::string electric(const std::string& mode, const std::string& conductivity) {
  return "[electric]\nmode = \"" + mode + "\"\n" + conductivity +
         (mode == "transient" ? "specific_capacity = 2e4\n" : "") + held(2.0, 0.0);
}

/// A ring of 40 nodes; `more` edges follow. Node 0 is held at 1 K.
SceneText ring(const std::string& name, double (*conductance)(int k), const std::string& more) {
  SceneText out{.name = name, .kind = "symmetric", .toml = "t_end = 10\n"};
  for (int k = 0; k < 40; ++k) {
    out.nodes += fmt::format("{},{},0.1,0,{}\n", k, 1 + k % 3, k == 0 ? "1" : "");
    out.edges += fmt::format("{},{},{}\n", k, (k + 1) % 40, conductance(k));
  }
  out.edges += more;
  return out;
}

std::vector<SceneText> scenes() {
  std::string spokes, second_cluster;
  for (int k = 4; k < 38; k += 2) spokes += fmt::format("2,{},1\n", k);
  std::vector<SceneText> out = {
      ring(
          "linear", [](int) { return 1.0; }, ""),
      ring(
          "hubs", [](int) { return 1.0; }, spokes),
      ring(
          "high_contrast", [](int k) { return std::pow(10.0, 8 * ((7 * k) % 40) / 39.0 - 4); }, ""),
      ring(
          "disconnected", [](int k) { return k == 19 || k == 39 ? 0.0 : 1.0 + k; }, ""),
  };
  const auto thermal = [](const std::string& more) { return "t_end = 20.0\n[thermal]\n" + metal + more; };
  out.push_back({"driven", "symmetric", 1,
                 thermal(held(400, 300) +
                         "source = [ { where = { ids = [40] }, value = { times = [2.0, 3.0, 5.0], values = "
                         "[0.0, 10.0, 0.0] } } ]\n")});
  out.push_back(
      {"convection", "symmetric", 1,
       thermal("convection = [ { where = \"all\", coefficient = 5e3, ambient = { times = [1.0, 2.0], "
               "values = [300.0, 400.0] } } ]\n")});
  out.push_back({"radiation", "symmetric", 4,
                 "t_end = 4.0\n[thermal]\n" + metal +
                     "radiation = [ { where = \"all\", emissivity = 0.8, ambient = 1500.0 } ]\n"});
  out.push_back(
      {"conductivity_by_table", "real", 4,
       "t_end = 2.0\n[thermal]\nconductivity = { law = \"table\", temperatures = [250.0, 450.0, 700.0], "
       "values = [50.0, 20.0, 80.0] }\nspecific_heat = 460.0\ninitial = 300.0\n" +
           held(600, 300)});
  out.push_back({"conductivity_by_sigmoid", "real", 4,
                 "t_end = 2.0\n[thermal]\nconductivity = { law = \"sigmoid\", value = 20.0, amplitude = 3.0, "
                 "steepness = 0.05, reference = 450.0 }\nspecific_heat = 460.0\ninitial = 300.0\n" +
                     held(600, 300)});
  out.push_back({"one_way", "real", 4,
                 "t_end = 2.0\n" + electric("transient", "conductivity = 1e4\n") + "[thermal]\n" + metal});
  out.push_back({"two_way", "real", 4,
                 "t_end = 5.0\n" + electric("transient", sigmoid) + "[thermal]\n" + metal + held(300, 300)});
  out.push_back({"two_way_large",
                 "real",
                 4,
                 "t_end = 5.0\n" + electric("transient", sigmoid) + "[thermal]\n" + metal + held(300, 300),
                 {},
                 {},
                 block(5, 9)});
  out.push_back({"steady_potential", "symmetric", 1,
                 "t_end = 5.0\n" + electric("steady", "conductivity = 1e4\n") + "[thermal]\n" + metal});
  out.push_back({"steady_potential_that_follows", "real", 4,
                 "t_end = 5.0\n" + electric("steady", sigmoid) + "[thermal]\n" + metal});
  out.push_back({"two_materials",
                 "symmetric",
                 1,
                 "t_end = 20.0\n[thermal]\ninitial = 300.0\n" + held(400, 300),
                 {},
                 {},
                 block(3, 8, true),
                 "[[materials]]\nname = \"metal\"\ndensity = 7800.0\nthermal = { conductivity = 200.0, "
                 "specific_heat = 460.0 }\n[[materials]]\nname = \"polymer\"\ndensity = 1200.0\nthermal = { "
                 "conductivity = 0.02, specific_heat = 1500.0 }\n"});
  return out;
}

class EveryClassOfScene : public ::testing::TestWithParam<SceneText> {};

TEST_P(EveryClassOfScene, PredictsTheLimitsThatAreMeasured) {
  const TemporaryFolder folder;
  const Scene scene = build(folder, GetParam());
  StabilityResults results;
  Progress silent(false);
  study_frozen_states(scene, true, silent, results);
  ASSERT_EQ(results.states.size(), GetParam().states);
  EXPECT_EQ(results.states.back().spectrum, GetParam().kind);
  for (const auto& state : results.states) {
    SCOPED_TRACE(fmt::format("t = {}", state.time));
    if (!scene.moving_potential && scene.fields.size() == 1) {  // Joule heat that rises with temperature may
      EXPECT_EQ(state.rising, 0);
    }
    EXPECT_GE(state.certified_bound, state.lambda_max * (1 - 1e-9)) << "a bound is one";
    EXPECT_LE(state.lambda_residual, 1e-5 * state.lambda_max);
    ASSERT_EQ(state.limits.size(), 3U);  // forward Euler, an STS pair, RKC with one number of stages
    for (const auto& limit : state.limits) {
      SCOPED_TRACE(limit.spec);
      const bool is_euler = limit.family == "forward-euler";
      ASSERT_EQ(limit.predicted.has_value(), is_euler || state.spectrum != "complex");
      if (!limit.predicted) continue;
      EXPECT_NEAR(*limit.predicted / limit.measured, 1, 0.02);
      EXPECT_EQ(limit.verdict, FrozenLimit::Verdict::agrees);
      EXPECT_NEAR(*limit.growth_at_predicted, 1, 0.05);
      // Of orthogonal modes no step is called stable at which the stiffest one grows, but for rounding.
      if (state.spectrum == "symmetric") {
        EXPECT_LE(limit.measured, *limit.predicted * (1 + 1e-6));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Laboratory, EveryClassOfScene, ::testing::ValuesIn(scenes()),
                         [](const auto& one) { return one.param.name; });

/// The frozen scene against what it stands for: f at two states nearby.
TEST_P(EveryClassOfScene, IsTheSlopeOfTheRightHandSide) {
  const TemporaryFolder folder;
  const Scene scene = build(folder, GetParam());
  if (scene.moving_potential) GTEST_SKIP() << "the potential is frozen, too, and f is not";
  const auto run = states_along_run(scene);
  for (const auto& state : run.states) {
    SCOPED_TRACE(fmt::format("t = {}", state.time));
    FrozenRhs frozen(*scene.rhs, freeze(*scene.rhs, state.time, state.y, run.spans));
    const auto n = scene.rhs->size();
    std::vector<double> direction(n), up(state.y), down(state.y), f_up(n), f_down(n), product(n);
    constexpr double reach =
        1e-5;  // K or V: no state lies as near to a knot of a table, and differences keep seven digits
    for (const auto& field : scene.rhs->fields())
      for (std::size_t k = 0; k < field.count; ++k) {
        const std::size_t i = field.offset + k * field.stride;
        direction[i] = std::sin(1.0 + 3.0 * static_cast<double>(i));
        up[i] += reach * direction[i];
        down[i] -= reach * direction[i];
      }
    (*scene.rhs)(state.time, up, f_up);
    (*scene.rhs)(state.time, down, f_down);
    frozen(0, direction, product);
    double largest = 0, worst = 0;
    for (std::size_t i = 0; i < n; ++i) {
      largest = std::max(largest, std::abs(product[i]));
      worst = std::max(worst, std::abs((f_up[i] - f_down[i]) / (2 * reach) - product[i]));
    }
    EXPECT_LE(worst, 1e-5 * largest);
  }
}

// ---- spectra that are known ----

/// A right-hand side of two unknowns with any Jacobian, rows (a, b) and (c, d).
FrozenRhs two_by_two(const Problem& problem, double a, double b, double c, double d) {
  FrozenJacobian jacobian;
  jacobian.pattern = {.column_begin = {0, 2, 4}, .row = {0, 1, 0, 1}, .diagonal = {0, 3}};
  jacobian.values = {a, c, b, d};
  jacobian.weights = {1, 1};
  jacobian.bound = std::max(std::abs(a) + std::abs(b), std::abs(c) + std::abs(d));
  jacobian.traits = {.linear = true, .constant_jacobian = true, .symmetric = b == c, .autonomous = true};
  return {*problem.rhs, std::move(jacobian)};
}

TEST(FrozenSpectrum, OfATurningPairPredictsForwardEulerAlone) {
  const Problem problem(test::chain(2));
  ASSERT_EQ(problem.rhs->size(), 2U);
  auto rhs = two_by_two(problem, -3, 4, -4, -3);  // -3 +- 4i
  const auto state = find_limits(rhs, true);
  EXPECT_EQ(state.spectrum, "complex");
  EXPECT_NEAR(state.lambda_max, 5, 1e-12);
  EXPECT_NEAR(state.lambda_imaginary, 4, 1e-12);
  ASSERT_TRUE(state.limits[0].predicted);
  EXPECT_NEAR(*state.limits[0].predicted, 6.0 / 25, 1e-12);
  EXPECT_NEAR(state.limits[0].measured, 6.0 / 25, 2e-4 * 6 / 25)
      << "modes of equal modulus: bisection's width";
  for (std::size_t k = 1; k < state.limits.size(); ++k) {
    EXPECT_EQ(state.limits[k].verdict, FrozenLimit::Verdict::not_predicted);
    EXPECT_FALSE(state.limits[k].predicted);
    EXPECT_GT(state.limits[k].measured, state.limits[0].measured);
  }
}

TEST(FrozenSpectrum, WhatGrowsByItselfDoesNotCountAgainstAStep) {
  const Problem problem(test::chain(2));
  auto rhs = two_by_two(problem, -100, 5, 0, 0.5);
  const auto state = find_limits(rhs, true);
  EXPECT_EQ(state.spectrum, "real");
  EXPECT_NEAR(state.rising, 0.5, 1e-12);
  for (const auto& limit : state.limits) {
    EXPECT_EQ(limit.verdict, FrozenLimit::Verdict::agrees) << limit.spec;
    EXPECT_TRUE(std::isfinite(limit.measured));
  }
  EXPECT_NEAR(*state.limits[0].predicted, 0.02, 1e-12);
}

TEST(FrozenSpectrum, OfOneEigenvalue) {
  EXPECT_DOUBLE_EQ(euler_limit({-4, 0}), 0.5);
  EXPECT_DOUBLE_EQ(euler_limit({-3, 4}), 6.0 / 25);
  EXPECT_TRUE(std::isinf(euler_limit({1, 0})));
  EXPECT_TRUE(std::isinf(euler_limit({0, 2})));
}

/// Arnoldi against a dense solver, on a scene that is just too large for the dense way.
TEST(FrozenSpectrum, OfALargeCoupledSceneIsTheDenseOne) {
  const auto all = scenes();
  const auto large =
      std::find_if(all.begin(), all.end(), [](const auto& one) { return one.name == "two_way_large"; });
  const TemporaryFolder folder;
  const Scene scene = build(folder, *large);
  const auto run = states_along_run(scene);
  FrozenRhs rhs(*scene.rhs, freeze(*scene.rhs, run.states.back().time, run.states.back().y, run.spans));
  ASSERT_GT(rhs.size(), most_for_all_eigenvalues);
  const auto spectrum = spectrum_of(rhs);
  EXPECT_EQ(spectrum.found_by, "Arnoldi");
  const auto n = static_cast<Eigen::Index>(rhs.size());
  Eigen::MatrixXd dense(n, n);
  std::vector<double> unit(rhs.size(), 0.0), column(rhs.size());
  for (Eigen::Index j = 0; j < n; ++j) {
    unit[static_cast<std::size_t>(j)] = 1;
    rhs(0, unit, column);
    unit[static_cast<std::size_t>(j)] = 0;
    for (Eigen::Index i = 0; i < n; ++i)  // in the norm of the fields, without which rounding rules
      dense(i, j) =
          column[static_cast<std::size_t>(i)] * std::sqrt(rhs.capacities()[static_cast<std::size_t>(i)] /
                                                          rhs.capacities()[static_cast<std::size_t>(j)]);
  }
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(dense, false);
  double largest = 0;
  for (Eigen::Index k = 0; k < n; ++k) largest = std::max(largest, std::abs(solver.eigenvalues()(k)));
  EXPECT_NEAR(std::abs(spectrum.limiting), largest, 1e-5 * largest);
}

// ---- instruments and notes ----

TEST(FrozenStates, SaysWhatItLeavesOut) {
  const auto all = scenes();
  const auto notes_of = [&](const std::string& name) {
    const auto one = std::find_if(all.begin(), all.end(), [&](const auto& s) { return s.name == name; });
    const TemporaryFolder folder;
    const Scene scene = build(folder, *one);
    StabilityResults results;
    Progress silent(false);
    study_frozen_states(scene, true, silent, results);
    std::string out;
    for (const auto& note : results.notes) out += note + "\n";
    return out;
  };
  EXPECT_NE(notes_of("linear").find("one state stands for all"), std::string::npos);
  EXPECT_NE(notes_of("one_way").find("potential first"), std::string::npos);
  EXPECT_NE(notes_of("steady_potential_that_follows").find("frozen with the state"), std::string::npos);
}

TEST(FrozenRhs, KnowsWhatItIs) {
  const Problem problem(test::chain(2));
  EXPECT_TRUE(two_by_two(problem, -2, 1, 1, -2).traits().symmetric);
  auto rhs = two_by_two(problem, -2, 1, 3, -4);
  std::vector<double> e = {1, -1}, out(2);
  rhs(5.0, e, out);
  EXPECT_EQ(out, (std::vector<double>{-3, 7}));
  const std::vector<double> other = {10, 20};
  rhs.stage(0, {.y1 = e.data(), .a = 2, .d = 0.5, .y2 = other.data(), .b = 3}, out);
  EXPECT_EQ(out, (std::vector<double>{2 - 1.5 + 30, -2 + 3.5 + 60}));
}

}  // namespace
}  // namespace superstep
