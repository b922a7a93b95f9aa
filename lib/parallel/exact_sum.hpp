#pragma once
/// Sums of doubles without any rounding until the end: the result is the same in whatever order, in whatever
/// groups and by however many processes the terms are added up.
///
///   value = sum over k of limb[k] 2^(32 k - 1074)
///   Each limb holds 32 bits and room for carries, so that sums of limbs are plain integer sums.
/// Source of the idea: Kulisch's long accumulator; as integers Demmel & Nguyen (2013),
/// doi:10.1109/ARITH.2013.9; Neal (2015), arXiv:1505.05571.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace superstep {

class ExactSum {
 public:
  void add(double term) noexcept;
  /// All that went into another sum.
  void add(const ExactSum& other) noexcept;
  /// The exact sum, rounded once, to nearest. NaN or an infinity where a term was one.
  [[nodiscard]] double value() const noexcept;

  /// What the sum is made of: words that can be added up with those of other processes, up to two thousand
  /// million of them.
  static constexpr std::size_t word_count = 71;
  using Words = std::array<std::int64_t, word_count>;
  [[nodiscard]] Words words() const noexcept;
  [[nodiscard]] static ExactSum of(const Words& words) noexcept;

 private:
  static constexpr std::size_t limbs = 68;  // 2^-1074 to 2^1024 and 78 bits for carries
  void carry() noexcept;

  std::array<std::int64_t, limbs> limb_{};
  std::int64_t nan_ = 0, positive_infinity_ = 0, negative_infinity_ = 0;  ///< terms of that kind
  std::uint32_t since_carry_ = 0;                                         ///< terms
};

}  // namespace superstep
