#include "case/layers/layered_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "case/build_rhs.hpp"
#include "case/checks/number_ranges.hpp"
#include "case/checks/skips.hpp"
#include "case/checks/warnings.hpp"
#include "case/inputs/read_inputs.hpp"
#include "case/layers/layer_assembly.hpp"
#include "case/layers/layer_counts.hpp"
#include "case/layers/layer_probes.hpp"
#include "case/packed/packing_options.hpp"
#include "case/parts/agreed.hpp"
#include "case/parts/part_clusters.hpp"
#include "core/index.hpp"
#include "core/memory.hpp"
#include "network/network_in_order.hpp"
#include "rhs/network_rhs.hpp"

namespace superstep {
namespace {

std::vector<NodeRole> roles_of(const Graph& graph) {
  std::vector<NodeRole> roles(graph.nodes());  // spheres that all touch are one cluster: nobody is idle
  for (std::size_t k = 0; k < roles.size(); ++k)
    roles[k] = graph.is_fixed[k] ? NodeRole::fixed : NodeRole::free;
  return roles;
}

/// What is found while the own layers are read.
struct OwnLayers {
  double pair_step = std::numeric_limits<double>::infinity();
  std::uint64_t edges = 0, limited_necks = 0;
  std::optional<PartClusters> clusters;  ///< where there may be several
};

/// A contact is its first sphere's. Of nodes before `first` and from `end` on others count, or an earlier or
/// later stretch does.
void count_contacts(const ReadLayers& read, const LayeredNodes& nodes, std::int64_t first, std::int64_t end,
                    OwnLayers& own) {
  first = std::max(first, nodes.begin);
  end = std::min(end, nodes.end);
  const Contacts& contacts = read.packed.contacts;
  const auto& radius = read.packed.packing.radius;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const std::int64_t node = contacts.i[k] + read.first_node;
    if (node < first || node >= end) continue;
    ++own.edges;
    if (contacts.neck_radius[k] >= std::min(radius[at(contacts.i[k])], radius[at(contacts.j[k])]))
      ++own.limited_necks;
  }
}

void read_own_layers(const Partition& partition, double origin, LayeredNodes& nodes, LayerAssembly& assembly,
                     OwnLayers& own, Scene& scene) {
  const LayerSource& source = nodes.source();
  nodes.for_stretches([&](std::int64_t first, std::int64_t last) {
    const std::int64_t from = std::max<std::int64_t>(0, first - 1), to = std::min(last + 1, source.layers());
    const ReadLayers read = nodes.reader().read(from, to, true);
    count_contacts(read, nodes, source.nodes_before(first), source.nodes_before(last), own);
    if (own.clusters)
      own.clusters->take(read.field.graph, {source.nodes_before(first), source.nodes_before(last)},
                         [&](std::size_t k) { return static_cast<std::int64_t>(k) + read.first_node; });
    const FieldScene& field = read.field;
    require_workable_numbers(scene.file, field, field.graph);
    const auto roles = roles_of(field.graph);
    own.pair_step = std::min(own.pair_step, min_pair_step(field.graph, roles, field.bare_conductance()));
    std::vector<std::int32_t> order(field.graph.nodes());
    std::iota(order.begin(), order.end(), 0);
    assembly.take(build_network_in_order(field.graph, roles, origin, order), nodes.rows_before[at(from)],
                  read.first_node, nodes.rows_before[at(first)], nodes.rows_before[at(last)]);
    std::int64_t row = nodes.rows_before[at(from)], node = read.first_node;
    for (std::size_t k = 0; k < roles.size(); ++k, ++node) {
      if (roles[k] != NodeRole::free) continue;
      if (partition.owns(row) && node >= source.nodes_before(first) && node < source.nodes_before(last))
        scene.initial.push_back(field.graph.initial[k] - origin);
      ++row;
    }
  });
}

/// As of the whole scene.
void list_warnings(const LayeredNodes& nodes, const LayerFacts& facts, std::uint64_t limited_necks,
                   Scene& scene) {
  const Packing sample = nodes.source().sample();
  const auto [smallest, largest] = std::minmax_element(sample.radius.begin(), sample.radius.end());
  scene.warnings = packing_warnings({.smallest_radius = *smallest,
                                     .largest_radius = *largest,
                                     .particles = at(nodes.source().nodes()),
                                     .contacts = at(nodes.edges),
                                     .limited_necks = limited_necks});
  add_warnings(range_warnings(scene), scene.warnings);
  add_warnings(scene.fields.front().warnings, scene.warnings);
  for (const auto& place : facts.feeding_nobody) scene.warnings.push_back(feeds_nobody(place));
}

void list_skips(const LayerFacts& facts, Scene& scene) {
  if (facts.fixed > 0) scene.skips.push_back(fixed_nodes_skip(facts.fixed, ""));
  scene.skips.push_back(order_skip(true));
  scene.skips.push_back(electric_skip());
  if (!facts.convects) scene.skips.push_back(convection_skip());
  if (!facts.radiates) scene.skips.push_back(radiation_skip());
}

/// A field without its nodes.
FieldScene describe_field(LayeredNodes& nodes, const LayerFacts& facts) {
  FieldScene field = nodes.reader().read_sample(false).field;
  field.graph = {};
  field.laws.material.clear();
  field.components = 1;
  field.floating_clusters = facts.fixed == 0 ? 1 : 0;
  field.view = 0;
  field.low = facts.low;
  field.high = facts.high;
  if (!facts.radiates) field.origin = origin_of(field.low, field.high);
  return field;
}

}  // namespace

void LayeredNodes::show(const std::function<void(const ShownNode&)>& each) {
  for_stretches([&](std::int64_t first, std::int64_t last) {
    const ReadLayers read = reader_.read(first, last, false);
    const Packing& packing = read.packed.packing;
    const Graph& graph = read.field.graph;
    for (std::size_t k = 0; k < packing.size(); ++k) {
      const std::int64_t node = read.first_node + static_cast<std::int64_t>(k);
      if (node >= begin && node < end)
        each({packing.id[k], graph.is_fixed[k] != 0, graph.fixed_value[k], packing.centre[k],
              packing.radius[k]});
    }
  });
}

bool can_be_layered(const TomlTable& given, std::string& why_not) {
  TomlTable root = given;
  auto packing = root.table("packing"), contact = root.table("contact"), thermal = root.table("thermal");
  const auto is_other = [&](const std::string& what) {
    if (packing && read_packing_options(*packing).in_layers) why_not = what;
    return false;
  };
  if (!packing || !contact || !thermal) return is_other("its case has no [thermal]");
  for (const char* other :
       {"electric", "network", "materials", "interfaces", "dynamics", "coupling", "published"})
    if (root.find(other)) return is_other(fmt::format("its case has [{}]", other));
  for (const char* other : {"container", "periodic", "box"})
    if (packing->find(other)) return is_other(fmt::format("[packing] has {}", other));
  for (const char* other : {"gap", "bonds", "bond_radius", "file"})
    if (contact->find(other)) return is_other(fmt::format("[contact] has {}", other));
  if (thermal->find("initial") && thermal->find("initial")->is_table())
    return is_other("temperatures begin as a column says");
  auto source = find_layer_source(*packing, why_not);
  if (!source) return false;
  LayerReader reader(root, std::move(source));
  const FieldScene field = reader.read_sample(false).field;
  if (!field.graph.tables.empty() || field.laws.of_material.front().varies())
    return is_other("inputs follow tables of time, or conductivities the temperature");
  return true;
}

Scene build_in_layers(TomlTable root, Communicator& among) {
  std::string why_not;
  auto packing = root.table("packing");
  LayerReader reader(root, find_layer_source(*packing, why_not));
  Scene scene;
  static_cast<CaseHead&>(scene) = reader.head();
  const auto own_nodes = std::make_shared<LayeredNodes>(std::move(reader));
  scene.own_nodes = own_nodes;
  LayeredNodes& nodes = *own_nodes;
  LayerSource& source = nodes.source();
  source.share(among);
  const LayerFacts facts = count_layers(nodes, among);
  if (nodes.rows() == 0)
    throw InputError(
        fmt::format("{}: every node is fixed, so nothing is left to integrate; free some", scene.file));
  scene.fields.push_back(describe_field(nodes, facts));
  FieldScene& field = scene.fields.front();

  const Partition partition(nodes.rows(), among.size(), among.rank(), block_rows());
  nodes.begin = node_of_row(nodes, partition.begin(), among);
  nodes.end = node_of_row(nodes, partition.end(), among);
  const auto [first, last] = nodes.layers_around();
  source.bring(first, last, among);
  LayerAssembly assembly(partition, source.usual_contacts());
  scene.initial.reserve(partition.owned());
  OwnLayers own;
  if (!source.is_one_cluster()) own.clusters.emplace(nodes.begin, nodes.end);
  agreed(among, [&] {
    read_own_layers(partition, field.origin, nodes, assembly, own, scene);
    if (nodes.begin == nodes.end) (void)nodes.reader().read_sample(true);  // its mistakes are everybody's
  });
  const bool is_closed = facts.fixed == 0 && !facts.radiates && !facts.convects;
  field.adrift_clusters = own.clusters ? std::move(*own.clusters).count_adrift(among) : is_closed ? 1 : 0;
  own.clusters.reset();
  NetworkPart part = std::move(assembly).finish();
  part.network.origin = field.origin;
  part.network.halo = std::make_shared<Halo>(among, partition, std::move(part.halo));
  nodes.edges = static_cast<std::int64_t>(among.sum(own.edges));
  const double pair_step = among.min(own.pair_step);
  give_back_memory();  // of the layers that were read
  constexpr bool keep_network = false;
  scene.rhs =
      std::make_unique<NetworkRhs>(std::move(part.network), field.name, field.unit, pair_step, keep_network);

  const std::uint64_t limited = among.sum(own.limited_necks);
  read_layer_probes(nodes, scene, among);
  source.bring(first, last, among);  // files of results are made of them
  source.release();
  agreed(among, [&] { nodes.reader().root().finish(); });
  list_warnings(nodes, facts, limited, scene);
  list_skips(facts, scene);
  return scene;
}

}  // namespace superstep
