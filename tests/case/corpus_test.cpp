/// The corpus says of itself what is true.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <utility>

#include "case/corpus/corpus_tags.hpp"
#include "case/scene.hpp"
#include "core/error.hpp"
#include "core/text/text_file.hpp"

namespace superstep {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> files() {
  std::vector<std::string> out;
  for (const auto& entry : fs::directory_iterator(fs::path(SUPERSTEP_SOURCE_DIR) / "cases" / "corpus"))
    if (entry.path().extension() == ".toml") out.push_back(entry.path().string());
  return out;
}

CorpusTags tags_of(const std::string& file) {
  TomlTable root = TomlTable::parse_file(file);
  const auto tags = read_corpus_tags(root);
  EXPECT_TRUE(tags) << file;
  return tags.value_or(CorpusTags{});
}

TEST(Corpus, HasEveryClassAndSetsOfTheRightSize) {
  std::map<std::string, int> sets, classes;
  for (const auto& file : files()) {
    const auto tags = tags_of(file);
    ++classes[tags.scene_class];
    for (const char* set : corpus_sets)
      if (belongs_to(tags, set)) ++sets[set];
  }
  EXPECT_GE(sets["quick"], 12);
  EXPECT_LE(sets["quick"], 15);
  EXPECT_GE(sets["large"], 40);
  EXPECT_LT(sets["standard"], sets["large"]);
  for (const char* name : corpus_classes) EXPECT_GT(classes[name], 0) << name;
}

TEST(Corpus, IsAsLargeAsItsPagesSay) {
  std::map<std::string, std::pair<double, double>> sizes;  // smallest and largest of a set
  for (const auto& file : files()) {
    const auto tags = tags_of(file);
    for (const char* set : corpus_sets) {
      if (!belongs_to(tags, set)) continue;
      auto& [least, most] = sizes.try_emplace(set, tags.unknowns, tags.unknowns).first->second;
      least = std::min(least, tags.unknowns);
      most = std::max(most, tags.unknowns);
    }
  }
  const auto says = [](const char* page, const std::string& words) {
    const auto text = read_text_file((fs::path(SUPERSTEP_SOURCE_DIR) / "cases" / page).string());
    EXPECT_NE(text.find(words), std::string::npos) << page << ": " << words;
  };
  const auto spaced = [](double count) {  // "2 337"
    std::string digits = fmt::format("{:.0f}", count);
    for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, " ");
    return digits;
  };
  says("corpus/README.md", fmt::format("scenes up to {} unknowns", spaced(sizes["quick"].second)));
  says("README.md",
       fmt::format("{} to {} unknowns", spaced(sizes["large"].first), spaced(sizes["large"].second)));
}

/// Loading checks the hash of a generated network, too.
TEST(Corpus, StatesSizeAndStiffnessOfItsScenes) {
  constexpr double most_unknowns = 50'000;  // larger ones are loaded where they are measured
  for (const auto& file : files()) {
    const auto tags = tags_of(file);
    if (tags.unknowns > most_unknowns) continue;
    const Scene scene = load_scene(file);
    EXPECT_EQ(static_cast<double>(scene.rhs->size()), tags.unknowns) << file;
    // Stated with two digits.
    EXPECT_NEAR(scene.t_end * scene.rhs->spectral_bound(0, scene.initial) / tags.stiffness, 1, 0.1) << file;
  }
}

TEST(Corpus, StatesTheHashOfEveryGeneratedNetwork) {
  for (const auto& file : files()) {
    TomlTable root = TomlTable::parse_file(file);
    if (auto network = root.table("network"); network && network->find("generator")) {
      EXPECT_TRUE(network->find("expect")) << file;
    }
  }
}

TEST(CorpusTags, NameWhatIsWrong) {
  const auto message = [](const std::string& text) {
    TomlTable root = TomlTable::parse_text(text, "case.toml");
    try {
      (void)read_corpus_tags(root);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(message("[corpus]\nset = \"quik\"\n"),
            "case.toml:2: key 'corpus.set' is 'quik'; it must be one of quick, standard, large; did you mean "
            "'quick'?");
}

}  // namespace
}  // namespace superstep
