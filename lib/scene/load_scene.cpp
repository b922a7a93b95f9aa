#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/error.hpp"
#include "core/toml.hpp"
#include "rhs/network_rhs.hpp"
#include "scene/materials.hpp"
#include "scene/probe.hpp"
#include "scene/read_field.hpp"
#include "scene/read_packing_scene.hpp"
#include "scene/roles.hpp"
#include "scene/scene.hpp"
#include "scene/warnings.hpp"

namespace superstep {
namespace {

void read_times(TomlTable& root, Scene& scene) {
  scene.t_end = root.positive("t_end", "s");
  scene.output_times = {scene.t_end};
  const auto times = root.find("output_times");
  if (!times) return;
  scene.output_times = times->numbers();
  double previous = 0;
  for (const double t : scene.output_times) {
    if (!(t > previous)) times->reject("the times must be > 0 and ascending [s]");
    previous = t;
  }
  if (scene.output_times.empty() || scene.output_times.back() > scene.t_end)
    times->reject(fmt::format("there must be at least one time, and none after t_end = {}", scene.t_end));
  if (scene.output_times.back() < scene.t_end) scene.output_times.push_back(scene.t_end);
}

void read_bench(TomlTable& root, Scene& scene) {
  auto bench = root.table("bench");
  if (!bench) return;
  if (const auto baseline = bench->string("baseline")) scene.bench.baseline = *baseline;
  if (const auto integrators = bench->find("integrators")) scene.bench.integrators = integrators->strings();
}

void read_published(TomlTable& root, Scene& scene) {
  static const std::vector<std::string> figures = {"particles",  "relative_density", "effective_conductivity",
                                                   "lambda_max", "lambda_min",       "critical_step",
                                                   "pair_step",  "alpha_star"};
  auto published = root.table("published");
  if (!published) return;
  for (const auto& figure : figures)
    if (const auto value = published->number(figure)) scene.published[figure] = *value;
}

void read_direct_network(TomlTable& root, TomlTable& network, Scene& scene) {
  for (const char* other : {"packing", "material", "materials", "contact", "thermal", "electric"})
    if (const auto value = root.find(other))
      value->reject("a case with [network] gives nodes and edges directly; remove this, or remove [network]");
  FieldScene field;
  const auto name = network.string("field").value_or("temperature");
  if (name != "temperature" && name != "potential")
    network.require("field", "").reject("it must be \"temperature\" or \"potential\"");
  const FieldKind& kind = name == "potential" ? electric_kind() : thermal_kind();
  field.name = kind.name;
  field.unit = kind.unit;
  const auto nodes =
      network.require("nodes", "it names a CSV with id,capacity,source,initial,fixed").string();
  const auto edges = network.require("edges", "it names a CSV with i,j,conductance").string();
  field.graph = read_graph(beside_case(root.file(), nodes), beside_case(root.file(), edges));
  field.bare = field.graph.conductance;
  scene.fields.push_back(std::move(field));
}

void read_particles(TomlTable& root, Scene& scene) {
  auto thermal = root.table("thermal"), electric = root.table("electric");
  if (thermal && electric)
    throw InputError(
        fmt::format("{}: a case with [thermal] and [electric] needs coupling, which this version does not "
                    "offer; keep one of them",
                    electric->where()));
  if (!thermal && !electric)
    throw InputError(fmt::format("{}: neither [thermal] nor [electric] is there; give one field to integrate",
                                 root.where()));
  PackingInput input = read_packing_scene(root);
  Materials materials(root, input.scene.packing);
  if (thermal) {
    scene.fields.push_back(read_field(thermal_kind(), *thermal, input, materials));
  } else {
    if (const auto mode = electric->find("mode"); mode && mode->string() != "transient")
      mode->reject("it must be \"transient\"");
    scene.fields.push_back(read_field(electric_kind(), *electric, input, materials));
  }
  scene.packed = std::move(input.scene);
}

/// Range of everything that the field starts from or is held at.
void set_range(FieldScene& field) {
  bool first = true;
  for (std::size_t node = 0; node < field.graph.nodes(); ++node) {
    const double value =
        field.graph.is_fixed[node] ? field.graph.fixed_value[node] : field.graph.initial[node];
    field.low = first ? value : std::min(field.low, value);
    field.high = first ? value : std::max(field.high, value);
    first = false;
  }
}

void build_rhs(const std::string& where, Scene& scene) {
  auto& field = scene.fields.front();
  RoleReport report = assign_roles(field.graph, where);
  field.roles = std::move(report.roles);
  field.components = report.components;
  field.idle_clusters = report.idle_clusters;
  field.floating_clusters = report.floating;
  set_range(field);
  Network network = build_network(field.graph, field.roles);
  for (const auto node : network.node_of_row)
    scene.initial.push_back(field.graph.initial[static_cast<std::size_t>(node)]);
  field.row_of_node = network.row_of_node;
  const double pair_step = min_pair_step(field.graph, field.roles, field.bare);
  scene.rhs = std::make_unique<NetworkRhs>(std::move(network), field.name, field.unit, pair_step);
}

void list_skips(Scene& scene) {
  const auto& field = scene.fields.front();
  const auto count = [&](NodeRole role) { return std::count(field.roles.begin(), field.roles.end(), role); };
  if (const auto fixed = count(NodeRole::fixed); fixed > 0)
    scene.skips.push_back({fmt::format("{} fixed nodes", fixed), "their values are known"});
  if (field.idle_clusters > 0)
    scene.skips.push_back({fmt::format("{} nodes in {} clusters", count(NodeRole::idle), field.idle_clusters),
                           "their values are uniform and nothing acts on them"});
  const bool thermal = field.name == "temperature";
  scene.skips.push_back({thermal ? "electric field" : "temperature field",
                         thermal ? "the case has no [electric]" : "the case has no [thermal]"});
  if (!scene.packed) scene.skips.push_back({"neighbour search and necks", "the network is given directly"});
}

}  // namespace

Scene load_scene(const std::string& path) {
  TomlTable root = TomlTable::parse_file(path);
  Scene scene;
  scene.file = path;
  scene.name = std::filesystem::path(path).stem().string();
  scene.title = root.string("title").value_or(scene.name);
  scene.source = root.string("source").value_or("");
  read_times(root, scene);
  read_bench(root, scene);
  read_published(root, scene);
  const auto probe = root.find("probe");
  if (auto network = root.table("network"))
    read_direct_network(root, *network, scene);
  else
    read_particles(root, scene);
  root.finish();
  build_rhs(path, scene);
  if (probe) scene.probes = read_probes(*probe, scene);
  list_skips(scene);
  scene.warnings = range_warnings(scene);
  for (const auto& field : scene.fields)
    scene.warnings.insert(scene.warnings.end(), field.warnings.begin(), field.warnings.end());
  return scene;
}

std::vector<double> Scene::values_on_nodes(std::size_t field, std::span<const double> state) const {
  const auto& graph = fields[field].graph;
  std::vector<double> values(graph.nodes());
  for (std::size_t node = 0; node < values.size(); ++node) {
    const auto entry = entry_of_node(field, static_cast<std::int32_t>(node));
    values[node] = entry >= 0             ? state[static_cast<std::size_t>(entry)]
                   : graph.is_fixed[node] ? graph.fixed_value[node]
                                          : graph.initial[node];
  }
  return values;
}

std::ptrdiff_t Scene::entry_of_node(std::size_t field, std::int32_t node) const {
  const auto row = fields[field].row_of_node[static_cast<std::size_t>(node)];
  if (row < 0) return -1;
  const auto& view = rhs->fields()[field];
  return static_cast<std::ptrdiff_t>(view.offset + static_cast<std::size_t>(row) * view.stride);
}

}  // namespace superstep
