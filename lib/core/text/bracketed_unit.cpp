#include "core/text/bracketed_unit.hpp"

#include "core/text/text_file.hpp"

namespace superstep {

NameAndUnit split_bracketed_unit(std::string_view written) noexcept {
  written = trimmed(written);
  const std::size_t open = written.find_last_of("[(");
  const bool closed = !written.empty() && (written.back() == ']' || written.back() == ')');
  if (!closed || open == std::string_view::npos) return {written, {}};
  return {trimmed(written.substr(0, open)), trimmed(written.substr(open + 1, written.size() - open - 2))};
}

}  // namespace superstep
