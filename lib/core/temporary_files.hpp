#pragma once
/// Files that are being written: named after their process, and removed by whoever comes next when that died.

#include <filesystem>
#include <string>

namespace superstep {

/// A new file in a folder, ".superstep-<process>-<number>.tmp", locked while it is open; removed unless it
/// was renamed. The first one of a process in a folder removes those of dead processes there.
class TemporaryFile {
 public:
  /// On failure `descriptor` is -1 and errno says why.
  explicit TemporaryFile(const std::filesystem::path& folder);
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  [[nodiscard]] int descriptor() const noexcept { return descriptor_; }
  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  /// Closes the file and gives it its name; false with errno when that fails.
  [[nodiscard]] bool rename_to(const std::filesystem::path& file) noexcept;

 private:
  std::string name_;
  int descriptor_ = -1;
};

/// Removes temporaries that processes left in a folder which run no more.
void remove_dead_temporaries(const std::filesystem::path& folder) noexcept;

}  // namespace superstep
