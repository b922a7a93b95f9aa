/// The list of keys says what the readers ask for, and whatever breaks it is refused in one line.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <tuple>

#include "bad_inputs.hpp"
#include "case/press/press.hpp"
#include "case/scene.hpp"
#include "core/text/toml.hpp"
#include "program.hpp"
#include "whole_cases.hpp"

namespace superstep {
namespace {

using test::BadInput;
using test::WholeCase;

class Catalogue : public testing::Test {
 protected:
  test::CaseFolder folder_;
  std::vector<WholeCase> cases_ = test::whole_cases(folder_);

  std::string write(const WholeCase& one, const std::string& text) {
    return folder_.write(one.name + ".toml", text);
  }
  /// Keys that the readers asked for.
  std::vector<std::string> asked_of(const WholeCase& one) {
    TomlTable root = TomlTable::parse_file(write(one, test::toml_text(one.tree).text));
    if (one.scene == CaseKey::press)  // by its own reader: all others ask for [dynamics] as well
      (void)load_press(root);
    else
      (void)load_scene(root);
    return root.asked_keys();
  }
};

std::map<std::string, unsigned> scenes_by_place() {
  std::map<std::string, unsigned> scenes;
  for (const auto& key : case_keys()) scenes[key.place] |= key.scenes;
  return scenes;
}

const CaseKey* find_key(const std::string& place, CaseKey::Scene scene) {
  for (const auto& key : case_keys())
    if (key.place == place && (key.scenes & scene)) return &key;
  return nullptr;
}

TEST_F(Catalogue, TheListHoldsWhatTheReadersAskForAndNothingElse) {
  std::map<std::string, unsigned> asked;
  for (const auto& one : cases_)
    for (const auto& place : asked_of(one)) asked[test::general_place(place)] |= one.scene;
  const auto listed = scenes_by_place();
  for (const auto& [place, scenes] : listed)
    EXPECT_EQ(scenes & ~asked[place], 0u) << place << " is listed, and no reader asks for it";
  // In a case with a network the readers ask for the tables of a packing in order to refuse them.
  for (const auto& [place, scenes] : asked)
    EXPECT_TRUE(listed.contains(place)) << place << " is read and not listed";
}

TEST_F(Catalogue, TheCasesHoldEveryKey) {
  std::map<std::string, unsigned> present;
  for (const auto& one : cases_)
    for (const auto& [place, value] : test::places_of(one.tree)) {
      const std::string general = test::general_place(place);
      present[general] |= one.scene;
      EXPECT_NE(find_key(general, one.scene), nullptr) << place << " of " << one.name;
    }
  // What is common to all kinds of cases need not stand in every one of them.
  for (const auto& [place, scenes] : scenes_by_place())
    EXPECT_NE(present[place] & scenes, 0u) << place << " stands in no case";
}

TEST_F(Catalogue, TheTableOfTheDocumentationIsTheList) {
  std::ifstream stream(SUPERSTEP_SOURCE_DIR "/cases/KEYS.md");
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  const auto said = test::call_program({"list", "--keys"});
  EXPECT_EQ(said.code, 0);
  EXPECT_NE(text.find(said.out), std::string::npos)
      << "write the table of cases/KEYS.md anew: superstep list --keys";
}

TEST_F(Catalogue, RightCasesRun) {
  for (const auto& one : cases_) {
    const auto said = test::call_program(
        {"run", write(one, test::toml_text(one.tree).text), "--quiet", "--out", folder_.file("out")});
    EXPECT_EQ(said.code, 0) << one.name << ": " << said.out << said.err;
  }
}

/// Counts what is refused, and says what is not.
class Judge {
 public:
  Judge(const WholeCase& one, std::string file) : one_(one), file_(std::move(file)) {}

  void judge(const BadInput& bad, const CaseKey& key, const test::TomlText& toml, const test::Said& said) {
    ++count_;
    const std::string about = fmt::format("{}: {} ({}): {} = {} {}", one_.name, bad.edit.place, bad.what,
                                          bad.edit.key, bad.edit.value, bad.edit.more);
    EXPECT_EQ(said.code, 3) << about << "\n" << said.err << said.out;
    EXPECT_EQ(std::count(said.err.begin(), said.err.end(), '\n'), 1) << about << "\n" << said.err;
    EXPECT_EQ(said.out, "") << about;
    const auto at = [&](int line) {
      return said.err.starts_with(fmt::format("superstep: error: {}:{}:", file_, line));
    };
    const int line = toml.line.at(bad.edit.place);
    EXPECT_TRUE(at(line) || (!bad.edit.more.empty() && at(toml.line_of_more)))
        << about << "\n"
        << said.err << "instead of line " << line;
    const bool is_toml = said.err.find("not valid TOML") != std::string::npos;
    EXPECT_TRUE(is_toml || said.err.find(key.name()) != std::string::npos) << about << "\n" << said.err;
  }
  [[nodiscard]] int count() const noexcept { return count_; }

 private:
  const WholeCase& one_;
  std::string file_;
  int count_ = 0;
};

TEST_F(Catalogue, EveryKeyRefusesWhatItIsNot) {
  int count = 0;
  // A key once for each kind of case and of value: a table, a text, a number.
  std::set<std::tuple<const CaseKey*, CaseKey::Scene, std::string>> done;
  for (const auto& one : cases_) {
    const std::string file = write(one, "");
    const auto before = test::files_below(folder_.file("."));
    Judge judge(one, file);
    for (const auto& [place, value] : test::places_of(one.tree)) {
      const CaseKey* key = find_key(test::general_place(place), one.scene);
      if (!key || !done.insert({key, one.scene, value.type_name()}).second) continue;
      for (const auto& bad : test::bad_inputs(*key, place, value)) {
        const auto toml = test::toml_text(one.tree, bad.edit);
        (void)write(one, toml.text);
        judge.judge(bad, *key, toml, test::call_program({"run", file, "--out", folder_.file("out")}));
      }
    }
    EXPECT_EQ(test::files_below(folder_.file(".")), before) << "something was written";
    count += judge.count();
  }
  EXPECT_GT(count, 500);
  RecordProperty("bad_inputs", count);
}

}  // namespace
}  // namespace superstep
