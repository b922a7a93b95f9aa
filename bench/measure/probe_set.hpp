#pragma once
/// The probes of a scene, field by field: entries of the state, or constants.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "case/scene.hpp"
#include "integrators/probe_history.hpp"

namespace superstep {

/// One probe in one field.
struct ProbeColumn {
  std::string name;              ///< "temperature_mid-height"
  std::string field;             ///< "temperature"
  std::ptrdiff_t slot = -1;      ///< position in the history; -1 = no entry of the state
  double initial = 0;            ///< value at the start [K or V]
  double origin = 0;             ///< K or V: what is recorded are differences from it
  const Graph* graph = nullptr;  ///< where a fixed value is found
  std::size_t node = 0;

  /// Value of a node that is not an entry of the state.
  [[nodiscard]] double known_at(double t) const noexcept;
};

class ProbeSet {
 public:
  explicit ProbeSet(const Scene& scene);

  [[nodiscard]] std::span<const ProbeColumn> columns() const noexcept { return columns_; }
  /// Entries of the state that a run has to record.
  [[nodiscard]] const std::vector<std::size_t>& entries() const noexcept { return entries_; }
  /// First probe of a field whose value may change: the one that error measures refer to; nullptr without
  /// any.
  [[nodiscard]] const ProbeColumn* first_in(const std::string& field) const noexcept;
  /// A history that holds the initial state alone.
  [[nodiscard]] ProbeHistory history() const;

 private:
  std::vector<ProbeColumn> columns_;
  std::vector<std::size_t> entries_;
  std::vector<double> initial_;  // of the entries
};

}  // namespace superstep
