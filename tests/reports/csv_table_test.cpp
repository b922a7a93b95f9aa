#include "results/text/csv_table.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "results/text/csv_text.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

using test::message_of;
using test::TemporaryFolder;

TEST(CsvTable, GivesBackWhatWasWritten) {
  const TemporaryFolder folder;
  for (const std::string text : {"plain", "a,b", "say \"hi\"", "two\nlines", "=cmd()", "'=cmd()", "''=x",
                                 "-5 K", "@sum", "+1", "\tx", "ünïcode", "", "'", "it's", "=1,\"2\""}) {
    const CsvTable table(folder.write("t.csv", "name,value\n" + csv_cell(text) + ",1.5\n"));
    ASSERT_EQ(table.rows(), 1U) << text;
    EXPECT_EQ(table.text(0, table.column("name")), text);
    EXPECT_EQ(table.number(0, table.column("value")), 1.5);
  }
}

TEST(CsvTable, FormulasAreDefusedAndNumbersAreNot) {
  for (const std::string text : {"=cmd()", "+1", "-1", "@a", "\tx"})
    EXPECT_TRUE(csv_cell(text).starts_with("'")) << text;
  EXPECT_EQ(csv_cell("=a,b"), "\"'=a,b\"");
  EXPECT_EQ(csv_cell(-1.5), "-1.5");
}

TEST(CsvTable, EmptyCellsBlankLinesAndWindowsLineEnds) {
  const TemporaryFolder folder;
  const CsvTable table(folder.write("t.csv", "a,b,c\r\n1,,\r\n\r\n,2,\"x\"\r\n"));
  ASSERT_EQ(table.rows(), 2U);
  EXPECT_EQ(table.number(0, 0), 1.0);
  EXPECT_FALSE(table.number(0, 1));
  EXPECT_EQ(table.text(0, 2), "");
  EXPECT_EQ(table.text(1, 2), "x");
  EXPECT_FALSE(table.find("d"));
}

TEST(CsvTable, WhatCountsIsWhole) {
  const TemporaryFolder folder;
  const CsvTable table(folder.write("t.csv", "a,b\n7,\n3.0,\n-2,\n1.5,\n1e300,\n,\n"));
  EXPECT_EQ(table.count(0, 0), 7U);
  EXPECT_EQ(table.count(1, 0), 3U);
  EXPECT_EQ(table.whole(2, 0), -2);
  EXPECT_FALSE(table.count(5, 0));
  for (const std::size_t row : {2U, 3U, 4U})
    EXPECT_NE(message_of<InputError>([&] { (void)table.count(row, 0); }).find("not negative"),
              std::string::npos)
        << row;
  for (const std::size_t row : {3U, 4U, 5U})
    EXPECT_NE(message_of<InputError>([&] { (void)table.whole(row, 0); }).find("whole number"),
              std::string::npos)
        << row;
}

TEST(CsvTable, ErrorsNameFileAndRule) {
  const TemporaryFolder folder;
  const auto message = [&](const std::string& content, auto use) {
    const std::string path = folder.write("t.csv", content);
    return message_of<InputError>([&] { use(CsvTable(path)); });
  };
  const auto nothing = [](const CsvTable&) {};
  EXPECT_NE(message("a,b\n1\n", nothing).find("1 cells"), std::string::npos);
  EXPECT_NE(message("a,b,a\n1,2,3\n", nothing).find("two columns 'a'"), std::string::npos);
  EXPECT_NE(message("a,b\n\"1,2\n", nothing).find("quote"), std::string::npos);
  EXPECT_NE(message("a,b\n1,x\n", [](const CsvTable& t) { (void)t.number(0, 1); }).find("'b'"),
            std::string::npos);
  EXPECT_NE(message("a,b\n1,\n", [](const CsvTable& t) { (void)t.required(0, 1); }).find("empty"),
            std::string::npos);
  EXPECT_NE(message("valu,b\n1,2\n", [](const CsvTable& t) { (void)t.column("value"); }).find("'valu'"),
            std::string::npos);
}

}  // namespace
}  // namespace superstep
