#include "core/text/append.hpp"

#include <iterator>

namespace superstep {

void append_formatted(std::string& out, fmt::string_view format, fmt::format_args arguments) {
  fmt::vformat_to(std::back_inserter(out), format, arguments);
}

}  // namespace superstep
