#pragma once
/// The program, started in a folder of its own that holds a case `rod.toml`.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "support/temporary_case.hpp"

namespace superstep::test {

class Program : public testing::Test {
 protected:
  void SetUp() override { write_rod(folder_, Rod{}); }

  /// Runs the program in the temporary folder; its exit code, with stdout and stderr beside it.
  int run(const std::string& arguments, const std::string& before = "") {
    const std::string command = fmt::format("cd '{}' && {} '{}' {} >stdout.txt 2>stderr.txt",
                                            folder_.file("."), before, SUPERSTEP_PROGRAM, arguments);
    const int status = std::system(command.c_str());  // NOLINT(cert-env33-c): a shell is what users have
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  [[nodiscard]] std::string out() const { return folder_.read("stdout.txt"); }
  [[nodiscard]] std::string err() const { return folder_.read("stderr.txt"); }

  /// The contract of an error: that exit code, one line on stderr that holds `part`, nothing written.
  void expect_error(const std::string& arguments, int code, const std::string& part) {
    SCOPED_TRACE(arguments);
    EXPECT_EQ(run(arguments), code) << err();
    const std::string message = err();
    EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 1) << message;
    EXPECT_TRUE(message.starts_with("superstep: error: ")) << message;
    EXPECT_NE(message.find(part), std::string::npos) << message;
    EXPECT_EQ(out(), "");
    EXPECT_FALSE(folder_.has("superstep-out")) << "nothing may be written";
    EXPECT_FALSE(folder_.has("result")) << "nothing may be written";
  }

  CaseFolder folder_;
};

}  // namespace superstep::test
