#include "case/layers/layered_scene.hpp"

#include <fmt/format.h>

#include <limits>
#include <numeric>
#include <utility>

#include "case/checks/number_ranges.hpp"
#include "case/checks/skips.hpp"
#include "case/checks/warnings.hpp"
#include "case/layers/layer_assembly.hpp"
#include "case/layers/layer_counts.hpp"
#include "case/layers/layer_probes.hpp"
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

/// Neighbours that a sphere can have: those within one diameter.
std::size_t most_neighbours(const Lattice& lattice) {
  const double reach = lattice.diameter / lattice.spacing, squared = reach * reach;
  std::size_t count = 0;
  for (int k = 0; k < 27; ++k) {
    const int x = k % 3 - 1, y = k / 3 % 3 - 1, z = k / 9 - 1, distance = x * x + y * y + z * z;
    if (distance > 0 && distance < squared) ++count;
  }
  return count;
}

/// What is found while the own layers are read.
struct OwnLayers {
  double pair_step = std::numeric_limits<double>::infinity();
  std::uint64_t edges = 0, limited_necks = 0;
};

/// A contact is its first sphere's. Of nodes before `first` and from `end` on others count, or an earlier or
/// later stretch does.
void count_contacts(const ReadLayers& read, const LayeredNodes& nodes, std::int64_t first, std::int64_t end,
                    OwnLayers& own) {
  first = std::max(first, nodes.begin);
  end = std::min(end, nodes.end);
  const Contacts& contacts = read.packed.contacts;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const std::int64_t node = contacts.i[k] + read.first_node();
    if (node < first || node >= end) continue;
    ++own.edges;
    if (contacts.neck_radius[k] >= 0.5 * nodes.lattice().diameter) ++own.limited_necks;
  }
}

void read_own_layers(const Partition& partition, double origin, LayeredNodes& nodes, LayerAssembly& assembly,
                     OwnLayers& own, Scene& scene) {
  const Lattice& lattice = nodes.lattice();
  nodes.for_stretches([&](std::int64_t first, std::int64_t last) {
    const std::int64_t from = std::max<std::int64_t>(0, first - 1), to = std::min(last + 1, lattice.cells[2]);
    ReadLayers read = nodes.reader().read(from, to, true);
    const std::int64_t first_node = read.first_node();
    count_contacts(read, nodes, first * lattice.layer(), last * lattice.layer(), own);
    Scene checked;
    checked.file = scene.file;
    checked.output_times = scene.output_times;
    checked.fields.push_back(std::move(read.field));
    require_workable_numbers(checked);
    const FieldScene& field = checked.fields.front();
    const auto roles = roles_of(field.graph);
    own.pair_step = std::min(own.pair_step, min_pair_step(field.graph, roles, field.bare_conductance()));
    std::vector<std::int32_t> order(field.graph.nodes());
    std::iota(order.begin(), order.end(), 0);
    assembly.take(build_network_in_order(field.graph, roles, origin, order), nodes.rows_before[at(from)],
                  first_node, nodes.rows_before[at(first)], nodes.rows_before[at(last)]);
    for (std::size_t k = 0, row = at(nodes.rows_before[at(from)]); k < roles.size(); ++k) {
      if (roles[k] != NodeRole::free) continue;
      const auto layer = static_cast<std::int64_t>(k) / lattice.layer() + from;
      if (partition.owns(static_cast<std::int64_t>(row)) && layer >= first && layer < last)
        scene.initial.push_back(field.graph.initial[k] - origin);
      ++row;
    }
  });
}

void list_warnings(const LayeredNodes& nodes, const LayerFacts& facts, std::uint64_t limited_necks,
                   Scene& scene) {
  Scene one;  // a single sphere says what there is to say about all
  one.packed.emplace().packing = lattice_layers({{1, 1, 1}, 1, nodes.lattice().diameter}, 0, 1);
  scene.warnings = range_warnings(one);
  if (limited_necks > 0) scene.warnings.push_back(limited_necks_warning(limited_necks, at(nodes.edges)));
  if (facts.fixed == 0 && !facts.radiates && !facts.convects)
    scene.warnings.push_back(floating_warning(1, scene.fields.front().name));
}

void list_skips(const LayerFacts& facts, Scene& scene) {
  if (facts.fixed > 0) scene.skips.push_back(fixed_nodes_skip(facts.fixed, ""));
  scene.skips.push_back({"another order of the rows", "neighbours in a lattice stand near each other"});
  scene.skips.push_back(electric_skip());
  if (!facts.convects) scene.skips.push_back(convection_skip());
  if (!facts.radiates) scene.skips.push_back(radiation_skip());
}

/// A field without its nodes, as a single layer describes it.
FieldScene describe_field(LayeredNodes& nodes, const LayerFacts& facts) {
  FieldScene field = nodes.reader().read(0, 1, false).field;
  field.graph = {};
  field.laws.material.clear();
  field.components = 1;
  field.floating_clusters = facts.fixed == 0 ? 1 : 0;
  field.view = 0;
  field.low = facts.low;
  field.high = facts.high;
  if (!facts.radiates) field.origin = field.low > 0 ? field.low : std::min(field.high, 0.0);
  return field;
}

}  // namespace

bool can_be_layered(const TomlTable& given) {
  TomlTable root = given;
  auto packing = root.table("packing"), contact = root.table("contact"), thermal = root.table("thermal");
  if (!packing || !contact || !thermal) return false;
  for (const char* other :
       {"electric", "network", "materials", "interfaces", "dynamics", "coupling", "published"})
    if (root.find(other)) return false;
  const auto generator = packing->find("generator");
  if (!generator || generator->string() != "lattice" || packing->find("file")) return false;
  for (const char* other : {"container", "units", "periodic", "box", "format", "atom_style", "columns"})
    if (packing->find(other)) return false;
  for (const char* other : {"gap", "bonds", "bond_radius", "file"})
    if (contact->find(other)) return false;
  if (thermal->find("initial") && thermal->find("initial")->is_table()) return false;
  LayerReader reader(root);
  const Lattice& lattice = reader.lattice();
  const bool touch = lattice.diameter > lattice.spacing && lattice.diameter < 2 * lattice.spacing;
  if (!touch) return false;
  const FieldScene field = reader.read(0, 1, false).field;
  return field.graph.tables.empty() && !field.laws.of_material.front().varies();
}

Scene build_in_layers(TomlTable root, Communicator& among) {
  LayerReader reader(std::move(root));
  Scene scene;
  static_cast<CaseHead&>(scene) = reader.head();
  scene.layers = std::make_shared<LayeredNodes>(std::move(reader));
  LayeredNodes& nodes = *scene.layers;
  const LayerFacts facts = count_layers(nodes, among);
  if (nodes.rows() == 0)
    throw InputError(
        fmt::format("{}: every node is fixed, so nothing is left to integrate; free some", scene.file));
  scene.fields.push_back(describe_field(nodes, facts));
  const FieldScene& field = scene.fields.front();

  const Partition partition(nodes.rows(), among.size(), among.rank(), block_rows());
  nodes.begin = node_of_row(nodes, partition.begin());
  nodes.end = node_of_row(nodes, partition.end());
  LayerAssembly assembly(partition, most_neighbours(nodes.lattice()));
  scene.initial.reserve(partition.owned());
  OwnLayers own;
  agreed(among, [&] {
    read_own_layers(partition, field.origin, nodes, assembly, own, scene);
    if (nodes.begin == nodes.end) (void)nodes.reader().read(0, 1, true);  // its mistakes are everybody's
  });
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
  agreed(among, [&] {
    read_layer_probes(nodes, scene);
    nodes.reader().root().finish();
  });
  list_warnings(nodes, facts, limited, scene);
  add_warnings(field.warnings, scene.warnings);
  list_skips(facts, scene);
  return scene;
}

}  // namespace superstep
