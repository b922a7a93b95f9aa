#include "core/text/toml.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

TEST(Toml, ReadsTypedValues) {
  auto root = TomlTable::parse_text("a = 1\nb = [1.5, 2]\n[c]\nd = 'x'\n", "case.toml");
  EXPECT_EQ(root.number("a"), 1.0);
  EXPECT_EQ(root.find("b")->numbers(), (std::vector<double>{1.5, 2}));
  EXPECT_EQ(root.table("c")->string("d"), "x");
  EXPECT_NO_THROW(root.finish());
}

TEST(Toml, UnknownKeyNamesLineAndNearest) {
  auto root = TomlTable::parse_text("t_end = 1\n\n[thermal]\nconductivty = 3\n", "case.toml");
  static_cast<void>(root.number("t_end"));
  auto thermal = root.table("thermal");
  static_cast<void>(thermal->find("conductivity"));
  const auto message = test::message_of<InputError>([&] { root.finish(); });
  EXPECT_NE(message.find("case.toml:4"), std::string::npos) << message;
  EXPECT_NE(message.find("did you mean 'conductivity'"), std::string::npos) << message;
}

TEST(Toml, EveryTableThatWasReadAnswersForItsKeysInArraysToo) {
  auto root = TomlTable::parse_text(
      "[[m]]\nname = 'a'\n[[m]]\nname = 'b'\ndensty = 3\n[d]\nlist = [{ x = 1 }, { x = 2, deep = { y = 1, z "
      "= 2 } }]\n",
      "case.toml");
  for (const auto& value : root.find("m")->array()) static_cast<void>(value.table().find("name"));
  const auto message = test::message_of<InputError>([&] { root.finish(); });
  EXPECT_NE(message.find("case.toml:5: unknown key 'densty' in [m[1]]"), std::string::npos) << message;

  auto nested = TomlTable::parse_text("a = [{ b = { c = 1, see = 2 } }]\n", "case.toml");
  static_cast<void>(nested.find("a")->array()[0].table().table("b")->find("c"));
  const auto inner = test::message_of<InputError>([&] { nested.finish(); });
  EXPECT_NE(inner.find("unknown key 'see' in [a[0].b]"), std::string::npos) << inner;
}

TEST(Toml, AMisspeltKeyIsNotMissing) {
  auto root = TomlTable::parse_text("[material]\ndensty = 1\n[materiel]\n", "case.toml");
  auto material = root.table("material");
  const auto message =
      test::message_of<InputError>([&] { static_cast<void>(material->positive("density", "kg/m3")); });
  EXPECT_EQ(message, "case.toml:2: unknown key 'densty' in [material]; did you mean 'density'?");
  // A key that somebody asked for is no misspelling of another.
  static_cast<void>(material->find("densty"));
  const auto missing =
      test::message_of<InputError>([&] { static_cast<void>(material->positive("density", "kg/m3")); });
  EXPECT_NE(missing.find("'density' is missing"), std::string::npos) << missing;
}

TEST(Toml, LettersOutsideStringsAreErrorsOfTheirLine) {
  for (const char* letter : {"\u00e4", "\u00a1", "\u0416", "\u4e2d", "\u1e9e", "\u2020"}) {
    for (const auto& line : {std::string(letter) + " = 1", "a" + std::string(letter) + " = 1",
                             "b = " + std::string(letter), "b = 1" + std::string(letter)}) {
      const auto message = test::message_of<InputError>(
          [&] { static_cast<void>(TomlTable::parse_text("a = 1\n" + line + "\n", "case.toml")); });
      EXPECT_EQ(message.rfind("case.toml:2:", 0), 0u) << line << " -> " << message;
    }
  }
}

TEST(Toml, WrongTypesAndNonFiniteNumbersAreErrors) {
  auto root = TomlTable::parse_text("a = 'x'\nb = nan\nc = inf\nd = 1.5\n", "case.toml");
  EXPECT_NE(test::message_of<InputError>([&] { static_cast<void>(root.number("a")); }).find("case.toml:1"),
            std::string::npos);
  EXPECT_THROW(static_cast<void>(root.number("b")), InputError);
  EXPECT_THROW(static_cast<void>(root.number("c")), InputError);
  EXPECT_THROW(static_cast<void>(root.find("d")->integer()), InputError);
  EXPECT_THROW(static_cast<void>(root.find("d")->table()), InputError);
}

TEST(Toml, StringsHoldNothingThatSteersATerminal) {
  for (const char* code : {"\\u0000", "\\u001b[31m", "\\u009b", "\\b"}) {
    auto root = TomlTable::parse_text(std::string("a = 1\ntitle = \"red ") + code + "\"\n", "case.toml");
    const auto message = test::message_of<InputError>([&] { static_cast<void>(root.string("title")); });
    EXPECT_EQ(message.rfind("case.toml:2: key 'title'", 0), 0u) << message;
    for (const char* raw : {"\x1b", "\xc2\x9b"}) EXPECT_EQ(message.find(raw), std::string::npos) << message;
  }
  auto root = TomlTable::parse_text("title = \"\u00e4 \u2020\\tb\\nc\\u007f\"\n", "case.toml");
  EXPECT_EQ(root.string("title"), "\u00e4 \u2020\tb\nc\x7f");
}

TEST(Toml, HostileTextIsOneCleanError) {
  const std::string deep(5000, '[');
  for (const std::string& text : {std::string("[&"), std::string("a = 1\n[=a]"), std::string("a = "),
                                  std::string("\xff\xfe"), "a = " + deep, std::string("a = 1\na = 2"),
                                  std::string("a = {b"), std::string("[a]]"), std::string("a = 1979-")}) {
    const auto message =
        test::message_of<InputError>([&] { static_cast<void>(TomlTable::parse_text(text, "case.toml")); });
    EXPECT_EQ(message.rfind("case.toml:", 0), 0u) << text.substr(0, 20) << " -> " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
  const auto second_line = test::message_of<InputError>(
      [] { static_cast<void>(TomlTable::parse_text("a = 1\n[=a]\n", "case.toml")); });
  EXPECT_EQ(second_line.rfind("case.toml:2:", 0), 0u) << second_line;
}

TEST(Toml, TooLargeAFileIsRefused) {
  const std::string text(5u << 20, ' ');
  EXPECT_THROW(static_cast<void>(TomlTable::parse_text(text, "case.toml")), InputError);
}

}  // namespace
}  // namespace superstep
