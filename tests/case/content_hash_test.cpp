#include "case/content_hash.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

namespace fs = std::filesystem;

const fs::path cases = fs::path(SUPERSTEP_SOURCE_DIR) / "cases";

std::string content_of(const fs::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Hash of a text as if it stood in the folder of the cases.
std::string hash_of(const std::string& text) {
  return content_hash(TomlTable::parse_text(text, (cases / "mutated.toml").string()));
}

/// A value of a case text: where its characters are, and the table and key it belongs to.
struct Token {
  std::size_t begin, size;
  std::string table, key;
  bool is_string;
};

/// Numbers and strings to the right of an equals sign, found without a TOML parser.
std::vector<Token> values_in(const std::string& text) {
  std::vector<Token> out;
  std::string table, key, word;
  bool right = false;
  int depth = 0;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (c == '#') {
      k = text.find('\n', k) - 1;
    } else if (c == '\n') {
      if (depth == 0) right = false, word.clear();
    } else if (!right && c == '[') {
      const std::size_t end = text.find(']', k);
      table = text.substr(k, end - k);
      table.erase(0, table.find_first_not_of('['));
      k = text.find('\n', k) - 1;
    } else if (c == '"') {
      const std::size_t end = text.find('"', k + 1);
      if (right) out.push_back({k + 1, end - k - 1, table, key, true});
      k = end;
    } else if (c == '=') {
      if (depth == 0) key = word;
      right = true;
      word.clear();
    } else if (right && (std::isdigit(static_cast<unsigned char>(c)) != 0)) {
      const std::size_t end = text.find_first_not_of("0123456789.e+-_", k);
      if (word.empty()) out.push_back({k, end - k, table, key, false});
      k = end - 1;
    } else if (c == '{' || c == '[') {
      ++depth;
    } else if (c == '}' || c == ']') {
      --depth;
      word.clear();
    } else if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
      word += c;
    } else if (c == ',' || c == ' ') {
      if (c == ',' || right) word.clear();
    }
  }
  return out;
}

std::string mutated(const std::string& text, const Token& token) {
  std::string out = text;
  if (token.is_string) {
    out.insert(token.begin, "x");
  } else {
    char& digit = out[token.begin];  // another number, and still a number
    digit = digit == '9' ? '8' : static_cast<char>(digit + 1);
  }
  return out;
}

class EveryCaseText : public testing::TestWithParam<fs::path> {};

TEST_P(EveryCaseText, EveryValueThatAnAnswerDependsOnCounts) {
  const std::string text = content_of(GetParam());
  const std::string whole = hash_of(text);
  std::size_t counted = 0;
  for (const auto& token : values_in(text)) {
    const bool words = (token.table.empty() && (token.key == "title" || token.key == "source")) ||
                       token.table.starts_with("bench") || token.table == "published";
    const std::string other = mutated(text, token);
    EXPECT_EQ(hash_of(other) == whole, words)
        << "[" << token.table << "] " << token.key << " at " << text.substr(token.begin, token.size);
    if (!words) ++counted;
  }
  EXPECT_GE(counted, 3U) << "the walk over the text found nothing to change";
}

TEST_P(EveryCaseText, CommentsAndBlanksDoNotCount) {
  const std::string text = content_of(GetParam());
  std::string other = "# a comment\n\n" + text;
  for (std::size_t k = other.find("\n["); k != std::string::npos; k = other.find("\n[", k + 12))
    other.insert(k + 1, "\n# more\n  ");
  EXPECT_EQ(hash_of(other), hash_of(text));
}

std::vector<fs::path> case_files() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(cases))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

INSTANTIATE_TEST_SUITE_P(Cases, EveryCaseText, testing::ValuesIn(case_files()),
                         [](const auto& one) { return one.param.stem().string(); });

TEST(ContentHashOfACase, OrderOfKeysAndTheFormOfANumberDoNotCount) {
  EXPECT_EQ(hash_of("t_end = 2\n[a]\nx = 1\ny = \"z\"\n"), hash_of("t_end = 2.0\n[a]\ny = \"z\"\nx = 1e0\n"));
  EXPECT_NE(hash_of("[a]\nx = 1\n"), hash_of("[a]\nx = \"1\"\n"));
  EXPECT_NE(hash_of("[a]\nx = [1, 2]\n"), hash_of("[a]\nx = [2, 1]\n"));
  EXPECT_NE(hash_of("[a]\nx = []\n"), hash_of("[a]\n"));
  // Both are 2^63 as doubles, which no 64-bit integer is.
  EXPECT_NE(hash_of("x = 9223372036854775807\n"), hash_of("x = 9223372036854775806\n"));
  EXPECT_NE(hash_of("x = 9223372036854775807\n"), hash_of("x = 9223372036854775808.0\n"));
}

TEST(ContentHashOfACase, EveryByteOfADataFileCounts) {
  const test::TemporaryFolder folder;
  const std::string table = "id,x,y,z,radius\n0,0,0,0,0.5\n1,1,0,0,0.5\n";
  folder.write("packing.csv", table);
  folder.write("case.toml", "t_end = 1\n[packing]\nfile = \"packing.csv\"\n");
  const auto hash = [&] { return content_hash(TomlTable::parse_file(folder.file("case.toml"))); };
  const std::string whole = hash();
  EXPECT_EQ(hash(), whole);
  for (std::size_t k = table.find('\n'); k < table.size(); ++k) {
    if (std::isdigit(static_cast<unsigned char>(table[k])) == 0) continue;
    std::string other = table;
    other[k] = other[k] == '9' ? '8' : static_cast<char>(other[k] + 1);
    folder.write("packing.csv", other);
    EXPECT_NE(hash(), whole) << "character " << k;
  }
  folder.write("packing.csv", table);
  EXPECT_EQ(hash(), whole);
}

}  // namespace
}  // namespace superstep
