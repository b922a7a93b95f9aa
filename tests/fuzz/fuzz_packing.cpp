/// Packings in every format there is: the reader tells them apart by what they begin with.

#include "contact/search.hpp"
#include "input_file.hpp"
#include "packing/read.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace superstep;
  const fuzz::InputFile file(fuzz::text_of(data, size));
  fuzz::read_or_refuse([&] { (void)recognised_format(file.path()); });
  fuzz::read_or_refuse([&] {
    const Packing packing = read_packing(file.path());
    (void)find_contacts(packing, 0.0, true);
    fuzz::InputFile again(packing_csv(packing));  // what was read can be written
    (void)again;
  });
  return 0;
}
