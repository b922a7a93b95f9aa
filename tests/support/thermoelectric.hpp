#pragma once
/// Small thermoelectric networks with every term that a scene can have.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "integrators/registry.hpp"
#include "network/graph.hpp"
#include "rhs/nonlinear_rhs.hpp"

namespace superstep::test {

/// The same random graph for both fields, nodes of two materials in turn; the potential is held at 0 and 1 V,
/// the temperature at nothing.
struct Thermoelectric {
  std::size_t nodes = 12;
  bool potential = true, steady = false, joule_heat = true;
  std::vector<ConductivityLaw> thermal = {{.value = 2}, {.value = 1}};
  std::vector<ConductivityLaw> electric = {{.value = 3}, {.value = 1}};
  ConductanceMean mean = ConductanceMean::harmonic;
  bool convection = false, radiation = false;
  bool tables = false;       ///< the electrode and the ambient follow tables of time
  TimeTable electrode = {};  ///< that of the electrode instead, where it has knots

  [[nodiscard]] Graph thermal_graph() const;
  [[nodiscard]] Graph electric_graph() const;
  [[nodiscard]] Network electric_network() const;
  [[nodiscard]] std::unique_ptr<NonlinearRhs> build() const;
};

struct CoupledRun {
  Outcome outcome;
  std::vector<std::vector<double>> states;
  Statistics statistics;
  ProbeHistory history;
  std::optional<double> settled_at;
};

/// From zero, with a probe at the last row; potentials within 0 and 1 V. A refusal is the outcome.
[[nodiscard]] CoupledRun run_coupled(Rhs& rhs, const std::string& spec, const std::vector<double>& times,
                                     FieldRange temperature = {0, 0}, double settle_tolerance = 0);

}  // namespace superstep::test
