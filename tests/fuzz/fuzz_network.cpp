/// Nodes and edges: two files, divided by a line "---"; the first as a matrix, a pore network and a vector,
/// too.

#include "input_file.hpp"
#include "network/files/matrix_market.hpp"
#include "network/files/read_network.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace superstep;
  constexpr std::string_view divider = "\n---\n";
  const std::string_view text = fuzz::text_of(data, size);
  const auto middle = text.find(divider);
  if (middle == std::string_view::npos) return -1;
  const fuzz::InputFile nodes(text.substr(0, middle + 1)), edges(text.substr(middle + divider.size()));
  fuzz::read_or_refuse([&] { (void)read_nodes_and_edges(nodes.path(), edges.path()); });
  fuzz::read_or_refuse([&] { (void)read_edge_list(edges.path()); });
  fuzz::read_or_refuse([&] { (void)read_matrix_network(nodes.path(), MatrixKind::automatic, 0.0); });
  fuzz::read_or_refuse([&] { (void)read_openpnm(nodes.path(), "throat.k", "pore.volume"); });
  return 0;
}
