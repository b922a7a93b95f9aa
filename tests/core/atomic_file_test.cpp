#include "core/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <iterator>

#include "core/error.hpp"
#include "core/temporary_files.hpp"
#include "support/temporary_folder.hpp"

namespace superstep {
namespace {

namespace fs = std::filesystem;
using test::message_of;
using test::TemporaryFolder;

std::string content_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

mode_t mode_of(const std::string& path) {
  struct stat facts {};
  EXPECT_EQ(::stat(path.c_str(), &facts), 0);
  return facts.st_mode & 07777;
}

std::size_t files_in(const std::string& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

/// Runs `call` in a process of its own; its exit code, -1 when a signal ended it.
template <class Call>
int in_a_child(Call call) {
  const pid_t child = ::fork();
  if (child == 0) {
    call();
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(AtomicFile, WritesThroughLinksAndLeavesThem) {
  const TemporaryFolder folder;
  fs::create_directory(folder.file("data"));
  folder.write("data/target", "old");
  fs::create_symlink("data/target", folder.file("link"));
  fs::create_symlink("link", folder.file("link of link"));
  write_file_atomically(folder.file("link of link"), "new");
  EXPECT_TRUE(fs::is_symlink(folder.file("link")));
  EXPECT_TRUE(fs::is_symlink(folder.file("link of link")));
  EXPECT_EQ(content_of(folder.file("data/target")), "new");

  fs::create_symlink("data/not yet", folder.file("dangling"));
  write_file_atomically(folder.file("dangling"), "made");
  EXPECT_TRUE(fs::is_symlink(folder.file("dangling")));
  EXPECT_EQ(content_of(folder.file("data/not yet")), "made");

  fs::create_symlink("b", folder.file("a"));
  fs::create_symlink("a", folder.file("b"));
  EXPECT_THROW(write_file_atomically(folder.file("a"), "x"), OutputError);
  EXPECT_EQ(files_in(folder.file("data")), 2U) << "no temporary stays";
}

TEST(AtomicFile, DevicesPipesAndSocketsStayWhatTheyAre) {
  const TemporaryFolder folder;
  ASSERT_EQ(::mkfifo(folder.file("pipe").c_str(), 0600), 0);
  fs::create_symlink("pipe", folder.file("link"));
  for (const char* name : {"pipe", "link"})
    EXPECT_NE(message_of<OutputError>([&] { write_file_atomically(folder.file(name), "x"); }).find("no file"),
              std::string::npos);
  EXPECT_TRUE(fs::is_fifo(folder.file("pipe")));
  EXPECT_THROW(write_file_atomically("/dev/zero", "x"), OutputError);
  EXPECT_NO_THROW(write_file_atomically("/dev/null", "x"));
  fs::create_symlink("/dev/null", folder.file("nowhere"));
  EXPECT_NO_THROW(write_file_atomically(folder.file("nowhere"), "x"));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_TRUE(fs::is_symlink(folder.file("nowhere")));
  EXPECT_EQ(files_in(folder.file(".")), 3U);
}

TEST(AtomicFile, StandardOutputIsWrittenTo) {
  const TemporaryFolder folder;
  fs::create_symlink("/dev/stdout", folder.file("link"));
  const auto written = [&](const std::string& path) {
    EXPECT_EQ(in_a_child([&] {
                const int file = ::open(folder.file("out").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
                ::dup2(file, STDOUT_FILENO);
                write_file_atomically(path, "one, ");
                write_file_atomically(path, "two");
              }),
              0);
    return content_of(folder.file("out"));
  };
  EXPECT_EQ(written("/dev/stdout"), "one, two");
  EXPECT_EQ(written(folder.file("link")), "one, two");
}

TEST(AtomicFile, PermissionsAreThoseOfTheUmaskOrOfTheFileBefore) {
  const TemporaryFolder folder;
  const mode_t before = ::umask(027);
  write_file_atomically(folder.file("new"), "x");
  ::umask(before);
  EXPECT_EQ(mode_of(folder.file("new")), 0640U);
  ASSERT_EQ(::chmod(folder.file("new").c_str(), 0600), 0);
  write_file_atomically(folder.file("new"), "y");
  EXPECT_EQ(mode_of(folder.file("new")), 0600U);
}

TEST(AtomicFile, AFileThatDoesNotFitLeavesTheOldOne) {
  const TemporaryFolder folder;
  folder.write("file", "old");
  const std::string large(100'000, 'x');
  EXPECT_EQ(in_a_child([&] {
              const rlimit limit{10'000, 10'000};  // bytes a file may have
              ::setrlimit(RLIMIT_FSIZE, &limit);
              std::signal(SIGXFSZ, SIG_IGN);
              try {
                write_file_atomically(folder.file("file"), large);
              } catch (const OutputError&) {
                ::_exit(7);
              }
            }),
            7);
  EXPECT_EQ(content_of(folder.file("file")), "old");
  EXPECT_EQ(files_in(folder.file(".")), 1U);
}

TEST(AtomicFile, OthersMayFillIt) {
  const TemporaryFolder folder;
  const auto fill = [](const std::string& temporary) {
    EXPECT_EQ(content_of(temporary), "");
    std::ofstream(temporary) << "content";
    return true;
  };
  const mode_t before = ::umask(027);
  EXPECT_TRUE(fill_file_atomically(folder.file("new/file"), fill));
  ::umask(before);
  EXPECT_EQ(content_of(folder.file("new/file")), "content");
  EXPECT_EQ(mode_of(folder.file("new/file")), 0640U);
  const auto refuse = [&](const std::string& temporary) { return !fill(temporary); };
  EXPECT_FALSE(fill_file_atomically(folder.file("new/other"), refuse));
  EXPECT_THROW((void)fill_file_atomically(
                   folder.file("new/file"),
                   [](const std::string&) -> bool { throw write_error("file", "somebody cannot"); }),
               OutputError);
  EXPECT_EQ(content_of(folder.file("new/file")), "content");
  EXPECT_EQ(files_in(folder.file("new")), 1U);
}

TEST(AtomicFile, OthersFillNoLinksStreamsAndFolders) {
  const TemporaryFolder folder;
  fs::create_symlink(folder.file("file"), folder.file("link"));
  const auto fill = [](const std::string&) -> bool { throw std::logic_error("nobody fills it"); };
  for (const std::string& place : {folder.file("link"), folder.file("."), std::string("/dev/stdout")})
    EXPECT_FALSE(fill_file_atomically(place, fill)) << place;
  EXPECT_EQ(files_in(folder.file(".")), 1U);
}

TEST(AtomicFile, NamesAsLongAsTheyMayBe) {
  const TemporaryFolder folder;
  const std::string longest(255, 'n');
  write_file_atomically(folder.file(longest), "x");
  EXPECT_EQ(content_of(folder.file(longest)), "x");
  EXPECT_THROW(write_file_atomically(folder.file(longest + "n"), "x"), OutputError);
  EXPECT_EQ(files_in(folder.file(".")), 1U);
}

TEST(TemporaryFiles, ThoseOfTheDeadAreRemovedAndNoOthers) {
  const TemporaryFolder folder;
  const pid_t dead = ::fork();
  if (dead == 0) {
    const TemporaryFile left(folder.file("."));
    ::kill(::getpid(), SIGKILL);
  }
  ::waitpid(dead, nullptr, 0);
  ASSERT_EQ(files_in(folder.file(".")), 1U) << "a killed process leaves its temporary";
  folder.write(".superstep-notes.tmp", "mine");
  folder.write(fmt::format(".superstep-{}-0", dead), "mine");
  const std::string of_somebody_alive = fmt::format(".superstep-{}-77.tmp", ::getppid());
  folder.write(of_somebody_alive, "theirs");
  write_file_atomically(folder.file("file"), "x");
  EXPECT_EQ(files_in(folder.file(".")), 4U);
  EXPECT_FALSE(fs::exists(folder.file(fmt::format(".superstep-{}-0.tmp", dead))));
  EXPECT_TRUE(fs::exists(folder.file(of_somebody_alive)));
}

}  // namespace
}  // namespace superstep
