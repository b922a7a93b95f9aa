#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "bench/app/commands.hpp"
#include "bench/press/motion_schemes.hpp"
#include "bench/press/thermal_lanes.hpp"
#include "case/press/press.hpp"
#include "case/scene.hpp"
#include "core/error.hpp"
#include "core/text/text_file.hpp"
#include "dynamics/moving_network.hpp"
#include "support/small_press.hpp"
#include "support/temporary_case.hpp"

namespace superstep {
namespace {

using test::CaseFolder;
using test::small_press;

/// Runs a command with stdout out of the way.
template <class Call>
int quietly(Call call) {
  testing::internal::CaptureStdout();
  const int code = call();
  testing::internal::GetCapturedStdout();
  return code;
}

RunCommand run_of(const CaseFolder& folder, const std::string& out) {
  RunCommand command;
  command.case_file = small_press(folder);
  command.out = folder.file(out);
  command.common.quiet = true;
  return command;
}

TEST(RunSintering, WritesTheFilesOfTheContract) {
  const CaseFolder folder;
  const RunCommand command = run_of(folder, "out");
  ASSERT_EQ(quietly([&] { return execute(command); }), 0);
  const std::string history = folder.read("out/history.csv");
  EXPECT_TRUE(history.starts_with(
      "time,phase,volume_fraction,mean_temperature,max_temperature,wall_force,kinetic_energy,bonds,contacts,"
      "step,iterations,rejections,wall_work,potential_energy,elastic_energy,dissipated,joule_heat,heat_lost,"
      "heat_content,landed\n0,\"press, slowly\",0."))
      << history.substr(0, 200);
  const std::string last = folder.read("out/final.csv");
  EXPECT_TRUE(last.starts_with("id,x,y,z,r,current,temperature,vx,vy,vz\n0,"));
  EXPECT_EQ(std::count(last.begin(), last.end(), '\n'), 31);
  EXPECT_TRUE(folder.has("out/snapshots/particles_0000.csv"));
  EXPECT_EQ(folder.read("out/snapshots/particles_0001.csv"), last) << "the last output is the end";
  const std::string figure = folder.read("out/history.svg");
  EXPECT_TRUE(figure.starts_with("<svg ") && figure.ends_with("</svg>\n"));
  EXPECT_NE(figure.find("press, slowly"), std::string::npos) << "phases are named";
  EXPECT_EQ(figure.find("nan"), std::string::npos);
  const auto json = nlohmann::json::parse(folder.read("out/run.json"));
  EXPECT_EQ(json["outcome"]["status"], "ok");
  EXPECT_EQ(json["motion"]["phase_ends"].size(), 1U);
  EXPECT_EQ(json["motion"]["phase_ends"][0]["time"], 0.04);
  EXPECT_GE(json["motion"]["cpu_parts_s"]["forces"], 0.0);
}

TEST(RunSintering, RestartFromACheckpointGivesTheSameBytes) {
  const CaseFolder folder;
  RunCommand command = run_of(folder, "whole");
  command.checkpoint = 0.03;
  ASSERT_EQ(quietly([&] { return execute(command); }), 0);
  // The first checkpoint is overwritten at the end: stop a run there by its own t_end instead.
  RunCommand part = command;
  part.case_file = folder.write("part.toml", [&] {
    std::string text = folder.read("press.toml");
    text.replace(text.find("t_end = 0.04"), 12, "t_end = 0.02");
    text.replace(text.find("[0.02, 0.04]"), 12, "[0.02]");
    return text;
  }());
  part.out = folder.file("part");
  ASSERT_EQ(quietly([&] { return execute(part); }), 0);
  RunCommand rest = run_of(folder, "rest");
  rest.restart = folder.file("part/checkpoint.bin");
  std::filesystem::create_directories(folder.file("rest/snapshots"));
  folder.write("rest/snapshots/particles_0000.csv", "of the run so far");
  folder.write("rest/snapshots/particles_0002.csv", "of some other run");
  ASSERT_EQ(quietly([&] { return execute(rest); }), 0);
  EXPECT_EQ(folder.read("rest/snapshots/particles_0000.csv"), "of the run so far");
  EXPECT_FALSE(folder.has("rest/snapshots/particles_0002.csv"));
  EXPECT_EQ(folder.read("rest/final.csv"), folder.read("whole/final.csv"));
  EXPECT_EQ(folder.read("rest/history.csv"), folder.read("whole/history.csv"));

  rest.restart = folder.file("whole/checkpoint.bin");
  const auto message = test::message_of<InputError>([&] { (void)execute(rest); });
  EXPECT_NE(message.find("t_end = 0.04 s: nothing is left to run; raise t_end"), std::string::npos)
      << message;
}

TEST(RunSintering, ThermalIntegratorsGetAFolderEach) {
  const CaseFolder folder;
  RunCommand command = run_of(folder, "out");
  command.integrators = {"staggered", "rkc:rtol=1e-5"};
  ASSERT_EQ(quietly([&] { return execute(command); }), 0);
  EXPECT_TRUE(folder.has("out/staggered/final.csv"));
  EXPECT_TRUE(folder.has("out/rkc_rtol=1e-5/final.csv"));
  command.integrators = {"rkq"};
  EXPECT_THROW((void)execute(command), UsageError);
}

TEST(RunSintering, FailureKeepsWhatWasReached) {
  const CaseFolder folder;
  RunCommand command = run_of(folder, "out");
  std::string text = folder.read("press.toml");
  text.replace(text.find("[dynamics.wall]\nstiffness = 1e7"), 31, "[dynamics.wall]\nstiffness = 1.0");
  command.case_file = folder.write("soft.toml", text);
  EXPECT_EQ(quietly([&] { return execute(command); }), 4);
  const auto json = nlohmann::json::parse(folder.read("out/run.json"));
  EXPECT_EQ(json["outcome"]["status"], "failed");
  EXPECT_NE(std::string(json["outcome"]["reason"]).find("escapes through the upper wall"), std::string::npos);
  EXPECT_GT(json["outcome"]["t_reached"], 0.0);
  EXPECT_TRUE(folder.has("out/final.csv"));
  const std::string history = folder.read("out/history.csv");
  EXPECT_GT(std::count(history.begin(), history.end(), '\n'), 2) << "steps that went well";
}

/// The marks of an axis ran on for ever, and so did the memory of the figure.
TEST(RunSintering, TemperaturesThatDifferByOneRoundingAreDrawn) {
  const CaseFolder folder;
  RunCommand command;
  command.case_file = folder.write("rest.toml", R"(
t_end = 1e-3
[material]
density = 2000.0
[thermal]
conductivity = 100.0
specific_heat = 100.0
initial = 300.0
walls = 300.0
walls_conduct = false
[dynamics]
gravity = 0.0
[dynamics.box]
min = [0.0, 0.0, 0.0]
max = [0.3, 0.3, 0.3]
[dynamics.particles]
list = [ { position = [0.1, 0.1, 0.15], radius = 0.05, temperature = 300.00000000000006 }, { position = [0.2, 0.2, 0.225], radius = 0.05 } ]
[dynamics.contact]
stiffness = 1e7
[dynamics.wall]
stiffness = 1e7
[[dynamics.phases]]
name = "rest"
until = 1e-3
)");
  command.out = folder.file("out");
  command.common.quiet = true;
  ASSERT_EQ(quietly([&] { return execute(command); }), 0);
  const std::string figure = folder.read("out/history.svg");
  EXPECT_LT(figure.size(), 20000U);
  EXPECT_NE(figure.find(">300</text>"), std::string::npos) << figure;
}

TEST(RunSintering, CurrentWithoutAPathIsAWarning) {
  const CaseFolder folder;
  RunCommand command = run_of(folder, "out");
  std::string text = folder.read("press.toml");
  text.replace(text.find("count = 30"), 10, "count = 1");  // it hangs in the air all the time
  command.case_file = folder.write("one.toml", text);
  ASSERT_EQ(quietly([&] { return execute(command); }), 0);
  const auto json = nlohmann::json::parse(folder.read("out/run.json"));
  ASSERT_EQ(json["warnings"].size(), 1U);
  EXPECT_NE(std::string(json["warnings"][0]).find("no particle has a path"), std::string::npos);
}

TEST(RunSintering, OptionsOfMovingParticlesAreRefusedElsewhere) {
  const CaseFolder folder;
  RunCommand command;
  command.case_file = write_rod(folder, test::Rod{});
  command.checkpoint = 1;
  EXPECT_THROW((void)execute(command), UsageError);
  command.checkpoint.reset();
  command.export_packing = folder.file("p.csv");
  EXPECT_THROW((void)execute(command), UsageError);
}

TEST(RunSintering, WhatIsExportedIsTakenUpByAPressAndByANetwork) {
  const CaseFolder folder;
  RunCommand command = run_of(folder, "out");
  command.export_packing = folder.file("pressed.csv");
  ASSERT_EQ(quietly([&] { return execute(command); }), 0);
  // Going on from the packing starts where the run ended, to the last bit.
  std::string text = folder.read("press.toml");
  const std::size_t begin = text.find("[dynamics.particles]"), end = text.find("\n[", begin);
  text.replace(begin, end - begin,
               "[dynamics.particles]\nfile = \"pressed.csv\"\nmax_overlap = 0.5\n" +
                   std::string(folder.has("pressed.bonds.csv") ? "bonds = \"pressed.bonds.csv\"\n" : ""));
  const Press again = load_press(folder.write("again.toml", text));
  dynamics::MovingNetwork network(again.model, again.particles);
  dynamics::State state = again.state;
  network.resume(state, again.model.schedule.phases().front());
  const std::string last = folder.read("out/final.csv");
  std::size_t found = 0;
  for (std::size_t k = 0; k < state.size(); ++k)
    found += last.find(fmt::format("\n{},{},{},{},", again.particles.id[k], state.position[k].x,
                                   state.position[k].y, state.position[k].z)) != std::string::npos
                 ? 1
                 : 0;
  EXPECT_EQ(found, state.size());
  // Each neck conducts in the network as in the press: kappa pi a^2/distance.
  const std::string scene_text =
      "t_end = 1.0\n[packing]\nfile = \"pressed.csv\"\n[contact]\nneck = \"given\"\n"
      "file = \"pressed.necks.csv\"\nconductance = \"pipe\"\n[material]\ndensity = 2000.0\n"
      "[thermal]\nconductivity = 100.0\nspecific_heat = 100.0\ninitial = { column = \"temperature\" }\n";
  const Scene scene = load_scene(folder.write("network.toml", scene_text));
  double in_press = 0, in_network = 0;
  for (const auto& contact : network.contacts().points()) in_press += 100 * contact.area / contact.distance;
  for (const double conductance : scene.fields.front().graph.conductance) in_network += conductance;
  EXPECT_GT(in_press, 0);
  EXPECT_NEAR(in_network, in_press, 1e-12 * in_press);
}

/// Thermal methods of a press beside a tight one; none named = those of the case.
BenchCase lanes_of(const Press& press, int repetitions, std::vector<std::string> integrators = {}) {
  HarnessOptions options;
  options.reference = "exponential:rtol=1e-12";
  options.repetitions = repetitions;
  options.integrators = std::move(integrators);
  Progress progress(false);
  return bench_thermal_lanes(press, 0.5, options, progress);
}

TEST(BenchSintering, LanesMeasureErrorAndWork) {
  const CaseFolder folder;
  const BenchCase result = lanes_of(load_press(small_press(folder)), 2);
  ASSERT_EQ(result.rows.size(), 2U);
  const BenchRow &euler = result.rows[0], &rkc = result.rows[1];
  EXPECT_TRUE(euler.ok() && rkc.ok());
  EXPECT_EQ(euler.speedup_stepping, 1.0);
  EXPECT_GT(*euler.errors.rms, 0);
  EXPECT_LT(*rkc.errors.rms, 0.1 * *euler.errors.rms) << "its tolerance asks for 1e-5 of the span";
  EXPECT_LE(*rkc.errors.rms, *rkc.errors.max);
  EXPECT_GT(*euler.rhs, 0U);
  EXPECT_EQ(*euler.factorizations, 0U);
  EXPECT_DOUBLE_EQ(*rkc.speedup_total, euler.cpu_total->median / rkc.cpu_total->median);
  EXPECT_EQ(result.cpu_setup, 0.5);
  const auto implicit =
      lanes_of(load_press(small_press(folder)), 1, {"trapezoidal:rtol=1e-4,solver=klu"}).rows;
  ASSERT_EQ(implicit.front().integrator, "trapezoidal");
  EXPECT_GT(*implicit.front().factorizations, 0U);
  EXPECT_GT(*implicit.front().solves, 0U);
}

TEST(BenchSintering, AReferenceWithoutAToleranceIsHeldAgainstNoMethod) {
  const CaseFolder folder;
  HarnessOptions options;
  options.integrators = {"exponential:rtol=1e-10", "rkc:rtol=1e-8"};
  options.reference = "forward-euler";
  options.repetitions = 1;
  Progress progress(false);
  const BenchCase result = bench_thermal_lanes(load_press(small_press(folder)), 0, options, progress);
  for (const auto& row : result.rows) {
    EXPECT_TRUE(row.ok()) << row.spec << ": " << row.reason;
    EXPECT_FALSE(row.errors.delivered) << row.spec;
  }
  EXPECT_TRUE(std::any_of(result.warnings.begin(), result.warnings.end(), [](const auto& text) {
    return text.find("exponential:rtol=1e-10, rkc:rtol=1e-8 keep the tolerance") != std::string::npos;
  }));
}

/// Poured and pressed between hot walls; and from rest at 300 K, where nothing but the current heats.
TEST(BenchSintering, MethodsKeepTheirToleranceOverAllContactUpdatesTogether) {
  const CaseFolder folder;
  const std::string hot = folder.read(std::filesystem::path(small_press(folder)).filename().string());
  std::string rest = hot;
  const std::string walls = "walls = { lower = 1000.0, upper = 900.0, sides = 300.0 }";
  rest.replace(rest.find(walls), walls.size(), "walls = 300.0\nwalls_conduct = false");
  for (const auto& [name, text] : {std::pair{"hot.toml", hot}, {"rest.toml", rest}}) {
    const BenchCase result =
        lanes_of(load_press(folder.write(name, text)), 1,
                 {"auto:rtol=1e-3", "exponential:rtol=1e-3", "exponential:rtol=1e-2", "rkc:rtol=1e-3",
                  "rock:rtol=1e-3", "trapezoidal:rtol=1e-3", "cvode:rtol=1e-3", "esdirk:rtol=1e-3"});
    for (const auto& row : result.rows) {
      ASSERT_TRUE(row.ok()) << name << ' ' << row.spec << ": " << row.reason;
      EXPECT_GT(*row.steps, 20U) << "there is something to add up";
      EXPECT_LT(row.errors.delivered.value_or(0), 1) << name << ' ' << row.spec;
    }
    EXPECT_GT(result.rows[1].errors.span.value_or(0), 1) << name << ": something warms up";
  }
}

TEST(BenchSintering, GoesThroughTheHarnessOfAllCases) {
  const CaseFolder folder;
  BenchCommand command;
  command.case_files = {small_press(folder)};
  command.harness.repetitions = 1;
  command.report = true;
  command.out = folder.file("out");
  command.common.quiet = true;
  ASSERT_EQ(quietly([&] { return execute(command); }), 0);
  for (const char* name : {"results.csv", "results.json", "motion.csv", "report.html"})
    EXPECT_TRUE(folder.has(std::string("out/") + name)) << name;
  EXPECT_FALSE(folder.has("out/health.json")) << "there is no network that stays as it is";
  const auto json = nlohmann::json::parse(folder.read("out/results.json"));
  EXPECT_EQ(json["cases"][0]["reference"]["spec"], "exponential:basis=chebyshev,rtol=1e-12");
  EXPECT_GT(json["cases"][0]["cpu_setup_s"], 0.0);

  command.case_files.push_back(write_rod(folder, test::Rod{}));
  EXPECT_THROW((void)execute(command), UsageError) << "side by side with others";
}

TEST(BenchSintering, WithoutIntegratorsEveryFamilyIsMeasured) {
  const CaseFolder folder;
  std::string text = folder.read(std::filesystem::path(small_press(folder)).filename().string());
  text.erase(text.find("integrators ="),
             std::string("integrators = [\"forward-euler\", \"rkc:rtol=1e-5\"]").size());
  HarnessOptions options;
  options.repetitions = 1;
  Progress progress(false);
  const Press one = load_press(folder.write("open.toml", text));
  const BenchCase result = bench_thermal_lanes(one, 0, options, progress);
  EXPECT_EQ(result.rows.size(), contenders(one.bench, {}).size());
  EXPECT_GT(result.rows.size(), 5U);
  for (const auto& row : result.rows) EXPECT_TRUE(row.ok()) << row.spec << ": " << row.reason;
}

TEST(BenchSintering, MotionErrorsFallWithTheStep) {
  const CaseFolder folder;
  const auto one = load_press(small_press(folder));
  Progress progress(false);
  const MotionComparison result = compare_motion_schemes(one, progress);
  EXPECT_GT(result.travelled, 0);
  std::vector<double> plain;
  for (const auto& row : result.rows) {
    EXPECT_EQ(row.status, "ok");
    if (row.scheme == "plain") plain.push_back(row.error_position);
  }
  ASSERT_EQ(plain.size(), 5U);
  EXPECT_LT(plain.back(), 0.1 * plain.front())
      << "order 1, steps 95 times smaller, but for contacts that begin";
}

}  // namespace
}  // namespace superstep
