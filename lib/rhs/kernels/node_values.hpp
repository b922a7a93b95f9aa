#pragma once
/// Values of one field on all nodes, in an order that two fields share: what couples them needs both at the
/// same node, be it free, fixed or idle in either field.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "parallel/halo.hpp"
#include "rhs/tabled_inputs.hpp"

namespace superstep {

/// The value of a node that is not an unknown.
struct KnownValue {
  std::int32_t node = 0;  ///< position in the graph; a slot inside NodeValues
  double value = 0;       ///< K or V
  std::int32_t table = -1;
};

/// `slots` number the nodes: the rows of the temperature first, in their order, then all other nodes.
class NodeValues {
 public:
  ///   slot_of_row [n]  where each row's node stands;  known  all other nodes, `node` being a slot
  NodeValues(std::vector<std::int32_t> slot_of_row, std::vector<KnownValue> known,
             std::vector<TimeTable> tables);
  /// Values on the slots [nodes] for a state of this field at time t.
  [[nodiscard]] std::span<const double> on_slots(double t, const double* state);
  /// Some slots are values of rows that other processes have: those of `halo`, in its order.
  void share(std::shared_ptr<Halo> halo, std::vector<std::int32_t> slot_of_halo);
  [[nodiscard]] std::int32_t slot_of_row(std::size_t row) const noexcept { return slot_of_row_[row]; }
  /// See Rhs::enter and Rhs::leave.
  void enter(double begin, double end) noexcept { inputs_.enter(begin, end); }
  void leave() noexcept { inputs_.leave(); }

 private:
  std::vector<std::int32_t> slot_of_row_;
  bool rows_first_ = false;  ///< row i is slot i
  std::vector<KnownValue> changing_;
  TabledInputs inputs_;
  std::vector<double> value_;
  std::shared_ptr<Halo> halo_;  // null: all rows are here
  std::vector<std::int32_t> slot_of_halo_;
  std::vector<double> halo_value_;
};

}  // namespace superstep
