#include "bench/harness/instructions.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>
#include <vector>

#include "bench/measure/counted.hpp"
#include "core/text/number.hpp"
#include "rhs/kernels/sweep.hpp"

extern char** environ;

namespace superstep {
namespace {

namespace fs = std::filesystem;

/// A folder for the files of one count.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "superstep-count-XXXXXX").string();
    if (mkdtemp(name.data())) path_ = name;
  }
  ~ScratchFolder() {
    std::error_code none;
    if (!path_.empty()) fs::remove_all(path_, none);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  [[nodiscard]] bool there() const noexcept { return !path_.empty(); }
  [[nodiscard]] std::string file(const std::string& name) const { return (path_ / name).string(); }

 private:
  fs::path path_;
};

/// Runs a program to its end, or until it is to stop, what it says going to files; its exit code, or -1 when
/// it could not be started or was killed.
int run_program_file(std::vector<std::string> line, const std::string& out, const std::string& err,
                     const std::atomic<bool>* stop = nullptr) {
  std::vector<char*> arguments;
  for (auto& word : line) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  if (posix_spawn_file_actions_init(&actions) != 0) return -1;
  constexpr int flags = O_WRONLY | O_CREAT | O_TRUNC, mode = 0600;
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), flags, mode);
  posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), flags, mode);
  pid_t child = 0;
  const int failed = posix_spawnp(&child, arguments.front(), &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed) return -1;
  constexpr std::chrono::milliseconds between_looks(20);
  int status = 0;
  for (pid_t ended = 0; ended != child;) {
    ended = waitpid(child, &status, stop ? WNOHANG : 0);
    if (ended < 0 && errno != EINTR) return -1;
    if (ended == 0 && stop->load()) (void)kill(child, SIGKILL);  // it has nothing to tidy up
    if (ended == 0) std::this_thread::sleep_for(between_looks);
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string first_line(const std::string& file, const std::string& beginning = {}) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with(beginning)) return line;
  return {};
}

}  // namespace

std::string valgrind_version() {
  const ScratchFolder folder;
  if (!folder.there()) return {};
  if (run_program_file({"valgrind", "--version"}, folder.file("out"), folder.file("err")) != 0) return {};
  return first_line(folder.file("out"));
}

std::string counter_facts() {
  const std::string version = valgrind_version();
  if (version.empty()) return {};
  for (const auto& kernel : sweep_kernels())
    if (std::string_view(kernel.name).find("512") == std::string_view::npos)
      return fmt::format("{}, {}", version, kernel.name);
  return version;
}

InstructionCount count_instructions(const std::string& program, const std::string& case_file,
                                    const std::string& spec, const std::atomic<bool>* stop) {
  const ScratchFolder folder;
  if (!folder.there()) return {{}, "there is no folder for temporary files"};
  const int code =  // with one thread for BLAS a program need not start anew under a limit on memory
      run_program_file({"env", "OPENBLAS_NUM_THREADS=1", "valgrind", "--tool=callgrind",
                        "--callgrind-out-file=" + folder.file("counts"),
                        fmt::format("--toggle-collect={}", counted_function), program, "run", case_file,
                        "--integrator", spec, "--quiet", "--threads", "1", "--out", folder.file("result")},
                       folder.file("out"), folder.file("err"), stop);
  if (code != 0)
    return {{},
            fmt::format("the run under callgrind ended with code {}: {}", code,
                        first_line(folder.file("err"), "superstep: "))};
  constexpr const char* key = "summary: ";
  const std::string line = first_line(folder.file("counts"), key);
  const auto number =
      parse_integer(std::string_view(line).substr(std::min(line.size(), std::string(key).size())));
  if (!number || *number <= 0) return {{}, "callgrind counted nothing"};
  return {static_cast<std::uint64_t>(*number), {}};
}

}  // namespace superstep
