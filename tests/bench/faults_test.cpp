/// What goes wrong around the program: full disks, closed streams, damaged files, a second process.

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "bench/host/memory_limit.hpp"
#include "support/small_press.hpp"
#include "support/temporary_case.hpp"

namespace superstep {
namespace {

using test::CaseFolder;
using test::Rod;
using Json = nlohmann::ordered_json;

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

class Faults : public testing::Test {
 protected:
  void SetUp() override { write_rod(folder_, Rod{}); }

  /// Exit code of a shell command in the temporary folder, $S being the program; -1 when a signal ended it.
  int shell(const std::string& script) {
    folder_.write("script.sh", script);
    const std::string command = fmt::format("cd '{}' && S='{}' bash script.sh >stdout.txt 2>stderr.txt",
                                            folder_.file("."), SUPERSTEP_PROGRAM);
    const int status = std::system(command.c_str());  // NOLINT(cert-env33-c): a shell is what users have
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    constexpr int signalled = 128;  // as bash says it
    return code > signalled ? -1 : code;
  }
  [[nodiscard]] std::string err() const { return folder_.read("stderr.txt"); }
  void expect(const std::string& script, int code, const std::string& part) {
    SCOPED_TRACE(script);
    EXPECT_EQ(shell(script), code) << err();
    const std::string message = err();
    EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 1) << message;
    EXPECT_NE(message.find(part), std::string::npos) << message;
  }
  /// The rod's own results, with one thing about them changed.
  template <class Change>
  std::string damaged(const std::string& from, const std::string& to, Change change) {
    auto json = Json::parse(folder_.read(from));
    change(json);
    return folder_.write(to, json.dump());
  }

  CaseFolder folder_;
};

TEST_F(Faults, AMessageThatNobodyCanHearChangesNoExitCode) {
  for (const char* stderr_is : {"2>&-", "2>/dev/full", "2>&1 >/dev/null | true"}) {
    const std::string pipe = "set -o pipefail\n";
    EXPECT_EQ(shell(pipe + "$S run missing.toml " + stderr_is), 3) << stderr_is;
    EXPECT_EQ(shell(pipe + "$S run rod.toml --integrator nobody " + stderr_is), 2) << stderr_is;
    EXPECT_EQ(shell(pipe + "$S bench rod.toml --repetitions 1 --out b " + stderr_is), 0) << stderr_is;
  }
  EXPECT_EQ(shell("$S list >&-"), 7);
  EXPECT_EQ(shell("$S run rod.toml --out closed <&- >&- 2>&-"), 7);
  EXPECT_TRUE(folder_.read("closed/final.csv").starts_with("id,")) << "no message in a result";
}

TEST_F(Faults, AMessageIsOneLineWhateverItQuotes) {
  expect("$S run rod.toml --integrator $'forward-euler:step=1\\n2'", 2, "\\x0a");
  expect("$S run rod.toml --integrator $'x\\ny:a=1'", 2, "\\x0a");
  expect("$S run $'a\\nb.toml'", 3, "a\\x0ab.toml");
}

TEST_F(Faults, AFullDiskIsNoFaultOfTheMethod) {
  std::filesystem::copy(SUPERSTEP_SOURCE_DIR "/cases", folder_.file("cases"),
                        std::filesystem::copy_options::recursive);
  // In blocks of 1024 bytes: enough for everything but the fields.
  const std::string limit = "ulimit -f 16\n";
  expect(limit + "$S run cases/lattice.toml --integrator forward-euler --vtk --quiet --out full", 7,
         "cannot be written");
  EXPECT_FALSE(folder_.has("full/run.json"));
  expect(limit + "$S run cases/lattice.toml --integrator forward-euler --quiet --out full", 7,
         "final.csv: cannot be written");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.file("full")))
    EXPECT_NE(entry.path().extension(), ".tmp") << entry.path();
}

TEST_F(Faults, TooLittleMemoryIsNoSignalAndNoHang) {
  if (sanitized) GTEST_SKIP() << "a sanitizer reserves more";
  const auto under = [&](const char* limit, const char* command) {
    return shell(fmt::format("unset OPENBLAS_NUM_THREADS\nulimit -{}\ntimeout 20 $S {}", limit, command));
  };
  // 127: the loader found no room for the libraries.
  for (const char* limit : {"v 60000", "v 70000", "v 80000", "v 130000", "v 250000", "d 8000", "d 60000"}) {
    const int code = under(limit, "run rod.toml --quiet --out small");
    EXPECT_TRUE(code == 0 || code == 1 || code == 4 || code == 127) << limit << ": " << code << err();
  }
  // Its steady state is factorized in blocks, for which OpenBLAS wants a buffer: there is room for all else.
  EXPECT_EQ(under("v 150000", "info " SUPERSTEP_SOURCE_DIR "/cases/nial_thermal.toml"), 0) << err();
}

TEST_F(Faults, AMethodThatFindsNoMemoryIsARow) {
  if (sanitized) GTEST_SKIP() << "a sanitizer reserves more";
  folder_.write("cube.toml", "t_end = 1\n[network]\ngenerator = \"lattice\"\nsize = 27000\ninlet = 1\n");
  EXPECT_EQ(
      shell(
          "unset OPENBLAS_NUM_THREADS\nulimit -v 110000\n"
          "timeout 100 $S bench cube.toml --integrator cvode:linsol=klu --integrator trapezoidal:solver=klu "
          "--integrator trapezoidal:solver=cholmod --integrator rkc --reference none --repetitions 1 "
          "--quiet --out cube"),
      0)
      << err();
  const auto results = Json::parse(folder_.read("cube/results.json"));
  for (const auto& row : results.at("cases").at(0).at("rows")) {
    const auto name = row.at("integrator").get<std::string>();
    const bool factorizes = name == "cvode" || name == "trapezoidal";
    EXPECT_EQ(row.at("status"), factorizes ? "failed" : "ok") << row;
    EXPECT_EQ(row.at("reason").get<std::string>().find("out of memory") != std::string::npos, factorizes)
        << row;
  }
}

TEST(MemoryLimit, RefusesWhatTheMachineCannotGive) {
  const std::uint64_t all = attainable_memory();
  EXPECT_GT(all, 1u << 20);
  // Three pieces that the system would promise one by one, and kill the process for once they are used.
  const auto pieces_that_are_there = [all] {
    int there = 0;
    for (int piece = 0; piece < 3; ++piece)
      if (::mmap(nullptr, all / 20 * 9, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) !=
          MAP_FAILED)
        ++there;
    return there;
  };
  EXPECT_EXIT(
      {
        keep_to_memory(all);
        std::_Exit(pieces_that_are_there());
      },
      testing::ExitedWithCode(2), "");
}

TEST_F(Faults, AFolderBelongsToOneProcess) {
  std::filesystem::create_directory(folder_.file("busy"));
  const int held = ::open(folder_.file("busy").c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(::flock(held, LOCK_EX | LOCK_NB), 0);
  for (const char* command : {"run", "bench", "stability", "bench --work-precision"})
    expect(fmt::format("$S {} rod.toml --out busy", command), 7, "another superstep");
  ::close(held);
  EXPECT_EQ(shell("$S run rod.toml --out busy"), 0) << err();
}

TEST_F(Faults, TheIndexGoesFirstAndComesLast) {
  ASSERT_EQ(shell("$S run rod.toml --out result"), 0) << err();
  ASSERT_TRUE(folder_.has("result/run.json"));
  // Killed while it integrates: what is left must not pretend to belong to an earlier run.
  (void)shell(
      "$S run rod.toml --integrator forward-euler:step=1e-8 --out result &\n"
      "for i in $(seq 600); do [ -e result/run.json ] || break; sleep 0.1; done\nkill -9 $!; wait");
  EXPECT_FALSE(folder_.has("result/run.json"));
  ASSERT_EQ(shell("$S run rod.toml --out result"), 0) << err();
  for (const std::string name : Json::parse(folder_.read("result/run.json")).at("files"))
    EXPECT_TRUE(folder_.has("result/" + name)) << name;
}

TEST_F(Faults, WhatThisCommandDoesNotWriteStays) {
  ASSERT_EQ(shell("$S bench rod.toml --repetitions 1 --report --out page"), 0) << err();
  ASSERT_EQ(shell("$S bench rod.toml --repetitions 1 --out page"), 0) << err();
  EXPECT_TRUE(folder_.has("page/report.html"));
  EXPECT_NE(err().find("report.html shows earlier results"), std::string::npos) << err();
}

TEST_F(Faults, ARunLeavesNothingOfTheRunBefore) {
  std::filesystem::copy(SUPERSTEP_SOURCE_DIR "/cases", folder_.file("cases"),
                        std::filesystem::copy_options::recursive);
  const std::string press = SUPERSTEP_SOURCE_DIR "/tests/support/small_press.toml";
  const auto left = [&](const char* name) { return folder_.has(std::string("seen/") + name); };
  std::filesystem::create_directories(folder_.file("seen/snapshots"));
  folder_.write("seen/snapshots/mine.csv", "kept");
  folder_.write("seen/snapshots/particles_0007.csv", "old");
  folder_.write("seen/snapshots/particles_7.csv", "no name of ours");
  ASSERT_EQ(shell("$S run cases/lattice.toml --vtk --out seen"), 0) << err();
  EXPECT_TRUE(left("vtk/particles.pvd") && !left("snapshots/particles_0007.csv"));
  ASSERT_EQ(shell("$S run " + press + " --out seen"), 0) << err();
  EXPECT_TRUE(left("history.csv") && left("history.svg") && left("snapshots/particles_0001.csv"));
  EXPECT_FALSE(left("vtk/particles.pvd") || left("vtk/particles_0000.vtp") || left("probes.csv"));
  ASSERT_EQ(shell("$S run rod.toml --out seen"), 0) << err();
  for (const char* gone : {"history.csv", "history.svg", "snapshots/particles_0001.csv"})
    EXPECT_FALSE(left(gone)) << gone;
  EXPECT_TRUE(left("snapshots/mine.csv") && left("snapshots/particles_7.csv"));
}

TEST_F(Faults, CasesOfOneNameAreNotMerged) {
  std::filesystem::create_directory(folder_.file("other"));
  for (const char* name : {"rod.toml", "rod_nodes.csv", "rod_edges.csv"})
    folder_.write(std::string("other/") + name, folder_.read(name));
  for (const char* how : {"", "--work-precision "})
    expect(fmt::format("$S bench {}rod.toml other/rod.toml --out merged", how), 2, "both named 'rod'");
  EXPECT_FALSE(folder_.has("merged"));
}

TEST_F(Faults, ValuesOfAnotherTypeInResultsNameFileAndKey) {
  ASSERT_EQ(shell("$S bench rod.toml --repetitions 1 --quiet --out good"), 0) << err();
  std::filesystem::create_directory(folder_.file("bad"));
  struct Damage {
    const char* where;
    Json value;
    const char* key;
  };
  for (const auto& [where, value, key] :
       std::initializer_list<Damage>{{"/schema", 3, "'schema'"},
                                     {"/cases", "none", "'cases'"},
                                     {"/cases/0", 5, "'cases[0]'"},
                                     {"/cases/0/case", Json::array(), "'cases[0].case'"},
                                     {"/cases/0/rows/1", "row", "'cases[0].rows[1]'"},
                                     {"/cases/0/rows/1/steps", "many", "'cases[0].rows[1].steps'"},
                                     {"/cases/0/rows/1/rhs", Json::object(), "'cases[0].rows[1].rhs'"},
                                     {"/cases/0/rows/1/error_rms", true, "'cases[0].rows[1].error_rms'"},
                                     {"/cases/0/rows/1/status", 1, "'cases[0].rows[1].status'"}}) {
    damaged("good/results.json", "bad/results.json",
            [&, place = where, to = value](Json& json) { json[Json::json_pointer(place)] = to; });
    for (const char* command : {"report bad", "gate bad --baseline good", "gate good --baseline bad",
                                "report good --markdown --against bad"})
      expect(std::string("$S ") + command, 3, key);
  }
  damaged("good/health.json", "good/health.json", [](Json& json) { json["cases"][0]["fields"] = 7; });
  expect("$S report good", 3, "'cases[0].fields'");
}

TEST_F(Faults, ABadSpecInAFileIsTheFilesFault) {
  ASSERT_EQ(shell("$S bench rod.toml --work-precision --integrator rkc:rtol=1e-2 --quiet --out sweep"), 0)
      << err();
  std::string text = folder_.read("sweep/work_precision.csv");
  const auto at = text.find("rtol=1e-2");
  ASSERT_NE(at, std::string::npos) << text;
  folder_.write("sweep/work_precision.csv", text.replace(at, 9, "rtol"));
  expect("$S report sweep", 3, "work_precision.csv: row");
  ASSERT_EQ(shell("$S bench rod.toml --repetitions 1 --quiet --out good"), 0) << err();
  damaged("good/results.json", "good/results.json",
          [](Json& json) { json["cases"][0]["rows"][1]["params"] = "n=5,,"; });
  expect("$S report good", 3, "'cases[0].rows[1].params'");
}

TEST_F(Faults, AGateThatHasNothingToJudgeDoesNotPass) {
  ASSERT_EQ(shell("$S bench rod.toml --repetitions 1 --quiet --out good"), 0) << err();
  const auto each_row = [](Json& json, auto change) {
    for (auto& row : json["cases"][0]["rows"]) change(row);
  };
  const auto judged = [&](const std::string& name, auto change) {
    damaged("good/results.json", name, [&](Json& json) { each_row(json, change); });
    const int now = shell("$S gate " + name + " --baseline good");
    EXPECT_EQ(shell("$S gate good --baseline " + name), now);
    return now;
  };
  EXPECT_EQ(shell("$S gate good --baseline good"), 0) << err();
  EXPECT_EQ(judged("untimed.json", [](Json& row) { row["cpu_stepping_samples_s"] = Json::array(); }), 6);
  EXPECT_EQ(judged("null.json", [](Json& row) { row.erase("cpu_stepping_samples_s"); }), 6);
  EXPECT_EQ(judged("garbled.json", [](Json& row) { row["cpu_stepping_samples_s"] = "fast"; }), 3);
  EXPECT_EQ(judged("words.json", [](Json& row) { row["cpu_stepping_samples_s"] = {"fast"}; }), 3);
  EXPECT_EQ(
      judged("uncounted.json",
             [](Json& row) {
               for (const char* key : {"steps", "rejected", "rhs", "jacobians", "factorizations", "solves"})
                 row[key] = nullptr;
             }),
      3);
}

TEST_F(Faults, ARestartNeedsTheSamePressAndGoesOnWithItsSeries) {
  (void)test::small_press(folder_);
  const std::string press = folder_.read("press.toml");
  const auto changed = [&](const std::string& name, const std::string& from, const std::string& to) {
    std::string text = press;
    const auto at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    folder_.write(name, text.replace(at, from.size(), to));
  };
  changed("half.toml", "t_end = 0.04\noutput_times = [0.02, 0.04]", "t_end = 0.02");
  ASSERT_EQ(shell("$S run half.toml --vtk --checkpoint 0.01 --out out"), 0) << err();

  const std::string resume = " --restart out/checkpoint.bin --quiet --out again";
  changed("stiffer.toml", "stiffness = 1e7", "stiffness = 2e7");
  expect("$S run stiffer.toml" + resume, 3, "dynamics.contact.stiffness = 10000000");
  changed("hotter.toml", "upper = 900.0", "upper = 901.0");
  expect("$S run hotter.toml" + resume, 3, "thermal.walls");
  changed("faster.toml", "upper_wall = 0.35", "upper_wall = 0.34");
  expect("$S run faster.toml" + resume, 3, "phases");
  changed("lighter.toml", "density = 2000.0", "density = 1000.0");
  expect("$S run lighter.toml" + resume, 3, "other particles");
  EXPECT_FALSE(folder_.has("again/run.json"));

  ASSERT_EQ(shell("$S run press.toml --restart out/checkpoint.bin --vtk --out out"), 0) << err();
  const std::string series = folder_.read("out/vtk/particles.pvd");
  for (const char* frame : {"timestep=\"0\"", "timestep=\"0.02\"", "timestep=\"0.04\""})
    EXPECT_NE(series.find(frame), std::string::npos) << series;
  for (const char* file : {"particles_0000.vtp", "particles_0002.vtp", "contacts_0002.vtp"})
    EXPECT_TRUE(folder_.has(std::string("out/vtk/") + file)) << file;
  EXPECT_FALSE(folder_.has("out/vtk/particles_0003.vtp")) << "0.02 s stands there once";
}

}  // namespace
}  // namespace superstep
