#include "dynamics/heat.hpp"

#include <algorithm>
#include <limits>

#include "core/index.hpp"
#include "core/parallel.hpp"

namespace superstep::dynamics {

// The centre never gets as far as the wall in an accepted step; the bound keeps trial positions finite.
double wall_conductance(const ThermalLaw& law, const Particles& particles,
                        const WallContact& contact) noexcept {
  constexpr double nearest = 1e-3;  // of the radius
  const std::size_t i = at(contact.particle);
  return value_of(particles.conductivity, i, law.conductivity) * contact.area /
         std::max(contact.distance, nearest * particles.radius[i]);
}

void heat_rates(const ThermalLaw& law, const Particles& particles, const ContactPoints& contacts,
                std::span<const WallContact> walls, Held held, std::span<const double> joule,
                std::span<const double> temperature, std::span<double> rate) {
  std::copy(joule.begin(), joule.end(), rate.begin());
  const ContactTable& table = contacts.table();
  const bool conducts = law.conductivity > 0 || !particles.conductivity.empty();
  const auto flow_into_i = [&](std::size_t k) {
    return table.conductivity[k] * table.flow[k] *
           (temperature[at(table.j[k])] - temperature[at(table.i[k])]);
  };
  if (conducts && threads_for(table.size() / 4) == 1) {
    for (std::size_t k = 0; k < table.size(); ++k) {
      const double flow = flow_into_i(k);
      rate[at(table.i[k])] += flow;
      rate[at(table.j[k])] -= flow;
    }
  } else if (conducts) {
    const Incidence& pairs_of = contacts.incidence();
    for_ranges(rate.size(), table.size() / 4, [&](std::size_t first, std::size_t last) {
      for (std::size_t p = first; p < last; ++p)
        for (std::size_t e = pairs_of.begin[p]; e < pairs_of.begin[p + 1]; ++e) {
          const double flow = flow_into_i(at(pairs_of.entry[e] / 2));
          rate[p] += pairs_of.entry[e] % 2 == 0 ? flow : -flow;
        }
    });
  }
  if (conducts && law.walls_conduct)
    for (const auto& contact : walls) {
      const std::size_t i = at(contact.particle);
      rate[i] += wall_conductance(law, particles, contact) *
                 (law.wall_temperature[at(contact.wall)] - temperature[i]);
    }
  for_each_entry(rate.size(), [&](std::size_t i) {
    rate[i] = held[i] >= 0 ? 0.0 : rate[i] / heat_capacity(law, particles, i);
  });
}

double heat_step_limit(const ThermalLaw& law, const Particles& particles, const ContactPoints& contacts,
                       std::span<const WallContact> walls, Held held, std::vector<double>& conductance) {
  constexpr double never = std::numeric_limits<double>::infinity();
  if (!(law.conductivity > 0) && particles.conductivity.empty()) return never;
  conductance.assign(particles.size(), 0.0);
  const ContactTable& table = contacts.table();
  for (std::size_t k = 0; k < table.size(); ++k) {
    const double one = table.conductivity[k] * table.flow[k];
    conductance[at(table.i[k])] += one;
    conductance[at(table.j[k])] += one;
  }
  if (law.walls_conduct)
    for (const auto& contact : walls)
      conductance[at(contact.particle)] += wall_conductance(law, particles, contact);
  double inverse = 0;
  for (std::size_t i = 0; i < conductance.size(); ++i)
    if (held[i] < 0) inverse = std::max(inverse, conductance[i] / heat_capacity(law, particles, i));
  return inverse > 0 ? 1 / inverse : never;
}

Network thermal_network(const ThermalLaw& law, const Particles& particles, const Placement& placement,
                        Held held, std::span<const double> joule) {
  const std::size_t n = particles.size();
  Network network;
  network.row_of_node.assign(n, -1);
  for (std::size_t i = 0; i < n; ++i) {
    if (held[i] >= 0) continue;
    network.row_of_node[i] = static_cast<std::int32_t>(network.node_of_row.size());
    network.node_of_row.push_back(static_cast<std::int32_t>(i));
    network.capacity.push_back(heat_capacity(law, particles, i));
    network.source.push_back(joule[i]);
  }
  network.ghost_value.assign(law.wall_temperature.begin(), law.wall_temperature.end());
  const std::size_t rows = network.capacity.size();
  const auto& row_of = network.row_of_node;
  const auto conducts = [](double conductance) { return conductance > 0; };

  // Count, then fill: contacts are sorted by (i, j) with i < j, so each row's columns below the diagonal come
  // in order while j runs, those above while i runs.
  network.row_begin.assign(rows + 1, 0);
  for (const auto& contact : placement.contacts) {
    if (!conducts(pair_conductance(contact))) continue;
    const auto a = row_of[at(contact.i)], b = row_of[at(contact.j)];
    if (a < 0 || b < 0) continue;
    ++network.row_begin[at(a) + 1];
    ++network.row_begin[at(b) + 1];
  }
  for (std::size_t row = 0; row < rows; ++row) network.row_begin[row + 1] += network.row_begin[row];
  const auto entries = static_cast<std::size_t>(network.row_begin[rows]);
  network.column.resize(entries);
  network.conductance.resize(entries);
  std::vector<std::int64_t> next(network.row_begin.begin(), network.row_begin.end() - 1);
  const auto put = [&](std::int32_t row, std::int32_t column, double conductance) {
    const auto k = static_cast<std::size_t>(next[at(row)]++);
    network.column[k] = column;
    network.conductance[k] = conductance;
  };
  const auto to_wall = [&](std::int32_t row, std::int32_t wall, double conductance) {
    network.ghost_edges.push_back({row, wall, conductance});
  };
  for (const auto& contact : placement.contacts) {  // below the diagonal, and ghosts
    const double conductance = pair_conductance(contact);
    if (!conducts(conductance)) continue;
    const auto a = row_of[at(contact.i)], b = row_of[at(contact.j)];
    if (a >= 0 && b >= 0)
      put(b, a, conductance);
    else if (a >= 0)
      to_wall(a, held[at(contact.j)], conductance);
    else if (b >= 0)
      to_wall(b, held[at(contact.i)], conductance);
  }
  for (const auto& contact : placement.contacts) {  // above the diagonal
    const double conductance = pair_conductance(contact);
    const auto a = row_of[at(contact.i)], b = row_of[at(contact.j)];
    if (a >= 0 && b >= 0 && conducts(conductance)) put(a, b, conductance);
  }
  if (law.walls_conduct)
    for (const auto& contact : placement.walls) {
      const std::size_t i = at(contact.particle);
      const double conductance = wall_conductance(law, particles, contact);
      if (row_of[i] >= 0 && conducts(conductance)) to_wall(row_of[i], contact.wall, conductance);
    }
  std::stable_sort(network.ghost_edges.begin(), network.ghost_edges.end(),
                   [](const auto& a, const auto& b) { return a.row < b.row; });
  return network;
}

}  // namespace superstep::dynamics
