#include "core/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>
#include <system_error>

#include "core/temporary_files.hpp"

namespace superstep {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, const std::string& why) {
  throw write_error(path, why);
}
[[noreturn]] void fail(const std::string& path, int error) {
  fail(path, std::strerror(error));
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

/// The descriptor of the process that a path names, as /dev/stdout does.
std::optional<int> own_stream(const fs::path& path) {
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
    const char* usual = stream == STDOUT_FILENO ? "/dev/stdout" : "/dev/stderr";
    for (const std::string& name :
         {std::string(usual), fmt::format("/dev/fd/{}", stream), fmt::format("/proc/self/fd/{}", stream)})
      if (path == fs::path(name)) return stream;
  }
  return std::nullopt;
}

/// Where a path leads: the file at the end of its symbolic links, which need not exist, or one of our
/// streams.
struct Destination {
  fs::path file;
  std::optional<int> stream;
};

Destination follow_links(const std::string& path) {
  constexpr int longest_chain = 40;  // as the kernel has it
  fs::path at(path);
  for (int links = 0; links <= longest_chain; ++links) {
    if (const auto stream = own_stream(at.lexically_normal())) return {at, stream};
    std::error_code error;
    if (!fs::is_symlink(fs::symlink_status(at, error))) return {at, std::nullopt};
    const fs::path next = fs::read_symlink(at, error);
    if (error) fail(path, error.value());
    at = next.is_absolute() ? next : at.parent_path() / next;
  }
  fail(path, ELOOP);
}

bool is_null_device(const struct stat& facts) noexcept {
  constexpr unsigned memory_devices = 1, null = 3;  // of Linux
  return S_ISCHR(facts.st_mode) && major(facts.st_rdev) == memory_devices && minor(facts.st_rdev) == null;
}

/// Makes what was renamed into a folder last a power cut. Some file systems cannot: the file is there anyway.
void flush_folder(const fs::path& folder) noexcept {
  const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

using Pieces = std::function<void(const PieceWriter&)>;

void write_pieces(const std::string& path, int descriptor, const Pieces& pieces) {
  pieces([&](std::string_view piece) {
    if (!write_all(descriptor, piece)) fail(path, errno);
  });
}

/// Writes all there is to write; false where it is not to be written after all.
using Fill = std::function<bool(const TemporaryFile&)>;

/// Through a temporary. `kept` [mode] of the file that is replaced, if there is one.
bool replace(const std::string& path, const fs::path& file, const Fill& fill, std::optional<mode_t> kept) {
  TemporaryFile temporary(file.parent_path());
  if (temporary.descriptor() < 0) fail(path, errno);
  if (!fill(temporary)) return false;
  const bool flushed =
      (!kept || ::fchmod(temporary.descriptor(), *kept) == 0) && ::fsync(temporary.descriptor()) == 0;
  if (!flushed) fail(path, errno);
  if (!temporary.rename_to(file)) fail(path, errno);
  flush_folder(file.parent_path());
  return true;
}

/// What stands where a file is to be.
enum class Place : char { nothing, file, other };
struct Standing {
  Place place = Place::nothing;
  std::optional<mode_t> mode;  ///< of a file
  struct stat facts {};
};

/// Creates missing parent folders.
Standing look_at(const std::string& path, const fs::path& file) {
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  if (error) fail(path, error.value());
  Standing there;
  const bool exists = ::stat(file.c_str(), &there.facts) == 0;
  if (!exists && errno != ENOENT) fail(path, errno);
  if (!exists) return there;
  constexpr mode_t permissions = 07777;
  there.place = S_ISREG(there.facts.st_mode) ? Place::file : Place::other;
  if (there.place == Place::file) there.mode = there.facts.st_mode & permissions;
  return there;
}

}  // namespace

OutputError write_error(const std::string& path, const std::string& why) {
  return OutputError(
      fmt::format("{}: cannot be written: {}; choose another place or free some space", path, why));
}

void write_file_atomically(const std::string& path, std::string_view content) {
  write_file_atomically(path, [&](const PieceWriter& write) { write(content); });
}

void write_file_atomically(const std::string& path, const Pieces& pieces) {
  const auto [file, stream] = follow_links(path);
  if (stream) return write_pieces(path, *stream, pieces);
  const Standing there = look_at(path, file);
  if (there.place != Place::other) {
    const auto fill = [&](const TemporaryFile& temporary) {
      write_pieces(path, temporary.descriptor(), pieces);
      return true;
    };
    (void)replace(path, file, fill, there.mode);
    return;
  }
  if (S_ISDIR(there.facts.st_mode)) fail(path, EISDIR);
  if (!is_null_device(there.facts)) fail(path, "it is a device, a pipe or a socket, and no file");
}

bool fill_file_atomically(const std::string& path, const std::function<bool(const std::string&)>& fill) {
  const fs::path file(path);
  std::error_code ignored;
  if (own_stream(file.lexically_normal()) || fs::is_symlink(fs::symlink_status(file, ignored))) return false;
  const Standing there = look_at(path, file);
  if (there.place == Place::other) return false;
  return replace(
      path, file,
      [&](const TemporaryFile& temporary) { return fill(fs::absolute(temporary.name()).string()); },
      there.mode);
}

}  // namespace superstep
