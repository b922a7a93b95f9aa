#pragma once
/// What becomes of the energy of a press, step by step.

#include "dynamics/powers.hpp"
#include "integrators/press/history.hpp"

namespace superstep::dynamics {

/// Sum of m C T over the particles [J].
[[nodiscard]] double heat_content(const MovingNetwork& network, std::span<const double> temperature);

/// Whether two that come apart get back what their contact took up, damping and friction aside: without bonds
/// and with a stiffness that does not follow the temperature.
[[nodiscard]] bool conserves(const Model& model) noexcept;

/// What a step of h [s] adds to the energies of `before`, into `row`: work by the mean of the powers at its
/// ends, heat as the phi rule weighs them. The current's heat is that of the begin, and what was corrected.
void add_energies(const HistoryRow& before, const Powers& begin, const Powers& end, double h, double phi,
                  HistoryRow& row);

/// How far the balances are from closing over a whole history, relative to all that was turned over: the
/// mechanical one (kinetic, wall, weight, contacts, dissipated) and that of heat, 0 below roundings.
///   apart  nothing touches at either end, and contacts give back what they take (`conserves`): elastic
///          energy that is left is an error, too
struct BalanceErrors {
  double mechanical = 0, thermal = 0;
};
[[nodiscard]] BalanceErrors balance_errors(std::span<const HistoryRow> history, bool apart = false);

}  // namespace superstep::dynamics
