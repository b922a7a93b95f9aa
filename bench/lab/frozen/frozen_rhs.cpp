#include "bench/lab/frozen/frozen_rhs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/index.hpp"
#include "core/parallel.hpp"

namespace superstep {
namespace {

constexpr double rounding = 1e-12;  // of what two entries that ought to be equal may differ by

/// [n] number of the field that an entry belongs to.
std::vector<std::size_t> field_of_entry(const Rhs& scene) {
  std::vector<std::size_t> field(scene.size());
  for (std::size_t f = 0; f < scene.fields().size(); ++f) {
    const auto& view = scene.fields()[f];
    for (std::size_t k = 0; k < view.count; ++k) field[view.offset + k * view.stride] = f;
  }
  return field;
}

std::vector<double> weights_of(const Rhs& scene, std::span<const double> spans) {
  std::vector<double> weights(scene.capacities().begin(), scene.capacities().end());
  for (std::size_t f = 0; f < scene.fields().size(); ++f) {
    const auto& view = scene.fields()[f];
    double total = 0;
    for (std::size_t k = 0; k < view.count; ++k) total += weights[view.offset + k * view.stride];
    const double span = f < spans.size() && spans[f] > 0 ? spans[f] : 1;
    for (std::size_t k = 0; k < view.count; ++k)
      weights[view.offset + k * view.stride] /= total * span * span;
  }
  return weights;
}

template <class See>
void for_each_value(const FrozenJacobian& jacobian, See see) {
  const auto& pattern = jacobian.pattern;
  for (std::size_t j = 0; j + 1 < pattern.column_begin.size(); ++j)
    for (auto k = at(pattern.column_begin[j]); k < at(pattern.column_begin[j + 1]); ++k)
      see(at(pattern.row[k]), j, jacobian.values[k]);
}

double transposed(const FrozenJacobian& jacobian, std::size_t i, std::size_t j) noexcept {
  const auto& pattern = jacobian.pattern;
  const auto place = pattern.position(j, i);
  const bool is_there = place < at(pattern.column_begin[i + 1]) && at(pattern.row[place]) == j;
  return is_there ? jacobian.values[place] : 0;
}

RhsTraits traits_of(const FrozenJacobian& jacobian, const std::vector<std::size_t>& field) {
  bool symmetric = true, symmetric_blocks = true;
  std::array<bool, 2> acts{};  // across: the first field on the second, and back
  for_each_value(jacobian, [&](std::size_t i, std::size_t j, double value) {
    const double here = jacobian.weights[i] * value;
    const double there = jacobian.weights[j] * transposed(jacobian, i, j);
    const bool same = std::abs(here - there) <= rounding * std::max(std::abs(here), std::abs(there));
    symmetric = symmetric && same;
    if (field[i] == field[j])
      symmetric_blocks = symmetric_blocks && same;
    else if (value != 0)
      acts[field[i] < field[j]] = true;
  });
  return {.linear = true,
          .constant_jacobian = true,
          .symmetric = symmetric,
          .autonomous = true,
          .constant_blocks = symmetric_blocks && !(acts[0] && acts[1])};
}

bool no_row_rises(const FrozenJacobian& jacobian) {
  std::vector<double> sum(jacobian.weights.size()), size(sum.size());
  for_each_value(jacobian, [&](std::size_t i, std::size_t j, double value) {
    sum[i] += i == j ? value : std::abs(value);
    size[i] += std::abs(value);
  });
  for (std::size_t i = 0; i < sum.size(); ++i)
    if (sum[i] > rounding * size[i]) return false;
  return true;
}

}  // namespace

double FrozenJacobian::largest() const noexcept {
  double out = 0;
  for (const double value : values) out = std::max(out, std::abs(value));
  return out;
}

bool FrozenJacobian::equals(const FrozenJacobian& other, double part) const noexcept {
  const double allowed = part * largest();
  for (std::size_t k = 0; k < values.size(); ++k)
    if (!(std::abs(values[k] - other.values[k]) <= allowed)) return false;
  return true;
}

FrozenJacobian freeze(Rhs& scene, double t, std::span<const double> y, std::span<const double> spans) {
  scene.leave();
  FrozenJacobian out;
  out.pattern = scene.pattern();
  out.values.resize(out.pattern.row.size());
  scene.jacobian(t, y, out.values);
  out.weights = weights_of(scene, spans);
  out.bound = scene.spectral_bound(t, y);
  out.decays = no_row_rises(out);
  out.traits = traits_of(out, field_of_entry(scene));
  return out;
}

FrozenRhs::FrozenRhs(const Rhs& scene, FrozenJacobian jacobian)
    : Rhs(scene.size(), jacobian.traits, {scene.fields().begin(), scene.fields().end()}),
      jacobian_(std::move(jacobian)),
      capacity_(scene.capacities().begin(), scene.capacities().end()) {
  facts_.pair_step = scene.facts().pair_step;
  facts_.fields.resize(scene.fields().size());
  row_begin_.assign(size() + 1, 0);
  for_each_value(jacobian_, [&](std::size_t i, std::size_t, double) { ++row_begin_[i + 1]; });
  for (std::size_t i = 0; i < size(); ++i) row_begin_[i + 1] += row_begin_[i];
  column_.resize(row_begin_.back());
  value_.resize(row_begin_.back());
  auto next = row_begin_;
  for_each_value(jacobian_, [&](std::size_t i, std::size_t j, double value) {
    column_[next[i]] = j;
    value_[next[i]++] = value;
  });
}

double FrozenRhs::row_product(std::size_t row, const double* v) const noexcept {
  double sum = 0;
  for (std::size_t k = row_begin_[row]; k < row_begin_[row + 1]; ++k) sum += value_[k] * v[column_[k]];
  return sum;
}

double FrozenRhs::spectral_bound(double /*t*/, std::span<const double> /*y*/) {
  return jacobian_.bound;
}

double FrozenRhs::inflow(double /*t*/, std::span<const double> y) {
  return linear_inflow(y);
}

double FrozenRhs::linear_inflow(std::span<const double> v) const {
  const auto& heated = fields().back();  // the temperature where there is one
  double sum = 0;
  for (std::size_t k = 0; k < heated.count; ++k) {
    const std::size_t i = heated.offset + k * heated.stride;
    sum += capacity_[i] * row_product(i, v.data());
  }
  return sum;
}

void FrozenRhs::do_stage(double /*t*/, const Stage& stage, std::span<double> out) {
  do_linear_stage(stage, out);
}

void FrozenRhs::do_linear_stage(const Stage& stage, std::span<double> out) {
  for_each_entry(out.size(), [&](std::size_t i) {
    double sum = stage.a * stage.y1[i] + stage.d * row_product(i, stage.y1);
    if (stage.y2) sum += stage.b * stage.y2[i];
    if (stage.y0) sum += stage.c * stage.y0[i];
    if (stage.f0) sum += stage.e * stage.f0[i];
    out[i] = sum;
  });
}

void FrozenRhs::do_block_product(std::size_t field, std::span<const double> v, std::span<double> out) {
  const auto& view = fields()[field];
  std::vector<double> whole(size(), 0.0);
  for (std::size_t k = 0; k < view.count; ++k) whole[view.offset + k * view.stride] = v[k];
  for (std::size_t k = 0; k < view.count; ++k)
    out[k] = row_product(view.offset + k * view.stride, whole.data());
}

void FrozenRhs::do_jacobian(double /*t*/, std::span<const double> /*y*/, std::span<double> values) {
  std::copy(jacobian_.values.begin(), jacobian_.values.end(), values.begin());
}

SparsePattern FrozenRhs::build_pattern() {
  return jacobian_.pattern;
}

}  // namespace superstep
