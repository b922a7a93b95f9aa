#include "bench/output/output_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "core/error.hpp"

namespace superstep {

namespace fs = std::filesystem;

std::string default_output_folder(const std::string& name) {
  std::error_code error;
  return (fs::is_directory("reports", error) ? "reports/out/" : "superstep-out/") + name;
}

void require_writable_folder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error && !fs::is_directory(folder, error)) error = std::make_error_code(std::errc::not_a_directory);
  if (!error && ::access(folder.c_str(), W_OK | X_OK) != 0) error.assign(errno, std::generic_category());
  if (error)
    throw OutputError(fmt::format("{}: results cannot be written there: {}; choose another folder with --out",
                                  folder, error.message()));
}

OutputFolder::OutputFolder(const std::string& folder) {
  require_writable_folder(folder);
  descriptor_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor_ < 0 || ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  ::close(descriptor_);
  throw OutputError(fmt::format(
      "{}: another superstep is writing results there; wait for it, or choose another folder with "
      "--out",
      folder));
}

OutputFolder::~OutputFolder() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void remove_stale_file(const std::string& path) noexcept {
  std::error_code ignored;
  fs::remove(path, ignored);
}

}  // namespace superstep
