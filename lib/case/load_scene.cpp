#include <fmt/format.h>

#include "case/build_rhs.hpp"
#include "case/checks/law_ranges.hpp"
#include "case/checks/number_ranges.hpp"
#include "case/checks/warnings.hpp"
#include "case/materials.hpp"
#include "case/memory/case_data.hpp"
#include "case/network/read_network_scene.hpp"
#include "case/packed/assign_materials.hpp"
#include "case/parts/own_nodes.hpp"
#include "case/probe.hpp"
#include "case/read_field.hpp"
#include "case/read_packing_scene.hpp"
#include "case/scene.hpp"
#include "core/error.hpp"
#include "core/index.hpp"
#include "core/text/toml.hpp"

namespace superstep {
namespace {

constexpr double default_settle_tolerance = 1e-9;
constexpr double default_resolve_change = 1e-6;

/// A misspelt table is said first: what follows would only miss it.
void require_known_tables(TomlTable& root) {
  for (const char* key :
       {"title", "source", "t_end", "output_times", "probe", "bench", "corpus", "published", "network",
        "packing", "contact", "material", "materials", "interfaces", "thermal", "electric", "coupling"})
    (void)root.find(key);
  root.finish();
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

bool is_steady(TomlTable& electric) {
  const auto mode = electric.find("mode");
  if (!mode) return false;
  const std::string name = mode->string();
  if (name != "transient" && name != "steady") mode->reject("it must be \"transient\" or \"steady\"");
  return name == "steady";
}

double tolerance(TomlTable& table, const char* key, double fallback) {
  const auto value = table.find(key);
  if (!value) return fallback;
  if (!(value->number() >= 0 && value->number() < 1)) value->reject("it must be >= 0 and < 1");
  return value->number();
}

Coupling read_coupling(TomlTable& root, bool both_fields) {
  Coupling coupling{.joule_heat = both_fields};
  const auto value = root.find("coupling");
  if (!value) return coupling;
  if (!both_fields) value->reject("there is something to couple only with [thermal] and [electric]");
  TomlTable table = value->table();
  if (const auto joule_heat = table.find("joule_heat")) coupling.joule_heat = joule_heat->boolean();
  table.finish();
  return coupling;
}

void require_temperature(const TomlTable& electric, const FieldScene& potential) {
  for (const auto& law : potential.laws.of_material)
    if (law.varies())
      throw InputError(fmt::format(
          "{}: the conductivity follows temperature, and the case has no [thermal]; add it, or give a number",
          electric.where()));
}

Coupling read_particles(TomlTable& root, Scene& scene, const SphereArrays* spheres) {
  auto thermal = root.table("thermal"), electric = root.table("electric");
  if (!thermal && !electric)
    root.missing("thermal", "neither [thermal] nor [electric] is there; give one field to integrate");
  PackingInput input = read_packing_scene(root, spheres);
  input.t_end = scene.t_end;
  assign_materials(root, input.unit, input.scene.packing);
  Materials materials(root, input.scene.packing);
  Coupling coupling = read_coupling(root, thermal && electric);
  if (electric) {
    const bool steady = is_steady(*electric);
    coupling.settle_tolerance = tolerance(*electric, "settle_tolerance", default_settle_tolerance);
    coupling.resolve_change = tolerance(*electric, "resolve_change", default_resolve_change);
    scene.fields.push_back(read_field(electric_kind(), *electric, input, materials, steady));
    if (!thermal) require_temperature(*electric, scene.fields.back());
    if (!thermal && steady && !scene.fields.back().graph.tables.empty())
      throw InputError(fmt::format(
          "{}: a steady potential alone has one solution, so that nothing in it can follow a table of time; "
          "give numbers, or choose mode = \"transient\"",
          electric->where()));
  }
  if (thermal) scene.fields.push_back(read_field(thermal_kind(), *thermal, input, materials, false));
  scene.packed = std::move(input.scene);
  return coupling;
}

}  // namespace

Scene load_scene(const std::string& path) {
  return load_scene(TomlTable::parse_file(path));
}

Scene load_scene(TomlTable root) {
  return load_scene(std::move(root), CaseData{});
}

Scene load_scene(TomlTable root, const CaseData& data) {
  Scene scene;
  require_known_tables(root);
  read_head(root, scene);
  read_published(root, scene);
  const auto probe = root.find("probe");
  Coupling coupling;
  auto network = root.table("network");
  if (network ? data.spheres.has_value() : data.network.has_value())
    throw InputError(
        fmt::format("{}: there are {} in memory, and the case has {} [network]; leave one of the two out",
                    root.where(), network ? "particles" : "nodes and edges", network ? "a" : "no"));
  if (network)
    read_network_scene(root, *network, scene, data.network ? &*data.network : nullptr);
  else
    coupling = read_particles(root, scene, data.spheres ? &*data.spheres : nullptr);
  root.finish();
  require_workable_numbers(scene);
  require_laws_to_hold(scene);
  build_rhs(scene.file, coupling, scene);
  if (probe) scene.probes = read_probes(*probe, scene);
  add_warnings(range_warnings(scene), scene.warnings);
  if (scene.packed && !scene.packed->packing.frame.empty())
    scene.warnings.push_back(fmt::format("the packing is {} of its file", scene.packed->packing.frame));
  if (scene.packed) add_warnings(scene.packed->packing.warnings, scene.warnings);
  for (const auto& field : scene.fields) add_warnings(field.warnings, scene.warnings);
  return scene;
}

std::size_t Scene::nodes() const noexcept {
  return own_nodes ? at(own_nodes->nodes()) : fields.front().graph.nodes();
}

std::size_t Scene::edges() const noexcept {
  return own_nodes ? at(own_nodes->edges) : fields.front().graph.edges();
}

bool Scene::has_places() const noexcept {
  return packed || (own_nodes && own_nodes->are_spheres());
}

std::vector<double> Scene::values_on_nodes(std::size_t field, double t, std::span<const double> state) const {
  if (fields[field].steady) return steady_values(field, t, state);
  const auto& graph = fields[field].graph;
  std::vector<double> values(graph.nodes());
  for (std::size_t node = 0; node < values.size(); ++node) {
    const auto entry = entry_of_node(field, static_cast<std::int32_t>(node));
    values[node] = entry >= 0             ? state[static_cast<std::size_t>(entry)] + fields[field].origin
                   : graph.is_fixed[node] ? graph.fixed_at(node, t)
                                          : graph.initial[node];
  }
  recover_algebraic_values(fields[field].algebraic, graph, t, values);
  return values;
}

std::vector<double> Scene::steady_values(std::size_t field, double t, std::span<const double> state) const {
  if (!moving_potential) return steady_potential;
  const auto& graph = fields[field].graph;
  const auto rows = moving_potential->steady_potential(t, state);
  std::vector<double> values(graph.nodes());
  for (std::size_t node = 0; node < values.size(); ++node) {
    const auto row = fields[field].row_of_node[node];
    values[node] = row >= 0               ? rows[static_cast<std::size_t>(row)]
                   : graph.is_fixed[node] ? graph.fixed_at(node, t)
                                          : graph.initial[node];
  }
  return values;
}

std::ptrdiff_t Scene::entry_of_node(std::size_t field, std::int32_t node) const {
  const auto& described = fields[field];
  const auto row = described.row_of_node[static_cast<std::size_t>(node)];
  if (row < 0 || described.view < 0) return -1;
  const auto& view = rhs->fields()[static_cast<std::size_t>(described.view)];
  return static_cast<std::ptrdiff_t>(view.offset + static_cast<std::size_t>(row) * view.stride);
}

}  // namespace superstep
