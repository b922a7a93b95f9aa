/// What documents and help texts show works as it is printed: commands are understood, cases load and run.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

#include "bench/app/cli/cli.hpp"
#include "bench/app/cli/command_entry.hpp"
#include "bench/app/cli/run_program.hpp"
#include "bench/measure/run_one.hpp"
#include "case/scene.hpp"
#include "core/error.hpp"
#include "support/temporary_case.hpp"

namespace superstep {
namespace {

namespace fs = std::filesystem;

const fs::path root = SUPERSTEP_SOURCE_DIR;

std::vector<fs::path> documents() {
  std::vector<fs::path> out;
  for (const char* folder : {"", "bench", "cases", "integrators", "lib", "reports", "reports/baselines",
                             "reports/records", "tests"})
    for (const auto& entry : fs::directory_iterator(root / folder))
      if (entry.path().extension() == ".md") out.push_back(entry.path());
  return out;
}

/// Fenced blocks of a language.
std::vector<std::string> blocks(const fs::path& file, const std::string& language) {
  std::ifstream stream(file);
  std::vector<std::string> out;
  bool inside = false;
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("```")) {
      inside = !inside && line == "```" + language;
      if (inside) out.emplace_back();
    } else if (inside) {
      out.back() += line + "\n";
    }
  }
  return out;
}

/// Every `superstep ...` of a shell text, one command a line, without what a shell does with it.
std::vector<std::string> commands(std::string text) {
  text = std::regex_replace(text, std::regex("\\\\\n"), " ");
  std::vector<std::string> out;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    line = line.substr(0, line.find(" #"));
    line = line.substr(0, line.find("   ("));
    if (line.find('$') != std::string::npos || line.find("<(") != std::string::npos) continue;
    line = std::regex_replace(line, std::regex("&&|\\|"), "\n");
    std::istringstream parts(line);
    for (std::string part; std::getline(parts, part);) {
      static const std::regex program("^ *(build/release/bin/)?superstep ");
      std::smatch hit;
      if (std::regex_search(part, hit, program)) out.push_back(hit.suffix());
    }
  }
  return out;
}

void expect_understood(const std::string& command, const std::string& where) {
  std::istringstream words(command);
  const std::vector<std::string> arguments{std::istream_iterator<std::string>(words), {}};
  try {
    (void)parse_command_line(arguments);
  } catch (const UsageError& error) {
    ADD_FAILURE() << where << ": superstep " << command << ": " << error.what();
  }
}

TEST(Documents, EveryCommandIsUnderstood) {
  std::size_t seen = 0;
  for (const auto& file : documents())
    for (const auto& block : blocks(file, "sh"))
      for (const auto& command : commands(block)) {
        expect_understood(command, file.string());
        ++seen;
      }
  EXPECT_GT(seen, 15U);
}

TEST(Documents, EveryExampleOfTheHelpIsUnderstood) {
  std::size_t seen = 0;
  for (const auto& entry : command_entries()) {
    const std::string& name = entry.name;
    const auto help = parse_command_line({name, "--help"});
    for (const auto& command : commands(std::get<ShowText>(help).text)) {
      expect_understood(command, name);
      ++seen;
    }
  }
  EXPECT_GT(seen, 12U);
}

bool is_taken(const std::vector<std::string>& line) {
  try {
    (void)parse_command_line(line);
    return true;
  } catch (const UsageError&) {
    return false;
  }
}

// As many names as the usage of a command shows are taken; one fewer and one more are not.
TEST(Documents, UsageSaysHowManyNamesACommandTakes) {
  constexpr std::size_t any = 99;
  struct Shape {
    std::string command, usage;
    std::vector<std::string> options;
    std::size_t least, most;
  };
  const std::vector<std::string> pack = {"-o", "f", "--lattice", "8", "--spacing", "1", "--diameter", "1"};
  const Shape shapes[] = {{"run", " CASE", {}, 1, 1},
                          {"bench", " [CASE...]", {}, 1, any},
                          {"bench", " [CASE...]", {"--corpus"}, 0, 0},
                          {"info", " CASE", {}, 1, 1},
                          {"init", " FILE", {"-o", "case.toml"}, 1, 1},
                          {"stability", " CASE", {}, 1, 1},
                          {"gate", " RESULTS", {"--baseline", "file"}, 1, 1},
                          {"compare", " RESULTS RESULTS", {}, 2, 2},
                          {"fit", " CORPUS.csv...", {}, 1, any},
                          {"report", " DIR", {}, 1, 1},
                          {"completion", " SHELL", {}, 1, 1},
                          {"list", "", {}, 0, 0},
                          {"pack", "", pack, 0, 0}};
  for (const auto& shape : shapes) {
    const std::string help = std::get<ShowText>(parse_command_line({shape.command, "--help"})).text;
    const std::string usage = fmt::format("Usage: superstep {} [OPTIONS]{}\n", shape.command, shape.usage);
    EXPECT_NE(help.find(usage), std::string::npos) << help;
    const std::string names = help.substr(0, help.find("\nOptions:"));
    const bool listed_as_many = names.find(" ...  ") != std::string::npos;
    EXPECT_EQ(listed_as_many, shape.usage.find("...") != std::string::npos) << names;
    for (std::size_t n = 0; n <= 3; ++n) {
      std::vector<std::string> line{shape.command};
      line.insert(line.end(), n, "bash");
      line.insert(line.end(), shape.options.begin(), shape.options.end());
      EXPECT_EQ(is_taken(line), n >= shape.least && n <= shape.most) << usage << n;
    }
  }
}

/// 4 x 4 x 8 spheres of 1 mm that overlap by 5 %.
std::string lattice() {
  std::string out = "id,x,y,z,radius\n";
  for (int k = 0; k < 128; ++k)
    out += fmt::format("{},{},{},{},5e-4\n", k, 9.5e-4 * (k % 4), 9.5e-4 * (k / 4 % 4), 9.5e-4 * (k / 16));
  return out;
}

int quietly(const std::vector<std::string>& arguments) {
  testing::internal::CaptureStdout();
  const int code = run_program(arguments);
  testing::internal::GetCapturedStdout();
  return code;
}

/// my_packing.csv as the README makes it.
void pack_as_shown(const test::CaseFolder& folder) {
  for (const auto& block : blocks(root / "README.md", "sh"))
    for (const auto& command : commands(block)) {
      if (!command.starts_with("pack ")) continue;
      std::istringstream words(command + " --quiet");
      std::vector<std::string> arguments{std::istream_iterator<std::string>(words), {}};
      std::replace(arguments.begin(), arguments.end(), std::string("my_packing.csv"),
                   folder.file("my_packing.csv"));
      ASSERT_EQ(quietly(arguments), 0) << command;
    }
}

/// A press leaves pressed.csv and its necks for the cases behind it.
void run_press_as_shown(const test::CaseFolder& folder, const std::string& path) {
  pack_as_shown(folder);
  EXPECT_EQ(quietly({"run", path, "--quiet", "--export-packing", folder.file("pressed.csv"), "--out",
                     folder.file("out")}),
            0)
      << path;
}

TEST(Documents, EveryCaseTheyShowRunsAsItStands) {
  std::size_t seen = 0, presses = 0;
  for (const auto& file : documents()) {
    const test::CaseFolder folder;
    folder.write("my_packing.csv", lattice());
    folder.write("nodes.csv", "id,capacity,source,initial,fixed\n1,1,0,0,\n2,1,0,0,5\n");
    folder.write("edges.csv", "i,j,conductance\n1,2,1\n");
    for (const auto& block : blocks(file, "toml")) {
      if (block.find("t_end") == std::string::npos) continue;
      const std::string path = folder.write("my_case.toml", block);
      ++seen;
      if (block.find("[dynamics") != std::string::npos) {
        run_press_as_shown(folder, path);
        ++presses;
        continue;
      }
      const Scene scene = load_scene(path);
      const RunResult run = run_one(scene, "auto:rtol=1e-2", {});
      EXPECT_TRUE(run.outcome.ok()) << file << ": " << run.outcome.reason << "\n" << block;
    }
  }
  EXPECT_GE(seen, 5U);
  EXPECT_GE(presses, 1U);
}

}  // namespace
}  // namespace superstep
