#include "bench/output/system_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <vector>

#include "bench/output/output_folder.hpp"
#include "case/checks/field_at_state.hpp"
#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "network/files/matrix_market.hpp"
#include "rhs/nonlinear_rhs.hpp"

namespace superstep {
namespace {

/// A graph in which surroundings are nodes.
struct System {
  std::vector<MatrixMarket::Entry> off_diagonal;  ///< row > column
  std::vector<double> diagonal, capacity, source, initial;
  std::vector<std::pair<std::size_t, double>> fixed;  ///< row from 0, value
  std::vector<std::string> name;                      ///< of the rows
  std::vector<std::string> remarks;                   ///< what of the scene it does not hold
};

void join(System& system, std::size_t i, std::size_t j, double conductance) {
  if (!(conductance > 0)) return;
  system.off_diagonal.push_back({static_cast<std::int32_t>(std::max(i, j)),
                                 static_cast<std::int32_t>(std::min(i, j)), -conductance, 0});
  system.diagonal[i] += conductance;
  system.diagonal[j] += conductance;
}

void add_surroundings(const Graph& graph, System& system) {
  std::map<double, std::size_t> row_of;
  for (const auto& exchange : graph.convection) {
    const double ambient = exchange.ambient;
    const auto [entry, is_new] = row_of.try_emplace(ambient, system.name.size());
    if (is_new) {
      system.name.push_back("surroundings");
      system.fixed.push_back({entry->second, ambient});
      for (auto* list : {&system.diagonal, &system.source}) list->push_back(0.0);
      system.capacity.push_back(1.0);
      system.initial.push_back(ambient);
    }
    join(system, static_cast<std::size_t>(exchange.node), entry->second, exchange.coefficient);
  }
}

/// Heat of a current that is not one of the sources: it follows a potential that is stepped, or solved for
/// again.
bool is_heated_by_moving_current(const Scene& scene, const FieldScene& field) {
  const auto* coupled = dynamic_cast<const NonlinearRhs*>(scene.rhs.get());
  return field.name == "temperature" && coupled && coupled->heats();
}

System system_of(const Scene& scene, const FieldScene& field) {
  const FieldAtState start = field_at_start(scene, field);
  const Graph& graph = start.graph;
  if (!graph.radiation.empty())
    throw InputError(fmt::format(
        "{}: radiation is not linear, so that there is no matrix to write; leave it out", scene.file));
  System system;
  system.capacity = field.steady ? std::vector<double>(graph.nodes(), 1.0) : graph.capacity;
  system.source = graph.source;
  system.initial = graph.initial;
  system.diagonal.assign(graph.nodes(), 0.0);
  for (std::size_t node = 0; node < graph.nodes(); ++node) {
    system.name.push_back(std::to_string(graph.id[node]));
    if (graph.is_fixed[node]) system.fixed.push_back({node, graph.fixed_value[node]});
  }
  for (std::size_t k = 0; k < graph.edges(); ++k)
    join(system, static_cast<std::size_t>(graph.i[k]), static_cast<std::size_t>(graph.j[k]),
         graph.conductance[k]);
  add_surroundings(graph, system);
  if (!field.graph.tables.empty()) system.remarks.push_back("inputs that change in time are those at t = 0");
  if (!start.temperatures.empty())
    system.remarks.push_back("conductivities are those of the start, at " + start.temperatures);
  if (field.steady)
    system.remarks.push_back(
        "the case's potential is steady, that of this system's case moves there with capacities of 1 F");
  if (is_heated_by_moving_current(scene, field))
    system.remarks.push_back("the heat of the current is left out, since it follows the potential");
  if (!field.algebraic.empty()) system.remarks.push_back("nodes of capacity 0 are eliminated");
  return system;
}

std::string matrix_text(const System& system, const std::string& comment) {
  auto entries = system.off_diagonal;
  for (std::size_t row = 0; row < system.diagonal.size(); ++row)
    if (system.diagonal[row] != 0)
      entries.push_back(
          {static_cast<std::int32_t>(row), static_cast<std::int32_t>(row), system.diagonal[row], 0});
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
    return std::pair(a.column, a.row) < std::pair(b.column, b.row);
  });
  return matrix_market_text(system.diagonal.size(), entries, comment);
}

std::string case_text(const Scene& scene, const FieldScene& field, const std::string& prefix,
                      const System& system) {
  const auto file = [&](const char* name) { return fmt::format("\"{}{}\"", prefix, name); };
  std::string out = fmt::format(
      "title = \"{} of {}\"\n{}t_end = {}\noutput_times = [{}]\n\n[network]\nmatrix = {}\nmatrix_kind = "
      "\"laplacian\"\nfield = \"{}\"\ncapacity = {}\nsource = {}\ninitial = {}\n",
      field.name, scene.name,
      system.remarks.empty() ? "" : fmt::format("# {}\n", fmt::join(system.remarks, "; ")), scene.t_end,
      fmt::join(scene.output_times, ", "), file("K.mtx"), field.name, file("capacity.mtx"),
      file("source.mtx"), file("initial.mtx"));
  if (!system.fixed.empty()) out += fmt::format("fixed = {}\n", file("fixed.csv"));
  return out;
}

}  // namespace

std::vector<std::string> write_system(const std::string& folder, const Scene& scene) {
  std::vector<System> systems;
  for (const auto& field : scene.fields) systems.push_back(system_of(scene, field));
  require_writable_folder(folder);
  std::vector<std::string> warnings;
  for (std::size_t f = 0; f < systems.size(); ++f) {
    const FieldScene& field = scene.fields[f];
    const System& system = systems[f];
    const std::string prefix = scene.fields.size() > 1 ? field.name + "_" : "";
    std::string comment =
        fmt::format("{} of {}: C dX/dt = -K X + Y, rows of fixed.csv are known", field.name, scene.name);
    for (const auto& remark : system.remarks) {
      comment += "; " + remark;
      warnings.push_back(fmt::format("the system of the {}: {}", field.name, remark));
    }
    const auto write = [&](const char* name, const std::string& text) {
      write_file_atomically(fmt::format("{}/{}{}", folder, prefix, name), text);
    };
    write("K.mtx", matrix_text(system, comment));
    write("capacity.mtx", matrix_market_text(system.capacity, comment));
    write("source.mtx", matrix_market_text(system.source, comment));
    write("initial.mtx", matrix_market_text(system.initial, comment));
    std::string fixed = "id,value\n", nodes = "row,id\n";
    for (const auto& [row, value] : system.fixed) fixed += fmt::format("{},{}\n", row + 1, value);
    for (std::size_t row = 0; row < system.name.size(); ++row)
      nodes += fmt::format("{},{}\n", row + 1, system.name[row]);
    if (!system.fixed.empty()) write("fixed.csv", fixed);
    write("nodes.csv", nodes);
    write("case.toml", case_text(scene, field, prefix, system));
  }
  return warnings;
}

}  // namespace superstep
