#include "bench/press/sintering_vtk.hpp"

#include "dynamics/current.hpp"
#include "dynamics/heat.hpp"

namespace superstep {
namespace {

using dynamics::CurrentModel;
using Points = std::span<const dynamics::ContactPoint>;

/// conductance_<field> and flux_<field> of all contacts.
template <class Conductance>
void add_flow(VtkPolyData& data, const std::string& field, const Points& contacts,
              const std::vector<double>& values, Conductance conductance_of) {
  std::vector<double> conductance, flux;
  for (const auto& contact : contacts) {
    conductance.push_back(conductance_of(contact));
    flux.push_back(conductance.back() * (values[static_cast<std::size_t>(contact.i)] -
                                         values[static_cast<std::size_t>(contact.j)]));
  }
  data.cell_data.push_back({"conductance_" + field, std::move(conductance)});
  data.cell_data.push_back({"flux_" + field, std::move(flux)});
}

}  // namespace

VtkPolyData sintering_particles(const Press& one, const dynamics::State& state) {
  VtkPolyData data{
      .points = state.position, .lines = {}, .point_data = {}, .cell_data = {}, .time = state.time};
  data.point_data = {{"id", one.particles.id},
                     {"radius", one.particles.radius},
                     {"temperature", state.temperature},
                     {"velocity", state.velocity}};
  const auto model = one.model.electric.model;
  if (model != CurrentModel::none)
    data.point_data.push_back({model == CurrentModel::averaging ? "current" : "potential", state.electric});
  return data;
}

VtkPolyData sintering_contacts(const Press& one, const dynamics::MovingNetwork& network,
                               const dynamics::State& state) {
  VtkPolyData data{
      .points = state.position, .lines = {}, .point_data = {}, .cell_data = {}, .time = state.time};
  const Points contacts = network.contacts().points();
  if (contacts.empty()) return data;  // loose particles: vertices without values
  std::vector<double> overlap, area;
  std::vector<std::int64_t> bonded;
  for (const auto& contact : contacts) {
    data.lines.emplace_back(contact.i, contact.j);
    overlap.push_back(contact.radius_sum - contact.distance);
    area.push_back(contact.area);
    bonded.push_back(contact.bonded ? 1 : 0);
  }
  data.cell_data = {
      {"overlap", std::move(overlap)}, {"area", std::move(area)}, {"bonded", std::move(bonded)}};
  add_flow(data, "temperature", contacts, state.temperature,
           [&](const dynamics::ContactPoint& contact) { return dynamics::pair_conductance(contact); });
  if (one.model.electric.model == CurrentModel::potential)
    add_flow(data, "potential", contacts, state.electric, [&](const dynamics::ContactPoint& contact) {
      const double drop = state.electric[static_cast<std::size_t>(contact.i)] -
                          state.electric[static_cast<std::size_t>(contact.j)];
      return dynamics::branch_of(one.model.electric, one.particles, contact, state.temperature, drop)
          .conductance;
    });
  return data;
}

}  // namespace superstep
