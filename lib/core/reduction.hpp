#pragma once
/// Sums and maxima over owned entries with a fixed tree of chunks: the same bits for any number of threads.

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "core/parallel.hpp"

namespace superstep {

/// The one place where integrators add up entries. A distributed sum would extend `sum` and `max` here.
class Reduction {
 public:
  static constexpr std::size_t chunk = 1024;

  explicit Reduction(std::size_t size) : size_(size), chunk_sum_((size + chunk - 1) / chunk) {}
  [[nodiscard]] std::size_t size() const noexcept { return size_; }

  /// Sum of term(i) over [0, size). Threads share the chunks, so that term must not depend on the order of
  /// its calls; two threads must not use one Reduction at the same time.
  template <class Term>
  [[nodiscard]] double sum(Term term) const {
    for_ranges(chunk_sum_.size(), size_, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k)
        chunk_sum_[k] = sum_chunk(k * chunk, std::min((k + 1) * chunk, size_), term);
    });
    return sum_of_chunks(0, chunk_sum_.size());
  }

  /// Largest term(i) over [0, size), at least `floor`. A NaN term makes the result NaN.
  template <class Term>
  [[nodiscard]] double max(Term term, double floor = 0.0) const {
    double largest = floor;
    for (std::size_t i = 0; i < size_; ++i) {
      const double value = term(i);
      if (!(value <= largest)) largest = value;
      if (value != value) return value;
    }
    return largest;
  }

 private:
  // Eight running sums let the compiler use vector registers without changing the order from run to run.
  template <class Term>
  [[nodiscard]] double sum_chunk(std::size_t begin, std::size_t end, const Term& term) const {
    constexpr std::size_t lanes = 8;
    std::array<double, lanes> partial{};
    std::size_t i = begin;
    for (; i + lanes <= end; i += lanes)
      for (std::size_t lane = 0; lane < lanes; ++lane) partial[lane] += term(i + lane);
    for (std::size_t lane = 0; i < end; ++i, ++lane) partial[lane] += term(i);
    return ((partial[0] + partial[4]) + (partial[2] + partial[6])) +
           ((partial[1] + partial[5]) + (partial[3] + partial[7]));
  }

  [[nodiscard]] double sum_of_chunks(std::size_t first, std::size_t last) const {
    if (last - first <= 1) return first == last ? 0.0 : chunk_sum_[first];
    const std::size_t middle = first + (last - first) / 2;
    return sum_of_chunks(first, middle) + sum_of_chunks(middle, last);
  }

  std::size_t size_;
  mutable std::vector<double> chunk_sum_;  ///< room for the sums of the chunks
};

}  // namespace superstep
