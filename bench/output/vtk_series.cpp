#include "bench/output/vtk_series.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "case/checks/field_at_state.hpp"
#include "core/error.hpp"

namespace superstep {
namespace {

std::vector<double> flux(const Graph& graph, const std::vector<double>& values) {
  std::vector<double> out(graph.edges());
  for (std::size_t e = 0; e < out.size(); ++e)
    out[e] = graph.conductance[e] *
             (values[static_cast<std::size_t>(graph.i[e])] - values[static_cast<std::size_t>(graph.j[e])]);
  return out;
}

const Scene& with_packing(const Scene& scene) {
  require_packing(scene, "--vtk");
  return scene;
}

}  // namespace

void require_packing(const Scene& scene, const std::string& option) {
  if (scene.has_places()) return;
  throw InputError(
      fmt::format("{}: {} needs particles with positions, and this case gives its network directly; leave "
                  "{} out",
                  scene.file, option, option));
}

VtkSeries::VtkSeries(const Scene& scene, const std::string& folder)
    : scene_(with_packing(scene)), folder_(folder), frames_(folder) {
  add(0.0, scene.initial);
}

void VtkSeries::add(double t, std::span<const double> state) {
  if (scene_.own_nodes) return frames_.add_shared(t);
  frames_.add(particles(t, state), contacts(t, state));
}

std::string VtkSeries::folder_of_pieces() const {
  return scene_.own_nodes ? folder_ : "";
}

VtkPolyData VtkSeries::particles(double t, std::span<const double> state) const {
  const Packing& packing = scene_.packed->packing;
  VtkPolyData data{.points = packing.centre, .lines = {}, .point_data = {}, .cell_data = {}, .time = t};
  data.point_data.push_back({"id", packing.id});
  data.point_data.push_back({"radius", packing.radius});
  for (std::size_t f = 0; f < scene_.fields.size(); ++f)
    data.point_data.push_back({scene_.fields[f].name, scene_.values_on_nodes(f, t, state)});
  return data;
}

VtkPolyData VtkSeries::contacts(double t, std::span<const double> state) const {
  const Contacts& pairs = scene_.packed->contacts;
  VtkPolyData data{
      .points = scene_.packed->packing.centre, .lines = {}, .point_data = {}, .cell_data = {}, .time = t};
  for (std::size_t c = 0; c < pairs.size(); ++c) data.lines.emplace_back(pairs.i[c], pairs.j[c]);
  data.cell_data.push_back({"overlap", pairs.overlap});
  data.cell_data.push_back({"neck_radius", pairs.neck_radius});
  for (std::size_t f = 0; f < scene_.fields.size(); ++f) {
    const FieldScene& field = scene_.fields[f];
    if (field.graph.i != pairs.i || field.graph.j != pairs.j)
      throw std::logic_error("the edges of field '" + field.name + "' are not the contacts of the packing");
    const Graph now = field_at(scene_, field, t, state).graph;
    data.cell_data.push_back({"flux_" + field.name, flux(now, scene_.values_on_nodes(f, t, state))});
    data.cell_data.push_back({"conductance_" + field.name, now.conductance});
  }
  if (data.lines.empty()) data.cell_data.clear();  // loose particles: vertices without values
  return data;
}

}  // namespace superstep
