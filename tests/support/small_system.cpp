#include "support/small_system.hpp"

#include <cmath>
#include <stdexcept>

namespace superstep::test {

SmallSystem::SmallSystem(std::size_t size, double radius, Function f)
    : Rhs(size, {}, {{.name = "temperature", .unit = "K", .offset = 0, .stride = 1, .count = size}}),
      radius_(radius),
      f_(std::move(f)),
      capacities_(size, 1.0),
      rate_(size) {
  facts_.pair_step = 2 / radius;
  facts_.fields.resize(1);
}

double SmallSystem::inflow(double t, std::span<const double> y) {
  std::vector<double> rate(y.size());
  f_(t, y, rate);
  double sum = 0;
  for (const double r : rate) sum += r;
  return sum;
}

void SmallSystem::do_stage(double t, const Stage& s, std::span<double> out) {
  f_(t, {s.y1, size()}, rate_);
  for (std::size_t i = 0; i < size(); ++i)
    out[i] = s.a * s.y1[i] + (s.y2 ? s.b * s.y2[i] : 0) + (s.y0 ? s.c * s.y0[i] : 0) + s.d * rate_[i] +
             (s.f0 ? s.e * s.f0[i] : 0);
}

void SmallSystem::do_linear_stage(const Stage&, std::span<double>) {
  throw std::logic_error("linear_stage of a nonlinear system");
}

void SmallSystem::do_block_product(std::size_t, std::span<const double>, std::span<double>) {
  throw std::logic_error("block_product of a system without constant blocks");
}

void SmallSystem::do_jacobian(double t, std::span<const double> y, std::span<double> values) {
  std::vector<double> moved(y.begin(), y.end()), above(size()), below(size());
  for (std::size_t column = 0; column < size(); ++column) {
    const double change = 1e-6 * (1 + std::abs(y[column]));
    moved[column] = y[column] + change;
    f_(t, moved, above);
    moved[column] = y[column] - change;
    f_(t, moved, below);
    moved[column] = y[column];
    for (std::size_t row = 0; row < size(); ++row)
      values[column * size() + row] = (above[row] - below[row]) / (2 * change);
  }
}

SparsePattern SmallSystem::build_pattern() {
  SparsePattern dense;
  const auto n = static_cast<std::int64_t>(size());
  for (std::int64_t column = 0; column < n; ++column) {
    dense.column_begin.push_back(column * n);
    dense.diagonal.push_back(column * n + column);
    for (std::int64_t row = 0; row < n; ++row) dense.row.push_back(row);
  }
  dense.column_begin.push_back(n * n);
  return dense;
}

SmallSystem turning_system() {
  return {3, 8, [](double t, std::span<const double> y, std::span<double> dydt) {
            dydt[0] = -y[0] * y[1] + std::sin(2 * t) + 0.5 * y[2];
            dydt[1] = y[0] * y[0] - y[1] * std::exp(0.3 * y[2]) * (1 + 0.5 * std::cos(3 * t));
            dydt[2] = -2 * y[2] + y[0] * y[1] * y[2] + std::cos(t) / (1 + y[1] * y[1]);
          }};
}

std::vector<double> classical_runge_kutta(SmallSystem& system, std::vector<double> y, double t_end,
                                          std::size_t steps) {
  const std::size_t n = y.size();
  const double h = t_end / static_cast<double>(steps);
  std::vector<double> k1(n), k2(n), k3(n), k4(n), stage(n);
  const auto move = [&](const std::vector<double>& k, double part) {
    for (std::size_t i = 0; i < n; ++i) stage[i] = y[i] + part * h * k[i];
  };
  for (std::size_t step = 0; step < steps; ++step) {
    const double t = static_cast<double>(step) * h;
    system(t, y, k1);
    move(k1, 0.5);
    system(t + h / 2, stage, k2);
    move(k2, 0.5);
    system(t + h / 2, stage, k3);
    move(k3, 1);
    system(t + h, stage, k4);
    for (std::size_t i = 0; i < n; ++i) y[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  }
  return y;
}

}  // namespace superstep::test
