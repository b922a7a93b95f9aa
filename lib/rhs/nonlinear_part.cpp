#include "rhs/nonlinear_part.hpp"

#include <algorithm>
#include <utility>

#include "core/index.hpp"

namespace superstep {
namespace {

/// Nodes that a process knows, by their positions in the whole graph.
class KnownNodes {
 public:
  void add(std::int32_t node) {
    if (node >= 0) nodes_.push_back(node);
  }
  void add(const std::vector<std::int32_t>& nodes) {
    for (const auto node : nodes) add(node);
  }
  void finish() {
    std::sort(nodes_.begin(), nodes_.end());
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
  }
  [[nodiscard]] const std::vector<std::int32_t>& all() const noexcept { return nodes_; }
  /// Its number here; -1 = unknown.
  [[nodiscard]] std::int32_t here(std::int32_t node) const noexcept {
    const auto found = std::lower_bound(nodes_.begin(), nodes_.end(), node);
    const bool known = found != nodes_.end() && *found == node;
    return known ? static_cast<std::int32_t>(found - nodes_.begin()) : -1;
  }

 private:
  std::vector<std::int32_t> nodes_;
};

void add_touched(const Network& part, KnownNodes& nodes) {
  for (const auto* list : {&part.node_of_row, &part.node_of_halo, &part.ghost_node}) nodes.add(*list);
}

/// Calls use(branch) for branches that heat own rows of the temperature.
template <class Use>
void for_own_branches(const NonlinearInput& whole, const Partition& own, const Use& use) {
  const auto& row_of_node = whole.temperature.network.row_of_node;
  const auto is_own = [&](std::int32_t node) {
    const auto row = row_of_node[at(node)];
    return row >= 0 && own.owns(row);
  };
  for (std::size_t k = 0; k < whole.joule->edges(); ++k)
    if (whole.joule->conductance[k] > 0 && (is_own(whole.joule->i[k]) || is_own(whole.joule->j[k]))) use(k);
}

/// Numbers nodes as they are here, and takes of the field what belongs to them.
void localise(const FieldInput& whole, const Partition& own, const KnownNodes& nodes, FieldPart& part) {
  Network& network = part.network.network;
  for (auto* list : {&network.node_of_row, &network.node_of_halo, &network.ghost_node})
    for (auto& node : *list)
      if (node >= 0) node = nodes.here(node);
  network.row_of_node.assign(nodes.all().size(), -1);
  for (std::size_t row = 0; row < network.node_of_row.size(); ++row)
    network.row_of_node[at(network.node_of_row[row])] = static_cast<std::int32_t>(row);

  FieldInput& input = part.input;
  part.rows = own.rows();
  input.pair_step = whole.pair_step;
  input.low = whole.low;
  input.high = whole.high;
  input.laws.of_material = whole.laws.of_material;
  input.laws.mean = whole.laws.mean;
  for (const auto node : nodes.all()) {
    input.laws.material.push_back(whole.laws.material[at(node)]);
    if (!whole.id.empty()) input.id.push_back(whole.id[at(node)]);
  }
  for (auto known : whole.known)
    if (const auto here = nodes.here(known.node); here >= 0) {
      known.node = here;
      input.known.push_back(known);
    }
  std::vector<std::pair<std::int64_t, std::int32_t>> elsewhere;  // row and node
  for (std::size_t k = 0; k < nodes.all().size(); ++k) {
    const std::int64_t row = whole.network.row_of_node[at(nodes.all()[k])];
    if (row >= 0 && !own.owns(row)) elsewhere.emplace_back(row, static_cast<std::int32_t>(k));
  }
  std::sort(elsewhere.begin(), elsewhere.end());
  for (const auto& [row, node] : elsewhere) {
    part.rows_of_nodes.push_back(row);
    input.node_of_halo.push_back(node);
  }
}

void pack_law(const ConductivityLaw& law, Packer& out) {
  out.put(law.kind);
  for (const double number : {law.value, law.coefficient, law.reference, law.amplitude, law.steepness})
    out.put(number);
  out.put(law.temperatures);
  out.put(law.values);
  out.put(law.outside);
  out.put(law.place);
}

void unpack_law(Unpacker& in, ConductivityLaw& law) {
  in.take(law.kind);
  for (double* number : {&law.value, &law.coefficient, &law.reference, &law.amplitude, &law.steepness})
    in.take(*number);
  in.take(law.temperatures);
  in.take(law.values);
  in.take(law.outside);
  in.take(law.place);
}

void pack_field(const FieldPart& part, Packer& out) {
  const FieldInput& input = part.input;
  pack(part.network, out);
  out.put(part.network.network.row_of_node);
  out.put(part.rows);
  out.put(part.rows_of_nodes);
  for (const double number : {input.pair_step, input.low, input.high}) out.put(number);
  out.put(input.known);
  out.put(input.id);
  out.put(input.node_of_halo);
  out.put(input.laws.material);
  out.put(input.laws.mean);
  out.put(input.laws.of_material.size());
  for (const auto& law : input.laws.of_material) pack_law(law, out);
}

void unpack_field(Unpacker& in, FieldPart& part) {
  FieldInput& input = part.input;
  unpack(in, part.network);
  in.take(part.network.network.row_of_node);
  in.take(part.rows);
  in.take(part.rows_of_nodes);
  for (double* number : {&input.pair_step, &input.low, &input.high}) in.take(*number);
  in.take(input.known);
  in.take(input.id);
  in.take(input.node_of_halo);
  in.take(input.laws.material);
  in.take(input.laws.mean);
  input.laws.of_material.resize(in.take<std::size_t>());
  for (auto& law : input.laws.of_material) unpack_law(in, law);
}

FieldInput input_of(FieldPart part, Communicator& among, std::size_t block) {
  const Partition partition(part.rows, among.size(), among.rank(), block);
  part.network.network.halo = std::make_shared<Halo>(among, partition, std::move(part.network.halo));
  part.input.network = std::move(part.network.network);
  part.input.node_halo = std::make_shared<Halo>(among, partition, std::move(part.rows_of_nodes));
  return std::move(part.input);
}

}  // namespace

NonlinearPart part_of(const NonlinearInput& whole, int processes, int rank, std::size_t block) {
  const auto cut = [&](const FieldInput& field) {
    return Partition(static_cast<std::int64_t>(field.network.size()), processes, rank, block);
  };
  NonlinearPart part;
  const Partition own = cut(whole.temperature);
  part.temperature.network = part_of(whole.temperature.network, own);
  KnownNodes nodes;
  add_touched(part.temperature.network.network, nodes);
  if (whole.potential) {
    part.potential.emplace().network = part_of(whole.potential->network, cut(*whole.potential));
    add_touched(part.potential->network.network, nodes);
  }
  if (whole.joule)
    for_own_branches(whole, own, [&](std::size_t k) {
      nodes.add(whole.joule->i[k]);
      nodes.add(whole.joule->j[k]);
    });
  nodes.finish();
  localise(whole.temperature, own, nodes, part.temperature);
  if (whole.potential) localise(*whole.potential, cut(*whole.potential), nodes, *part.potential);
  if (whole.joule) {
    part.joule.emplace();
    for_own_branches(whole, own, [&](std::size_t k) {
      part.joule->i.push_back(nodes.here(whole.joule->i[k]));
      part.joule->j.push_back(nodes.here(whole.joule->j[k]));
      part.joule->conductance.push_back(whole.joule->conductance[k]);
    });
  }
  for (const auto node : nodes.all()) {
    const auto row = whole.temperature.network.row_of_node[at(node)];
    part.order_of_node.push_back(row >= 0 ? row : own.rows() + node);
  }
  return part;
}

void pack(const NonlinearPart& part, Packer& out) {
  pack_field(part.temperature, out);
  out.put(part.potential.has_value());
  if (part.potential) pack_field(*part.potential, out);
  out.put(part.joule.has_value());
  if (part.joule) {
    out.put(part.joule->i);
    out.put(part.joule->j);
    out.put(part.joule->conductance);
  }
  out.put(part.order_of_node);
}

void unpack(Unpacker& in, NonlinearPart& part) {
  unpack_field(in, part.temperature);
  if (in.take<bool>()) unpack_field(in, part.potential.emplace());
  if (in.take<bool>()) {
    auto& joule = part.joule.emplace();
    in.take(joule.i);
    in.take(joule.j);
    in.take(joule.conductance);
  }
  in.take(part.order_of_node);
}

std::unique_ptr<NonlinearRhs> make_rhs(NonlinearPart part, Communicator& among, std::size_t block) {
  NonlinearInput input;
  input.temperature = input_of(std::move(part.temperature), among, block);
  if (part.potential) input.potential = input_of(std::move(*part.potential), among, block);
  if (part.joule) input.joule = &*part.joule;
  input.order_of_node = std::move(part.order_of_node);
  return std::make_unique<NonlinearRhs>(std::move(input));
}

}  // namespace superstep
