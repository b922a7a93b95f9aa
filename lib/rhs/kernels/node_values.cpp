#include "rhs/kernels/node_values.hpp"

#include "core/parallel.hpp"

namespace superstep {

NodeValues::NodeValues(std::vector<std::int32_t> slot_of_row, std::vector<KnownValue> known,
                       std::vector<TimeTable> tables)
    : slot_of_row_(std::move(slot_of_row)),
      inputs_(std::move(tables)),
      value_(slot_of_row_.size() + known.size()) {
  for (const auto& entry : known) {
    value_[static_cast<std::size_t>(entry.node)] = entry.value;
    if (entry.table >= 0) changing_.push_back(entry);
  }
}

std::span<const double> NodeValues::on_slots(double t, const double* state) {
  for_each_entry(slot_of_row_.size(),
                 [&](std::size_t row) { value_[static_cast<std::size_t>(slot_of_row_[row])] = state[row]; });
  for (const auto& entry : changing_)
    value_[static_cast<std::size_t>(entry.node)] = inputs_.at(static_cast<std::size_t>(entry.table), t);
  return value_;
}

}  // namespace superstep
