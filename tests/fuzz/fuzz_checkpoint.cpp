/// Checkpoints: as they are, and with a checksum that fits, so that what stands behind it is read, too.

#include <algorithm>

#include "core/hash.hpp"
#include "input_file.hpp"
#include "integrators/press/checkpoint.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace superstep;
  const std::string_view body = fuzz::text_of(data, size);
  static const std::string empty = dynamics::checkpoint_image({});
  const std::string magic = empty.substr(0, empty.find('\n') + 1);
  const fuzz::InputFile plain(body), sealed(magic + ContentHash().add(body).text() + std::string(body));
  fuzz::read_or_refuse([&] { (void)dynamics::read_checkpoint(plain.path()); });
  fuzz::read_or_refuse([&] { (void)dynamics::read_checkpoint(sealed.path()); });
  return 0;
}
