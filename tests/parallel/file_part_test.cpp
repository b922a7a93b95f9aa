/// Files that several fill, by plain writes.

#include "parallel/file_part.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

std::string content_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(FileParts, MeetWhereOneEndsAndTheNextBegins) {
  const test::TemporaryFolder folder;
  folder.write("file", "");
  const auto one = open_plain_part(folder.file("file")), other = open_plain_part(folder.file("file"));
  other->write(4, "five six");
  one->write(0, "one ");
  one->write(12, "");
  one->finish();
  other->finish();
  EXPECT_EQ(content_of(folder.file("file")), "one five six");
}

TEST(FileParts, AFileThatIsNotThereIsNotMade) {
  const test::TemporaryFolder folder;
  try {
    (void)open_plain_part(folder.file("file"));
    FAIL() << "it was opened";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "No such file or directory");
  }
}

TEST(FileParts, AFullDiskIsSaid) {
  const auto part = open_plain_part("/dev/full");
  try {
    part->write(0, "text");
    FAIL() << "it was written";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "No space left on device");
  }
}

}  // namespace
}  // namespace superstep
