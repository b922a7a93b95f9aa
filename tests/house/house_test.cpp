/// The house as ARCHITECTURE.md and CONTRIBUTING.md promise it: rooms in order, small files, links that lead
/// somewhere.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path root = SUPERSTEP_SOURCE_DIR;

// Data flows from left to right.
const std::vector<std::string> rooms = {
    "lib/core",    "lib/parallel",  "lib/packing",   "lib/contact",  "lib/network",
    "lib/rhs",     "lib/dynamics",  "lib/case",      "integrators",  "lib/results",
    "bench/host",  "bench/measure", "bench/harness", "bench/output", "bench/lab",
    "bench/press", "reports",       "bench/app",     "lib/python",
};

std::string content_of(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

bool belongs_to_project(const fs::path& path) {
  const std::string text = fs::relative(path, root).generic_string();
  return !text.starts_with("build") && !text.starts_with(".") &&
         text.find("node_modules") == std::string::npos;
}

/// Files of the project, as paths relative to its folder.
std::vector<std::string> files(const std::vector<std::string>& extensions) {
  std::vector<std::string> out;
  for (auto entry = fs::recursive_directory_iterator(root); entry != fs::recursive_directory_iterator();
       ++entry) {
    if (!belongs_to_project(entry->path())) {
      entry.disable_recursion_pending();
      continue;
    }
    const auto extension = entry->path().extension().string();
    if (entry->is_regular_file() &&
        std::find(extensions.begin(), extensions.end(), extension) != extensions.end())
      out.push_back(fs::relative(entry->path(), root).generic_string());
  }
  EXPECT_FALSE(out.empty());
  return out;
}

std::size_t room_of(const std::string& file) {
  for (std::size_t k = 0; k < rooms.size(); ++k)
    if (file.starts_with(rooms[k] + "/")) return k;
  return rooms.size();
}

std::vector<std::string> includes_of(const std::string& file) {
  static const std::regex line("#include \"([^\"]+)\"");
  const std::string text = content_of(root / file);
  std::vector<std::string> out;
  for (std::sregex_iterator hit(text.begin(), text.end(), line), end; hit != end; ++hit) {
    const std::string name = (*hit)[1];
    out.push_back(fs::exists(root / name) ? name : "lib/" + name);
  }
  return out;
}

TEST(TheHouse, NoFileIncludesFromARoomToItsRight) {
  std::size_t checked = 0;
  for (const auto& file : files({".hpp", ".cpp"})) {
    const std::size_t room = room_of(file);
    if (room == rooms.size()) continue;
    for (const auto& included : includes_of(file)) {
      const std::size_t other = room_of(included);
      if (other == rooms.size()) continue;
      EXPECT_LE(other, room) << file << " includes " << included;
      ++checked;
    }
  }
  EXPECT_GT(checked, 500U);
}

TEST(TheHouse, ResultsNeedCoreAlone) {
  for (const auto& file : files({".hpp", ".cpp"}))
    if (file.starts_with("lib/results/")) {
      for (const auto& included : includes_of(file))
        EXPECT_TRUE(included.starts_with("lib/results/") || included.starts_with("lib/core/"))
            << file << " includes " << included;
    }
}

TEST(TheHouse, DetailStaysInTheFolderOfTheIntegrators) {
  for (const auto& file : files({".hpp", ".cpp"}))
    if (!file.starts_with("integrators/") && !file.starts_with("tests/")) {
      for (const auto& included : includes_of(file))
        EXPECT_FALSE(included.starts_with("integrators/detail/")) << file << " includes " << included;
    }
}

TEST(TheHouse, SundialsStaysInTheFolderOfTheIntegrators) {
  std::size_t knowing = 0;
  for (const auto& file : files({".hpp", ".cpp"})) {
    if (room_of(file) == rooms.size() || content_of(root / file).find("#include <cvode") == std::string::npos)
      continue;
    EXPECT_TRUE(file.starts_with("integrators/")) << file;
    ++knowing;
  }
  EXPECT_GT(knowing, 0U);
}

TEST(TheHouse, NoSourceFileIsLongerThan350Lines) {
  for (const auto& file : files({".hpp", ".cpp"})) {
    const std::string text = content_of(root / file);
    EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 350) << file;
  }
}

TEST(TheHouse, NoFolderHoldsMoreThan25SourceFiles) {
  std::map<std::string, int> count;
  for (const auto& file : files({".hpp", ".cpp"})) ++count[fs::path(file).parent_path().generic_string()];
  for (const auto& [folder, number] : count) EXPECT_LE(number, 25) << folder;
}

// Two types of one name in one namespace: where a program holds both, the linker keeps one destructor for
// either.
TEST(TheHouse, NoNameStandsForTwoTypes) {
  static const std::regex line(
      R"(^(?:namespace ([\w:]+) \{|(\})  // namespace.*|(?:struct|class|enum class|enum) (?:\[\[\w+\]\] )?(\w+)\b(?![;<]).*)$)");
  std::map<std::string, std::string> first;
  for (const auto& file : files({".hpp"})) {
    std::ifstream stream(root / file);
    std::vector<std::string> space;
    std::smatch hit;
    for (std::string text; std::getline(stream, text);) {
      if (!std::regex_match(text, hit, line)) continue;
      if (hit[1].matched) space.push_back(hit[1]);
      if (hit[2].matched && !space.empty()) space.pop_back();
      if (!hit[3].matched) continue;
      const std::string name = (space.empty() ? "" : space.back()) + "::" + hit[3].str();
      const auto [place, is_new] = first.emplace(name, file);
      EXPECT_TRUE(is_new) << name << " of " << place->second << " and " << file;
    }
  }
  EXPECT_GT(first.size(), 100u);
}

TEST(TheHouse, LinksAndPicturesOfEveryDocumentLeadSomewhere) {
  static const std::regex link("\\]\\(([^)#][^)]*)\\)");
  std::size_t checked = 0;
  for (const auto& file : files({".md"})) {
    const std::string text = content_of(root / file);
    for (std::sregex_iterator hit(text.begin(), text.end(), link), end; hit != end; ++hit) {
      std::string target = (*hit)[1];
      if (target.starts_with("http")) continue;
      target = target.substr(0, target.find('#'));
      EXPECT_TRUE(fs::exists((root / file).parent_path() / target)) << file << " points to " << target;
      ++checked;
    }
  }
  EXPECT_GT(checked, 5U);
}

TEST(TheHouse, EveryRoomHasAReadme) {
  for (const auto& room : rooms) {
    const fs::path own = root / room / "README.md", parent = (root / room).parent_path() / "README.md";
    EXPECT_TRUE(fs::exists(own) || (room.starts_with("bench/") && fs::exists(parent))) << room;
  }
}

}  // namespace
