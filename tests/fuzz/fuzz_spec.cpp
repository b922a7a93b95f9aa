/// SPECs of integrators.

#include "input_file.hpp"
#include "integrators/registry.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace superstep;
  fuzz::read_or_refuse([&] { (void)make_integrator(std::string(fuzz::text_of(data, size))); });
  return 0;
}
