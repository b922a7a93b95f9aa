#include "parallel/exact_sum.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace superstep {
namespace {

constexpr std::uint64_t digit = 0xffffffffu;
constexpr int digit_bits = 32;

/// Mantissa and position [bits above 2^-1074] of a finite number's size.
struct Parts {
  std::uint64_t mantissa;
  std::uint32_t position;
};

Parts parts_of(std::uint64_t bits) noexcept {
  constexpr std::uint64_t fraction = (std::uint64_t{1} << 52) - 1;
  const auto exponent = static_cast<std::uint32_t>(bits >> 52 & 0x7ff);
  if (exponent == 0) return {bits & fraction, 0};
  return {(bits & fraction) | (fraction + 1), exponent - 1};
}

/// mantissa 2^(position - 1074), rounded to nearest, ties to even. The mantissa's highest bit is set; its
/// lowest stands for all that lies below it, too.
double rounded(std::uint64_t mantissa, int position) noexcept {
  const int drop = std::max(11, -position);  // bits: 53 stay, and none below 2^-1074
  if (drop > 63) return 0;                   // cannot happen: limbs end at 2^-1074
  const std::uint64_t half = std::uint64_t{1} << (drop - 1), rest = mantissa & (2 * half - 1);
  std::uint64_t kept = mantissa >> drop;
  if (rest > half || (rest == half && (kept & 1) != 0)) ++kept;
  return std::ldexp(static_cast<double>(kept), position + drop - 1074);
}

}  // namespace

void ExactSum::add(double term) noexcept {
  const auto bits = std::bit_cast<std::uint64_t>(term);
  const bool negative = bits >> 63 != 0;
  if (!std::isfinite(term)) {
    ++(std::isnan(term) ? nan_ : negative ? negative_infinity_ : positive_infinity_);
    return;
  }
  const auto [mantissa, position] = parts_of(bits);
  const std::uint32_t shift = position % digit_bits;
  const std::uint64_t low = (mantissa & digit) << shift,
                      high = ((mantissa >> digit_bits) << shift) + (low >> digit_bits);
  const auto first = static_cast<std::int64_t>(low & digit), second = static_cast<std::int64_t>(high & digit),
             third = static_cast<std::int64_t>(high >> digit_bits);
  std::int64_t* limb = limb_.data() + position / digit_bits;
  if (negative) {
    limb[0] -= first;
    limb[1] -= second;
    limb[2] -= third;
  } else {
    limb[0] += first;
    limb[1] += second;
    limb[2] += third;
  }
  constexpr std::uint32_t most = std::uint32_t{1} << 29;  // terms that a limb has room for
  if (++since_carry_ == most) carry();
}

void ExactSum::add(const ExactSum& other) noexcept {
  ExactSum normal = other;
  normal.carry();
  carry();
  for (std::size_t k = 0; k < limbs; ++k) limb_[k] += normal.limb_[k];
  nan_ += other.nan_;
  positive_infinity_ += other.positive_infinity_;
  negative_infinity_ += other.negative_infinity_;
  since_carry_ = 2;
}

/// Every limb but the last, which has the sign, becomes a digit.
void ExactSum::carry() noexcept {
  std::int64_t carried = 0;
  for (std::size_t k = 0; k + 1 < limbs; ++k) {
    const std::int64_t sum = limb_[k] + carried;
    limb_[k] = sum & static_cast<std::int64_t>(digit);
    carried = sum >> digit_bits;
  }
  limb_.back() += carried;
  since_carry_ = 1;
}

double ExactSum::value() const noexcept {
  if (nan_ > 0 || (positive_infinity_ > 0 && negative_infinity_ > 0))
    return std::numeric_limits<double>::quiet_NaN();
  if (positive_infinity_ > 0) return std::numeric_limits<double>::infinity();
  if (negative_infinity_ > 0) return -std::numeric_limits<double>::infinity();
  ExactSum sum = *this;
  sum.carry();
  const bool negative = sum.limb_.back() < 0;
  if (negative) {
    for (auto& limb : sum.limb_) limb = -limb;
    sum.carry();
  }
  std::size_t top = limbs - 1;
  while (top > 0 && sum.limb_[top] == 0) --top;
  const auto at = [&](std::size_t below) {
    return below <= top ? static_cast<std::uint64_t>(sum.limb_[top - below]) : 0;
  };
  if (at(0) == 0) return 0;
  // The highest three digits hold 65 bits or more; what lies below only says whether there is anything.
  std::uint64_t mantissa = at(0) << digit_bits | at(1);
  const int lead = std::countl_zero(mantissa);
  std::uint64_t below = at(2);
  if (lead > 0) {
    mantissa = mantissa << lead | below >> (digit_bits - lead);
    below &= digit >> lead;
  }
  bool rest = below != 0;
  for (std::size_t k = 3; k <= top && !rest; ++k) rest = at(k) != 0;
  if (rest) mantissa |= 1;
  const double size = rounded(mantissa, digit_bits * (static_cast<int>(top) - 1) - lead);
  return negative ? -size : size;
}

ExactSum::Words ExactSum::words() const noexcept {
  ExactSum normal = *this;
  normal.carry();
  Words out;
  std::copy(normal.limb_.begin(), normal.limb_.end(), out.begin());
  out[limbs] = nan_;
  out[limbs + 1] = positive_infinity_;
  out[limbs + 2] = negative_infinity_;
  return out;
}

ExactSum ExactSum::of(const Words& words) noexcept {
  ExactSum sum;
  std::copy(words.begin(), words.begin() + limbs, sum.limb_.begin());
  sum.nan_ = words[limbs];
  sum.positive_infinity_ = words[limbs + 1];
  sum.negative_infinity_ = words[limbs + 2];
  sum.carry();
  return sum;
}

}  // namespace superstep
