/// Packings in every format there is: the reader tells them apart by what they begin with.

#include "contact/search.hpp"
#include "input_file.hpp"
#include "packing/read.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace superstep;
  const fuzz::InputFile file(fuzz::text_of(data, size));
  fuzz::read_or_refuse([&] { (void)stated_length_unit(file.path()); });
  fuzz::read_or_refuse([&] { (void)find_contacts(read_packing(file.path(), 1e-3)); });
  return 0;
}
