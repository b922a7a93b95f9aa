#pragma once
/// What one process writes of a file that several fill together.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace superstep {

class FilePart {
 public:
  virtual ~FilePart() = default;
  /// Writes all of `bytes` so many bytes behind the begin of the file, where nobody else writes. Throws
  /// std::runtime_error with the reason alone.
  virtual void write(std::uint64_t offset, std::string_view bytes) = 0;
  /// Has the disk keep what was written. Throws likewise.
  virtual void finish() = 0;
};

/// Through the system's own calls, for processes of one machine. Throws likewise.
[[nodiscard]] std::unique_ptr<FilePart> open_plain_part(const std::string& file);

}  // namespace superstep
