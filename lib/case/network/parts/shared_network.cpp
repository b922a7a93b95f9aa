#include "case/network/parts/shared_network.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "case/build_rhs.hpp"
#include "case/checks/number_ranges.hpp"
#include "case/checks/skips.hpp"
#include "case/checks/warnings.hpp"
#include "case/inputs/named_file.hpp"
#include "case/network/parts/local_network.hpp"
#include "case/network/parts/node_directory.hpp"
#include "case/network/parts/shared_edges.hpp"
#include "case/network/parts/shared_nodes.hpp"
#include "case/network/read_network_scene.hpp"
#include "case/parts/agreed.hpp"
#include "case/parts/build_in_parts.hpp"
#include "case/parts/own_nodes.hpp"
#include "case/parts/part_clusters.hpp"
#include "case/probe.hpp"
#include "core/index.hpp"
#include "core/memory.hpp"
#include "core/text/ids_in_words.hpp"
#include "network/files/read_network.hpp"
#include "rhs/network_rhs.hpp"

namespace superstep {
namespace {

class NetworkNodes final : public OwnNodes {
 public:
  explicit NetworkNodes(const SharedNodes& shared) : count_(shared.count()) {
    begin = shared.here().begin;
    end = shared.here().end;
    shown_.reserve(shared.own().size());
    for (const auto& node : shared.own()) shown_.push_back({node.id, node.fixed_value, node.is_fixed()});
  }
  [[nodiscard]] std::int64_t nodes() const override { return count_; }
  [[nodiscard]] bool are_spheres() const override { return false; }
  void show(const std::function<void(const ShownNode&)>& each) override {
    for (const auto& node : shown_)
      each({.id = node.id, .is_fixed = node.is_fixed, .fixed_value = node.fixed_value, .centre = {}});
  }

 private:
  struct Shown {
    std::int64_t id;
    double fixed_value;
    bool is_fixed;
  };
  std::int64_t count_;
  std::vector<Shown> shown_;
};

struct Tables {
  RowsInParts nodes, edges;
};

std::optional<Tables> open_tables(TomlTable& network, std::string& why_not) {
  const auto open = [&](const char* key, const std::vector<std::string>& columns) {
    const auto file = network.require(key, "it names a table");
    auto rows =
        read_named_file(file, [&](const std::string& path) { return open_rows(path, columns, why_not); });
    if (!rows) why_not = fmt::format("of {}, {}", file.string(), why_not);
    return rows;
  };
  auto nodes = open("nodes", node_columns());
  if (!nodes) return std::nullopt;
  auto edges = open("edges", edge_columns());
  if (!edges) return std::nullopt;
  return Tables{std::move(*nodes), std::move(*edges)};
}

/// Into a graph that holds the probed nodes alone.
void read_shared_probes(TomlTable& root, const SharedNodes& nodes, Scene& scene, Communicator& among) {
  const auto probe = root.find("probe");
  if (!probe) return;
  FieldScene& field = scene.fields.front();
  const auto by_id = [&](const TomlValue& value) {
    const std::int64_t number = nodes.node_of_id(value.integer(), among);
    if (number < 0) value.reject("it must be the id of a node; " + ids_in_words(0, nodes.count() - 1));
    const SharedNode node = nodes.ask(std::span(&number, 1), among).front();
    add_node(node, field.graph);
    field.row_of_node.push_back(static_cast<std::int32_t>(node.row));
    return Probe{std::to_string(node.id), node.id, static_cast<std::int32_t>(field.graph.nodes()) - 1};
  };
  const auto at_mid_height = [&](const TomlValue& value) -> Probe {
    value.reject("a network without coordinates has no mid-height; give the id of a node");
  };
  scene.probes = read_probes(*probe, {.by_id = by_id, .at_mid_height = at_mid_height});
}

std::uint64_t count_adrift(const SharedNodes& nodes, const LocalNetwork& local, Communicator& among) {
  PartClusters clusters(nodes.here().begin, nodes.here().end);
  clusters.take(local.graph(), nodes.here(), [&](std::size_t k) { return local.number(k); });
  return std::move(clusters).count_adrift(among);
}

void list_skips(const SharedNodes& nodes, const FieldScene& field, Scene& scene) {
  if (const std::int64_t fixed = nodes.count() - nodes.rows().rows(); fixed > 0)
    scene.skips.push_back(fixed_nodes_skip(fixed, ""));
  scene.skips.push_back(order_skip(false));
  scene.skips.push_back(field.name == "potential" ? thermal_skip() : electric_skip());
  scene.skips.push_back(search_skip());
}

}  // namespace

bool can_be_shared_network(const TomlTable& given, std::string& why_not) {
  TomlTable root = given;
  TomlTable network = *root.table("network");
  const auto order = network.find("order");
  if (!order || !order->is_string() || order->string() != "file") return false;
  const auto is_other = [&](const std::string& what) {
    why_not = what;
    return false;
  };
  for (const char* other : {"packing", "material", "materials", "interfaces", "contact", "thermal",
                            "electric", "coupling", "dynamics", "published"})
    if (root.find(other)) return is_other(fmt::format("its case has [{}]", other));
  for (const char* other : {"generator", "matrix", "openpnm", "fixed", "source"})
    if (network.find(other)) return is_other(fmt::format("[network] has {}", other));
  for (const char* table : {"nodes", "edges"})
    if (!network.find(table)) return is_other(fmt::format("[network] has no {}", table));
  return open_tables(network, why_not).has_value();
}

Scene build_shared_network(TomlTable root, Communicator& among) {
  Scene scene;
  read_head(root, scene);
  TomlTable network = *root.table("network");
  scene.fields.push_back(describe_network_field(network));
  FieldScene& field = scene.fields.front();
  std::string why_not;
  std::optional<Tables> tables;
  agreed(among, [&] { tables = open_tables(network, why_not); });
  if (among.any(!tables)) throw NeedsOneReader("its tables change");
  SharedNodes nodes(tables->nodes, among);
  if (nodes.rows().rows() == 0)
    throw InputError(
        fmt::format("{}: every node is fixed, so nothing is left to integrate; free some", scene.file));
  field.components = 1;
  field.view = 0;
  field.low = nodes.low();
  field.high = nodes.high();
  field.origin = origin_of(field.low, field.high);

  std::optional<NodeDirectory> directory(std::in_place, nodes, tables->nodes.path(), among);
  SharedEdges edges = share_edges(tables->edges, nodes, *directory, among);
  directory.reset();
  LocalNetwork local(nodes, edges.own, among);
  std::vector<SharedEdge>().swap(edges.own);
  scene.own_nodes = std::make_shared<NetworkNodes>(nodes);
  scene.own_nodes->edges = static_cast<std::int64_t>(edges.count);
  agreed(among, [&] { require_workable_numbers(scene.file, field, local.graph()); });
  field.adrift_clusters = count_adrift(nodes, local, among);
  read_shared_probes(root, nodes, scene, among);
  list_skips(nodes, field, scene);
  agreed(among, [&] { root.finish(); });

  const double pair_step = among.min(local.pair_step());
  scene.initial = local.initial(field.origin);
  nodes.release();
  give_back_memory();  // of what was read
  NetworkPart part = std::move(local).part(field.origin);
  if (!among.alone()) part.network.halo = std::make_shared<Halo>(among, nodes.rows(), std::move(part.halo));
  give_back_memory();
  constexpr bool keep_network = false;
  scene.rhs =
      std::make_unique<NetworkRhs>(std::move(part.network), field.name, field.unit, pair_step, keep_network);
  if (edges.joined > 0) scene.warnings.push_back(note_of_parallel_edges(tables->edges.path(), edges.joined));
  add_warnings(range_warnings(scene), scene.warnings);
  return scene;
}

}  // namespace superstep
