#include "bench/host/terminal.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
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
  const bool written =
      std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (!written) throw OutputError(fmt::format("standard output cannot be written: {}", std::strerror(errno)));
}

void note(const std::string& text) {
  fmt::print(stderr, "superstep: {}\n", text);
}

void warn(const std::vector<std::string>& texts) {
  for (const auto& text : texts) note("warning: " + text);
}

}  // namespace superstep
