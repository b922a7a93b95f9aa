#include "integrators/press/energy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace superstep::dynamics {

double heat_content(const MovingNetwork& network, std::span<const double> temperature) {
  double sum = 0;
  for (std::size_t i = 0; i < temperature.size(); ++i)
    sum += heat_capacity(network.model().thermal, network.particles(), i) * temperature[i];
  return sum;
}

bool conserves(const Model& model) noexcept {
  return !model.bond.acts() && std::isinf(model.contact.softening.temperature) &&
         std::isinf(model.wall.softening.temperature);
}

void add_energies(const HistoryRow& before, const Powers& begin, const Powers& end, double h, double phi,
                  HistoryRow& row) {
  const auto mean = [&](double Powers::*power) { return 0.5 * h * (begin.*power + end.*power); };
  row.wall_work = before.wall_work + mean(&Powers::wall);
  row.potential_energy = before.potential_energy - mean(&Powers::weight);
  row.elastic_energy = before.elastic_energy + mean(&Powers::elastic);
  row.dissipated = before.dissipated + mean(&Powers::dissipated);
  row.joule_heat = before.joule_heat + h * begin.joule;
  row.heat_lost = before.heat_lost + h * ((1 - phi) * begin.heat_lost + phi * end.heat_lost);
}

BalanceErrors balance_errors(std::span<const HistoryRow> history, bool apart) {
  if (history.empty()) return {};
  const HistoryRow &first = history.front(), &last = history.back();
  const auto turned_over = [&](double HistoryRow::*energy) {
    double sum = 0;
    for (std::size_t k = 1; k < history.size(); ++k)
      sum += std::abs(history[k].*energy - history[k - 1].*energy);
    return sum;
  };
  const auto relative = [](double error, double all) { return all > 0 ? std::abs(error) / all : 0; };
  const double mechanical = last.kinetic_energy - first.kinetic_energy - last.wall_work +
                            last.potential_energy + (apart ? 0 : last.elastic_energy) + last.dissipated;
  const double thermal = last.heat_content - first.heat_content - last.joule_heat + last.heat_lost;
  // Every step rounds every temperature: less than that can not be told from nothing.
  const double rounding = std::numeric_limits<double>::epsilon() * static_cast<double>(history.size()) *
                          std::max(std::abs(first.heat_content), std::abs(last.heat_content));
  return {relative(mechanical,
                   turned_over(&HistoryRow::kinetic_energy) + turned_over(&HistoryRow::wall_work) +
                       turned_over(&HistoryRow::potential_energy) + turned_over(&HistoryRow::elastic_energy)),
          std::abs(thermal) > rounding
              ? relative(thermal, turned_over(&HistoryRow::joule_heat) + turned_over(&HistoryRow::heat_lost))
              : 0};
}

}  // namespace superstep::dynamics
