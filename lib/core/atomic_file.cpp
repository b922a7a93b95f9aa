#include "core/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "core/error.hpp"

namespace superstep {
namespace {

[[noreturn]] void fail(const std::string& path, int error) {
  throw OutputError(
      fmt::format("{}: cannot be written: {}; choose another place with --out or free some space", path,
                  std::strerror(error)));
}

bool write_all(int descriptor, std::string_view content) noexcept {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

}  // namespace

void write_file_atomically(const std::string& path, std::string_view content) {
  const std::filesystem::path target(path);
  std::error_code error;
  if (target.has_parent_path()) std::filesystem::create_directories(target.parent_path(), error);
  if (error) fail(path, error.value());
  if (std::filesystem::is_directory(target, error)) fail(path, EISDIR);

  std::string temporary = path + ".XXXXXX";
  const int descriptor = ::mkstemp(temporary.data());
  if (descriptor < 0) fail(path, errno);
  constexpr mode_t readable_by_all = 0644;
  const bool flushed = write_all(descriptor, content) && ::fchmod(descriptor, readable_by_all) == 0 &&
                       ::fsync(descriptor) == 0;
  int failure = flushed ? 0 : errno;
  if (::close(descriptor) != 0 && failure == 0) failure = errno;
  if (failure == 0 && std::rename(temporary.c_str(), path.c_str()) != 0) failure = errno;
  if (failure != 0) {
    ::unlink(temporary.c_str());
    fail(path, failure);
  }
}

}  // namespace superstep
