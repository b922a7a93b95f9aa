#include "integrators/detail/exponential/scaled_jacobian.hpp"

#include <cmath>

#include "core/parallel.hpp"
#include "integrators/detail/krylov/arnoldi_kernels.hpp"
#include "rhs/kernels/sweep.hpp"

namespace superstep {

void ScaledJacobian::prepare(Rhs& rhs, const Task& task) {
  rhs_ = &rhs;
  const std::size_t n = rhs.size();
  for (auto* v : {&scale_, &inverse_, &diagonal_}) v->assign(n, 0.0);
  const auto capacity = rhs.capacities();
  const auto fields = rhs.fields();
  for (std::size_t f = 0; f < fields.size(); ++f) {
    const auto& field = fields[f];
    double total = 0;
    for (std::size_t k = 0; k < field.count; ++k) total += capacity[field.offset + k * field.stride];
    // A field in which nothing may move has no allowed error; any scale serves.
    const double allowed = task.allowed[f] > 0 ? task.allowed[f] : 1;
    const double part = static_cast<double>(field.count) / static_cast<double>(n);
    for (std::size_t k = 0, i = field.offset; k < field.count; ++k, i += field.stride)
      scale_[i] = std::sqrt(part * capacity[i] / total) / allowed;
  }
  for (std::size_t i = 0; i < n; ++i) inverse_[i] = 1 / scale_[i];

  const auto& pattern = rhs.pattern();
  value_.resize(pattern.row.size());
  row_begin_.assign(n + 1, 0);
  const auto for_each_off_diagonal = [&](auto visit) {
    for (std::size_t j = 0; j < n; ++j)
      for (auto k = pattern.column_begin[j]; k < pattern.column_begin[j + 1]; ++k) {
        const auto i = static_cast<std::size_t>(pattern.row[static_cast<std::size_t>(k)]);
        if (i != j) visit(i, j, k);
      }
  };
  for_each_off_diagonal([&](std::size_t i, std::size_t, std::int64_t) { ++row_begin_[i + 1]; });
  for (std::size_t i = 0; i < n; ++i) row_begin_[i + 1] += row_begin_[i];
  column_.resize(static_cast<std::size_t>(row_begin_[n]));
  position_.resize(column_.size());
  std::vector<std::int64_t> next(row_begin_.begin(), row_begin_.end() - 1);
  for_each_off_diagonal([&](std::size_t i, std::size_t j, std::int64_t k) {
    const auto at = static_cast<std::size_t>(next[i]++);
    column_[at] = static_cast<std::int32_t>(j);
    position_[at] = k;
  });
  rows_ = SlicedRows(row_begin_, column_);
  is_set_ = false;
}

void ScaledJacobian::set(double t, std::span<const double> y) {
  if (is_set_ && rhs_->traits().constant_jacobian) return;
  is_set_ = true;
  rhs_->jacobian(t, y, value_);
  const auto& pattern = rhs_->pattern();
  rows_.set_values(row_begin_, [&](std::size_t i, std::size_t k) {
    return value_[static_cast<std::size_t>(position_[k])] * scale_[i] *
           inverse_[static_cast<std::size_t>(column_[k])];
  });
  for_each_entry(diagonal_.size(), [&](std::size_t i) {
    double sum = value_[static_cast<std::size_t>(pattern.diagonal[i])];
    for (auto k = static_cast<std::size_t>(row_begin_[i]); k < static_cast<std::size_t>(row_begin_[i + 1]);
         ++k)
      sum += value_[static_cast<std::size_t>(position_[k])] * scale_[i] *
             inverse_[static_cast<std::size_t>(column_[k])];
    diagonal_[i] = sum;
  });
}

double ScaledJacobian::multiply(const double* v, const double* other, double* out) {
  rhs_->count_product();
  fused_sweep(rows_, {.y1 = v, .a = 0, .d = 1}, out);
  const auto& kernel = arnoldi_kernels().front();
  return rhs_->reduction().sum_of_ranges([&](std::size_t first, std::size_t last) {
    return kernel.add_diagonal(out, diagonal_.data(), v, other, first, last);
  });
}

}  // namespace superstep
