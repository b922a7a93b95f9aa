/// Nodes and edges: two files, divided by a line "---".

#include "input_file.hpp"
#include "network/graph.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace superstep;
  constexpr std::string_view divider = "\n---\n";
  const std::string_view text = fuzz::text_of(data, size);
  const auto middle = text.find(divider);
  if (middle == std::string_view::npos) return -1;
  const fuzz::InputFile nodes(text.substr(0, middle + 1)), edges(text.substr(middle + divider.size()));
  fuzz::read_or_refuse([&] { (void)read_graph(nodes.path(), edges.path()); });
  return 0;
}
