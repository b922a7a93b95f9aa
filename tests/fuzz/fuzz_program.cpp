/// Command lines, an argument a line.

#include "bench/app/cli/cli.hpp"
#include "input_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace superstep;
  std::vector<std::string> arguments;
  for (std::string_view rest = fuzz::text_of(data, size); !rest.empty();) {
    const auto end = std::min(rest.find('\n'), rest.size());
    arguments.emplace_back(rest.substr(0, end));
    if (arguments.back().find('\0') != std::string::npos) return -1;  // no shell can pass it
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  fuzz::read_or_refuse([&] { (void)parse_command_line(arguments); });
  return 0;
}
