#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "network/files/pores.hpp"
#include "packing/formats/vtk/vtk_xml.hpp"

namespace superstep {
namespace {

/// "net | property | pore | diameter" as "net.property.pore.diameter".
std::string with_dots(std::string name) {
  for (const std::string bar : {" | ", "|"})
    for (std::size_t at = name.find(bar); at != std::string::npos; at = name.find(bar, at))
      name.replace(at, bar.size(), ".");
  return name;
}

/// The array that is called `name`, with or without what comes before it, or without `kind` ("pore.").
const VtkArray& need(const std::string& file, const std::vector<VtkArray>& arrays, const std::string& name,
                     const std::string& kind, const char* place) {
  const auto named = [&](const std::string& wanted) {
    return std::find_if(arrays.begin(), arrays.end(), [&](const VtkArray& array) {
      const std::string own = with_dots(array.name);
      return array.components == 1 && (own == wanted || own.ends_with("." + wanted));
    });
  };
  auto found = named(name);
  if (found == arrays.end() && name.starts_with(kind)) found = named(name.substr(kind.size()));
  if (found != arrays.end()) return *found;
  std::string known;
  for (const auto& array : arrays) known += (known.empty() ? "" : ", ") + array.name;
  throw InputError(fmt::format("{}: there is no array '{}' among the data of {}; it has {}", file, name,
                               place, known.empty() ? "none" : known));
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
  std::vector<double> capacities(vtk.points.size() / 3, 1.0);
  if (!capacity.empty()) capacities = need(file, vtk.data, capacity, "pore.", "points").value;
  std::vector<Throat> throats(conducts.size());
  for (std::size_t k = 0; k < throats.size(); ++k)
    throats[k] = {.i = vtk.lines[2 * k], .j = vtk.lines[2 * k + 1], .conductance = conducts[k]};
  PoreNetwork network;
  add_labels(vtk.data, network);
  join_pores(file, capacities, throats, network);
  return network;
}

}  // namespace superstep
