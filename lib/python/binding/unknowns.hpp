#pragma once
/// The unknowns of a scene as its user sees them: in the order of the user's nodes, with their own zero.

#include <cstdint>
#include <span>
#include <vector>

#include "case/scene.hpp"

namespace superstep::python {

/// m unknowns: field after field, in each the nodes that are neither fixed nor idle nor of capacity 0,
/// ascending. Inside, a state is ordered for locality and counted from the fields' origins.
class Unknowns {
 public:
  explicit Unknowns(const Scene& scene);

  [[nodiscard]] std::size_t size() const noexcept { return entry_.size(); }
  /// [m] position of each one's field among the scene's, and of its node.
  [[nodiscard]] const std::vector<std::int32_t>& field() const noexcept { return field_; }
  [[nodiscard]] const std::vector<std::int32_t>& node() const noexcept { return node_; }

  /// From a state to the user's values and back; both [m].
  void to_user(std::span<const double> state, double* values) const noexcept;
  void to_state(std::span<const double> values, std::span<double> state) const noexcept;
  /// The same for rates, which have no zero.
  void rates_to_user(std::span<const double> state, double* rates) const noexcept;

  /// Compressed columns of a Jacobian among the user's unknowns, rows ascending.
  struct Pattern {
    std::vector<std::int32_t> column_begin, row;
    std::vector<std::size_t> source;  ///< position of each entry in the right-hand side's own pattern
  };
  [[nodiscard]] Pattern pattern(const SparsePattern& own) const;

 private:
  std::vector<std::int32_t> field_, node_;
  std::vector<std::size_t> entry_;  // of the state
  std::vector<double> origin_;
};

}  // namespace superstep::python
