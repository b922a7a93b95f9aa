/// Nothing waits for ever: runs have limits that end them, inputs without an end are refused.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "bench/host/watchdog.hpp"
#include "bench/measure/run_limits.hpp"
#include "core/stopwatch.hpp"
#include "integrators/registry.hpp"
#include "program.hpp"
#include "support/small_press.hpp"
#include "support/temporary_case.hpp"

namespace superstep {
namespace {

using Json = nlohmann::ordered_json;

class Limits : public testing::Test {
 protected:
  void SetUp() override { case_ = test::write_rod(folder_, test::Rod{}); }
  /// The rod for days: with steps of a millionth of a second nobody sees its end.
  std::string endless() {
    return test::write_rod(folder_, {.head = "t_end = 3e5\noutput_times = [1e5, 3e5]\n"}, "endless");
  }
  [[nodiscard]] std::string out() const { return folder_.file("out"); }
  [[nodiscard]] Json json(const std::string& name) const { return Json::parse(folder_.read(name)); }

  test::CaseFolder folder_;
  std::string case_;
};

TEST_F(Limits, ARunEndsWhenItsTimeIsUp) {
  const auto said = test::call_program({"run", endless(), "--integrator", "forward-euler:step=1e-6",
                                        "--time-limit", "0.2", "--quiet", "--out", out()});
  EXPECT_EQ(said.code, 4) << said.err;
  EXPECT_NE(said.out.find("timeout: not done after 0.2 s"), std::string::npos) << said.out;
  EXPECT_EQ(json("out/run.json").at("outcome").at("status"), "timeout");
  EXPECT_EQ(test::call_program({"run", case_, "--time-limit", "600", "--quiet", "--out", out()}).code, 0);
}

TEST_F(Limits, EveryMethodLooksAtTheClock) {
  for (const char* spec : {"forward-euler:step=1e-6", "sts:n=5,step=1e-6", "rkc:step=1e-6", "rock:step=1e-6",
                           "trapezoidal:step=1e-6", "esdirk:rtol=1e-12"}) {
    const auto said = test::call_program(
        {"run", endless(), "--integrator", spec, "--time-limit", "0.1", "--quiet", "--out", out()});
    EXPECT_TRUE(said.code == 4 || std::string(spec) == "esdirk:rtol=1e-12") << spec << said.out << said.err;
  }
}

/// Rates of 1e78 per second, slopes that leave the range of a double: whatever comes of it, no signal.
TEST_F(Limits, AMethodThatCannotGoOnIsAnOutcome) {
  folder_.write("nodes.csv", "id,capacity,source,initial,fixed\n1,1e-39,0,1e39,\n2,1,0,0,\n3,1,0,0,0\n");
  folder_.write("edges.csv", "i,j,conductance\n1,2,1e39\n2,3,1\n");
  const std::string steep =
      folder_.write("steep.toml", "t_end = 1\n[network]\nnodes = \"nodes.csv\"\nedges = \"edges.csv\"\n");
  std::vector<std::string> specs = {"arkode:method=erk", "cvode:linsol=gmres", "cvode:linsol=klu"};
  for (const auto& entry : integrators()) specs.push_back(entry.name);
  for (const auto& spec : specs) {
    const auto said = test::call_program(
        {"run", steep, "--integrator", spec, "--time-limit", "0.5", "--quiet", "--out", out()});
    EXPECT_TRUE(said.code == 0 || said.code == 4) << spec << ": " << said.code << said.out << said.err;
    if (said.code == 4) {
      EXPECT_NE(json("out/run.json").at("outcome").at("reason"), "") << spec;
    }
  }
}

// Much shorter than the time between two looks at the clock. The quickest of several, as others may use the
// machine.
TEST_F(Limits, AShortLimitIsKept) {
  constexpr double limit = 1e-3, late = 0.02;  // s
  for (const bool of_cpu : {false, true}) {
    double quickest = 1;
    for (int k = 0; k < 10; ++k) {
      const double began = wall_seconds();
      const Watchdog dog(limit, nullptr, of_cpu);
      while (!dog.flag()->load() && wall_seconds() - began < 1)
        ;
      EXPECT_TRUE(dog.time_is_up());
      quickest = std::min(quickest, wall_seconds() - began);
    }
    EXPECT_GT(quickest, 0.5 * limit);
    EXPECT_LT(quickest, late) << of_cpu;
  }
}

TEST_F(Limits, ABenchmarkGoesOnWithoutTheMethodThatTakesTooLong) {
  const auto said =
      test::call_program({"bench", endless(), "--integrator", "forward-euler:step=1e-6", "--integrator",
                          "exponential", "--integrator", "cvode:rtol=1e-4", "--repetitions", "1",
                          "--time-limit", "0.5", "--quiet", "--out", out()});
  EXPECT_EQ(said.code, 0) << said.err;
  const Json results = json("out/results.json");
  std::map<std::string, std::string> status;
  for (const auto& row : results.at("cases")[0].at("rows"))
    status[std::string(row.at("integrator")) + ":" + std::string(row.at("params"))] = row.at("status");
  EXPECT_EQ(status["forward-euler:step=1e-6"], "timeout");
  EXPECT_EQ(status["exponential:"], "ok");
  EXPECT_EQ(status["cvode:rtol=1e-4"], "ok");
}

TEST_F(Limits, ASweepOfTolerancesGoesOn) {
  const auto said =
      test::call_program({"bench", endless(), "--work-precision", "--integrator", "forward-euler:step=1e-6",
                          "--integrator", "exponential", "--time-limit", "0.5", "--quiet", "--out", out()});
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_NE(folder_.read("out/work_precision.csv").find("timeout"), std::string::npos);
}

TEST_F(Limits, WorkThatIsKnownBeforehandIsNotBegun) {
  const auto run = [&](const char* spec, const char* most) {
    return test::call_program(
        {"run", endless(), "--integrator", spec, "--max-work", most, "--quiet", "--out", out()});
  };
  const auto said = run("forward-euler:step=1e-3", "1000000");
  EXPECT_EQ(said.code, 4) << said.err;
  EXPECT_NE(said.out.find("refused: it would take 3e+08 sweeps"), std::string::npos) << said.out;
  EXPECT_EQ(run("forward-euler:step=1", "300000").code, 4) << "unstable, and begun";
  EXPECT_EQ(run("forward-euler:step=0.4", "750000").code, 0);
  EXPECT_EQ(run("forward-euler:step=0.4", "749999").code, 4);
  const auto adaptive = run("rkc:rtol=1e-8", "100");
  EXPECT_EQ(adaptive.code, 4);
  EXPECT_NE(adaptive.out.find("timeout: at t = "), std::string::npos) << adaptive.out;
}

TEST_F(Limits, MoreStepsThanAnybodyCanTakeAreRefused) {
  for (const char* spec :
       {"forward-euler:step=1e-9", "sts:n=5,step=1e-9", "rkc:step=1e-9", "trapezoidal:step=1e-9"}) {
    const auto said = test::call_program({"run", endless(), "--integrator", spec, "--quiet", "--out", out()});
    EXPECT_EQ(said.code, 4) << spec << said.err;
    EXPECT_NE(said.out.find("to the end; take"), std::string::npos) << said.out;
  }
}

TEST_F(Limits, MovingParticlesHaveATimeLimitToo) {
  (void)test::small_press(folder_);
  std::string press = folder_.read("press.toml");
  press.replace(press.find("until = 0.04"), 12, "until = 4000");
  press.replace(press.find("t_end = 0.04"), 12, "t_end = 4000");
  press.replace(press.find("output_times = [0.02, 0.04]"), 27, "");
  folder_.write("press.toml", press);
  const auto said = test::call_program(
      {"run", folder_.file("press.toml"), "--time-limit", "0.3", "--quiet", "--out", out()});
  EXPECT_EQ(said.code, 4) << said.err;
  EXPECT_NE(said.out.find("timeout"), std::string::npos) << said.out << said.err;
  EXPECT_TRUE(folder_.has("out/checkpoint.bin"));
}

TEST_F(Limits, WhatHasNoEndIsNoData) {
  const std::string pipe = folder_.file("pipe");
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::filesystem::create_symlink("/dev/zero", folder_.file("link"));
  for (const auto& data :
       std::vector<std::string>{"/dev/zero", "/dev/urandom", "/dev", pipe, folder_.file("link")}) {
    const std::string network =
        fmt::format("t_end = 1.0\n[network]\nnodes = \"{}\"\nedges = \"rod_edges.csv\"\n", data);
    const std::string packing = fmt::format(
        "t_end = 1.0\n[packing]\nfile = \"{}\"\n[material]\ndensity = 1.0\n[contact]\nneck = \"geometric\"\n"
        "[thermal]\nconductivity = 1.0\nspecific_heat = 1.0\n",
        data);
    for (const auto& line : {std::vector<std::string>{"run", data},
                             {"run", folder_.write("network.toml", network)},
                             {"bench", folder_.write("network.toml", network)},
                             {"run", folder_.write("packing.toml", packing)},
                             {"report", data},
                             {"gate", data, "--baseline", data},
                             {"compare", data, data}}) {
      const auto said = test::call_program(line);
      EXPECT_EQ(said.code, 3) << line[0] << ' ' << data << ": " << said.err;
      EXPECT_EQ(std::count(said.err.begin(), said.err.end(), '\n'), 1) << said.err;
    }
  }
  (void)test::small_press(folder_);
  EXPECT_EQ(test::call_program({"run", folder_.file("press.toml"), "--restart", pipe, "--out", out()}).code,
            3);
}

TEST_F(Limits, FilesBeyondWhatAnybodyReadsAreRefused) {
  folder_.write("huge.csv", "id,capacity,source,initial,fixed\n");
  std::filesystem::resize_file(folder_.file("huge.csv"), std::uintmax_t{1} << 40);  // no block of it is there
  folder_.write("huge.toml", "t_end = 1.0\n");
  std::filesystem::resize_file(folder_.file("huge.toml"), std::uintmax_t{1} << 30);
  const std::string network = folder_.write(
      "network.toml", "t_end = 1.0\n[network]\nnodes = \"huge.csv\"\nedges = \"rod_edges.csv\"\n");
  for (const auto& file : {network, folder_.file("huge.toml")}) {
    const auto said = test::call_program({"run", file, "--out", out()});
    EXPECT_EQ(said.code, 3) << said.err;
    EXPECT_NE(said.err.find("bytes, and at most"), std::string::npos) << said.err;
  }
}

TEST_F(Limits, AForecastSaysHowLongItTakesAndWhatIsFaster) {
  EXPECT_EQ(forecast_text("rkc", 0.5, 10, 0, "exponential"), "") << "over in twenty seconds";
  const std::string minutes = forecast_text("rkc", 0.01, 10, 0, "exponential");
  EXPECT_NE(minutes.find("17 minutes"), std::string::npos) << minutes;
  EXPECT_EQ(minutes.find("faster"), std::string::npos) << minutes;
  const std::string hours = forecast_text("forward-euler", 1e-3, 10, 600, "exponential");
  EXPECT_NE(hours.find("3 hours"), std::string::npos) << hours;
  EXPECT_NE(hours.find("ends after 10 minutes"), std::string::npos) << hours;
  EXPECT_NE(hours.find("exponential would be faster"), std::string::npos) << hours;
  EXPECT_NE(forecast_text("cvode", 0, 10, 0, "").find("no step is done"), std::string::npos);
  const std::string late = forecast_text("cvode", 0, 10, 0.3, "");
  EXPECT_NE(late.find("its time was up after 0.3 s"), std::string::npos) << late;
  EXPECT_EQ(late.find("it ends after"), std::string::npos) << late;
}

}  // namespace
}  // namespace superstep
