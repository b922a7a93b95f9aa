#include "case/read_field.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "case/checks/warnings.hpp"
#include "case/inputs/read_initial.hpp"
#include "case/inputs/read_inputs.hpp"
#include "contact/conductance.hpp"
#include "core/error.hpp"
#include "core/index.hpp"
#include "core/memory.hpp"

namespace superstep {
namespace {

void set_capacities(const Packing& packing, const Materials& materials, const FieldMaterials& field,
                    Graph& graph) {
  graph.capacity.reserve(packing.size());
  for (std::size_t k = 0; k < packing.size(); ++k) {
    const double radius = packing.radius[k];
    const double mass =
        materials.density(packing.material[k]) * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
    graph.capacity.push_back(mass *
                             field.of_material[static_cast<std::size_t>(packing.material[k])].capacity);
  }
}

void set_conductances(const PackingInput& input, const FieldMaterials& field, FieldScene& scene) {
  const auto& packing = input.scene.packing;
  const auto& contacts = input.scene.contacts;
  auto& graph = scene.graph;
  graph.i = contacts.i;
  graph.j = contacts.j;
  graph.conductance.reserve(contacts.size());
  scene.bare.reserve(contacts.size());
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const auto i = static_cast<std::size_t>(contacts.i[k]), j = static_cast<std::size_t>(contacts.j[k]);
    const auto a = packing.material[i], b = packing.material[j];
    const double kappa_i = field.of_material[static_cast<std::size_t>(a)].conductivity.value;
    const double kappa_j = field.of_material[static_cast<std::size_t>(b)].conductivity.value;
    const double neck = contacts.neck_radius[k];
    if (input.pipe) {
      const double distance = norm(branch(packing, contacts, k));
      graph.conductance.push_back(pipe_conductance(kappa_i, kappa_j, neck, distance));
      scene.bare.push_back(graph.conductance.back());
    } else {
      graph.conductance.push_back(series_conductance(kappa_i, kappa_j, neck, field.interface(a, b)));
      scene.bare.push_back(series_conductance(kappa_i, kappa_j, neck, Interface{}));
    }
  }
  if (scene.bare == graph.conductance) free_list(scene.bare);  // nothing lies between particles
}

/// Who gives absolute temperatures around a packing means some for its start, too.
void warn_of_cold_start(FieldScene& scene) {
  constexpr double far = 100;  // K
  const Graph& graph = scene.graph;
  double furthest = 0;
  const auto take = [&](double value) {
    if (std::abs(value) > std::abs(furthest)) furthest = value;
  };
  for (std::size_t node = 0; node < graph.nodes(); ++node)
    if (graph.is_fixed[node]) take(graph.fixed_at(node, 0));
  for (const auto* exchanges : {&graph.convection, &graph.radiation})
    for (const auto& exchange : *exchanges)
      take(exchange.table < 0 ? exchange.ambient : graph.tables[at(exchange.table)].at(0));
  if (std::abs(furthest) > far)
    scene.warnings.push_back(fmt::format(
        "[thermal] initial is left out, so that the run begins at 0 K, and something is held at {:g} K, or "
        "surrounded by it; give initial",
        furthest));
}

/// A pipe leads from centre to centre, and has no halves that a layer could lie between.
void refuse_layers(TomlTable& table, const FieldMaterials& field) {
  constexpr const char* why =
      "a layer lies in series between two halves, and [contact] conductance is \"pipe\", which has none; "
      "leave the layer out, or take conductance = \"series\"";
  if (const auto layer = table.find("grain_boundary")) layer->reject(why);
  if (!field.between.empty()) throw InputError(fmt::format("{}: {}", field.place, why));
}

}  // namespace

const FieldKind& thermal_kind() {
  static const FieldKind kind{"thermal", "temperature", "K", "specific_heat"};
  return kind;
}

const FieldKind& electric_kind() {
  static const FieldKind kind{"electric", "potential", "V", "specific_capacity"};
  return kind;
}

FieldScene read_field(const FieldKind& kind, TomlTable& table, const PackingInput& input,
                      Materials& materials, bool steady) {
  const auto& packing = input.scene.packing;
  FieldScene scene;
  scene.name = kind.name;
  scene.unit = kind.unit;
  scene.steady = steady;
  scene.in_order = packing.in_order;
  const FieldMaterials field = materials.field(kind.table, table, steady ? "" : kind.capacity_key);
  if (input.pipe) refuse_layers(table, field);
  scene.warnings = material_warnings(kind, field, materials);
  scene.laws.material = packing.material;
  scene.laws.mean = input.pipe ? ConductanceMean::arithmetic : ConductanceMean::harmonic;
  for (const auto& conduction : field.of_material) scene.laws.of_material.push_back(conduction.conductivity);
  auto& graph = scene.graph;
  graph.id = packing.id;
  graph.source.assign(packing.size(), 0.0);
  graph.initial = read_initial(table, graph.id, &packing, kind.unit);
  graph.fixed_value.assign(packing.size(), 0.0);
  graph.is_fixed.assign(packing.size(), 0);
  set_capacities(packing, materials, field, graph);
  set_conductances(input, field, scene);
  const bool thermal = kind.name == thermal_kind().name;
  const auto about_inputs = read_inputs(table, input, thermal, graph);
  if (thermal && !table.find("initial")) warn_of_cold_start(scene);
  add_warnings(about_inputs, scene.warnings);
  return scene;
}

}  // namespace superstep
