#pragma once
/// What runs under the integrators of SUNDIALS share: tolerances, inflow, probes, messages.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "integrators/detail/error_norm.hpp"
#include "integrators/detail/implicit/sundials.hpp"
#include "integrators/probe_history.hpp"
#include "rhs/rhs.hpp"

namespace superstep::sundials {

/// The last message of a package; its address is the handler's data.
struct Message {
  std::string text;
  static void keep(int /*code*/, const char* /*module*/, const char* function, char* message,
                   void* self) noexcept {
    try {
      static_cast<Message*>(self)->text = fmt::format("{}: {}", function, message);
    } catch (...) {  // out of memory while reporting: the flag alone has to do
    }
  }
};

/// Weights of local errors: 1 = `share` of what the run allows.
inline void set_weights(const ErrorNorm& norm, double share, N_Vector y, N_Vector inverse) {
  const auto values = entries(y), out = entries(inverse);
  constexpr double roundings = 8 * std::numeric_limits<double>::epsilon();  // below them no step would pass
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double weight = norm.weight(i);
    out[i] = weight > 0 ? 1 / std::max(share / weight, roundings * std::abs(values[i])) : 1e-30;
  }
}

/// What entered between two instants of a step, by Gauss points on its interpolant [J or C].
///   differentiate(t, k)  puts the k-th derivative at t into `derivative`; false = it cannot
template <class Differentiate>
[[nodiscard]] double inflow_between(Rhs& rhs, double begin, double end, N_Vector derivative,
                                    Differentiate differentiate) {
  static constexpr double node = 0.7745966692414834;  // sqrt(3/5): Gauss-Legendre, exact to degree 5
  const double middle = 0.5 * (begin + end), half = 0.5 * (end - begin);
  double sum = 0;
  for (const auto& [position, weight] : {std::pair{-node, 5.0 / 9}, {0.0, 8.0 / 9}, {node, 5.0 / 9}}) {
    const double t = middle + position * half;
    if (differentiate(t, 0)) sum += weight * half * rhs.inflow(t, entries(derivative));
  }
  return sum;
}

/// Hands the Taylor polynomials of the probes at a step's end to the history.
template <class Differentiate>
void record_taylor(double t, int order, std::span<const std::size_t> probes, N_Vector derivative,
                   Differentiate differentiate, std::vector<double>& taylor, ProbeHistory& history) {
  taylor.resize(probes.size() * (static_cast<std::size_t>(order) + 1));
  double factorial = 1;
  for (int k = 0; k <= order; ++k) {
    if (k > 1) factorial *= k;
    if (!differentiate(t, k)) return;
    const auto values = entries(derivative);
    for (std::size_t p = 0; p < probes.size(); ++p)
      taylor[static_cast<std::size_t>(k) * probes.size() + p] = values[probes[p]] / factorial;
  }
  history.append(t, std::span<const double>(taylor), order);
}

}  // namespace superstep::sundials
