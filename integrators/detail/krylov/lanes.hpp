#pragma once
/// Sums over entries in eight lanes, whatever the width of a vector register: AVX2 and AVX-512 agree bit by
/// bit.

#include <array>

#include "parallel/lane_sum.hpp"
#include "rhs/kernels/packs.hpp"

namespace superstep {

template <std::size_t width>
SUPERSTEP_INLINE void load(const double* from, typename Vector<width>::type& out) {
  std::memcpy(&out, from, sizeof(out));
}

template <std::size_t width>
SUPERSTEP_INLINE void load(const float* from, typename Vector<width>::type& out) {
  typedef float Single __attribute__((vector_size(width * sizeof(float))));
  Single single;
  std::memcpy(&single, from, sizeof(single));
  out = __builtin_convertvector(single, typename Vector<width>::type);
}

template <std::size_t width>
SUPERSTEP_INLINE void store(const typename Vector<width>::type& value, double* to) {
  std::memcpy(to, &value, sizeof(value));
}

template <std::size_t width>
SUPERSTEP_INLINE void store(const typename Vector<width>::type& value, float* to) {
  typedef float Single __attribute__((vector_size(width * sizeof(float))));
  const Single single = __builtin_convertvector(value, Single);
  std::memcpy(to, &single, sizeof(single));
}

/// Sum over entries [first, last) in an order that the width does not change.
///   add(i, sum)  adds the `width` entries from i on to a register;  term(i)  says what one entry adds
template <std::size_t width, class Add, class Term>
SUPERSTEP_INLINE double sum_in_lanes(std::size_t first, std::size_t last, const Add& add, const Term& term) {
  std::array<typename Vector<width>::type, sum_lanes / width> registers{};
  std::size_t i = first;
  for (; i + sum_lanes <= last; i += sum_lanes)
    for (std::size_t p = 0; p < registers.size(); ++p) add(i + p * width, registers[p]);
  std::array<double, sum_lanes> sums;
  std::memcpy(sums.data(), registers.data(), sizeof(sums));
  for (std::size_t lane = 0; i < last; ++i, ++lane) sums[lane] += term(i);
  return sum_of_lanes(sums);
}

}  // namespace superstep
