#include "bench/app/file_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "bench/app/cli/command_entry.hpp"
#include "core/error.hpp"
#include "core/text/quantity.hpp"
#include "core/text/text_file.hpp"
#include "core/text/toml.hpp"
#include "network/components.hpp"
#include "network/files/recognise_network.hpp"
#include "packing/read.hpp"
#include "results/text/json_numbers.hpp"
#include "results/text/json_object.hpp"

namespace superstep {
namespace {

using Json = nlohmann::ordered_json;

/// A line of the report for people.
std::string row(const std::string& label, const std::string& value) {
  return fmt::format("  {:<34} {}\n", label, value);
}

std::string rows(const std::string& label, const std::vector<std::string>& values) {
  std::string out;
  for (const auto& value : values) out += row(out.empty() ? label : "", value);
  return out;
}

std::string box_words(Vec3 low, Vec3 high) {
  return fmt::format("({:.4g}, {:.4g}, {:.4g}) to ({:.4g}, {:.4g}, {:.4g}) m", low.x, low.y, low.z, high.x,
                     high.y, high.z);
}

std::vector<std::string> names_of(const std::vector<PackingAttribute>& attributes) {
  std::vector<std::string> names;
  for (const auto& one : attributes) names.push_back(one.name);
  return names;
}

/// What a conductivity under a mean gradient is for.
std::string cell_words(const Cell& cell, char axis) {
  const double length = cell.height(static_cast<std::size_t>(axis - 'x'));
  return fmt::format(
      "under a mean gradient over the whole periodic cell: {:.4g} m along {}, cross-section {:.4g} m2",
      length, axis, cell.volume() / length);
}

std::string packing_text(const Packing& packing, const std::string& path,
                         const std::optional<PackingConduction>& conduction) {
  const auto [smallest, largest] = std::minmax_element(packing.radius.begin(), packing.radius.end());
  const Bounds box = surface_bounds(packing);
  std::string out = fmt::format("{}: a packing\n", path);
  out += row("format", packing.format);
  if (!packing.frame.empty()) out += row("read", packing.frame);
  out += row("particles", fmt::format("{}", packing.size()));
  out += row("diameters", fmt::format("{:.4g} to {:.4g} m", 2 * *smallest, 2 * *largest));
  out += row("surfaces reach from", box_words(box.min, box.max));
  if (packing.cell) {
    out +=
        row("cell", box_words(packing.cell->origin, packing.cell->origin + packing.cell->shift({1, 1, 1})));
    out += row("periodic along", packing.cell->periodic_axes());
    if (packing.cell->is_periodic())
      out += row("relative density", fmt::format("{:.4g}", sphere_volume(packing) / packing.cell->volume()));
  }
  if (!packing.material_names.empty())
    out += row("materials", fmt::format("{}", fmt::join(packing.material_names, ", ")));
  if (!packing.attributes.empty())
    out += row("attributes", fmt::format("{}", fmt::join(names_of(packing.attributes), ", ")));
  out += rows("understood", packing.notes);
  out += rows("warning", packing.warnings);
  if (!conduction) return out;
  const auto value = [](const std::optional<double>& k) {
    return k ? fmt::format("{:.6g} W/(m K)", *k) : std::string("-");
  };
  out += "\nConduction\n";
  out += row("mean coordination", fmt::format("{:.4g}", conduction->coordination));
  out += row("components", fmt::format("{}, {} without a contact", conduction->components,
                                       quantity(conduction->isolated, "particle")));
  if (conduction->periodic)
    out += row(fmt::format("effective conductivity along {}", conduction->axis),
               value(conduction->periodic) + ", " + cell_words(*packing.cell, conduction->axis));
  out += row(conduction->periodic ? "" : fmt::format("effective conductivity along {}", conduction->axis),
             value(conduction->between_layers) +
                 (conduction->periodic ? ", cut open, between layers at both ends" : "") +
                 (conduction->note.empty() ? "" : "; " + conduction->note));
  if (!conduction->basis.empty()) out += row("", conduction->basis);
  if (!conduction->passes) return out;
  out += row("heat passes in about", fmt::format("{:g} s", conduction->time));
  out += row("recommended over that time", conduction->method);
  return out;
}

std::string packing_json(const Packing& packing, const std::string& path,
                         const std::optional<PackingConduction>& conduction) {
  const auto [smallest, largest] = std::minmax_element(packing.radius.begin(), packing.radius.end());
  Json out = {{"schema", "superstep.file"},
              {"schema_version", 1},
              {"file", path},
              {"kind", "packing"},
              {"format", packing.format},
              {"frame", packing.frame},
              {"particles", packing.size()},
              {"diameter_min_m", 2 * *smallest},
              {"diameter_max_m", 2 * *largest},
              {"periodic", packing.cell ? packing.cell->periodic_axes() : "none"},
              {"length_unit_m", packing.length_unit},
              {"materials", packing.material_names},
              {"attributes", names_of(packing.attributes)},
              {"notes", packing.notes},
              {"warnings", packing.warnings}};
  if (conduction)
    out["conduction"] = {{"axis", std::string(1, conduction->axis)},
                         {"coordination", conduction->coordination},
                         {"components", conduction->components},
                         {"isolated", conduction->isolated},
                         {"effective_conductivity", optional_number(conduction->between_layers)},
                         {"effective_conductivity_periodic", optional_number(conduction->periodic)},
                         {"length_m", positive_or_null(conduction->length)},
                         {"cross_section_m2", positive_or_null(conduction->area)},
                         {"note", conduction->note},
                         {"transit_time_s", conduction->passes ? Json(conduction->time) : Json(nullptr)},
                         {"recommended", conduction->passes ? Json(conduction->method) : Json(nullptr)}};
  return json_text(out);
}

std::string network_report(const NetworkFile& network, const std::string& path, bool json) {
  const auto& graph = network.input.graph;
  const Components components = connected_components(graph.nodes(), graph.i, graph.j, graph.conductance);
  double low = graph.edges() > 0 ? graph.conductance[0] : 0, high = low;
  for (const double k : graph.conductance) {
    low = std::min(low, k);
    high = std::max(high, k);
  }
  if (json)
    return json_text(Json{{"schema", "superstep.file"},
                          {"schema_version", 1},
                          {"file", path},
                          {"kind", "network"},
                          {"format", network.format},
                          {"nodes", graph.nodes()},
                          {"edges", graph.edges()},
                          {"components", components.count},
                          {"conductance_min", low},
                          {"conductance_max", high},
                          {"notes", network.input.notes}});
  return fmt::format("{}: a network\n", path) + row("format", network.format) +
         row("nodes", fmt::format("{}", graph.nodes())) + row("edges", fmt::format("{}", graph.edges())) +
         row("components", fmt::format("{}", components.count)) +
         row("conductances", fmt::format("{:.4g} to {:.4g} W/K or S", low, high)) +
         row("in a case", fmt::format("[network] {} = \"{}\", with capacity = ...", network.key,
                                      std::filesystem::path(path).filename().string())) +
         rows("understood", network.input.notes);
}

void require_no_options(const FileOptions& options, const std::string& path) {
  if (!options.given.empty())
    throw UsageError(fmt::format("info: {} is about a packing file, and {} is a network; leave it out",
                                 options.given.front(), path));
}

/// What asks how a packing conducts goes with --conductivity.
void require_conductivity(const FileOptions& options) {
  if (options.conductivity) return;
  const GivenOption asking[] = {{options.density.has_value(), "--density"},
                                {options.specific_heat.has_value(), "--specific-heat"},
                                {options.axis != 0, "--axis"},
                                {!options.neck.empty(), "--neck"}};
  refuse_given(
      "info", asking,
      "is about how a packing conducts, which is told with --conductivity; add that, or leave it out");
}

}  // namespace

bool is_no_case(const std::string& path) {
  require_regular_file(path);
  if (std::filesystem::path(path).extension() == ".toml") return false;
  try {
    (void)TomlTable::parse_file(path);
    return false;
  } catch (const InputError&) {
    return true;
  }
}

std::string file_report(const InfoCommand& command) {
  const std::string& path = command.case_file;
  if (recognised_format(path).empty())
    if (const auto network = recognise_network(path)) {
      require_no_options(command.file, path);
      return network_report(*network, path, command.common.json);
    }
  require_conductivity(command.file);
  const Packing packing = read_packing(path, command.file.reading);
  std::optional<PackingConduction> conduction;
  if (command.file.conductivity)
    conduction = assess_conduction(packing, path, starter_settings(packing, command.file, path));
  return command.common.json ? packing_json(packing, path, conduction)
                             : packing_text(packing, path, conduction);
}

}  // namespace superstep
