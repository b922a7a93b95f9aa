#include "case/inputs/read_inputs.hpp"

#include <fmt/format.h>

#include <numbers>
#include <string>
#include <vector>

#include "case/inputs/read_amount.hpp"
#include "case/selection.hpp"

namespace superstep {
namespace {

constexpr double stefan_boltzmann = 5.670374419e-8;  // W/(m^2 K^4), CODATA 2018
constexpr double suspiciously_cold = 100;            // K
using Notes = std::vector<std::string>;

/// Calls each(particle) for all particles that `where` selects.
template <class Each>
void for_selected(const TomlValue& where, const PackingInput& input, Each each) {
  const auto chosen = select_particles(where, input.scene.packing, input.unit, input.selections);
  for (std::size_t k = 0; k < chosen.size(); ++k)
    if (chosen[k]) each(k);
}

/// The same for what feeds particles. Where all of them are held it does nothing, which `notes` say.
template <class Each>
void for_fed(const TomlValue& where, const PackingInput& input, const Graph& graph, Notes& notes, Each each) {
  bool feeds_one = false;
  for_selected(where, input, [&](std::size_t k) {
    feeds_one = feeds_one || !graph.is_fixed[k];
    each(k);
  });
  if (input.fed)
    input.fed->try_emplace(where.where()).first->second |= feeds_one;
  else if (!feeds_one)
    notes.push_back(feeds_nobody(where.where()));
}

/// Calls each(entry, where) for every table of a list, which must have no other keys than those asked for.
template <class Each>
void for_entries(TomlTable& table, const char* key, Each each) {
  const auto list = table.find(key);
  if (!list) return;
  for (const auto& value : list->array()) {
    TomlTable entry = value.table();
    const auto where = entry.require("where", "it selects particles");
    each(entry, where);
    entry.finish();
  }
}

void read_fixed(TomlTable& table, const PackingInput& input, Graph& graph) {
  for_entries(table, "fixed", [&](TomlTable& entry, const TomlValue& where) {
    const Amount amount = read_amount(entry.require("value", "it is the fixed value"), input.t_end, graph);
    if (amount.table >= 0 && graph.fixed_table.empty()) graph.fixed_table.assign(graph.nodes(), -1);
    for_selected(where, input, [&](std::size_t k) {
      if (graph.is_fixed[k])
        where.reject(
            fmt::format("particle {} is already in an earlier selection; selections must not overlap",
                        input.scene.packing.id[k]));
      graph.is_fixed[k] = 1;
      graph.fixed_value[k] = amount.value;
      if (!graph.fixed_table.empty()) graph.fixed_table[k] = amount.table;
    });
  });
}

void read_sources(TomlTable& table, const PackingInput& input, Graph& graph, Notes& notes) {
  for_entries(table, "source", [&](TomlTable& entry, const TomlValue& where) {
    const Amount amount = read_amount(
        entry.require("value", "it is the source of each selected particle [W or A]"), input.t_end, graph);
    for_fed(where, input, graph, notes, [&](std::size_t k) {
      if (amount.table < 0)
        graph.source[k] += amount.value;
      else
        graph.tabled_sources.push_back({static_cast<std::int32_t>(k), amount.table});
    });
  });
}

double surface_area(double radius) noexcept {
  return 4 * std::numbers::pi * radius * radius;
}

void read_convection(TomlTable& table, const PackingInput& input, Graph& graph, Notes& notes) {
  for_entries(table, "convection", [&](TomlTable& entry, const TomlValue& where) {
    const double coefficient = entry.positive("coefficient", "W/(m2 K)");
    const Amount ambient = read_amount(entry.require("ambient", "it is the temperature of the surroundings"),
                                       input.t_end, graph);
    for_fed(where, input, graph, notes, [&](std::size_t k) {
      graph.convection.push_back({static_cast<std::int32_t>(k),
                                  coefficient * surface_area(input.scene.packing.radius[k]), ambient.value,
                                  ambient.table});
    });
  });
}

/// The fourth power of a temperature means something in kelvin only.
void require_kelvin(const TomlValue& at, double temperature, bool known_to_be_cold, const char* what) {
  if (temperature < 0)
    at.reject(fmt::format("the {} is {} K; radiation needs temperatures >= 0 K", what, temperature));
  if (temperature < suspiciously_cold && !known_to_be_cold)
    at.reject(
        fmt::format("the {} is {}, which looks like degrees Celsius; radiation needs kelvin, or "
                    "kelvin = true beside it if it really is that cold",
                    what, temperature));
}

void require_kelvin_everywhere(const TomlValue& at, const Graph& graph, bool cold, const Amount& ambient) {
  require_kelvin(
      at, ambient.table < 0 ? ambient.value : graph.tables[static_cast<std::size_t>(ambient.table)].lowest(),
      cold, "ambient");
  for (std::size_t k = 0; k < graph.nodes(); ++k) {
    const auto table = graph.fixed_table.empty() ? -1 : graph.fixed_table[k];
    if (!graph.is_fixed[k])
      require_kelvin(at, graph.initial[k], cold, "initial temperature");
    else
      require_kelvin(
          at, table < 0 ? graph.fixed_value[k] : graph.tables[static_cast<std::size_t>(table)].lowest(), cold,
          "fixed temperature");
  }
}

void read_radiation(TomlTable& table, const PackingInput& input, Graph& graph, Notes& notes) {
  constexpr double most = 1 + 1e-12;                      // parts of a surface add up to 1 with roundings
  std::vector<double> emissivity_of(graph.nodes(), 0.0);  // towards all surroundings together
  for_entries(table, "radiation", [&](TomlTable& entry, const TomlValue& where) {
    const auto emissivity = entry.require("emissivity", "it lies between 0 and 1");
    if (!(emissivity.number() >= 0 && emissivity.number() <= 1))
      emissivity.reject("the emissivity must lie between 0 and 1");
    const auto at = entry.require("ambient", "it is the temperature of the surroundings [K]");
    const Amount ambient = read_amount(at, input.t_end, graph);
    const auto kelvin = entry.find("kelvin");
    require_kelvin_everywhere(at, graph, kelvin && kelvin->boolean(), ambient);
    for_fed(where, input, graph, notes, [&](std::size_t k) {
      emissivity_of[k] += emissivity.number();
      if (emissivity_of[k] > most)
        where.reject(fmt::format(
            "particle {} is in an earlier selection, too, and would radiate with an emissivity of "
            "{:.6g}; the emissivities of a particle add up and must not exceed 1",
            input.scene.packing.id[k], emissivity_of[k]));
      graph.radiation.push_back(
          {static_cast<std::int32_t>(k),
           emissivity.number() * stefan_boltzmann * surface_area(input.scene.packing.radius[k]),
           ambient.value, ambient.table});
    });
  });
}

}  // namespace

std::vector<std::string> read_inputs(TomlTable& table, const PackingInput& input, bool thermal,
                                     Graph& graph) {
  Notes notes;
  read_fixed(table, input, graph);
  read_sources(table, input, graph, notes);
  if (!thermal) return notes;
  read_convection(table, input, graph, notes);
  read_radiation(table, input, graph, notes);
  return notes;
}

std::string feeds_nobody(const std::string& place) {
  return place + " selects fixed particles alone, which nothing changes: it does nothing";
}

}  // namespace superstep
