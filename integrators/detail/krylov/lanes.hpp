#pragma once
/// Sums over entries in eight lanes, whatever the width of a vector register: AVX2 and AVX-512 agree bit by
/// bit.

#include <array>

#include "rhs/kernels/packs.hpp"

namespace superstep {

inline constexpr std::size_t lanes = 8;

template <std::size_t width>
using Lanes = std::array<typename Vector<width>::type, lanes / width>;

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

/// Sum of all lanes and of what the entries after them add, in an order that the width does not change.
template <std::size_t width>
SUPERSTEP_INLINE double total(const Lanes<width>& sums, std::array<double, lanes> rest) {
  std::array<double, lanes> s;
  std::memcpy(s.data(), sums.data(), sizeof(s));
  for (std::size_t k = 0; k < lanes; ++k) s[k] += rest[k];
  return ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
}

}  // namespace superstep
