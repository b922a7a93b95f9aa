/// Case files, moving particles included. Files that they name are not there, except /dev/null.

#include "case/case.hpp"
#include "core/text/toml.hpp"
#include "input_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace superstep;
  const std::string text(fuzz::text_of(data, size));
  // A generator that is asked for a million particles takes as long as it says.
  if (text.find("generator") != std::string::npos || text.find("count") != std::string::npos) return -1;
  fuzz::read_or_refuse([&] { (void)load_case(TomlTable::parse_text(text, "case.toml")); });
  return 0;
}
