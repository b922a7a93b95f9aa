#include "audit/audit.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <sstream>

#include "audit/special_audits.hpp"

namespace superstep::audit {
namespace {

/// Two nodes, the second one held: one equation whose solution can be written down.
StatedScene one_unknown(double t_end) {
  StatedScene scene;
  scene.kind = "driven-linear";
  scene.t_end = t_end;
  scene.output_times = {0.3 * t_end, t_end};
  FieldScene field;
  field.name = "temperature";
  field.unit = "K";
  Graph& graph = field.graph;
  graph.id = {0, 1};
  graph.i = {0};
  graph.j = {1};
  graph.conductance = {2};
  graph.capacity = {4, 1};
  graph.source = {0, 0};
  graph.initial = {300, 300};
  graph.fixed_value = {0, 300};
  graph.is_fixed = {0, 1};
  field.bare = graph.conductance;
  scene.fields = {field};
  return scene;
}

TEST(AuditOracle, FollowsARampLikeTheClosedForm) {
  auto scene = one_unknown(3);
  Graph& graph = scene.fields[0].graph;
  graph.fixed_table = {-1, 0};
  graph.tables.push_back({.time = {0, 3}, .value = {300, 306}});
  // dT/dt = k (300 + s t - T), k = 2/4, s = 2 K/s: T = 300 + s (t - (1 - exp(-k t))/k).
  const auto exact = [](double t) { return 300 + 2 * (t - (1 - std::exp(-0.5 * t)) / 0.5); };
  for (const bool by_steps : {false, true}) {
    const Truth truth = find_truth(scene, {.by_steps = by_steps});
    EXPECT_EQ(truth.exact, !by_steps);
    for (std::size_t k = 0; k < 2; ++k)  // 1e-12 of 306 K: some ten roundings
      EXPECT_NEAR(truth.fields[0].values[k][0], exact(scene.output_times[k]), 5e-13 + 1e-11 * 6);
    EXPECT_NEAR(truth.fields[0].span(), 6, 1e-9);
  }
}

TEST(AuditOracle, SeesAStepFromBothSides) {
  auto scene = one_unknown(4);
  Graph& graph = scene.fields[0].graph;
  graph.fixed_table = {-1, 0};
  graph.tables.push_back({.time = {1, 1, 2, 2}, .value = {300, 310, 310, 300}});
  // Held at 310 K for a second, then at 300 K for two.
  const double exact = 300 + 10 * (1 - std::exp(-0.5)) * std::exp(-0.5 * 2);
  for (const bool by_steps : {false, true})
    EXPECT_NEAR(find_truth(scene, {.by_steps = by_steps}).fields[0].values[1][0], exact, 1e-10);  // of 10 K
}

TEST(AuditOracle, RadiatesLikeTheClosedForm) {
  auto scene = one_unknown(50);
  Graph& graph = scene.fields[0].graph;
  graph.conductance = {0};
  graph.initial = {1000, 1000};
  graph.radiation.push_back({0, 1e-9, 0, -1});
  // 4 dT/dt = -1e-9 T^4.
  const double exact = std::pow(std::pow(1000.0, -3) + 3 * 1e-9 / 4 * 50, -1.0 / 3);
  EXPECT_NEAR(find_truth(scene).fields[0].values[1][0], exact, 1e-8);  // 1e-11 of 1000 K
}

TEST(AuditOracle, EigenvectorsAndStepsAgree) {
  std::size_t compared = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed)
    for (const char* kind : {"linear-constant", "driven-linear", "steady-potential"}) {
      const auto scene = state_scene(seed, {.kind = kind, .most_nodes = 20});
      if (!is_linear(scene)) continue;
      ++compared;
      const Truth exact = find_truth(scene), stepped = find_truth(scene, {.by_steps = true});
      for (std::size_t f = 0; f < exact.fields.size(); ++f) {
        const auto &a = exact.fields[f], &b = stepped.fields[f];
        EXPECT_NEAR(a.span(), b.span(), 1e-3 * a.span()) << kind << ' ' << seed;  // looked for between steps
        for (std::size_t k = 0; k < a.values.size(); ++k)
          for (std::size_t node = 0; node < a.values[k].size(); ++node)
            // Both claim 1e-11 of the span; steps also carry roundings of the values.
            EXPECT_NEAR(a.values[k][node], b.values[k][node], 1e-10 * a.span() + 1e-13 * a.size())
                << kind << ' ' << seed;
      }
    }
  EXPECT_GE(compared, 24u);
}

TEST(AuditOracle, AShiftMovesTheTruthAndNothingElse) {
  const double by = 273.15;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    const auto scene = state_scene(seed, {.kind = "driven-linear"});
    ASSERT_TRUE(may_be_shifted(scene));
    const auto before = find_truth(scene).fields[0], after = find_truth(shifted(scene, by)).fields[0];
    for (std::size_t k = 0; k < before.values.size(); ++k)
      for (std::size_t node = 0; node < before.values[k].size(); ++node)
        // Tables are rounded when they are moved.
        EXPECT_NEAR(before.values[k][node] + by, after.values[k][node], 1e-14 * (before.size() + by));
  }
}

TEST(AuditScenes, CoverWhatTheyAreFor) {
  std::map<std::string, int> kinds, shapes;
  int steps = 0, rests = 0, offsets = 0, short_pulses = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const auto scene = state_scene(seed);
    ++kinds[scene.kind];
    ++shapes[scene.shape];
    const Graph& graph = scene.fields.back().graph;
    rests += std::all_of(graph.initial.begin(), graph.initial.end(),
                         [&](double value) { return value == graph.initial[0]; });
    offsets += graph.initial[0] >= 300;
    for (const auto& field : scene.fields)
      for (const auto& table : field.graph.tables) {
        for (std::size_t k = 1; k < table.time.size(); ++k) steps += table.time[k] == table.time[k - 1];
        short_pulses += table.time.size() == 4 && table.time[3] - table.time[0] < 1e-3 * scene.t_end;
      }
  }
  for (const auto& kind : scene_kinds()) EXPECT_GE(kinds[kind], 10) << kind;
  for (const char* shape : {"chain", "ring", "grid", "hub", "tree", "random", "disconnected"})
    EXPECT_GE(shapes[shape], 10) << shape;
  EXPECT_GE(steps, 30);
  EXPECT_GE(rests, 100);
  EXPECT_GE(offsets, 100);
  EXPECT_GE(short_pulses, 10);
}

TEST(AuditScenes, AreTheSameForTheSameSeed) {
  const auto a = state_scene(7), b = state_scene(7);
  EXPECT_EQ(a.fields.back().graph.conductance, b.fields.back().graph.conductance);
  EXPECT_EQ(a.output_times, b.output_times);
}

/// Scenes that every method is judged on, with their truths, found once.
struct Judged {
  StatedScene stated;
  Truth truth;
  Scene scene;
};
const std::vector<Judged>& judged_scenes() {
  static const auto scenes = [] {
    std::vector<Judged> out;
    // Stiffer ones belong to the program: explicit methods take seconds on them.
    for (std::uint64_t seed = 1; out.size() < 100; ++seed) {
      auto stated = state_scene(seed, {.most_nodes = 30});
      if (stated.t_lambda > 1e6) continue;
      Truth truth = find_truth(stated);
      Scene scene = build_scene(stated);
      out.push_back({std::move(stated), std::move(truth), std::move(scene)});
    }
    return out;
  }();
  return scenes;
}

/// Methods that take every linear scene and may not fail on any.
bool works_on_linear_scenes(const Contender& method) {
  for (const char* name : {"auto", "cvode", "rkc", "trapezoidal"})
    if (method.label == name) return true;
  return false;
}

class EveryMethod : public testing::TestWithParam<Contender> {};

TEST_P(EveryMethod, DeliversWhatIsAskedFor) {
  TimeLimit limit(5);
  std::size_t scored = 0, below_3 = 0, above_10 = 0, failed = 0, runs = 0;
  std::string misses;
  for (const auto& one : judged_scenes())
    for (const double rtol : {1e-3, 1e-5}) {
      const Row row = judge(one.stated, one.scene, one.truth, GetParam(), rtol, {}, limit);
      const std::string what = fmt::format("seed {} {} rtol {:g}: {}, delivered {:.3g}, {}\n", row.seed,
                                           row.kind, row.rtol, row.status, row.delivered, row.reason);
      const bool ok = row.status == "ok", given_up = !ok && row.status != "refused";
      EXPECT_FALSE(ok && (row.delivered > 10 || row.error > 0.1)) << what;
      EXPECT_FALSE(!ok && is_linear(one.stated) && works_on_linear_scenes(GetParam())) << what;
      runs += row.status != "refused";
      failed += given_up;
      if (given_up || row.delivered > 3) misses += what;
      if (row.delivered < 0) continue;
      ++scored;
      below_3 += row.delivered < 3;
      above_10 += row.delivered > 10;
    }
  // The shares that the project claims for 500 scenes; so few allow for one more.
  const auto share = [](double part, std::size_t of) { return 1 + part * static_cast<double>(of); };
  EXPECT_LE(static_cast<double>(scored - below_3), share(0.05, scored)) << misses;
  EXPECT_LE(static_cast<double>(above_10), share(0.001, scored)) << misses;
  EXPECT_LE(static_cast<double>(failed), share(0.02, runs)) << misses;
  EXPECT_GE(scored, 8u);  // of Lanczos, which takes constant inputs alone
}

std::vector<Contender> adaptive_contenders() {
  auto all = contenders({});
  std::erase_if(all, [](const Contender& one) { return !one.adaptive; });
  return all;
}
INSTANTIATE_TEST_SUITE_P(Registry, EveryMethod, testing::ValuesIn(adaptive_contenders()),
                         [](const auto& tested) {
                           std::string name = tested.param.label;
                           std::replace_if(
                               name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
                           return name;
                         });

/// A one-way scene whose potential settles on the way: what goes on must know what is left behind. `auto`
/// once began anew there and missed by 11 times.
TEST(AutoAudit, KeepsItsWordWhenAPotentialHasSettled) {
  TimeLimit limit(5);
  const auto stated = state_scene(119, {});
  ASSERT_EQ(stated.kind, "one-way");
  const Truth truth = find_truth(stated);
  const Scene scene = build_scene(stated);
  for (const auto& method : adaptive_contenders())
    if (method.label == "auto")
      for (const double rtol : {1e-3, 1e-5}) {
        const Row row = judge(stated, scene, truth, method, rtol, {}, limit);
        EXPECT_EQ(row.status, "ok") << row.reason;
        EXPECT_LT(row.delivered, 2) << rtol;
      }
}

/// Held temperatures exchange a million spans in a panel of the exponential, whose series once counted as if
/// it were one: what it left out grew with the time.
TEST(OneWayExponential, KeepsItsWordOverLongPanelsBetweenHeldTemperatures) {
  TimeLimit limit(5);
  const auto stated = state_scene(104, {.kind = "one-way"});
  const Truth truth = find_truth(stated);
  const Scene scene = build_scene(stated);
  for (const auto& method : adaptive_contenders())
    if (method.label == "exponential")
      for (const double rtol : {1e-2, 1e-3, 1e-5}) {
        const Row row = judge(stated, scene, truth, method, rtol, {}, limit);
        EXPECT_EQ(row.status, "ok") << row.reason;
        EXPECT_LT(row.delivered, 1) << rtol;
      }
}

/// Electrodes that touch each other and change in time: the potential of no free node feels them, but the
/// current between them heats. Every method once slept through their pulses, and all of them agreed.
TEST(PulsesBetweenElectrodes, HeatUnderEveryMethod) {
  TimeLimit limit(5);
  for (const std::uint64_t seed : {231, 286, 320, 335}) {
    const auto stated = state_scene(seed, {.kind = "one-way"});
    const Truth truth = find_truth(stated);
    const Scene scene = build_scene(stated);
    for (const auto& method : adaptive_contenders()) {
      const Row row = judge(stated, scene, truth, method, 1e-3, {}, limit);
      if (row.status == "refused") continue;
      EXPECT_EQ(row.status, "ok") << seed << " " << method.label << ": " << row.reason;
      EXPECT_LT(row.delivered, 3) << seed << " " << method.label;
    }
  }
}

/// Scenes that methods once missed by far: thousands of short pieces, a tree that Lanczos told nothing from
/// five vectors of, profiles under BDF, two fields that GMRES solved too loosely, a step that had to become
/// much shorter than the one before.
TEST(ScenesThatWentWrong, AreRightNow) {
  struct Case {
    std::uint64_t seed;
    const char *kind, *method;
    double rtol, most;
  };
  TimeLimit limit(5);
  for (const Case& one : {Case{2070, "driven-linear", "exprb", 1e-3, 3},
                          {2070, "driven-linear", "exprb", 1e-5, 3},
                          {2148, "driven-linear", "exprb", 1e-5, 3},
                          {2057, "linear-constant", "auto", 1e-3, 2},
                          {2057, "linear-constant", "exponential:basis=lanczos", 1e-3, 2},
                          {2026, "steady-potential", "auto", 1e-5, 2},
                          {2092, "steady-potential", "auto", 1e-5, 2},
                          {185, "one-way", "auto", 1e-5, 2},
                          {429, "", "cvode:linsol=gmres", 1e-3, 3},
                          {429, "", "cvode:linsol=gmres", 1e-5, 3},
                          {429, "", "cvode:linsol=gmres", 1e-7, 3},
                          {58, "", "tsrkc", 1e-7, 3},
                          {299, "linear-constant", "tsrkc", 1e-7, 3}}) {
    const auto stated = state_scene(one.seed, {.kind = one.kind});
    const Truth truth = find_truth(stated);
    const Row row =
        judge(stated, build_scene(stated), truth, contenders({one.method}).front(), one.rtol, {}, limit);
    EXPECT_EQ(row.status, "ok") << one.seed << ' ' << one.method << ": " << row.reason;
    EXPECT_LT(row.delivered, one.most) << one.seed << ' ' << one.method;
  }
}

/// With scenes that bounds were wrong on: stored offsets (972), spaces without vectors (31), small solutions
/// (14), series of many terms (47).
TEST(AuditBounds, HoldAgainstSixtyDigits) {
#ifdef SUPERSTEP_HAS_BOOST
  const auto methods = contenders(
      {"exponential:basis=chebyshev", "exponential:basis=lanczos", "exponential:basis=shift-invert"});
  const auto expect_held = [&](const char* kind, const SeedRange& seeds) {
    std::ostringstream out;
    EXPECT_EQ(print_bounds_audit(out, seeds, {.kind = kind}, methods, {1e-3, 1e-6, 1e-12}, true), 0)
        << out.str();
  };
  for (const auto* kind : {"linear-constant", "driven-linear"}) expect_held(kind, {1, 32});
  for (const std::uint64_t seed : {47, 972}) expect_held("linear-constant", {seed, seed + 1});
#else
  GTEST_SKIP() << "built without Boost";
#endif
}

TEST(AuditSpans, TheLibraryFindsWhatTheOracleSees) {
  std::size_t fields = 0, off = 0;
  std::string misses;
  for (const auto& one : judged_scenes())
    for (const auto& pair : compare_spans(one.stated, one.truth)) {
      ++fields;
      // The pilot run's own accuracy and twice what may still move when it ends, 5 %.
      if (std::abs(pair.found - pair.right) <= 0.1 * pair.right) continue;
      ++off;
      misses += fmt::format("seed {} {} {}: {:g} instead of {:g}; {}\n", one.stated.seed, one.stated.kind,
                            pair.field, pair.found, pair.right, pair.how);
      EXPECT_LE(std::max(pair.found, pair.right), 2 * std::min(pair.found, pair.right)) << misses;
    }
  EXPECT_LE(static_cast<double>(off), 0.05 * static_cast<double>(fields)) << misses;
}

}  // namespace
}  // namespace superstep::audit
