/// The program as a user meets it: exit codes, messages, files.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "support/program_fixture.hpp"

namespace superstep {
namespace {

using test::Program;
using test::Rod;

TEST_F(Program, UsageErrorsExitWith2AndNameTheNearestChoice) {
  expect_error("", 2, "a command is missing");
  expect_error("benc rod.toml", 2, "did you mean 'bench'");
  expect_error("bench rod.toml --repetitons 3", 2, "did you mean '--repetitions'");
  expect_error("bench", 2, "a case file is missing");
  expect_error("run rod.toml other.toml", 2, "unexpected argument");
  expect_error("bench rod.toml --out", 2, "--out");
}

TEST_F(Program, SwappedLettersAreForgiven) {
  expect_error("bnech rod.toml", 2, "did you mean 'bench'");
  expect_error("repotr result", 2, "did you mean 'report'");
  expect_error("run rod.toml --integrator forward-euelr", 2, "did you mean 'forward-euler'");
}

TEST_F(Program, LongerAndShorterNamesAreUnderstood) {
  expect_error("benchmark rod.toml", 2, "did you mean 'bench'");
  expect_error("run rod.toml --integrator euler", 2, "did you mean 'forward-euler'");
  folder_.write("three.csv", "id,x,y,z,radius\n1,0,0,0,1\n2,1.9,0,0,1\n");
  folder_.write("necks.toml",
                "t_end = 1\n[packing]\nfile = \"three.csv\"\n[material]\ndensity = 1\n[contact]\n"
                "neck = \"hertzian\"\n[thermal]\nconductivity = 1\nspecific_heat = 1\ninitial = 0\n");
  expect_error("info necks.toml", 3, "did you mean 'hertz'");
}

TEST_F(Program, APackingInPlaceOfACaseIsToldApart) {
  folder_.write("three.csv", "id,x,y,z,radius\n1,0,0,0,1\n2,1.9,0,0,1\n");
  for (const char* command : {"run", "bench", "stability", "bench --work-precision"}) {
    expect_error(fmt::format("{} three.csv", command), 3, "three.csv: this is a packing");
    EXPECT_NE(err().find("[packing] file = 'three.csv'"), std::string::npos) << err();
  }
  folder_.write("list.csv", "a,b\n1,2\n");
  expect_error("run list.csv", 3, "list.csv:1");
}

TEST_F(Program, ANetworkInPlaceOfACaseIsToldApart) {
  folder_.write("e.csv", "i,j,conductance\n1,2,3\n");
  folder_.write("bare.txt", "1 2 3.5\n2 3 4\n");
  folder_.write("K.mtx", "%%MatrixMarket matrix coordinate real symmetric\n2 2 3\n1 1 2\n2 1 -1\n2 2 1\n");
  for (const auto& [file, key] : {std::pair{"e.csv", "edges"}, {"bare.txt", "edges"}, {"K.mtx", "matrix"}}) {
    expect_error(fmt::format("run {}", file), 3, fmt::format("{}: this is a network", file));
    EXPECT_NE(err().find(fmt::format("[network] {} = '{}'", key, file)), std::string::npos) << err();
  }
}

TEST_F(Program, ReportsNeedResultsAndNamesOfFoldersDoNoHarm) {
  expect_error("report", 2, "folder of results is missing");
  expect_error("report missing", 3, "missing");
  expect_error("report rod.toml", 3, "not a folder");
  expect_error("report . --against other", 2, "--markdown");
  expect_error("report . --markdown --json", 2, "choose one");
  expect_error("run rod.toml --vtk --out result", 3, "leave --vtk out");
  const std::string name = "'=cmd() <b> \"x\"'";
  ASSERT_EQ(run("bench rod.toml --repetitions 1 --report --out " + name), 0) << err();
  EXPECT_NE(err().find("report in"), std::string::npos);
  ASSERT_EQ(run("report " + name + " --markdown --quiet"), 0) << err();
  EXPECT_EQ(err(), "");
  EXPECT_TRUE(out().starts_with("**All 3 runs succeeded.**")) << out();
  ASSERT_EQ(run("report " + name + " --json --quiet"), 0) << err();
  EXPECT_EQ(nlohmann::json::parse(out()).at("file"), "=cmd() <b> \"x\"/report.html");
  EXPECT_TRUE(folder_.has("=cmd() <b> \"x\"/report.html"));
}

TEST_F(Program, AReportGathersBenchSweepStabilityAndRun) {
  ASSERT_EQ(run("bench rod.toml --repetitions 1 --out all"), 0) << err();
  ASSERT_EQ(
      run("bench rod.toml --work-precision --integrator rkc:rtol=1e-2 --integrator rkc:rtol=1e-4 --out all"),
      0)
      << err();
  ASSERT_EQ(run("stability rod.toml --quick --out all"), 0) << err();
  ASSERT_EQ(run("run rod.toml --out all/one"), 0) << err();
  ASSERT_EQ(run("report all"), 0) << err();
  const std::string html = folder_.read("all/report.html");
  for (const char* id : {"case-1-results", "case-1-work-precision", "stability", "runs", "machine"})
    EXPECT_NE(html.find(std::string("<section id=\"") + id + "\""), std::string::npos) << id;
}

TEST_F(Program, CompletionScriptsOfferCommandsOptionsAndMethods) {
  expect_error("completion", 2, "bash, zsh or fish");
  expect_error("completion bsah", 2, "did you mean 'bash'");
  ASSERT_EQ(run("completion bash"), 0);
  folder_.write("complete.sh",
                out() +
                    "try() { COMP_WORDS=(superstep \"$@\"); COMP_CWORD=$#; _superstep; echo "
                    "\"${COMPREPLY[*]}\"; }\n"
                    "try be; try bench --rep; try run --integrator exp; try pack --color n; try run case\n");
  const std::string command =
      fmt::format("cd '{}' && bash complete.sh >completed.txt 2>&1", folder_.file("."));
  ASSERT_EQ(std::system(command.c_str()), 0);  // NOLINT(cert-env33-c): a shell is what users have
  EXPECT_EQ(folder_.read("completed.txt"), "bench\n--repetitions --report\nexponential exprb\nnever\n\n");
  for (const std::string shell : {"zsh", "fish"}) {
    ASSERT_EQ(run("completion " + shell), 0);
    EXPECT_NE(out().find("work-precision"), std::string::npos);
    EXPECT_NE(out().find("exponential"), std::string::npos);
  }
}

TEST_F(Program, NumbersOnTheCommandLineAreStrict) {
  for (const std::string value : {"0", "-5", "1e2", "''", "3x", "99999999999999999999"})
    expect_error("bench rod.toml --repetitions " + value, 2, "--repetitions");
  expect_error("bench rod.toml --threads 1025", 2, "from 1 to 1024");
  expect_error("run rod.toml --tolerance -1", 2, "--tolerance");
  expect_error("run rod.toml --tolerance nan", 2, "--tolerance");
  expect_error("list --color sometimes", 2, "--color");
  expect_error("run rod.toml --tolerance ''", 2, "--tolerance");
  expect_error("run rod.toml --out ''", 2, "--out");
  expect_error("pack --height 1 --diameter 1 --sizes uniform:min=0.1,max=0.2 --seed -5 -o x.csv", 2,
               "--seed");
  expect_error("pack --height 1 --diameter 1 --sizes uniform:min=0.3,max=0.2 -o x.csv", 2, "min");
  expect_error("pack --height 1 --diameter 1 --sizes uniform:0.3:0.2 -o x.csv", 2,
               "--sizes 'uniform:0.3:0.2'");
  expect_error("pack --height 1 --diameter 1 --sizes unform:min=0.1,max=0.2 -o x.csv", 2,
               "did you mean 'uniform'");
  expect_error("pack --height 1 --sizes list:0.1,0.2 -o x.csv", 2, "--diameter");
}

TEST_F(Program, WhatFollowsTwoDashesIsNoOption) {
  folder_.write("-lead.toml", folder_.read("rod.toml"));
  EXPECT_EQ(run("run --integrator rkc --out lead -- -lead.toml"), 0) << err();
  EXPECT_EQ(run("run --out lead --quiet -- rod.toml"), 0) << err();
  expect_error("run --out -- rod.toml", 2, "--out needs a value");
  expect_error("run -- --out", 3, "--out: no such file");
}

TEST_F(Program, GateAndCompareKeepTheirExitCodes) {
  expect_error("gate", 2, "results.json");
  expect_error("gate rod.toml", 2, "--baseline");
  expect_error("compare rod.toml", 2, "two results.json");
  expect_error("gate rod.toml --baseline rod.toml", 3, "rod.toml");
  const std::string bench = "bench rod.toml --integrator forward-euler --repetitions 1 --quiet --out ";
  ASSERT_EQ(run(bench + "a"), 0) << err();
  ASSERT_EQ(run(bench + "b"), 0) << err();
  EXPECT_EQ(run("gate b --baseline a/results.json"), 0)
      << out();  // work and errors repeat; one round: no times
  EXPECT_TRUE(out().starts_with("# Performance gate: passed")) << out();
  EXPECT_EQ(run("gate b --baseline a --json"), 0);
  EXPECT_EQ(nlohmann::json::parse(out()).at("verdict"), "passed");
  EXPECT_EQ(run("compare a b"), 0);
  auto json = nlohmann::json::parse(folder_.read("b/results.json"));
  json["cases"][0]["rows"][0]["rhs"] = json["cases"][0]["rows"][0]["rhs"].get<int>() + 1;
  folder_.write("worse.json", json.dump());
  EXPECT_EQ(run("gate worse.json --baseline a"), 5);
  json["cases"] = nlohmann::json::array();
  folder_.write("none.json", json.dump());
  EXPECT_EQ(run("gate a --baseline none.json"), 6);
  EXPECT_EQ(run("compare a none.json"), 6);
}

TEST_F(Program, SpecsAreCheckedBeforeAnythingElse) {
  expect_error("run rod.toml --integrator forward-eular --out result", 2, "did you mean 'forward-euler'");
  expect_error("bench rod.toml --integrator sts:n=0 --out result", 2, "1 <= n");
  expect_error("bench rod.toml --reference sts:n=five --out result", 2, "n");
  expect_error("run rod.toml --integrator forward-euler --tolerance 1e-5 --out result", 2, "tolerance");
}

TEST_F(Program, BadInputExitsWith3AndNamesFileAndLine) {
  expect_error("run missing.toml --out result", 3, "missing.toml");
  folder_.write("bad.toml", "t_ende = 2\n" + folder_.read("rod.toml"));
  expect_error("run bad.toml --out result", 3, "bad.toml:1");
  folder_.write("broken.toml", "t_end = = 1\n");
  expect_error("bench rod.toml broken.toml --out result", 3, "broken.toml:1");
}

TEST_F(Program, UnwritableOutputExitsWith7) {
  folder_.write("file", "in the way");
  expect_error("run rod.toml --out file", 7, "file");
  expect_error("bench rod.toml --out file/below", 7, "file/below");
  EXPECT_EQ(folder_.read("file"), "in the way");
  EXPECT_EQ(run("list", R"(sh -c '"$0" "$@" >/dev/full')"), 7) << err();
}

TEST_F(Program, ResultsAreKeptWhereStandardOutputIsFull) {
  const std::string full = R"(sh -c '"$0" "$@" >/dev/full')";
  EXPECT_EQ(run("bench rod.toml --repetitions 1 --out b", full), 7) << err();
  EXPECT_TRUE(folder_.has("b/results.json"));
  EXPECT_EQ(run("bench rod.toml --work-precision --integrator rkc --out w", full), 7) << err();
  EXPECT_TRUE(folder_.has("w/work_precision.csv"));
  EXPECT_EQ(run("run rod.toml --integrator rkc rock --out r", full), 7) << err();
  EXPECT_TRUE(folder_.has("r/rkc/run.json"));
  EXPECT_TRUE(folder_.has("r/rock/run.json"));
}

TEST_F(Program, AnUnstableRunExitsWith4AndRecordsItsOutcome) {
  EXPECT_EQ(run("run rod.toml --integrator forward-euler:step=0.7 --out result"), 4);
  EXPECT_FALSE(folder_.has("result/final.csv"));
  const auto json = nlohmann::json::parse(folder_.read("result/run.json"));
  EXPECT_EQ(json.at("outcome").at("status"), "unstable");
  EXPECT_NE(out().find("unstable"), std::string::npos);
}

TEST_F(Program, ABenchInWhichAllFailExitsWith4) {
  Rod rod;
  rod.bench = "baseline = \"forward-euler:step=0.7\"\nintegrators = [\"forward-euler:step=0.8\"]\n";
  write_rod(folder_, rod, "hopeless");
  EXPECT_EQ(run("bench hopeless.toml --out result"), 4);
  EXPECT_TRUE(folder_.has("result/results.csv"));
}

TEST_F(Program, RunWritesItsFilesBesideTheCallerByDefault) {
  ASSERT_EQ(run("run rod.toml"), 0) << err();
  for (const char* name : {"final.csv", "probes.csv", "run.json"})
    EXPECT_TRUE(folder_.has(std::string("superstep-out/rod/") + name)) << name;
  EXPECT_NE(out().find("auto"), std::string::npos) << "auto is the default";
}

TEST_F(Program, SeveralIntegratorsGetAFolderEach) {
  ASSERT_EQ(run("run rod.toml --integrator cvode --integrator sts:n=5 --tolerance 1e-5 --out result"), 2)
      << "sts has no tolerance";
  ASSERT_EQ(run("run rod.toml --integrator cvode --integrator sts:n=5 --out result"), 0) << err();
  EXPECT_TRUE(folder_.has("result/cvode/final.csv"));
  EXPECT_TRUE(folder_.has("result/sts_n=5/final.csv"));
}

TEST_F(Program, AListOfIntegratorsEndsAtTheNextOptionOrCase) {
  const std::string bench = "bench --repetitions 1 --reference none --json --quiet --out result ";
  for (const char* order : {"rod.toml --integrator rkc sts:n=5,nu=0.05 cvode --threads 1",
                            "--integrator rkc sts:n=5,nu=0.05 --integrator cvode rod.toml",
                            "--integrator=rkc sts:n=5,nu=0.05 cvode ./rod.toml"}) {
    ASSERT_EQ(run(bench + order), 0) << order << err();
    std::vector<std::string> specs;
    const auto json = nlohmann::json::parse(out());
    for (const auto& row : json.at("cases").at(0).at("rows")) specs.push_back(row.at("integrator"));
    EXPECT_EQ(specs, (std::vector<std::string>{"rkc", "sts", "cvode", "forward-euler"})) << order;
  }
  ASSERT_EQ(run("run rod.toml --integrator cvode sts:n=5 --out two"), 0) << err();
  EXPECT_TRUE(folder_.has("two/cvode/final.csv") && folder_.has("two/sts_n=5/final.csv"));
  std::filesystem::remove_all(folder_.file("result"));
  folder_.write("plain", folder_.read("rod.toml"));
  EXPECT_EQ(run("run --integrator cvode plain --out three"), 0)
      << "a case may be called what it likes" << err();
  expect_error("run rod.toml --integrator cvode rkq --out result", 2, "unknown integrator 'rkq'");
  expect_error("run --integrator rod.toml --out result", 2, "a case file is missing");
}

TEST_F(Program, OneRepetitionHasNoSpread) {
  ASSERT_EQ(run("bench rod.toml --integrator rkc --reference none --repetitions 1 --out result"), 0) << err();
  EXPECT_EQ(out().find('%'), std::string::npos) << out();
  ASSERT_EQ(run("bench rod.toml --integrator rkc --reference none --repetitions 2 --out result"), 0) << err();
  EXPECT_NE(out().find('%'), std::string::npos) << out();
}

TEST_F(Program, ToleranceReachesTheMethod) {
  ASSERT_EQ(run("run rod.toml --integrator cvode:rtol=1e-2 --tolerance 1e-8 --json --out result"), 0)
      << err();
  EXPECT_EQ(nlohmann::json::parse(out()).at("params"), "rtol=1e-08");
}

TEST_F(Program, BenchPrintsATableAndWritesItsResults) {
  ASSERT_EQ(run("bench rod.toml --repetitions 2 --out result"), 0) << err();
  EXPECT_NE(out().find("forward-euler"), std::string::npos);
  EXPECT_EQ(out().find('\033'), std::string::npos) << "no colours in a file";
  const auto json = nlohmann::json::parse(folder_.read("result/results.json"));
  EXPECT_EQ(json.at("cases").at(0).at("reference_from_cache"), false);
  EXPECT_EQ(json.at("cases").at(0).at("rows").size(), 3U);
  EXPECT_EQ(json.at("cases").at(0).at("rows").at(0).at("repetitions"), 2);
  EXPECT_NE(err().find("result/results.csv"), std::string::npos);

  ASSERT_EQ(run("bench rod.toml --repetitions 1 --out result --json --quiet"), 0) << err();
  EXPECT_EQ(err(), "");
  EXPECT_EQ(nlohmann::json::parse(out()).at("cases").at(0).at("reference_from_cache"), true);
}

TEST_F(Program, ColoursAreThereWhenAskedFor) {
  ASSERT_EQ(run("list --color always"), 0);
  EXPECT_NE(out().find('\033'), std::string::npos);
  ASSERT_EQ(run("list"), 0);
  EXPECT_EQ(out().find('\033'), std::string::npos);
}

TEST_F(Program, AnInterruptEndsCleanlyWith130) {
  const std::string endless = "--integrator forward-euler:step=1e-8 --out result";
  EXPECT_EQ(run("run rod.toml " + endless, "timeout --preserve-status --signal=INT 0.5"), 130) << err();
  EXPECT_EQ(nlohmann::json::parse(folder_.read("result/run.json")).at("outcome").at("status"), "interrupted");
  EXPECT_FALSE(folder_.has("result/final.csv"));
  folder_.write("result/histories.csv", "of the benchmark before");
  EXPECT_EQ(run("bench rod.toml --reference none " + endless, "timeout --preserve-status --signal=INT 0.5"),
            130);
  EXPECT_EQ(nlohmann::json::parse(folder_.read("result/results.json")).at("interrupted"), true);
  EXPECT_FALSE(folder_.has("result/histories.csv"));
}

TEST_F(Program, ShellsAndBatchSystemsEndItAsCleanly) {
  const std::string endless = "run rod.toml --integrator forward-euler:step=1e-8 --out ";
  for (const auto& [signal, code] : {std::pair{"TERM", 143}, {"HUP", 129}, {"XCPU", 152}}) {
    EXPECT_EQ(run(endless + signal, fmt::format("timeout --preserve-status --signal={} 0.5", signal)), code)
        << signal << err();
    const auto index = nlohmann::json::parse(folder_.read(fmt::format("{}/run.json", signal)));
    EXPECT_EQ(index.at("outcome").at("status"), "interrupted") << signal;
  }
}

TEST_F(Program, HelpShowsExamples) {
  EXPECT_EQ(run("--help"), 0);
  for (const std::string command :
       {"run", "bench", "info", "stability", "pack", "report", "completion", "list"}) {
    EXPECT_NE(folder_.read("stdout.txt").find(command), std::string::npos);
  }
  for (const std::string command :
       {"run", "bench", "info", "stability", "pack", "report", "completion", "list"}) {
    EXPECT_EQ(run(command + " --help"), 0);
    EXPECT_NE(out().find("superstep " + command), std::string::npos) << out();
  }
  EXPECT_EQ(run("--version"), 0);
  EXPECT_TRUE(out().starts_with("superstep 0."));
}

TEST_F(Program, ListNamesEveryIntegratorWithItsKeys) {
  folder_.write("note.txt", "");
  ASSERT_EQ(run("list --json"), 0);
  const auto json = nlohmann::json::parse(out());
  std::vector<std::string> names;
  for (const auto& entry : json.at("integrators")) names.push_back(entry.at("name"));
  EXPECT_NE(std::find(names.begin(), names.end(), "cvode"), names.end());
  EXPECT_NE(std::find(names.begin(), names.end(), "sts"), names.end());
  EXPECT_TRUE(json.at("cases").empty());
  for (const auto& entry : json.at("integrators"))
    for (const auto& key : entry.at("keys"))
      if (key.at("name") == "rtol") {
        EXPECT_NE(key.at("meaning").get<std::string>().find(
                      "error allowed at every output time (rms), relative to the span of the field"),
                  std::string::npos)
            << entry.at("name") << ": a tolerance means the same everywhere";
      }
}

}  // namespace
}  // namespace superstep
