/// Every option of every command refuses what it is not, in one line, and nothing is written.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "bench/app/cli/command_entry.hpp"
#include "integrators/registry.hpp"
#include "program.hpp"
#include "support/temporary_case.hpp"

namespace superstep {
namespace {

using Line = std::vector<std::string>;

class CommandLine : public testing::Test {
 protected:
  void SetUp() override {
    case_ = test::write_rod(folder_, test::Rod{.nodes = 5});
    before_ = test::files_below(folder_.file("."));
  }
  /// A line that the command would take.
  [[nodiscard]] Line line_of(const std::string& command) const {
    if (command == "pack")
      return {"pack",
              "--container",
              "box",
              "--width",
              "2",
              "--depth",
              "2",
              "--height",
              "2",
              "--sizes",
              "uniform:min=0.5,max=0.6",
              "--relative-density",
              "0.4",
              "--output",
              folder_.file("packing.csv")};
    if (command == "gate") return {"gate", folder_.file("none"), "--baseline", folder_.file("none")};
    if (command == "compare") return {"compare", folder_.file("none"), folder_.file("none")};
    if (command == "report") return {"report", folder_.file("none")};
    if (command == "completion") return {"completion"};
    if (command == "list") return {"list"};
    return {command, case_};
  }
  void refuse(const Line& line, const std::string& names) {
    ++count_;
    const auto said = test::call_program(line);
    const std::string about = fmt::format("superstep {}\n{}{}", fmt::join(line, " "), said.err, said.out);
    EXPECT_TRUE(said.code == 2 || said.code == 3) << said.code << ": " << about;
    EXPECT_EQ(std::count(said.err.begin(), said.err.end(), '\n'), 1) << about;
    EXPECT_EQ(said.out, "") << about;
    EXPECT_NE(said.err.find(names), std::string::npos) << names << " is not named: " << about;
  }
  void TearDown() override {
    EXPECT_EQ(test::files_below(folder_.file(".")), before_) << "something was written";
  }

  test::CaseFolder folder_;
  std::string case_;
  std::vector<std::string> before_;
  int count_ = 0;
};

/// Values that an option must refuse, by how the help calls what it takes.
Line bad_values(const std::string& type) {
  const Line numbers = {"abc",  "nan", "inf", "-1", "0",    "1e999", "1,5",
                        "0x10", " ",   "1 2", "--", "\xff", "1_"};
  Line integers = numbers;
  integers.insert(integers.end(), {"1.5", "99999999999999999999", "1e3"});
  const std::map<std::string, Line> bad = {
      {"N", integers},
      {"SWEEPS", numbers},
      {"X", numbers},
      {"T", numbers},
      {"L", numbers},
      {"SECONDS", numbers},
      {"SPEC",
       {"nobody", ":", "rkc:", "rkc:rtol", "rkc:rtol=", "rkc:=1", "rkc:rtol=x", "rkc:rtol=nan", "rkc:rtol=-1",
        "rkc:rtol=1e-3,rtol=1e-3", "rkc:zzz=1", "rkc:rtol=1e-3,", "\xff", std::string(100'000, 'x')}},
      {"SHAPE", {"sphere", "1", "\xff"}},
      {"UNIT", {"inch", "1", "\xff"}},
      {"WHEN", {"often", "1", "\xff"}},
      {"SIZES",
       {"gauss:min=1,max=2", "uniform", "uniform:", "uniform:min=1", "uniform:min=2,max=1",
        "uniform:min=0,max=1", "uniform:min=nan,max=1", "lognormal:min=1,max=2", "list:", "list:1,,2",
        "list:-1", "list:x", "\xff"}},
      {"FILE", {"/nowhere/at/all", "/dev/zero", "/dev"}},
      {"SET", {"fastest", "/nowhere/at/all"}},
      {"K", numbers},
      {"RHO", numbers},
      {"C", numbers},
      {"AXIS", {"w", "xy", "1", "\xff"}},
      {"LAW", {"hertzian", "1", "\xff"}},
      {"STYLE", {"imperial", "1", "\xff"}},
      {"AXES", {"w", "1", "\xff"}},
      {"FOLDER", {"/dev/null", "/proc/nowhere"}},
      {"DIR", {}}};
  const auto found = bad.find(type);
  EXPECT_NE(found, bad.end()) << "an option takes " << type << ": say here what it refuses";
  return found == bad.end() ? Line{} : found->second;
}

TEST_F(CommandLine, EveryOptionRefusesWhatItIsNot) {
  for (const auto& entry : command_entries()) {
    std::vector<OptionEntry> options = entry.options;
    for (const char* common : {"--threads", "--color"})
      options.push_back({common, &Arguments::threads, "", std::string(common) == "--color" ? "WHEN" : "N"});
    for (const auto& option : options) {
      const std::string name = option.name.substr(option.name.rfind(',') + 1);
      const auto with = [&](const Line& more) {
        Line line = line_of(entry.name);
        if (const auto own = std::find(line.begin(), line.end(), name); own != line.end())
          line.erase(own, own + 2);
        line.insert(line.end(), more.begin(), more.end());
        return line;
      };
      refuse(with({name + "q"}), name + "q");
      if (std::holds_alternative<bool Arguments::*>(option.target)) {
        refuse(with({name + "=maybe"}), name);
        continue;
      }
      const bool writes = name == "--output";  // any name will do
      refuse(with({name}), name);
      refuse(with({name, ""}), name);
      refuse(with({name + "="}), name);
      for (const auto& value : writes ? Line{} : bad_values(option.type)) {
        // "0" is a right seed.
        if (value == "0" && name == "--seed") continue;
        refuse(with({name, value}), "");
      }
    }
  }
  EXPECT_GT(count_, 300);
}

TEST_F(CommandLine, EveryKeyOfEveryMethodRefusesWhatItIsNot) {
  for (const auto& method : integrators())
    for (const auto& key : method.keys) {
      Line bad = {"", "nan", "inf", "zzz", "1e999", "\xff"};
      if (key.type != OptionKey::Type::word) {
        if (key.min > -1e300) bad.push_back(fmt::format("{}", key.min - 1));
        if (key.min_open) bad.push_back(fmt::format("{}", key.min));
        if (key.max < 1e300) bad.push_back(fmt::format("{}", key.max + 1));
        if (key.max_open) bad.push_back(fmt::format("{}", key.max));
      }
      if (key.type == OptionKey::Type::integer) bad.insert(bad.end(), {"1.5", "99999999999999999999"});
      for (const auto& value : bad)
        refuse({"run", case_, "--integrator", fmt::format("{}:{}={}", method.name, key.name, value)},
               key.name);
    }
  EXPECT_GT(count_, 300);
}

TEST_F(CommandLine, WhatIsMissingIsNamed) {
  refuse({"run", case_, "--integrator="}, "--integrator= is followed by nothing");
  refuse({"init"}, "init: a packing file is missing");
  refuse({"info"}, "info: a case, packing or network file is missing");
  refuse({"report"}, "report: a folder of results is missing");
  refuse({"run"}, "run: a case file is missing");
}

TEST_F(CommandLine, OptionsThatWouldBeIgnoredAreRefused) {
  const std::string press = SUPERSTEP_SOURCE_DIR "/cases/sintering_two_particles.toml";
  const auto packing = folder_.write("p.csv", "id,x,y,z,radius\n1,0,0,0.01,0.0102\n2,0,0,0.03,0.0102\n");
  const auto network = folder_.write("e.csv", "i,j,conductance\n1,2,3\n2,3,4\n");
  before_ = test::files_below(folder_.file("."));
  for (const Line& option : {Line{"--verify"}, {"--max-work", "9"}}) {
    Line line = {"run", press};
    line.insert(line.end(), option.begin(), option.end());
    refuse(line, "run: " + option[0] + " is for networks that stay as they are");
  }
  refuse({"bench", press, "--max-work", "9"}, "bench: --max-work is for networks");
  refuse({"info", press, "--matrix", folder_.file("system")}, "info: --matrix is for networks");
  for (const char* option : {"--conductivity", "--density", "--specific-heat", "--axis", "--neck",
                             "--length-unit", "--units", "--periodic"}) {
    const std::string name = option, value = name == "--axis"          ? "z"
                                             : name == "--neck"        ? "hertz"
                                             : name == "--length-unit" ? "mm"
                                             : name == "--units"       ? "si"
                                             : name == "--periodic"    ? "xy"
                                                                       : "85";
    for (const auto& file : {case_, press, network})
      refuse({"info", file, name, value}, name + " is about a packing file");
  }
  for (const Line& option :
       {Line{"--density", "5910"}, {"--specific-heat", "1"}, {"--axis", "z"}, {"--neck", "hertz"}})
    refuse({"info", packing, option[0], option[1]}, "with --conductivity");
  for (const Line& option : {Line{"--integrator", "rkc"},
                             {"--repetitions", "2"},
                             {"--reference", "cvode"},
                             {"--time-limit", "1"},
                             {"--max-work", "9"},
                             {"--no-cache"},
                             {"--instructions"}}) {
    Line line = {"bench", press, "--press-table"};
    line.insert(line.end(), option.begin(), option.end());
    refuse(line, option[0] + " does not go with --press-table");
  }
  for (const char* option : {"--instructions", "--press-table", "--json"}) {
    refuse({"bench", case_, "--work-precision", option}, "does not go with --work-precision");
    refuse({"bench", "--corpus", "quick", option}, "does not go with --corpus");
  }
  for (const Line& option :
       {Line{"--seed", "2"}, {"--container", "box"}, {"--height", "1"}, {"--sizes", "list:1"}})
    refuse({"pack", "--lattice", "8", "--spacing", "1", "--diameter", "1", "-o", folder_.file("l.csv"),
            option[0], option[1]},
           option[0] + " belongs to a container");
  refuse({"init", packing, "-o", folder_.file("c.toml"), "--json"}, "--json");
  refuse({"completion", "bash", "--json"}, "--json");
}

TEST_F(CommandLine, AnOptionWithoutItsValueSaysWhatThatIs) {
  refuse({"run", case_, "--tolerance"}, "--tolerance needs a value: --tolerance X (error allowed");
  refuse({"run", case_, "--out", "--quiet"}, "--out needs a value: --out DIR (folder for");
  refuse({"run", case_, "--tolerance", "1e-3", "--tolerance", "1e-4"}, "--tolerance stands more than once");
}

TEST_F(CommandLine, ACaseNeedsNoOtherToStartFrom) {
  refuse({"init", case_, "-o", folder_.file("new.toml")}, "is a case already");
}

TEST_F(CommandLine, UnitsThatTheLineStatesTwiceAreItsOwnFault) {
  const auto packing = folder_.write("p.csv", "id,x,y,z,radius\n1,0,0,0.01,0.0102\n2,0,0,0.03,0.0102\n");
  before_ = test::files_below(folder_.file("."));
  refuse({"info", packing, "--units", "si", "--length-unit", "mm"},
         "the unit of length is mm, and beside it stands units si; leave one of the two out");
}

TEST_F(CommandLine, ALatticeOfSpheresThatHoldOneAnotherIsRefused) {
  refuse({"pack", "--lattice", "100", "--spacing", "1", "--diameter", "3", "-o", folder_.file("l.csv")},
         "--diameter '3' is not valid; it must be less than twice the spacing");
  const auto path = folder_.write("l.toml",
                                  "t_end = 1.0\n[packing]\ngenerator = \"lattice\"\ncells = [2, 2, "
                                  "2]\nspacing = 1.0\ndiameter = 3.0\n[thermal]\n");
  before_ = test::files_below(folder_.file("."));
  refuse({"info", path}, "l.toml:6: key 'packing.diameter'");
}

TEST_F(CommandLine, AMethodIsNamedOnce) {
  const auto twice =
      test::write_rod(folder_, test::Rod{.nodes = 5, .bench = "integrators = [\"rkc\", \"rkc\"]\n"}, "twice");
  before_ = test::files_below(folder_.file("."));
  for (const char* command : {"run", "bench"})
    refuse({command, case_, "--integrator", "sts:n=5,nu=0.1", "sts:nu=0.1,n=5"},
           "'sts:nu=0.1,n=5' stands twice");
  refuse({"bench", case_, "--work-precision", "--integrator", "rkc", "rkc"}, "'rkc' stands twice");
  refuse({"bench", twice}, "key 'bench.integrators'");
}

TEST_F(CommandLine, CommandsRefuseWhatTheyDoNotTake) {
  refuse({}, "command");
  refuse({"zzz"}, "zzz");
  refuse({"--zzz"}, "--zzz");
  for (const auto& entry : command_entries()) {
    refuse({entry.name, "--zzz"}, "--zzz");
    refuse({entry.name + "q"}, entry.name + "q");
    Line line = line_of(entry.name);
    line.insert(line.end(), {"one", "too", "many"});
    refuse(line, "");
    if (!entry.positional.empty()) refuse({entry.name}, entry.name);
    if (entry.positional.empty()) continue;
    for (const char* file : {"", "/nowhere/at/all", "/dev/zero", "/dev/null", "/proc/self/mem", "/"})
      refuse({entry.name, file}, "");
  }
}

}  // namespace
}  // namespace superstep
