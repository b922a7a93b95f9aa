#include "integrators/detail/krylov/tridiagonal_response.hpp"

#include <cmath>
#include <complex>
#include <numbers>

namespace superstep {
namespace {

using Complex = std::complex<double>;

/// z(x) = size (1 + sin(ix - angle)), x = k * step for k = 0 ... points, the lower half by symmetry. With
/// size * t at most 5 no term exceeds e^2.2, so that rounding does not grow. A pole at 0 of order p costs the
/// rule some (2 pi / step)^(p-1) of its accuracy, and a slow mode of T adds one: angle and step leave 1e-15
/// of t^p/p! for jumps (p = 1) and kinks (p = 2) and 2e-14 for the integrals of kinks (p = 3), also at the
/// first of times that are eight apart.
struct Hyperbola {
  static constexpr double accuracy = 34.5, largest = 5, angle = 0.6, step = 0.11;
  double size = 0;  ///< 1/s
  int points = 0;
  /// For times in [first, last]: until e^(zt) has fallen to 1e-15 at the first.
  Hyperbola(double first, double last) : size(largest / last) {
    const double reach = std::acosh((1 + accuracy / (size * first)) / std::sin(angle));
    points = static_cast<int>(std::ceil(reach / step));
  }
};

/// out = (zI + T)^-1 e_1, by elimination from the last row up: all the work on the right-hand side is then
/// in the first entry.
void solve_shifted(std::span<const double> alpha, std::span<const double> beta, Complex z,
                   std::vector<Complex>& pivot, std::vector<Complex>& out) {
  const std::size_t m = alpha.size();
  for (std::size_t j = m; j-- > 0;) {
    const double real = alpha[j] + z.real();
    // Division by hand: the general one of std::complex guards against overflow that cannot occur.
    const Complex below = j + 1 < m ? beta[j] * beta[j] * pivot[j + 1] : Complex{};
    const double re = real - below.real(), im = z.imag() - below.imag(), square = re * re + im * im;
    pivot[j] = {re / square, -im / square};  // its inverse
  }
  out[0] = pivot[0];
  for (std::size_t j = 1; j < m; ++j) {
    const Complex p = pivot[j], x = out[j - 1];
    out[j] = {-beta[j - 1] * (p.real() * x.real() - p.imag() * x.imag()),
              -beta[j - 1] * (p.real() * x.imag() + p.imag() * x.real())};
  }
}

/// Calls add(first, last, z, weight(t), (zI + T)^-1 e_1) for every node z of a contour that serves times
/// [first, last) of `times`, ascending and > 0: the sum of the real parts of weight(t) (zI + T)^-1 e_1 F(z)
/// is then the inverse Laplace transform of F(z) (zI + T)^-1 e_1 at t.
template <class Add>
void over_contours(std::span<const double> alpha, std::span<const double> beta, std::span<const double> times,
                   const Add& add) {
  constexpr double widest = 8;  // of the times that share a contour
  const std::size_t m = alpha.size();
  std::vector<Complex> pivot(m), solution(m);
  for (std::size_t first = 0, last = 0; first < times.size(); first = last) {
    while (last < times.size() && times[last] <= widest * times[first]) ++last;
    const Hyperbola path(times[first], times[last - 1]);
    for (int k = 0; k <= path.points; ++k) {
      const double x = k * Hyperbola::step, s = std::sin(Hyperbola::angle), c = std::cos(Hyperbola::angle);
      const Complex z(path.size * (1 - s * std::cosh(x)), path.size * c * std::sinh(x));
      const Complex slope(path.size * c * std::cosh(x), path.size * s * std::sinh(x));  // dz/dx / i
      const double half = k == 0 ? 0.5 : 1;  // both halves of the path give the same real part
      solve_shifted(alpha, beta, z, pivot, solution);
      add(first, last, z, half * Hyperbola::step / std::numbers::pi * slope, solution);
    }
  }
}

void add_real_part(Complex factor, const std::vector<Complex>& solution, std::vector<double>& out) {
  for (std::size_t j = 0; j < out.size(); ++j)
    out[j] += factor.real() * solution[j].real() - factor.imag() * solution[j].imag();
}

}  // namespace

std::vector<TridiagonalResponse> tridiagonal_responses(std::span<const double> alpha,
                                                       std::span<const double> beta,
                                                       std::span<const double> times) {
  const std::size_t m = alpha.size();
  std::vector<TridiagonalResponse> out(times.size(),
                                       {std::vector<double>(m, 0.0), std::vector<double>(m, 0.0)});
  if (m == 0) return out;
  over_contours(alpha, beta, times,
                [&](std::size_t first, std::size_t last, Complex z, Complex weight, const auto& solution) {
                  for (std::size_t i = first; i < last; ++i) {
                    const Complex value = weight * std::exp(z * times[i]) / z;
                    add_real_part(value, solution, out[i].value);
                    add_real_part(value / z, solution, out[i].integral);
                  }
                });
  return out;
}

TridiagonalResponse tridiagonal_response(std::span<const double> alpha, std::span<const double> beta,
                                         std::span<const TridiagonalInput> inputs) {
  const std::size_t m = alpha.size();
  TridiagonalResponse out{std::vector<double>(m, 0.0), std::vector<double>(m, 0.0)};
  std::vector<double> times;
  for (const auto& input : inputs) times.push_back(input.since);
  if (m == 0) return out;
  over_contours(alpha, beta, times,
                [&](std::size_t first, std::size_t last, Complex z, Complex weight, const auto& solution) {
                  Complex sum{};
                  for (std::size_t i = first; i < last; ++i)
                    sum += std::exp(z * times[i]) * (inputs[i].jump + inputs[i].kink / z);
                  const Complex value = weight * sum / z;
                  add_real_part(value, solution, out.value);
                  add_real_part(value / z, solution, out.integral);
                });
  return out;
}

}  // namespace superstep
