#pragma once
/// The program called in this process, with what it wrote.

#include <string>
#include <vector>

namespace superstep::test {

struct Said {
  int code = 0;
  std::string out, err;
};

/// Runs a command line; standard output and error go to memory meanwhile.
[[nodiscard]] Said call_program(const std::vector<std::string>& arguments);

/// Files and folders below a folder, sorted.
[[nodiscard]] std::vector<std::string> files_below(const std::string& folder);

}  // namespace superstep::test
