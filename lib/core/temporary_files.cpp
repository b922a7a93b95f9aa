#include "core/temporary_files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <mutex>
#include <optional>
#include <set>

#include "core/text/number.hpp"

namespace superstep {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view prefix = ".superstep-", suffix = ".tmp";

/// Process that a temporary is named after; nothing for other files.
std::optional<pid_t> owner_of(std::string_view name) {
  if (!name.starts_with(prefix) || !name.ends_with(suffix)) return std::nullopt;
  name.remove_prefix(prefix.size());
  const auto process = parse_integer(name.substr(0, name.find('-')));
  if (!process || *process <= 0) return std::nullopt;
  return static_cast<pid_t>(*process);
}

bool runs(pid_t process) noexcept {
  return ::kill(process, 0) == 0 || errno == EPERM;
}

/// A process of another machine is unknown here, but the lock on its file is known where the file system is
/// shared.
bool is_locked(const fs::path& file) noexcept {
  const int descriptor = ::open(file.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
  if (descriptor < 0) return true;
  const bool locked = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0;
  ::close(descriptor);
  return locked;
}

void clean_once(const fs::path& folder) {
  static std::mutex mutex;
  static std::set<fs::path> cleaned;
  const std::lock_guard lock(mutex);
  if (cleaned.insert(folder).second) remove_dead_temporaries(folder);
}

}  // namespace

void remove_dead_temporaries(const fs::path& folder) noexcept {
  try {
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder.empty() ? fs::path(".") : folder, ignored)) {
      const auto owner = owner_of(entry.path().filename().string());
      if (owner && !runs(*owner) && !is_locked(entry.path())) ::unlink(entry.path().c_str());
    }
  } catch (const std::exception&) {  // litter that stays does no harm
  }
}

TemporaryFile::TemporaryFile(const fs::path& folder) {
  static std::atomic<unsigned> number{0};
  clean_once(folder);
  constexpr int attempts = 100;  // a dead process may have had our number
  for (int attempt = 0; attempt < attempts; ++attempt) {
    name_ = (folder / fmt::format("{}{}-{}{}", prefix, ::getpid(), number++, suffix)).string();
    descriptor_ = ::open(name_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (descriptor_ >= 0 || errno != EEXIST) break;
  }
  if (descriptor_ >= 0) (void)::flock(descriptor_, LOCK_EX | LOCK_NB);
}

TemporaryFile::~TemporaryFile() {
  if (descriptor_ < 0) return;
  const int error = errno;  // of what went wrong before
  ::close(descriptor_);
  ::unlink(name_.c_str());
  errno = error;
}

bool TemporaryFile::rename_to(const fs::path& file) noexcept {
  const bool closed = ::close(descriptor_) == 0;
  descriptor_ = -1;
  if (closed && std::rename(name_.c_str(), file.c_str()) == 0) return true;
  const int error = errno;
  ::unlink(name_.c_str());
  errno = error;
  return false;
}

}  // namespace superstep
