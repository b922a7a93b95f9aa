/// Kept references: as they are, and with a checksum that fits, so that what stands behind it is read, too.

#include "bench/harness/reference_cache.hpp"
#include "core/hash.hpp"
#include "input_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace superstep;
  const std::string_view body = fuzz::text_of(data, size);
  const fuzz::InputFile plain(body), sealed("SSREF002" + ContentHash().add(body).text() + std::string(body));
  (void)read_cached_reference(plain.path());
  (void)read_cached_reference(sealed.path());
  return 0;
}
