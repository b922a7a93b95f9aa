#include "integrators/schemes/three_term.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/index.hpp"
#include "core/parallel.hpp"

namespace superstep {

void set_stage_times(ThreeTermScheme& scheme) {
  scheme.c[0] = 0;
  scheme.c[1] = scheme.mt[1];
  for (std::size_t j = 2; j <= at(scheme.recurrence_stages()); ++j)
    scheme.c[j] = scheme.m[j] * scheme.c[j - 1] + scheme.n[j] * scheme.c[j - 2] + scheme.mt[j] + scheme.gt[j];
}

void first_order_chebyshev(int stages, double excess, ThreeTermScheme& scheme, double reach) {
  const auto s = static_cast<std::size_t>(stages);
  scheme.stages = stages;
  scheme.uses_first_derivative = scheme.keeps_first_stage = false;
  scheme.finish.reset();
  for (auto* v : {&scheme.m, &scheme.n, &scheme.mt, &scheme.gt, &scheme.c}) v->assign(s + 1, 0.0);
  // T_j = cosh(j theta): T'_s/T_s = s tanh(s theta)/sinh(theta), theta free of cancellation.
  const double w0 = 1 + excess, sinh_theta = std::sqrt(excess * (2 + excess)), theta = std::asinh(sinh_theta);
  const double w1 = reach * sinh_theta / (stages * std::tanh(stages * theta));
  scheme.beta = (1 + w0) / w1;
  scheme.mt[1] = w1 / w0;
  for (std::size_t j = 2; j <= s; ++j) {
    // T_{j-1}/T_j = cosh((j-1) theta)/cosh(j theta), by the addition theorem: no overflow, no error carried
    // from j to j+1.
    const double ratio = w0 - sinh_theta * std::tanh(static_cast<double>(j) * theta);
    scheme.m[j] = 2 * w0 * ratio;
    scheme.n[j] = 1 - scheme.m[j];  // exactly: the recurrence has no Y_0 term to make up for a rounding
    scheme.mt[j] = 2 * w1 * ratio;
  }
  set_stage_times(scheme);
}

bool evaluates_changes(const Rhs& rhs) noexcept {
  return rhs.traits().linear && rhs.traits().autonomous;
}

void ThreeTermEngine::resize(std::size_t size, bool finishing) {
  result_.resize(size);
  previous_.resize(size);
  argument_.resize(finishing ? size : 0);
  for (auto& slope : slopes_) slope.resize(finishing ? size : 0);
}

void ThreeTermEngine::step(Rhs& rhs, const ThreeTermScheme& scheme, double t, double h,
                           std::span<const double> y0, std::span<const double> f0) {
  if (scheme.finish || (scheme.by_change && evaluates_changes(rhs)))
    return step_by_change(rhs, scheme, t, h, y0, f0);
  std::array<ChainedStage, longest_chain> links;
  std::size_t linked = 0;
  const auto stages = static_cast<std::size_t>(scheme.recurrence_stages());
  const auto run_chain = [&] {
    rhs.chain(std::span(links).first(linked), false);
    linked = 0;
  };

  if (scheme.uses_first_derivative) {
    const double first = scheme.mt[1] * h;
    for_each_entry(y0.size(), [&](std::size_t i) { result_[i] = y0[i] + first * f0[i]; });
  } else {
    links[linked++] = {
        .t = t, .stage = {.y1 = y0.data(), .a = 1, .d = scheme.mt[1] * h}, .out = result_.data()};
  }
  std::span<const double> before = y0;
  for (std::size_t j = 2; j <= stages; ++j) {
    Stage stage{
        .y1 = result_.data(), .a = scheme.m[j], .d = scheme.mt[j] * h, .y2 = before.data(), .b = scheme.n[j]};
    if (scheme.keeps_first_stage) {
      stage.y0 = y0.data();
      stage.c = 1 - scheme.m[j] - scheme.n[j];
      stage.f0 = f0.data();
      stage.e = scheme.gt[j] * h;
    }
    links[linked++] = {.t = t + scheme.c[j - 1] * h, .stage = stage, .out = previous_.data()};
    if (linked == longest_chain) run_chain();
    std::swap(result_, previous_);
    before = previous_;
  }
  if (linked > 0) run_chain();
}

void ThreeTermEngine::step_by_change(Rhs& rhs, const ThreeTermScheme& scheme, double t, double h,
                                     std::span<const double> y0, std::span<const double> f0) {
  const bool by_change = evaluates_changes(rhs);
  const std::size_t n = y0.size();
  // Changes D_j = Y_j - Y_0 of the last two stages.
  auto &now = result_, &before = previous_;
  for_each_entry(n, [&](std::size_t i) {
    before[i] = 0;
    now[i] = scheme.mt[1] * h * f0[i];
  });
  for (std::size_t j = 2; j <= at(scheme.recurrence_stages()); ++j) {
    const double m = scheme.m[j], n_j = scheme.n[j], mt = scheme.mt[j] * h;
    // A sweep takes Y_0 and F_0 together: what has factor zero is a vector that it reads anyway.
    if (by_change) {
      rhs.linear_stage({.y1 = now.data(),
                        .a = m,
                        .d = mt,
                        .y2 = before.data(),
                        .b = n_j,
                        .y0 = now.data(),
                        .c = 0,
                        .f0 = f0.data(),
                        .e = mt},
                       before);
    } else {
      for_each_entry(n, [&](std::size_t i) { argument_[i] = y0[i] + now[i]; });
      rhs.stage(t + scheme.c[j - 1] * h,
                {.y1 = argument_.data(),
                 .a = 0,
                 .d = mt,
                 .y2 = before.data(),
                 .b = n_j,
                 .y0 = now.data(),
                 .c = m,
                 .f0 = argument_.data(),
                 .e = 0},
                before);
    }
    std::swap(now, before);
  }
  if (scheme.finish) return finish(rhs, scheme, t, h, y0, f0);
  for_each_entry(n, [&](std::size_t i) { now[i] += y0[i]; });
}

void ThreeTermEngine::finish(Rhs& rhs, const ThreeTermScheme& scheme, double t, double h,
                             std::span<const double> y0, std::span<const double> f0) {
  const std::size_t n = y0.size(), recurrence = at(scheme.recurrence_stages());
  const auto& a = scheme.finish->a;
  const auto& b = scheme.finish->b;
  const auto sweep = [&](std::size_t k, std::span<const double> change) {
    if (evaluates_changes(rhs)) {
      rhs.linear_stage({.y1 = change.data(),
                        .a = 0,
                        .d = 1,
                        .y2 = change.data(),
                        .b = 0,
                        .y0 = change.data(),
                        .c = 0,
                        .f0 = f0.data(),
                        .e = 1},
                       slopes_[k]);
    } else {
      for_each_entry(n, [&](std::size_t i) { argument_[i] = y0[i] + change[i]; });
      rhs(t + scheme.c[recurrence + k] * h, argument_, slopes_[k]);
    }
  };
  auto &now = result_, &stage = previous_;
  const auto &f1 = slopes_[0], &f2 = slopes_[1], &f3 = slopes_[2], &f4 = slopes_[3];
  sweep(0, now);
  for_each_entry(n, [&](std::size_t i) { stage[i] = now[i] + h * (a[0][0] * f1[i]); });
  sweep(1, stage);
  for_each_entry(n, [&](std::size_t i) { stage[i] = now[i] + h * (a[1][0] * f1[i] + a[1][1] * f2[i]); });
  sweep(2, stage);
  for_each_entry(n, [&](std::size_t i) {
    stage[i] = now[i] + h * (a[2][0] * f1[i] + a[2][1] * f2[i] + a[2][2] * f3[i]);
  });
  sweep(3, stage);
  for_each_entry(n, [&](std::size_t i) {
    result_[i] = y0[i] + (now[i] + h * (b[0] * f1[i] + b[1] * f2[i] + b[2] * f3[i] + b[3] * f4[i]));
  });
}

}  // namespace superstep
