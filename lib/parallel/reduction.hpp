#pragma once
/// Sums and maxima over the entries of a state: the same bits for any number of threads and of processes.

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/parallel.hpp"
#include "parallel/communicator.hpp"
#include "parallel/lane_sum.hpp"

namespace superstep {

/// The one place where integrators add up entries.
///
/// Entries are added up in chunks, each in a fixed order, and the chunks exactly. Chunks begin where a field
/// does and never straddle two blocks of a partition, so that they are the same whoever has them.
class Reduction {
 public:
  /// Of a state that is all here.
  explicit Reduction(std::size_t size) : Reduction(std::array{size}, size, nullptr) {}
  ///   parts  entries of each field that are here, one field behind the other
  ///   total  entries here and elsewhere;  among  the processes that have them, null = all are here
  Reduction(std::span<const std::size_t> parts, std::size_t total, Communicator* among)
      : total_(total), among_(among) {
    const std::size_t chunk = chunk_rows();
    for (const std::size_t part : parts) {
      for (std::size_t k = 0; k < part; k += chunk) chunk_begin_.push_back(size_ + k);
      size_ += part;
    }
    chunk_begin_.push_back(size_);
    chunk_sum_.resize(chunk_begin_.size() - 1);
  }

  /// Entries that are here, and all there are.
  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] std::size_t total() const noexcept { return total_; }
  /// Those that share the state; null = all of it is here.
  [[nodiscard]] Communicator* among() const noexcept { return among_; }

  /// Sum of term(i) over all entries. Threads share the chunks, so that term must not depend on the order of
  /// its calls; two threads must not use one Reduction at the same time.
  template <class Term>
  [[nodiscard]] double sum(Term term) const {
    return sum_of_ranges([&](std::size_t first, std::size_t last) { return sum_chunk(first, last, term); });
  }

  /// Sum of part(first, last) over ranges that make up all entries: of a kernel that adds up by itself.
  template <class Part>
  [[nodiscard]] double sum_of_ranges(const Part& part) const {
    for_ranges(chunk_sum_.size(), size_, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k) chunk_sum_[k] = part(chunk_begin_[k], chunk_begin_[k + 1]);
    });
    return sum_of_chunks();
  }

  /// Largest term(i) over all entries, at least `floor`. A NaN term makes the result NaN.
  template <class Term>
  [[nodiscard]] double max(Term term, double floor = 0.0) const {
    double largest = floor;
    for (std::size_t i = 0; i < size_ && largest == largest; ++i) {
      const double value = term(i);
      if (!(value <= largest)) largest = value;
    }
    return among_ ? among_->max(largest) : largest;
  }

  /// Whether it is so anywhere.
  [[nodiscard]] bool any(bool here) const { return among_ ? among_->any(here) : here; }
  /// Of every process's one.
  [[nodiscard]] double largest(double here) const { return among_ ? among_->max(here) : here; }
  [[nodiscard]] double smallest(double here) const { return among_ ? among_->min(here) : here; }
  [[nodiscard]] double sum(const ExactSum& here) const { return among_ ? among_->sum(here) : here.value(); }

 private:
  template <class Term>
  [[nodiscard]] double sum_chunk(std::size_t begin, std::size_t end, const Term& term) const {
    std::array<double, sum_lanes> partial{};
    std::size_t i = begin;
    for (; i + sum_lanes <= end; i += sum_lanes)
      for (std::size_t lane = 0; lane < sum_lanes; ++lane) partial[lane] += term(i + lane);
    for (std::size_t lane = 0; i < end; ++i, ++lane) partial[lane] += term(i);
    return sum_of_lanes(partial);
  }

  [[nodiscard]] double sum_of_chunks() const {
    if (!among_ && chunk_sum_.size() == 1) return chunk_sum_.front() + 0.0;  // -0 is 0 in an exact sum
    ExactSum all;
    for (const double part : chunk_sum_) all.add(part);
    return sum(all);
  }

  std::size_t size_ = 0, total_ = 0;
  Communicator* among_ = nullptr;
  std::vector<std::size_t> chunk_begin_;   ///< [chunks + 1]
  mutable std::vector<double> chunk_sum_;  ///< room for the sums of the chunks
};

/// A sum over some of the rows, given in ascending order: by the same chunks.
class RowSum {
 public:
  void add(std::size_t row, double term) noexcept {
    if (const std::size_t chunk = row / rows_; chunk != chunk_) {
      flush();
      chunk_ = chunk;
    }
    running_ += term;
  }
  /// What has been added up so far.
  [[nodiscard]] const ExactSum& exact() noexcept {
    flush();
    return sum_;
  }

 private:
  void flush() noexcept {
    if (running_ != 0) sum_.add(running_);  // true for NaN, too
    running_ = 0;
  }
  std::size_t rows_ = chunk_rows(), chunk_ = 0;
  double running_ = 0;
  ExactSum sum_;
};

}  // namespace superstep
