#pragma once
/// The door for a code that moves its own particles: it hands in what touches what and how well that
/// conducts; temperatures are kept here, and any registered method advances them.
///
///   HostedHeat heat(capacities, temperatures, "exponential:rtol=1e-4");
///   for (each step of the host) {
///     heat.set_contacts(contacts);            // as they are now
///     if (const auto outcome = heat.advance_temperatures(dt); !outcome.ok()) stop(outcome.reason);
///   }
///
/// Contacts stand still during a call. What has not changed since the last one is not done again: the same
/// contacts with the same conductances keep the method prepared, the same contacts with others keep their
/// places in the network, other contacts between the same particles keep, for a while, its order. The network
/// is linear and its inputs stand: `exponential` has the fewest sweeps. Walls are particles that are held.
/// Bad input throws InputError and changes nothing: numbers that are not finite, too, and those beyond 1e-40
/// to 1e40, with which not every method can compute.

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "integrators/host/stretches.hpp"
#include "network/network.hpp"

namespace superstep {

class HostedHeat {
 public:
  struct Contact {
    std::int32_t i = 0, j = 0;  ///< positions of two particles
    double conductance = 0;     ///< W/K, >= 0; the same pair twice conducts twice
  };

  ///   capacities    [n] J/K, > 0
  ///   temperatures  [n] K, or in any unit and from any zero
  ///   method        SPEC, see `superstep list`; throws UsageError
  HostedHeat(std::span<const double> capacities, std::span<const double> temperatures,
             std::string method = "exponential:rtol=1e-4");

  /// Other particles, as many as there are now; contacts, sources and what is held are forgotten.
  void set_particles(std::span<const double> capacities, std::span<const double> temperatures);
  /// All contacts, in any order; those of before are gone.
  void set_contacts(std::span<const Contact> contacts);
  void set_capacities(std::span<const double> capacities);      ///< [n] J/K, > 0
  void set_temperatures(std::span<const double> temperatures);  ///< [n] K
  void set_sources(std::span<const double> sources);            ///< [n] W
  /// The particle has this temperature until it is released [K].
  void hold(std::size_t particle, double temperature);
  void release(std::size_t particle);
  /// What rtol refers to [K], > 0; unless it is said, the largest minus the smallest temperature seen so far.
  void set_span(double span);

  /// dt [s] > 0. Temperatures stay as they were unless the outcome is ok. All calls together, however many
  /// there are, may err by rtol times the span: see `share`.
  [[nodiscard]] Outcome advance_temperatures(double dt);

  [[nodiscard]] std::span<const double> temperatures() const noexcept { return temperature_; }
  /// Sum of capacity times temperature over all particles, those that are held included [J].
  [[nodiscard]] double heat() const;
  /// Work so far.
  [[nodiscard]] const Stretches& stretches() const noexcept { return stretches_; }

 private:
  enum class Stale { nothing, values, structure };
  void spoil(Stale what) noexcept { stale_ = std::max(stale_, what); }
  void require(std::size_t particle) const;
  [[nodiscard]] bool is_held(std::size_t particle) const noexcept { return held_[particle] != 0; }
  void build();
  [[nodiscard]] Network new_network() const;
  [[nodiscard]] double share(double dt) const noexcept;
  void find_places();
  void fill();
  void gather();

  Stretches stretches_;
  std::vector<double> capacity_, temperature_, source_;  // [n]
  std::vector<char> held_;                               // [n]
  std::vector<Contact> contacts_;                        // that conduct
  Stale stale_ = Stale::structure;
  Network network_;
  std::vector<std::int32_t> order_;  // of the particles that are not held, as once found; empty = to be found
  int orders_used_ = 0;              // networks that have it
  /// [contacts] where their conductances stand: two entries of the matrix, or an edge to a ghost and -1, or
  /// -1 twice between two that are held.
  std::vector<std::pair<std::int64_t, std::int64_t>> place_;
  std::vector<double> row_value_;   // [rows] differences from the network's origin
  FieldRange seen_;                 // K
  double stated_span_ = 0;          // K; 0 = not stated
  double elapsed_ = 0, first_ = 0;  // s; of all calls so far, and of the first one
};

}  // namespace superstep
