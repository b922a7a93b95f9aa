#include "program.hpp"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "bench/app/cli/run_program.hpp"

namespace superstep::test {
namespace {

/// A stream of the process that leads into memory for a while.
class Caught {
 public:
  explicit Caught(int stream) : stream_(stream), kept_(::dup(stream)), memory_(::memfd_create("said", 0)) {
    if (kept_ < 0 || memory_ < 0 || ::dup2(memory_, stream) < 0) throw std::runtime_error("no memory file");
  }
  ~Caught() {
    ::dup2(kept_, stream_);
    ::close(kept_);
    ::close(memory_);
  }
  Caught(const Caught&) = delete;
  Caught& operator=(const Caught&) = delete;

  [[nodiscard]] std::string text() const {
    std::string text(static_cast<std::size_t>(::lseek(memory_, 0, SEEK_END)), '\0');
    if (::pread(memory_, text.data(), text.size(), 0) < 0) throw std::runtime_error("memory file unreadable");
    return text;
  }

 private:
  int stream_, kept_, memory_;
};

}  // namespace

Said call_program(const std::vector<std::string>& arguments) {
  std::fflush(nullptr);
  const Caught out(STDOUT_FILENO), err(STDERR_FILENO);
  const int code = run_program(arguments);
  std::fflush(nullptr);
  return {code, out.text(), err.text()};
}

std::vector<std::string> files_below(const std::string& folder) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace superstep::test
