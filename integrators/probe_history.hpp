#pragma once
/// Values of a few entries at the step ends of a run, with dense output where the method has one.

#include <cstddef>
#include <span>
#include <vector>

namespace superstep {

class ProbeHistory {
 public:
  ProbeHistory() = default;
  explicit ProbeHistory(std::size_t probes) : probes_(probes) {}

  /// Forgets everything; keeps the memory.
  void clear() noexcept;
  void reserve(std::size_t steps);
  /// Step end at `t` with one value per probe.
  void append(double t, std::span<const double> values);
  /// The same, with the method's interpolant over the step that ends at t: y(t + s) = sum_k c_k s^k, s <= 0.
  ///   taylor  [(order+1) * probes]  c_0 of all probes, c_1 of all probes, ...; c_0 are the values at t
  void append(double t, std::span<const double> taylor, int order);

  [[nodiscard]] std::size_t probes() const noexcept { return probes_; }
  [[nodiscard]] std::size_t size() const noexcept { return time_.size(); }
  [[nodiscard]] double time(std::size_t step) const noexcept { return time_[step]; }
  [[nodiscard]] double value(std::size_t step, std::size_t probe) const noexcept;
  /// Value of a probe at any time inside the history: the interpolant, or linear between step ends without
  /// one.
  [[nodiscard]] double at(double t, std::size_t probe) const noexcept;

  /// Flat storage for a cache: time and order of each step, all coefficients one after the other.
  struct Data {
    std::vector<double> time;
    std::vector<int> order;
    std::vector<double> coefficient;
  };
  [[nodiscard]] Data data() const;
  [[nodiscard]] static ProbeHistory from(std::size_t probes, const Data& data);

 private:
  std::size_t probes_ = 0;
  std::vector<double> time_, coefficient_;
  std::vector<int> order_;
  std::vector<std::size_t> begin_;  // of each step in coefficient_
};

}  // namespace superstep
