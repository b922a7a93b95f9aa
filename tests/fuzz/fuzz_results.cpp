/// results.json as the report reads it, and as the gate reads a baseline.

#include "input_file.hpp"
#include "reports/gate/results_file.hpp"
#include "results/results_json.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace superstep;
  const fuzz::InputFile file(fuzz::text_of(data, size));
  fuzz::read_or_refuse([&] { (void)read_results_json(file.path()); });
  fuzz::read_or_refuse([&] { (void)read_run_json(file.path()); });
  fuzz::read_or_refuse([&] { (void)read_results(file.path()); });
  return 0;
}
