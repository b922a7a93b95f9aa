#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "core/text/csv.hpp"
#include "core/text/text_file.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

using test::message_of;
using test::TemporaryFolder;

TEST(TextFile, RefusesWhatIsNoText) {
  const TemporaryFolder folder;
  EXPECT_THROW(static_cast<void>(read_text_file(folder.file("absent"))), InputError);
  EXPECT_THROW(static_cast<void>(read_text_file(folder.file(""))), InputError);
  EXPECT_THROW(static_cast<void>(read_text_file(folder.write("empty", ""))), InputError);
  EXPECT_THROW(static_cast<void>(read_text_file(folder.write("blank", " \n\r\n"))), InputError);
  EXPECT_THROW(static_cast<void>(read_text_file(folder.write("binary", std::string("a\0b", 3)))), InputError);
}

TEST(TextFile, DropsByteOrderMarkAndCarriageReturns) {
  const TemporaryFolder folder;
  const auto text = read_text_file(folder.write("bom",
                                                "\xEF\xBB\xBF"
                                                "a\r\nb"));
  LineReader lines(text);
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(lines.line(), "a");
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(lines.line(), "b");
  EXPECT_EQ(lines.number(), 2u);
  EXPECT_FALSE(lines.next());
}

TEST(Csv, NamesFileLineAndColumn) {
  const TemporaryFolder folder;
  const auto path = folder.write("t.csv", "b,a\n1,2\n\n3,x\n5\n");
  CsvReader rows(path, {"a", "b"}, {"c"});
  ASSERT_TRUE(rows.next());
  EXPECT_EQ(rows.number(0), 2);
  EXPECT_EQ(rows.integer(1), 1);
  EXPECT_FALSE(rows.has(2));
  ASSERT_TRUE(rows.next());
  EXPECT_EQ(rows.line(), 4u);
  const auto message = message_of<InputError>([&] { static_cast<void>(rows.number(0)); });
  EXPECT_NE(message.find("t.csv:4: column 'a' is 'x'"), std::string::npos) << message;
  EXPECT_NE(message_of<InputError>([&] { rows.next(); }).find("t.csv:5"), std::string::npos);
}

TEST(Csv, AColumnWithoutANameIsLeftOut) {
  const TemporaryFolder folder;
  for (const char* text : {",a,b\n0,2,1\n", "a,b,\n2,1\n", "a;b\n2;1;\n", "a,b\n2, 1,\n"}) {
    CsvReader rows(folder.write("t.csv", text), {"a", "b"});
    ASSERT_TRUE(rows.next());
    EXPECT_EQ(rows.number(0), 2) << text;
    EXPECT_EQ(rows.number(1), 1) << text;
  }
}

TEST(Csv, ChecksTheHeader) {
  const TemporaryFolder folder;
  const auto open = [&](const std::string& text) {
    return message_of<InputError>([&] { CsvReader(folder.write("h.csv", text), {"id", "radius"}); });
  };
  EXPECT_NE(open("id\n").find("'radius' is missing"), std::string::npos);
  EXPECT_NE(open("id,radus\n").find("did you mean 'radius'"), std::string::npos);
  EXPECT_NE(open("id,id,radius\n").find("twice"), std::string::npos);
}

TEST(AtomicFile, AppearsWholeOrNotAtAll) {
  const TemporaryFolder folder;
  const auto path = folder.file("sub/out.txt");
  write_file_atomically(path, "first");
  write_file_atomically(path, "second");
  EXPECT_EQ(read_text_file(path), "second");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.file("sub")), {}), 1);
  EXPECT_THROW(write_file_atomically(folder.file("sub"), "x"), OutputError);
  EXPECT_THROW(write_file_atomically(path + "/below/a/file", "x"), OutputError);
}

}  // namespace
}  // namespace superstep
