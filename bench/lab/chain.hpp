#pragma once
/// A chain with its modes in closed form: exact evolution under any function of the rates.

#include <functional>
#include <vector>

#include "bench/lab/networks.hpp"

namespace superstep {

/// The chain of `chain_network`: y = steady profile + sum_m b_m sin(m pi k/(n+1)), rates 4 sin^2(m
/// pi/(2(n+1))). Sums in long double, so that what differs from a computed state is the state's own rounding.
class Chain {
 public:
  explicit Chain(std::size_t free_nodes);

  [[nodiscard]] NetworkRhs& rhs() noexcept { return *network_.rhs; }
  [[nodiscard]] const std::vector<double>& initial() const noexcept { return network_.initial; }
  [[nodiscard]] double largest_rate() const noexcept { return static_cast<double>(rate_.back()); }
  /// State in which each mode was multiplied by factor(rate), as the right-hand side orders it.
  [[nodiscard]] std::vector<double> evolved(const std::function<long double(long double rate)>& factor) const;

 private:
  [[nodiscard]] long double sine(std::size_t mode, std::size_t node) const noexcept;
  [[nodiscard]] long double steady(std::size_t node) const noexcept;

  LaboratoryNetwork network_;
  std::size_t n_;
  std::vector<long double> sine_;         ///< [2(n+1)] sin(k pi/(n+1))
  std::vector<long double> rate_, part_;  ///< [n] rates ascending, b_m
};

}  // namespace superstep
