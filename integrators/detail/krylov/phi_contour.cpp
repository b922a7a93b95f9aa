#include "integrators/detail/krylov/phi_contour.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace superstep {

void HessenbergBand::prepare(std::size_t most, std::size_t depth) {
  width_ = depth + 1;
  entry_.assign((most + 1) * width_, 0.0);
}

void HessenbergBand::clear() noexcept {
  std::fill(entry_.begin(), entry_.end(), 0.0);
}

PhiContour::PhiContour() {
  constexpr double n = 2 * pairs;
  for (std::size_t p = 0; p < pairs; ++p) {
    const double theta = static_cast<double>(2 * p + 1) * std::numbers::pi / n;
    const double angle = 0.6407 * theta, sine = std::sin(angle), cot = std::cos(angle) / sine;
    const std::complex<double> s = {n * (0.5017 * theta * cot - 0.6122), n * 0.2645 * theta};
    const std::complex<double> slope = {n * 0.5017 * (cot - angle / (sine * sine)), n * 0.2645};
    node_.re[p] = s.real();
    node_.im[p] = s.imag();
    // Twice the real part: the other half of the contour is the conjugate.
    std::complex<double> weight = 2.0 / n * std::exp(s) * slope / std::complex<double>(0, 1);
    for (auto& of_order : weight_) {
      of_order.re[p] = weight.real();
      of_order.im[p] = weight.imag();
      weight /= s;
    }
  }
}

void PhiContour::solve(const HessenbergBand& matrix, std::size_t m, double h) noexcept {
  x_[m - 1].re.fill(1.0);
  x_[m - 1].im.fill(0.0);
  for (std::size_t row = m; row-- > 0;) {
    // (s - h H) x in this row, but for the entry before the diagonal.
    const double diagonal = h * matrix.at(row, row);
    Complex sum;
    const Complex& own = x_[row];
    for (std::size_t p = 0; p < pairs; ++p) {
      const double re = node_.re[p] - diagonal, im = node_.im[p];
      sum.re[p] = re * own.re[p] - im * own.im[p];
      sum.im[p] = re * own.im[p] + im * own.re[p];
    }
    for (std::size_t column = row + 1; column < std::min(m, row + matrix.depth()); ++column) {
      const double value = h * matrix.at(row, column);
      for (std::size_t p = 0; p < pairs; ++p) {
        sum.re[p] -= value * x_[column].re[p];
        sum.im[p] -= value * x_[column].im[p];
      }
    }
    if (row > 0) {
      const double inverse = 1 / (h * matrix.at(row, row - 1));
      for (std::size_t p = 0; p < pairs; ++p) {
        x_[row - 1].re[p] = inverse * sum.re[p];
        x_[row - 1].im[p] = inverse * sum.im[p];
      }
      continue;
    }
    for (int k = 0; k <= highest; ++k) {
      const auto& weight = weight_[static_cast<std::size_t>(k)];
      auto& scaled = scaled_[static_cast<std::size_t>(k)];
      for (std::size_t p = 0; p < pairs; ++p) {
        const double square = sum.re[p] * sum.re[p] + sum.im[p] * sum.im[p];
        scaled.re[p] = (weight.re[p] * sum.re[p] + weight.im[p] * sum.im[p]) / square;
        scaled.im[p] = (weight.im[p] * sum.re[p] - weight.re[p] * sum.im[p]) / square;
      }
    }
  }
}

double PhiContour::entry(int k, std::size_t j) const noexcept {
  const auto& scaled = scaled_[static_cast<std::size_t>(k)];
  double sum = 0;
  for (std::size_t p = 0; p < pairs; ++p) sum += scaled.re[p] * x_[j].re[p] - scaled.im[p] * x_[j].im[p];
  return sum;
}

}  // namespace superstep
