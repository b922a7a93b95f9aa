#include "case/read_inputs.hpp"

#include <fmt/format.h>

#include <numbers>

#include "case/selection.hpp"

namespace superstep {
namespace {

constexpr double stefan_boltzmann = 5.670374419e-8;  // W/(m^2 K^4), CODATA 2018
constexpr double suspiciously_cold = 100;            // K

/// Two equal neighbours are a step; a third value at the same instant would have no meaning.
void require_ascending(const TomlValue& times, const std::vector<double>& time) {
  for (std::size_t k = 1; k < time.size(); ++k) {
    if (time[k] < time[k - 1])
      times.reject(fmt::format("the times must be ascending, and {} follows {}", time[k], time[k - 1]));
    if (k > 1 && time[k] == time[k - 2])
      times.reject(fmt::format(
          "{} stands three times; the times must be ascending, and a step is two equal times with the value "
          "before it and the value after it",
          time[k]));
  }
}

}  // namespace

Amount read_amount(const TomlValue& amount, Graph& graph) {
  if (!amount.is_table()) return {amount.number(), -1};
  TomlTable table = amount.table();
  const auto times = table.require("times", "it lists instants, ascending [s]");
  const auto values = table.require("values", "it lists the value at each instant");
  TimeTable out{times.numbers(), values.numbers()};
  table.finish();
  if (out.time.empty()) times.reject("a table needs at least one instant");
  if (out.value.size() != out.time.size()) values.reject("there must be as many values as times");
  require_ascending(times, out.time);
  graph.tables.push_back(std::move(out));
  return {graph.tables.back().at(0), static_cast<std::int32_t>(graph.tables.size()) - 1};
}

namespace {

/// Calls each(particle) for all particles that `where` selects.
template <class Each>
void for_selected(const TomlValue& where, const Packing& packing, double unit, Each each) {
  const auto chosen = select_particles(where, packing, unit);
  for (std::size_t k = 0; k < chosen.size(); ++k)
    if (chosen[k]) each(k);
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

void read_fixed(TomlTable& table, const Packing& packing, double unit, Graph& graph) {
  for_entries(table, "fixed", [&](TomlTable& entry, const TomlValue& where) {
    const Amount amount = read_amount(entry.require("value", "it is the fixed value"), graph);
    if (amount.table >= 0 && graph.fixed_table.empty()) graph.fixed_table.assign(graph.nodes(), -1);
    for_selected(where, packing, unit, [&](std::size_t k) {
      if (graph.is_fixed[k])
        where.reject(fmt::format(
            "particle {} is already in an earlier selection; selections must not overlap", packing.id[k]));
      graph.is_fixed[k] = 1;
      graph.fixed_value[k] = amount.value;
      if (!graph.fixed_table.empty()) graph.fixed_table[k] = amount.table;
    });
  });
}

void read_sources(TomlTable& table, const Packing& packing, double unit, Graph& graph) {
  for_entries(table, "source", [&](TomlTable& entry, const TomlValue& where) {
    const Amount amount =
        read_amount(entry.require("value", "it is the source of each selected particle [W or A]"), graph);
    for_selected(where, packing, unit, [&](std::size_t k) {
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

void read_convection(TomlTable& table, const Packing& packing, double unit, Graph& graph) {
  for_entries(table, "convection", [&](TomlTable& entry, const TomlValue& where) {
    const double coefficient = entry.positive("coefficient", "W/(m2 K)");
    const Amount ambient =
        read_amount(entry.require("ambient", "it is the temperature of the surroundings"), graph);
    for_selected(where, packing, unit, [&](std::size_t k) {
      graph.convection.push_back({static_cast<std::int32_t>(k), coefficient * surface_area(packing.radius[k]),
                                  ambient.value, ambient.table});
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

void read_radiation(TomlTable& table, const Packing& packing, double unit, Graph& graph) {
  for_entries(table, "radiation", [&](TomlTable& entry, const TomlValue& where) {
    const auto emissivity = entry.require("emissivity", "it lies between 0 and 1");
    if (!(emissivity.number() >= 0 && emissivity.number() <= 1))
      emissivity.reject("the emissivity must lie between 0 and 1");
    const auto at = entry.require("ambient", "it is the temperature of the surroundings [K]");
    const Amount ambient = read_amount(at, graph);
    const auto kelvin = entry.find("kelvin");
    require_kelvin_everywhere(at, graph, kelvin && kelvin->boolean(), ambient);
    for_selected(where, packing, unit, [&](std::size_t k) {
      graph.radiation.push_back({static_cast<std::int32_t>(k),
                                 emissivity.number() * stefan_boltzmann * surface_area(packing.radius[k]),
                                 ambient.value, ambient.table});
    });
  });
}

}  // namespace

void read_inputs(TomlTable& table, const Packing& packing, double unit, bool thermal, Graph& graph) {
  read_fixed(table, packing, unit, graph);
  read_sources(table, packing, unit, graph);
  if (!thermal) return;
  read_convection(table, packing, unit, graph);
  read_radiation(table, packing, unit, graph);
}

}  // namespace superstep
