/// A folder of results, read as `report` does and made a page of.

#include "input_folder.hpp"
#include "reports/html/report_html.hpp"
#include "reports/html/report_input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace superstep;
  const fuzz::InputFolder folder(fuzz::text_of(data, size), "results.json");
  fuzz::read_or_refuse([&] { (void)report_html(read_report_input(folder.path())); });
  return 0;
}
