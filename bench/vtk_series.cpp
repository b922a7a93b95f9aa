#include "bench/vtk_series.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

#include "bench/output_folder.hpp"
#include "core/atomic_file.hpp"
#include "core/error.hpp"

namespace superstep {
namespace {

namespace fs = std::filesystem;

std::vector<double> flux(const Graph& graph, const std::vector<double>& values) {
  std::vector<double> out(graph.edges());
  for (std::size_t e = 0; e < out.size(); ++e)
    out[e] = graph.conductance[e] *
             (values[static_cast<std::size_t>(graph.i[e])] - values[static_cast<std::size_t>(graph.j[e])]);
  return out;
}

}  // namespace

// Only files that a series has: the folder may hold what the user put there.
void remove_vtk_series(const std::string& folder) noexcept {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder + "/vtk", ignored)) {
    const std::string name = entry.path().filename().string(), extension = entry.path().extension().string();
    const bool ours = name.starts_with("particles") || name.starts_with("contacts");
    if (ours && (extension == ".vtp" || extension == ".pvd")) remove_stale_file(entry.path().string());
  }
}

void require_packing(const Scene& scene, const std::string& option) {
  if (scene.packed) return;
  throw InputError(
      fmt::format("{}: {} needs particles with positions, and this case gives its network directly; leave "
                  "{} out",
                  scene.file, option, option));
}

VtkSeries::VtkSeries(const Scene& scene, const std::string& folder) : scene_(scene), folder_(folder) {
  require_packing(scene, "--vtk");
  require_writable_folder(folder_ + "/vtk");
  remove_vtk_series(folder_);
  add(0.0, scene.initial);
}

void VtkSeries::add(double t, std::span<const double> state) {
  const std::string particles = fmt::format("particles_{:04}.vtp", particles_.size());
  const std::string contacts = fmt::format("contacts_{:04}.vtp", contacts_.size());
  write_particles(t, state, folder_ + "/vtk/" + particles);
  write_contacts(t, state, folder_ + "/vtk/" + contacts);
  particles_.push_back({t, particles});
  contacts_.push_back({t, contacts});
}

std::vector<std::string> VtkSeries::finish() const {
  write_file_atomically(folder_ + "/vtk/particles.pvd", pvd_text(particles_));
  write_file_atomically(folder_ + "/vtk/contacts.pvd", pvd_text(contacts_));
  return {"vtk/particles.pvd", "vtk/contacts.pvd"};
}

void VtkSeries::write_particles(double t, std::span<const double> state, const std::string& file) const {
  const Packing& packing = scene_.packed->packing;
  VtkPolyData data{.points = packing.centre, .lines = {}, .point_data = {}, .cell_data = {}, .time = t};
  data.point_data.push_back({"id", packing.id});
  data.point_data.push_back({"radius", packing.radius});
  for (std::size_t f = 0; f < scene_.fields.size(); ++f)
    data.point_data.push_back({scene_.fields[f].name, scene_.values_on_nodes(f, t, state)});
  write_file_atomically(file, vtp_text(data));
}

void VtkSeries::write_contacts(double t, std::span<const double> state, const std::string& file) const {
  const Contacts& contacts = scene_.packed->contacts;
  VtkPolyData data{
      .points = scene_.packed->packing.centre, .lines = {}, .point_data = {}, .cell_data = {}, .time = t};
  for (std::size_t c = 0; c < contacts.size(); ++c) data.lines.emplace_back(contacts.i[c], contacts.j[c]);
  data.cell_data.push_back({"overlap", contacts.overlap});
  data.cell_data.push_back({"neck_radius", contacts.neck_radius});
  for (std::size_t f = 0; f < scene_.fields.size(); ++f) {
    const FieldScene& field = scene_.fields[f];
    if (field.graph.i != contacts.i || field.graph.j != contacts.j)
      throw std::logic_error("the edges of field '" + field.name + "' are not the contacts of the packing");
    data.cell_data.push_back({"conductance_" + field.name, field.graph.conductance});
    data.cell_data.push_back({"flux_" + field.name, flux(field.graph, scene_.values_on_nodes(f, t, state))});
  }
  if (data.lines.empty()) data.cell_data.clear();  // loose particles: vertices without values
  write_file_atomically(file, vtp_text(data));
}

}  // namespace superstep
