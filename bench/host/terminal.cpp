#include "bench/host/terminal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "core/error.hpp"

namespace superstep {

bool use_color(ColorMode mode) {
  if (mode != ColorMode::automatic) return mode == ColorMode::always;
  const char* refused = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  const bool dumb = terminal && std::string_view(terminal) == "dumb";
  return ::isatty(STDOUT_FILENO) != 0 && !dumb && (!refused || *refused == '\0');
}

bool stderr_is_terminal() {
  return ::isatty(STDERR_FILENO) != 0;
}

void print_data(std::string_view text) {
  static bool nobody_reads = false;  // any more, as where `head` has seen enough
  if (nobody_reads) return;
  const bool written =
      std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  nobody_reads = !written && errno == EPIPE;
  if (!written && !nobody_reads)
    throw OutputError(fmt::format("standard output cannot be written: {}", std::strerror(errno)));
}

void DataInBetween::print(std::string_view text) {
  if (failed_) return;
  try {
    print_data(text);
  } catch (const OutputError&) {
    failed_ = std::current_exception();
  }
}

void DataInBetween::end() const {
  if (failed_) std::rethrow_exception(failed_);
}

void say(std::string_view text) noexcept {
  while (!text.empty()) {
    const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

namespace {

/// A line that is put together piece by piece and written at once, as far as it fits.
class Line {
 public:
  void add(std::string_view text) noexcept {
    for (const char c : text) put(c);
  }
  /// What would end the line, or steer a terminal, is shown as \x0a.
  void add_escaped(std::string_view text) noexcept {
    constexpr std::string_view digits = "0123456789abcdef";
    for (const char c : text) {
      const auto byte = static_cast<unsigned char>(c);
      if (byte >= 0x20 && byte != 0x7F) {
        put(c);
        continue;
      }
      add("\\x");
      put(digits[byte >> 4]);
      put(digits[byte & 15]);
    }
  }
  void flush() noexcept {
    say({buffer_, size_});
    size_ = 0;
  }

 private:
  void put(char c) noexcept {
    if (size_ == sizeof buffer_) flush();
    buffer_[size_++] = c;
  }
  char buffer_[4096];
  std::size_t size_ = 0;
};

}  // namespace

void note(std::string_view kind, std::string_view text) noexcept {
  Line line;
  line.add("superstep: ");
  line.add(kind);
  line.add_escaped(text);
  line.add("\n");
  line.flush();
}

void note(std::string_view text) noexcept {
  note("", text);
}

void warn(const std::vector<std::string>& texts) noexcept {
  for (const auto& text : texts) note("warning: ", text);
}

void prepare_streams() noexcept {
  for (int descriptor = STDIN_FILENO; descriptor <= STDERR_FILENO; ++descriptor)
    if (::fcntl(descriptor, F_GETFD) < 0 && errno == EBADF) {
      // Read only: what is written to it fails, as it does where it is closed.
      const int nowhere = ::open("/dev/null", O_RDONLY);
      if (nowhere >= 0 && nowhere != descriptor) ::close(nowhere);
    }
  for (const int signal : {SIGXFSZ, SIGPIPE}) std::signal(signal, SIG_IGN);
}

}  // namespace superstep
