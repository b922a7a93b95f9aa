#include "rhs/kernels/node_values.hpp"

#include <algorithm>
#include <utility>

#include "core/parallel.hpp"

namespace superstep {

NodeValues::NodeValues(std::vector<std::int32_t> slot_of_row, std::vector<KnownValue> known,
                       std::vector<TimeTable> tables)
    : slot_of_row_(std::move(slot_of_row)),
      inputs_(std::move(tables)),
      value_(slot_of_row_.size() + known.size()) {
  rows_first_ = true;
  for (std::size_t row = 0; row < slot_of_row_.size(); ++row)
    rows_first_ = rows_first_ && static_cast<std::size_t>(slot_of_row_[row]) == row;
  for (const auto& entry : known) {
    // Slots of rows that others have may lie between: `share` says which.
    value_.resize(std::max(value_.size(), static_cast<std::size_t>(entry.node) + 1));
    value_[static_cast<std::size_t>(entry.node)] = entry.value;
    if (entry.table >= 0) changing_.push_back(entry);
  }
}

void NodeValues::share(std::shared_ptr<Halo> halo, std::vector<std::int32_t> slot_of_halo) {
  halo_ = std::move(halo);
  slot_of_halo_ = std::move(slot_of_halo);
  halo_value_.resize(slot_of_halo_.size());
  for (const auto slot : slot_of_halo_)
    value_.resize(std::max(value_.size(), static_cast<std::size_t>(slot) + 1));
}

std::span<const double> NodeValues::on_slots(double t, const double* state) {
  if (halo_) halo_->begin(state, halo_value_.data());
  for_ranges(slot_of_row_.size(), slot_of_row_.size(), [&](std::size_t first, std::size_t last) {
    if (rows_first_)
      std::copy(state + first, state + last, value_.data() + first);
    else
      for (std::size_t row = first; row < last; ++row)
        value_[static_cast<std::size_t>(slot_of_row_[row])] = state[row];
  });
  for (const auto& entry : changing_)
    value_[static_cast<std::size_t>(entry.node)] = inputs_.at(static_cast<std::size_t>(entry.table), t);
  if (!halo_) return value_;
  halo_->end();
  for_each_entry(slot_of_halo_.size(),
                 [&](std::size_t k) { value_[static_cast<std::size_t>(slot_of_halo_[k])] = halo_value_[k]; });
  return value_;
}

}  // namespace superstep
