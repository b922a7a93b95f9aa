/// The corpus says of itself what is true.

#include <gtest/gtest.h>

#include <filesystem>
#include <map>

#include "case/corpus/corpus_tags.hpp"
#include "case/scene.hpp"
#include "core/error.hpp"

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
