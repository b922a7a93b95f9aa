#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "network/files/pores.hpp"
#include "packing/formats/vtk/vtk_xml.hpp"

namespace superstep {
namespace {

/// The array that is called `name`, or without `kind` ("pore."): it stands among those of its kind.
const VtkArray& need(const std::string& file, const std::vector<VtkArray>& arrays, const std::string& name,
                     const std::string& kind, const char* place) {
  std::vector<std::string> names;
  std::string known;
  for (const auto& array : arrays) {
    names.push_back(array.components == 1 ? array.name : "");
    known += (known.empty() ? "" : ", ") + array.name;
  }
  auto found = find_name(names, name, file);
  if (!found && name.starts_with(kind)) found = find_name(names, name.substr(kind.size()), file);
  if (!found)
    throw InputError(fmt::format("{}: there is no array '{}' among the data of {}; it has {}", file, name,
                                 place, known.empty() ? "none" : known));
  return arrays[*found];
}

/// Arrays of noughts and ones, by the names that a case calls them.
void add_labels(const std::vector<VtkArray>& arrays, PoreNetwork& network) {
  for (const auto& array : arrays) {
    const bool label = array.components == 1 && std::all_of(array.value.begin(), array.value.end(),
                                                            [](double x) { return x == 0 || x == 1; });
    if (!label) continue;
    const std::string name = with_dots(array.name);
    const auto at = name.rfind("pore.");
    auto& [own, members] = network.labels.emplace_back();
    own = at == std::string::npos ? "pore." + name : name.substr(at);
    for (const double x : array.value) members.push_back(x == 1 ? 1 : 0);
  }
}

}  // namespace

PoreNetwork pores_of_vtk(const std::string& file, const std::string& text, const std::string& conductance,
                         const std::string& capacity) {
  const VtkPoints vtk = read_vtk_xml(file, text, true);
  const auto& conducts = need(file, vtk.lines_data, conductance, "throat.", "lines").value;
  std::vector<Pore> pores(vtk.points.size() / 3);
  if (!capacity.empty()) {
    const auto& capacities = need(file, vtk.data, capacity, "pore.", "points").value;
    for (std::size_t k = 0; k < pores.size(); ++k) pores[k].capacity = capacities[k];
  }
  std::vector<Throat> throats(conducts.size());
  for (std::size_t k = 0; k < throats.size(); ++k)
    throats[k] = {.i = vtk.lines[2 * k], .j = vtk.lines[2 * k + 1], .conductance = conducts[k]};
  PoreNetwork network;
  add_labels(vtk.data, network);
  join_pores(file, pores, throats, network);
  return network;
}

}  // namespace superstep
