#include "bench/lab/chain.hpp"

#include <cmath>
#include <numbers>

namespace superstep {
namespace {

constexpr long double pi = std::numbers::pi_v<long double>;

}  // namespace

Chain::Chain(std::size_t free_nodes) : network_(chain_network(free_nodes)), n_(free_nodes) {
  const auto intervals = static_cast<long double>(n_ + 1);
  for (std::size_t k = 0; k < 2 * (n_ + 1); ++k)
    sine_.push_back(std::sin(static_cast<long double>(k) * pi / intervals));
  for (std::size_t m = 1; m <= n_; ++m) {
    const long double half = std::sin(static_cast<long double>(m) * pi / (2 * intervals));
    rate_.push_back(4 * half * half);
    long double sum = 0;
    for (std::size_t k = 1; k <= n_; ++k) sum += (network_.graph.initial[k] - steady(k)) * sine(m, k);
    part_.push_back(2 / intervals * sum);
  }
}

long double Chain::sine(std::size_t mode, std::size_t node) const noexcept {
  return sine_[mode * node % sine_.size()];
}

long double Chain::steady(std::size_t node) const noexcept {
  return static_cast<long double>(node) / static_cast<long double>(n_ + 1);
}

std::vector<double> Chain::evolved(const std::function<long double(long double rate)>& factor) const {
  std::vector<long double> remaining;
  for (std::size_t m = 0; m < n_; ++m) remaining.push_back(part_[m] * factor(rate_[m]));
  std::vector<double> state;
  for (const auto node : network_.rhs->network().node_of_row) {
    const auto k = static_cast<std::size_t>(node);
    long double value = steady(k);
    for (std::size_t m = 0; m < n_; ++m) value += remaining[m] * sine(m + 1, k);
    state.push_back(static_cast<double>(value));
  }
  return state;
}

}  // namespace superstep
