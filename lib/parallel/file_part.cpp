#include "parallel/file_part.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace superstep {
namespace {

[[noreturn]] void fail(int error) {
  throw std::runtime_error(std::strerror(error));
}

class PlainPart final : public FilePart {
 public:
  explicit PlainPart(const std::string& file) : descriptor_(::open(file.c_str(), O_WRONLY | O_CLOEXEC)) {
    if (descriptor_ < 0) fail(errno);
  }
  ~PlainPart() override { ::close(descriptor_); }
  PlainPart(const PlainPart&) = delete;
  PlainPart& operator=(const PlainPart&) = delete;

  void write(std::uint64_t offset, std::string_view bytes) override {
    while (!bytes.empty()) {
      const ssize_t written = ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) fail(written < 0 ? errno : EIO);
      offset += static_cast<std::uint64_t>(written);
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }
  void finish() override {
    if (::fsync(descriptor_) != 0) fail(errno);
  }

 private:
  int descriptor_;
};

}  // namespace

std::unique_ptr<FilePart> open_plain_part(const std::string& file) {
  return std::make_unique<PlainPart>(file);
}

}  // namespace superstep
