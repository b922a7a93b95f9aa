#include "python/binding/unknowns.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "rhs/kernels/sparse_pattern.hpp"

namespace superstep::python {

Unknowns::Unknowns(const Scene& scene) {
  for (std::size_t f = 0; f < scene.fields.size(); ++f) {
    if (scene.fields[f].steady) continue;
    for (std::size_t node = 0; node < scene.nodes(); ++node) {
      const auto entry = scene.entry_of_node(f, static_cast<std::int32_t>(node));
      if (entry < 0) continue;
      field_.push_back(static_cast<std::int32_t>(f));
      node_.push_back(static_cast<std::int32_t>(node));
      entry_.push_back(static_cast<std::size_t>(entry));
      origin_.push_back(scene.fields[f].origin);
    }
  }
}

void Unknowns::to_user(std::span<const double> state, double* values) const noexcept {
  for (std::size_t k = 0; k < entry_.size(); ++k) values[k] = state[entry_[k]] + origin_[k];
}

void Unknowns::to_state(std::span<const double> values, std::span<double> state) const noexcept {
  for (std::size_t k = 0; k < entry_.size(); ++k) state[entry_[k]] = values[k] - origin_[k];
}

void Unknowns::rates_to_user(std::span<const double> state, double* rates) const noexcept {
  for (std::size_t k = 0; k < entry_.size(); ++k) rates[k] = state[entry_[k]];
}

Unknowns::Pattern Unknowns::pattern(const SparsePattern& own) const {
  if (own.row.size() > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
    throw NumericalError("the Jacobian has more entries than SciPy's short indices can count");
  std::vector<std::int32_t> user(entry_.size());
  for (std::size_t k = 0; k < entry_.size(); ++k) user[entry_[k]] = static_cast<std::int32_t>(k);
  Pattern out;
  out.column_begin.assign(1, 0);
  out.row.reserve(own.row.size());
  out.source.reserve(own.row.size());
  std::vector<std::pair<std::int32_t, std::size_t>> column;
  for (const std::size_t entry : entry_) {
    column.clear();
    for (auto k = static_cast<std::size_t>(own.column_begin[entry]);
         k < static_cast<std::size_t>(own.column_begin[entry + 1]); ++k)
      column.emplace_back(user[static_cast<std::size_t>(own.row[k])], k);
    std::sort(column.begin(), column.end());
    for (const auto& [row, source] : column) {
      out.row.push_back(row);
      out.source.push_back(source);
    }
    out.column_begin.push_back(static_cast<std::int32_t>(out.row.size()));
  }
  return out;
}

}  // namespace superstep::python
