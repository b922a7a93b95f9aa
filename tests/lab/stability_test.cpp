/// The stability laboratory on networks whose answers are known.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>

#include "bench/lab/catalogue.hpp"
#include "bench/lab/chain.hpp"
#include "bench/lab/function.hpp"
#include "bench/lab/lab.hpp"
#include "bench/lab/methods.hpp"
#include "bench/lab/rounding.hpp"
#include "bench/lab/verdicts.hpp"
#include "core/error.hpp"
#include "integrators/schemes/super_step.hpp"
#include "reports/text/stability_report.hpp"
#include "results/study/stability_tables.hpp"
#include "support/problem.hpp"
#include "support/temporary_case.hpp"

namespace superstep {
namespace {

using test::CaseFolder;
using test::Problem;
using test::random_graph;

/// The quick laboratory on a rod of 18 free nodes, once for all tests.
const StabilityResults& rod_results() {
  static const StabilityResults results = [] {
    const CaseFolder folder;
    const Scene scene = load_scene(test::write_rod(folder, {}));
    Progress silent(false);
    return run_stability_lab(scene, true, silent);
  }();
  return results;
}

TEST(StabilityLab, EveryMethodBehavesAsItsTheorySays) {
  ASSERT_FALSE(rod_results().methods.empty());
  for (const auto& method : rod_results().methods) {
    if (method.order == "natural") continue;
    SCOPED_TRACE(method.spec);
    EXPECT_TRUE(method.agrees);
    EXPECT_LE(method.largest, 1 + 1e-9) << "inside its declared limit";
    EXPECT_LE(method.difference, 1e-9);
    EXPECT_NEAR(method.stiff_measured, method.stiff, 1e-9);
    EXPECT_LE(method.growth, 1 + 1e-9);
    if (!method.beta) continue;
    EXPECT_GE(*method.limit, *method.beta);
    EXPECT_NEAR(*method.beyond, 2, 1e-9);
    EXPECT_NEAR(*method.beyond_measured, 2, 0.02);
  }
  EXPECT_TRUE(is_consistent(rod_results()));
}

TEST(StabilityLab, LooksAtEveryFamily) {
  std::map<std::string, int> seen;
  for (const auto& method : rod_results().methods) ++seen[method.family];
  for (const char* family :
       {"forward-euler", "sts", "rkc1", "rkc2", "rkl1", "rkl2", "rkg2", "rock2", "rock4", "trapezoidal"})
    EXPECT_GT(seen[family], 0) << family;
}

TEST(StabilityLab, BisectionFindsWhatLanczosSays) {
  const auto& study = rod_results().critical_step;
  EXPECT_TRUE(study.agrees);
  // 18 free nodes between fixed ends: lambda_max = 4 sin^2(18 pi / 38).
  const double lambda_max = 4 * std::pow(std::sin(18 * std::numbers::pi / 38), 2);
  EXPECT_NEAR(rod_results().lambda_max, lambda_max, 1e-9);
  // Bisection ends at 1e-5; it never calls a step stable that Lanczos calls unstable.
  EXPECT_LE(study.limit, 2 / lambda_max * (1 + 1e-9));
  EXPECT_GE(study.limit, 2 / lambda_max * (1 - 3e-5));
  EXPECT_GE(study.lanczos_ratio, 1 - 1e-9);
  for (const auto& estimate : study.estimates) {
    SCOPED_TRACE(estimate.name);
    if (estimate.note == certified_bound) {
      EXPECT_EQ(estimate.tendency, Tendency::decays);
    }
    if (estimate.note == "sharp") {  // growth is 1 but for rounding
      EXPECT_EQ(estimate.tendency, Tendency::unclear);
    }
    if (estimate.of_limit > 1.001) {
      EXPECT_EQ(estimate.tendency, Tendency::grows);
      EXPECT_NEAR(estimate.growth, estimate.step * lambda_max - 1, 1e-4) << "that of the stiffest mode";
    }
  }
}

TEST(StabilityLab, RecordsNaturalOrderAsWrongAndTheOthersAsRight) {
  int wrong = 0;
  for (const auto& row : rod_results().rounding) {
    const bool lost = row.order == "natural" && row.n >= 64;
    EXPECT_EQ(row.right, !lost) << row.order << " n = " << row.n << " nu = " << row.nu;
    wrong += !row.right;
    if (row.order == "natural") continue;
    EXPECT_LT(row.amplification, 500) << row.order << " n = " << row.n;
    EXPECT_LT(row.rounding_error, 1e-11) << row.order << " n = " << row.n;
    EXPECT_LT(row.end_error, 1e-4) << row.order << " n = " << row.n;
  }
  EXPECT_EQ(wrong, 4);  // (64, 0.05), (128, 1e-3) and their cross pairs
  // The same is seen on the case's own network.
  for (const auto& method : rod_results().methods)
    if (method.order == "natural" && method.parameters == "n=128,nu=0.001") {
      EXPECT_FALSE(method.agrees);
    }
}

TEST(StabilityLab, BoundsHoldAtEveryContrast) {
  for (const auto& point : rod_results().sweeps) {
    EXPECT_GE(point.edge_ratio, 1 - 1e-9) << point.sweep << ' ' << point.contrast;
    EXPECT_GE(point.gershgorin_ratio, 1 - 1e-9) << point.sweep << ' ' << point.contrast;
    EXPECT_LE(point.bound_ratio, 2) << "no graph is worse than twice";
    EXPECT_GT(point.alpha, 0);
    // Backward Euler keeps the maximum principle.
    EXPECT_LT(point.overshoots.back().spans, 1e-9);
  }
}

TEST(StabilityLab, WritesTheColumnsItPromises) {
  const std::map<std::string, std::string> headers = {
      {"stability_methods.csv",
       "method,parameters,order,spec,stages,step_s,z_stiff,beta,limit,max_response,damping,stiff_theory,"
       "stiff_measured,difference,tolerance,growth_measured,beyond_theory,beyond_measured,agrees"},
      {"stability_critical_step.csv", "estimate,step_s,alpha,of_limit,stable,note,growth"},
      {"stability_states.csv",
       "part_of_run,time_s,unknowns,spectrum,eigenvalues_by,lambda_max,lambda_imaginary,lambda_residual,"
       "rising_rate,certified_bound,method,parameters,spec,limit_predicted_s,limit_measured_s,"
       "predicted_over_measured,growth_at_predicted,verdict"},
      {"stability_rounding.csv",
       "n,nu,order,internal_amplification,superstep_rounding_eps,run_rounding_spans,run_error_spans,right"},
      {"stability_sweeps.csv",
       "sweep,contrast,size_ratio,nu,n,nodes,networks,edge_over_true,gershgorin_over_true,bound_over_true,"
       "alpha_star,overshoot_forward_euler,overshoot_sts,overshoot_rkc1,overshoot_rkc2,overshoot_rkl1,"
       "overshoot_rkl2,overshoot_rkg2,overshoot_rock2,overshoot_rock4,overshoot_trapezoidal_0.5,overshoot_"
       "trapezoidal_0.6,"
       "overshoot_trapezoidal_1"}};
  const auto tables = stability_tables(rod_results());
  ASSERT_EQ(tables.size(), headers.size());
  for (const auto& table : tables) {
    const std::string csv = table.csv();
    EXPECT_EQ(csv.substr(0, csv.find('\n')), headers.at(table.file_name()));
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
    EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), table.rows.size() + 1);
    EXPECT_EQ(csv.find("inf"), std::string::npos) << "cells are plain numbers";
  }
}

TEST(StabilityLab, GivesAVerdictPerMethod) {
  std::map<std::string, Verdict::Grade> grades;
  for (const auto& verdict : rod_results().verdicts) grades[verdict.method] = verdict.grade;
  EXPECT_EQ(grades.size(), 14u);
  EXPECT_EQ(grades.at("sts, order natural"), Verdict::Grade::unsafe);
  EXPECT_EQ(grades.at("trapezoidal, phi = 1"), Verdict::Grade::safe);
  const std::string text = stability_text(rod_results(), false);
  for (const auto& [method, grade] : grades)
    EXPECT_NE(text.find(fmt::format("\n{}: {}\n", method, grade_name(grade))), std::string::npos) << method;
}

TEST(StabilityLab, SaysWhenAMeasurementContradictsTheory) {
  StabilityResults doctored = rod_results();
  for (auto& method : doctored.methods)
    if (method.family == "rkc2") {
      method.agrees = false;
      method.difference = 0.25;
    }
  EXPECT_FALSE(is_consistent(doctored));
  for (const auto& verdict : judge_methods(doctored))
    if (verdict.method == "rkc2") {
      EXPECT_EQ(verdict.grade, Verdict::Grade::unsafe);
      EXPECT_NE(verdict.text.find("2.5e-01"), std::string::npos) << verdict.text;
    }
}

TEST(StabilityLab, SaysWhenAPredictedLimitIsNotTheMeasuredOne) {
  StabilityResults doctored = rod_results();
  ASSERT_FALSE(doctored.states.empty());
  EXPECT_EQ(stability_text(doctored, false).find("DIFFERS"), std::string::npos);
  auto& limit = doctored.states.front().limits.front();
  limit.predicted = 1.1 * limit.measured;
  limit.verdict = FrozenLimit::Verdict::differs;
  EXPECT_FALSE(is_consistent(doctored));
  EXPECT_NE(stability_text(doctored, false).find("DIFFERS"), std::string::npos);
  EXPECT_NE(stability_json(doctored).find("\"differs\""), std::string::npos);
  doctored.linear = false;  // verdicts are then those of the states
  EXPECT_EQ(judge_methods(doctored).front().grade, Verdict::Grade::unsafe);
}

TEST(StabilityProgram, WritesFilesAndJson) {
  const CaseFolder folder;
  const std::string rod = test::write_rod(folder, {}), lab = folder.file("lab"),
                    json = folder.file("out.json");
  const std::string command =
      fmt::format("'{}' stability '{}' --quick --json --out '{}' >'{}'", SUPERSTEP_PROGRAM, rod, lab, json);
  const int status = std::system(command.c_str());  // NOLINT(cert-env33-c): a shell is what users have
  ASSERT_TRUE(WIFEXITED(status));
  ASSERT_EQ(WEXITSTATUS(status), 0);
  for (const char* name : {"methods", "critical_step", "rounding", "sweeps", "states"})
    EXPECT_TRUE(folder.has(fmt::format("lab/stability_{}.csv", name))) << name;
  const auto parsed = nlohmann::json::parse(folder.read("out.json"));
  EXPECT_EQ(parsed.at("schema"), "superstep.stability");
  EXPECT_EQ(parsed.at("schema_version"), 2);
  EXPECT_EQ(parsed.at("states").size(), 3U);
  EXPECT_EQ(parsed.at("unknowns"), 18);
  EXPECT_EQ(parsed.at("methods").size(), rod_results().methods.size());
  EXPECT_EQ(parsed.at("verdicts").size(), 14u);
}

TEST(StabilityProgram, TakesASceneThatIsNotLinear) {
  const CaseFolder folder;
  folder.write("row.csv", "id,x,y,z,radius\n0,0,0,0,0.5\n1,0,0,0.95,0.5\n2,0,0,1.9,0.5\n3,0,0,2.85,0.5\n");
  const std::string scene = folder.write(
      "hot.toml",
      "t_end = 20.0\n[packing]\nfile = \"row.csv\"\nlength_unit = \"mm\"\n[material]\ndensity = "
      "5000.0\n[contact]\nneck = \"coble\"\n[thermal]\nconductivity = 50.0\nspecific_heat = 500.0\ninitial "
      "= 300.0\nradiation = [ { where = { ids = [0] }, emissivity = 0.9, ambient = 1500.0 } ]\n");
  const std::string command = fmt::format("'{}' stability '{}' --quick --out '{}' >'{}'", SUPERSTEP_PROGRAM,
                                          scene, folder.file("lab"), folder.file("out.txt"));
  const int status = std::system(command.c_str());  // NOLINT(cert-env33-c): a shell is what users have
  ASSERT_TRUE(WIFEXITED(status));
  ASSERT_EQ(WEXITSTATUS(status), 0);
  EXPECT_NE(folder.read("out.txt").find("at 100 % of the run"), std::string::npos);
  const auto parsed = nlohmann::json::parse(folder.read("lab/stability.json"));
  EXPECT_FALSE(parsed.at("linear").get<bool>());
  EXPECT_TRUE(parsed.at("methods").empty());
  EXPECT_EQ(parsed.at("verdicts").size(), 3U) << "one per method of the states";
  for (const auto& row : parsed.at("states")) EXPECT_EQ(row.at("verdict"), "agrees");
  const auto report = fmt::format("'{}' report '{}' >/dev/null 2>'{}'", SUPERSTEP_PROGRAM, folder.file("lab"),
                                  folder.file("err.txt"));
  EXPECT_EQ(WEXITSTATUS(std::system(report.c_str())), 0);  // NOLINT(cert-env33-c)
  EXPECT_NE(folder.read("lab/report.html").find("Limits at states of a run"), std::string::npos);

  auto old = parsed;  // a file of another version is refused by name
  old["schema_version"] = 1;
  folder.write("lab/stability.json", old.dump());
  EXPECT_EQ(WEXITSTATUS(std::system(report.c_str())), 3);  // NOLINT(cert-env33-c)
  const std::string words = folder.read("err.txt");
  EXPECT_NE(words.find("stability.json: schema_version is 1"), std::string::npos) << words;
}

// ---- the instruments ----

TEST(PerturbationRhs, IsTheDifferenceOfTwoRuns) {
  Problem problem(random_graph({.nodes = 40, .seed = 2, .fixed = 3, .sources = true}));
  PerturbationRhs perturbation(*problem.rhs);
  const auto e = rough_perturbation(problem.rhs->size());
  for (const std::string spec :
       {"forward-euler:step=0.005", "sts:n=5,nu=0.01,step=0.005,order=leja", "rkc:step=0.02,stages=4",
        "rkl:order=1,step=0.02,stages=5", "rkg:step=0.02,stages=5", "trapezoidal:phi=0.6,step=0.02"}) {
    auto perturbed = problem.initial;
    for (std::size_t k = 0; k < e.size(); ++k) perturbed[k] += e[k];
    Problem other = Problem(problem.graph);
    other.initial = perturbed;
    const double t = 0.1;
    const auto base = test::run(spec, problem, {t}), moved = test::run(spec, other, {t});
    ASSERT_TRUE(base.outcome.ok() && moved.outcome.ok()) << spec;
    auto propagated = e;
    StepOperator whole_run(perturbation, spec, t);
    ASSERT_TRUE(whole_run.apply(propagated)) << spec;
    for (std::size_t k = 0; k < e.size(); ++k)
      EXPECT_NEAR(propagated[k], moved.states.back()[k] - base.states.back()[k], 1e-13) << spec;
  }
}

TEST(StiffestMode, IsTheOneKnownInClosedForm) {
  Problem problem(test::chain(200, 0.0, 1.0));  // more nodes than vectors: restarts
  const auto mode = stiffest_mode(*problem.rhs);
  const double exact = 4 * std::pow(std::sin(198 * std::numbers::pi / (2 * 199)), 2);
  EXPECT_NEAR(mode.rate, exact, 1e-9);
  EXPECT_LE(mode.residual, 1e-8);
  EXPECT_NEAR(capacity_product(*problem.rhs, mode.shape, mode.shape), 1, 1e-12);
}

TEST(StiffestMode, OfANetworkWithoutConductanceIsAtRest) {
  Graph graph = test::chain(4);
  graph.conductance.assign(graph.edges(), 0.0);
  Problem problem(graph);
  EXPECT_EQ(stiffest_mode(*problem.rhs).rate, 0);
}

/// Hundreds of roundings that ROCK4's finish multiplies: as many as are foreseen, not a hundred times fewer.
TEST(StabilityLab, KnowsWhatROCK4RoundsAtManyStages) {
  const Scene scene = load_scene(SUPERSTEP_SOURCE_DIR "/cases/nial_thermal.toml");
  PerturbationRhs rhs(*scene.rhs);
  const StiffestMode mode = stiffest_mode(rhs);
  std::size_t seen = 0;
  for (const auto& method : stability_functions(false)) {
    if (method.family != "rock4" || method.stages < 50) continue;
    const MethodStability found = examine_method(rhs, mode, method);
    EXPECT_TRUE(found.agrees) << method.stages << ": " << found.difference << " of " << found.tolerance;
    EXPECT_GT(found.difference, 0.01 * method.rounding) << method.stages;
    ++seen;
  }
  EXPECT_EQ(seen, 2U);
}

TEST(StabilityFunction, SuperstepIsTheProductOfItsSubsteps) {
  for (const int n : {1, 5, 20})
    for (const double nu : {1e-3, 0.05}) {
      const auto substeps = leja_ordered(superstep_substeps(n, nu));
      for (const double x : {0.0, 0.01, 0.5, 1.3, 2.0, 2.2}) {
        double product = 1;
        for (const double substep : substeps) product *= 1 - substep * x;
        const auto closed = static_cast<double>(superstep_response(n, nu, x));
        EXPECT_NEAR(closed, product, 1e-11 * std::max(1.0, std::abs(product))) << n << ' ' << nu << ' ' << x;
      }
    }
}

TEST(StabilityFunction, FindsWhereForwardEulerGrows) {
  const Response euler = [](double z) { return 1 - z; };
  EXPECT_NEAR(growth_limit(euler, 2, 200).value(), 2, 1e-8);
  EXPECT_NEAR(growth_position(euler, 2, 2), 3, 1e-12);
  EXPECT_NEAR(largest_response(euler, 1, 1.5, 10), 0.5, 1e-15);
  const Response backward_euler = [](double z) { return 1 / (1 + z); };
  EXPECT_FALSE(growth_limit(backward_euler, 100, 200).has_value());
}

TEST(InternalAmplification, HasItsKnownSizes) {
  EXPECT_NEAR(internal_amplification(20, 0.01, "natural"), 2.8e8, 0.1e8);
  EXPECT_NEAR(internal_amplification(50, 1e-3, "natural"), 9.25e23, 0.1e23);
  EXPECT_LT(internal_amplification(50, 1e-3, "leja"), 500);
  EXPECT_LT(internal_amplification(50, 1e-3, "recurrence"), 500);
  EXPECT_EQ(internal_amplification(1, 0.5, "natural"), 1);
}

TEST(Chain, EvolvesAsTheDenseExponentialSays) {
  Chain chain(25);
  EXPECT_LT(test::max_difference(chain.evolved([](long double) { return 1.0L; }), chain.initial()), 1e-15);
  Graph graph = test::chain(27, 0.0, 1.0);
  graph.initial = chain_network(25).graph.initial;
  const double t = 3;
  const auto evolved = chain.evolved([&](long double rate) { return std::exp(-rate * t); });
  EXPECT_LT(test::max_difference(evolved, Problem(graph).exact(t)), 1e-13);
}

}  // namespace
}  // namespace superstep
