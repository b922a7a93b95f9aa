#pragma once
/// Nodes with two values side by side in vector registers, for kernels whose conductances follow the state.

#include "rhs/kernels/packs.hpp"
#include "rhs/kernels/varying_sweep.hpp"

namespace superstep {

/// A value and its s in one register.
typedef double PairPack __attribute__((vector_size(2 * sizeof(double))));

SUPERSTEP_INLINE PairPack load_pair(const NodePair* nodes, std::size_t k) {
  PairPack pair;
  std::memcpy(&pair, nodes + k, sizeof(pair));
  return pair;
}

template <std::size_t width>
SUPERSTEP_INLINE void split_pairs(const PairPack (&pair)[width], typename Vector<width>::type& value,
                                  typename Vector<width>::type& s) {
  using Four = Vector<4>::type;
  Four low_value, low_s;
  const auto four = [](const PairPack* p, Four& v, Four& f) __attribute__((always_inline)) {
    v = __builtin_shufflevector(__builtin_shufflevector(p[0], p[1], 0, 2),
                                __builtin_shufflevector(p[2], p[3], 0, 2), 0, 1, 2, 3);
    f = __builtin_shufflevector(__builtin_shufflevector(p[0], p[1], 1, 3),
                                __builtin_shufflevector(p[2], p[3], 1, 3), 0, 1, 2, 3);
  };
  four(pair, low_value, low_s);
  if constexpr (width == 4) {
    value = low_value;
    s = low_s;
  } else {
    Four high_value, high_s;
    four(pair + 4, high_value, high_s);
    value = __builtin_shufflevector(low_value, high_value, 0, 1, 2, 3, 4, 5, 6, 7);
    s = __builtin_shufflevector(low_s, high_s, 0, 1, 2, 3, 4, 5, 6, 7);
  }
}

template <std::size_t width>
SUPERSTEP_INLINE void gather_pairs(const NodePair* nodes, const std::int32_t* column,
                                   typename Vector<width>::type& value, typename Vector<width>::type& s) {
  PairPack pair[width];
  for (std::size_t k = 0; k < width; k += 2) {
    const NeighbourPair two(column + k);
    pair[k] = load_pair(nodes, two.first());
    pair[k + 1] = load_pair(nodes, two.second());
  }
  split_pairs<width>(pair, value, s);
}

template <std::size_t width>
SUPERSTEP_INLINE void own_nodes(const NodePair* nodes, std::size_t row, typename Vector<width>::type& value,
                                typename Vector<width>::type& s) {
  PairPack pair[width];
  for (std::size_t k = 0; k < width; ++k) pair[k] = load_pair(nodes, row + k);
  split_pairs<width>(pair, value, s);
}

}  // namespace superstep
