#include "integrators/detail/exponential/duhamel_coefficients.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "integrators/detail/exponential/chebyshev_exponential.hpp"

namespace superstep {
namespace {

constexpr int points = 16;

struct GaussLegendre {
  std::array<double, points> node{}, weight{};  ///< on [0, 1]
  /// Newton on the Legendre polynomial of degree 16, from Chebyshev points.
  GaussLegendre() {
    for (std::size_t k = 0; k < points; ++k) {
      double x = std::cos(std::numbers::pi * (static_cast<double>(k) + 0.75) / (points + 0.5)), slope = 1;
      for (int iteration = 0; iteration < 10; ++iteration) {
        double before = 1, value = x;
        for (int j = 2; j <= points; ++j) {
          const double next = ((2 * j - 1) * x * value - (j - 1) * before) / j;
          before = value;
          value = next;
        }
        slope = points * (x * value - before) / (x * x - 1);
        x -= value / slope;
      }
      node[k] = 0.5 * (1 + x);
      weight[k] = 1 / ((1 - x * x) * slope * slope);
    }
  }
};

/// Adds weight * T_p(x) to out[p].
void add_chebyshev(double x, double weight, std::vector<double>& out) {
  double before = 1, value = x;
  out[0] += weight;
  for (std::size_t p = 1; p < out.size(); ++p) {
    out[p] += weight * value;
    const double next = 2 * x * value - before;
    before = value;
    value = next;
  }
}

/// Coefficients of sum_k f_k T_k(x) from values at the Chebyshev points x_j = cos((j + 1/2) pi/n), made exact
/// at x = 1: the mode without decay, which carries the heat of an insulated network, gets its value to
/// rounding.
std::vector<double> transform(const std::vector<double>& values, double value_at_one) {
  const std::size_t n = values.size();
  std::vector<double> cosine(4 * n), out(n);
  for (std::size_t m = 0; m < 4 * n; ++m)
    cosine[m] = std::cos(std::numbers::pi * static_cast<double>(m) / (2 * static_cast<double>(n)));
  for (std::size_t k = 0; k < n; ++k) {
    double sum = 0;
    for (std::size_t j = 0; j < n; ++j) sum += values[j] * cosine[(k * (2 * j + 1)) % (4 * n)];
    out[k] = (k == 0 ? 1.0 : 2.0) / static_cast<double>(n) * sum;
    value_at_one -= out[k];
  }
  out[0] += value_at_one;
  return out;
}

/// Samples state(mu) and source(mu)[p] over the spectrum and transforms them.
template <class State, class Source>
DuhamelCoefficients expand(const DuhamelPanel& panel, std::size_t terms, State state, Source source) {
  const auto degrees = static_cast<std::size_t>(panel.degree) + 1;
  std::vector<double> state_values(terms);
  std::vector<std::vector<double>> source_values(degrees, std::vector<double>(terms));
  for (std::size_t j = 0; j < terms; ++j) {
    const double angle = (static_cast<double>(j) + 0.5) * std::numbers::pi / static_cast<double>(terms);
    const double s = std::sin(angle / 2);
    const double mu = panel.h * panel.rho * s * s;  // h lambda = h rho/2 (1 - cos angle)
    state_values[j] = state(mu);
    const auto moments = source(mu);
    for (std::size_t p = 0; p < degrees; ++p) source_values[p][j] = moments[p];
  }
  const auto without_decay = source(0);
  DuhamelCoefficients out{transform(state_values, state(0)), {}};
  for (std::size_t p = 0; p < degrees; ++p)
    out.source.push_back(transform(source_values[p], without_decay[p]));
  return out;
}

/// (1 - exp(-mu))/mu
double phi1(double mu) {
  return mu > 1e-8 ? -std::expm1(-mu) / mu : 1 - mu / 2;
}

}  // namespace

std::vector<double> exponential_moments(double mu, int degree) {
  static const GaussLegendre rule;
  constexpr double beyond_rounding = 42, decay_per_piece = 6;
  std::vector<double> out(static_cast<std::size_t>(degree) + 1, 0.0);
  const double end = std::min(1.0, beyond_rounding / std::max(mu, 1e-300));
  const int pieces = std::max(1, static_cast<int>(std::ceil(mu * end / decay_per_piece)));
  const double width = end / pieces;
  for (int piece = 0; piece < pieces; ++piece)
    for (std::size_t k = 0; k < points; ++k) {
      const double w = width * (piece + rule.node[k]);
      add_chebyshev(1 - 2 * w, width * rule.weight[k] * std::exp(-mu * w), out);
    }
  return out;
}

std::vector<double> chebyshev_integrals(int degree) {
  std::vector<double> out;
  for (int p = 0; p <= degree; ++p) out.push_back(p % 2 == 1 ? 0.0 : 1 / (1 - static_cast<double>(p) * p));
  return out;
}

std::size_t duhamel_terms(const DuhamelPanel& panel, double tolerance) {
  return exponential_series(panel.h * panel.rho / 2, tolerance, {.by_rate = true, .rate = 1}).c.size() +
         static_cast<std::size_t>(panel.degree) + 4;
}

DuhamelCoefficients end_coefficients(const DuhamelPanel& panel, std::size_t terms) {
  return expand(
      panel, terms, [](double mu) { return std::exp(-mu); },
      [&](double mu) {
        auto moments = exponential_moments(mu, panel.degree);
        for (double& moment : moments) moment *= panel.h;
        return moments;
      });
}

DuhamelCoefficients integral_coefficients(const DuhamelPanel& panel, std::size_t terms) {
  const auto whole = chebyshev_integrals(panel.degree);
  return expand(
      panel, terms, [&](double mu) { return panel.h * phi1(mu); },
      [&](double mu) {
        // integral_0^1 (1 - exp(-mu w))/mu T_p(1 - 2 w) dw; below mu = 1 by differences of moments in mu.
        std::vector<double> out(whole.size(), 0.0);
        if (mu > 1) {
          const auto moments = exponential_moments(mu, panel.degree);
          for (std::size_t p = 0; p < out.size(); ++p) out[p] = (whole[p] - moments[p]) / mu;
        } else {
          static const GaussLegendre rule;
          for (std::size_t k = 0; k < points; ++k)
            add_chebyshev(1 - 2 * rule.node[k], rule.weight[k] * rule.node[k] * phi1(mu * rule.node[k]), out);
        }
        for (double& value : out) value *= panel.h * panel.h;
        return out;
      });
}

}  // namespace superstep
