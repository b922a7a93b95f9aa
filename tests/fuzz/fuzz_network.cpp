/// Nodes and edges: two files, divided by a line "---"; the first as a matrix, a pore network and a vector,
/// too.

#include "input_file.hpp"
#include "network/files/matrix_market.hpp"
#include "network/files/network_rows.hpp"
#include "network/files/read_network.hpp"

namespace superstep {
namespace {

constexpr std::uint64_t parts = 3;

std::uint64_t begin_of(std::uint64_t part, const RowsInParts& table) {
  return table.bytes() * part / parts;
}

/// What was read as a whole is there in parts, too.
void read_in_parts(const std::string& nodes_file, const std::string& edges_file, const Graph& whole) {
  std::string why_not;
  if (const auto nodes = open_rows(nodes_file, node_columns(), why_not)) {
    std::size_t next = 0;
    for (std::uint64_t part = 0; part < parts; ++part)
      for (const auto& node : nodes_of_part(*nodes, begin_of(part, *nodes), begin_of(part + 1, *nodes))) {
        fuzz::require(next < whole.nodes() && node.id == whole.id[next]);
        fuzz::require(node.capacity == whole.capacity[next] && node.initial == whole.initial[next]);
        fuzz::require(node.fixed.has_value() == (whole.is_fixed[next] != 0));
        ++next;
      }
    fuzz::require(next == whole.nodes());
  }
  if (const auto edges = open_rows(edges_file, edge_columns(), why_not)) {
    std::size_t count = 0;
    for (std::uint64_t part = 0; part < parts; ++part)
      count += edges_of_part(*edges, begin_of(part, *edges), begin_of(part + 1, *edges)).size();
    fuzz::require(count >= whole.edges());  // those that run parallel are joined
  }
}

}  // namespace
}  // namespace superstep

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace superstep;
  constexpr std::string_view divider = "\n---\n";
  const std::string_view text = fuzz::text_of(data, size);
  const auto middle = text.find(divider);
  if (middle == std::string_view::npos) return -1;
  const fuzz::InputFile nodes(text.substr(0, middle + 1)), edges(text.substr(middle + divider.size()));
  std::optional<NetworkInput> whole;
  fuzz::read_or_refuse([&] { whole = read_nodes_and_edges(nodes.path(), edges.path()); });
  if (whole) read_in_parts(nodes.path(), edges.path(), whole->graph);
  fuzz::read_or_refuse([&] { (void)read_edge_list(edges.path()); });
  fuzz::read_or_refuse([&] { (void)read_matrix_network(nodes.path(), MatrixKind::automatic, 0.0); });
  fuzz::read_or_refuse([&] { (void)read_openpnm(nodes.path(), "throat.k", "pore.volume"); });
  return 0;
}
