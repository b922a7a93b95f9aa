#include "rhs/kernels/varying_bound.hpp"

#include "rhs/kernels/node_pairs.hpp"

namespace superstep {
namespace {

constexpr std::size_t lanes = SlicedRows::lanes;

// Results by reference: the ABI of a function that returns a vector depends on the instruction set.
struct Harmonic {
  /// K = g/(s_i + s_j), |dK/dT_i| = K |ds_i/dT|/(s_i + s_j).
  template <class Number>
  SUPERSTEP_INLINE static void sums(const Number& geometry, const Number& both, const Number& bend,
                                    Number& conduction, Number& law) {
    const Number inverse = 1 / both;
    conduction = geometry * inverse;
    law = conduction * (bend * inverse);
  }
  /// h = s_i/(s_i + s_j)^2; of its slopes in s_i and s_j the magnitudes, times those of s in T.
  template <class Number>
  SUPERSTEP_INLINE static void heat(const Number& own, const Number& other, const Number& own_bend,
                                    const Number& other_bend, Number& share, Number& slope) {
    const Number inverse = 1 / (own + other);
    const Number apart = other - own;
    share = (own * inverse) * inverse;
    slope = ((apart < 0 ? -apart : apart) * inverse * own_bend + 2 * (own * inverse) * other_bend) *
            (inverse * inverse);
  }
};

struct Arithmetic {
  template <class Number>
  SUPERSTEP_INLINE static void sums(const Number& geometry, const Number& both, const Number& bend,
                                    Number& conduction, Number& law) {
    conduction = geometry * both;
    law = geometry * bend;
  }
  /// h = s_j.
  template <class Number>
  SUPERSTEP_INLINE static void heat(const Number& /*own*/, const Number& other, const Number& /*own_bend*/,
                                    const Number& other_bend, Number& share, Number& slope) {
    share = other;
    slope = other_bend;
  }
};

/// So many rows side by side; one where a slice is not whole.
template <std::size_t width>
struct Lanes {
  using Number = typename Vector<width>::type;
  SUPERSTEP_INLINE static void own(const NodePair* nodes, std::size_t row, Number& value, Number& s) {
    own_nodes<width>(nodes, row, value, s);
  }
  SUPERSTEP_INLINE static void other(const NodePair* nodes, const std::int32_t* column, Number& value,
                                     Number& s) {
    gather_pairs<width>(nodes, column, value, s);
  }
  SUPERSTEP_INLINE static void pick(const double* values, const std::int32_t* column, Number& out) {
    for (std::size_t lane = 0; lane < width; ++lane) out[lane] = values[column[lane]];
  }
};
template <>
struct Lanes<1> {
  using Number = double;
  SUPERSTEP_INLINE static void own(const NodePair* nodes, std::size_t row, double& value, double& s) {
    value = nodes[row].value;
    s = nodes[row].s;
  }
  SUPERSTEP_INLINE static void other(const NodePair* nodes, const std::int32_t* column, double& value,
                                     double& s) {
    own(nodes, static_cast<std::size_t>(*column), value, s);
  }
  SUPERSTEP_INLINE static void pick(const double* values, const std::int32_t* column, double& out) {
    out = values[*column];
  }
};

template <class Number>
SUPERSTEP_INLINE void load(const double* from, Number& out) {
  std::memcpy(&out, from, sizeof(Number));
}
template <class Number>
SUPERSTEP_INLINE void store(const Number& value, double* to) {
  std::memcpy(to, &value, sizeof(Number));
}

template <class Number>
SUPERSTEP_INLINE void take_magnitude(Number& value) {
  value = value < 0 ? -value : value;
}

/// What conduction and laws sum up in rows.
template <class Mean>
struct Conduction {
  const NodePair* nodes;
  const double* bend;
  const JacobianSums& out;

  template <std::size_t width>
  SUPERSTEP_INLINE void rows(std::size_t row, const std::int32_t* column, const double* geometry,
                             std::size_t entries) const {
    using At = Lanes<width>;
    typename At::Number own, own_s, own_bend, conduction{}, laws{};
    At::own(nodes, row, own, own_s);
    load(bend + row, own_bend);
    for (std::size_t k = 0; k < entries; ++k, column += lanes, geometry += lanes) {
      typename At::Number other, s, other_bend, factor, rate, law;
      At::other(nodes, column, other, s);
      At::pick(bend, column, other_bend);
      load(geometry, factor);
      s += own_s;
      other_bend += own_bend;
      Mean::sums(factor, s, other_bend, rate, law);
      other -= own;
      take_magnitude(other);
      conduction += rate;
      laws += law * other;
    }
    store(conduction, out.conduction.data() + row);
    store(laws, out.laws.data() + row);
  }
};

/// What the heat of a current sums up in rows.
template <class Mean>
struct Heat {
  const HeatColumns& columns;
  const double* inverse_capacity;
  const HeatSums& out;

  template <std::size_t width>
  SUPERSTEP_INLINE void rows(std::size_t row, const std::int32_t* column, const double* geometry,
                             std::size_t entries) const {
    using At = Lanes<width>;
    typename At::Number own, own_s, own_bend, own_moves, temperatures{}, potentials{};
    At::own(columns.nodes, row, own, own_s);
    load(columns.bend + row, own_bend);
    load(columns.moves + row, own_moves);
    for (std::size_t k = 0; k < entries; ++k, column += lanes, geometry += lanes) {
      typename At::Number other, s, bend, moves, factor, share, slope;
      At::other(columns.nodes, column, other, s);
      At::pick(columns.bend, column, bend);
      At::pick(columns.moves, column, moves);
      load(geometry, factor);
      Mean::heat(own_s, s, own_bend, bend, share, slope);
      other -= own;
      take_magnitude(other);
      temperatures += factor * (other * other) * slope;
      potentials += factor * other * share * (own_moves + moves);
    }
    typename At::Number scale;
    load(inverse_capacity + row, scale);
    add(temperatures * scale, out.temperatures.data() + row);
    add(2 * potentials * scale, out.potentials.data() + row);
  }

  template <class Number>
  SUPERSTEP_INLINE static void add(const Number& value, double* to) {
    Number sum;
    load(to, sum);
    sum += value;
    store(sum, to);
  }
};

/// Whole slices `width` rows at a time, the rest of the last one row by row.
template <std::size_t width, class What>
SUPERSTEP_INLINE void pass(const SlicedRows& geometry, std::size_t first, std::size_t last,
                           const What& what) {
  const std::size_t whole = std::min(last, geometry.rows() / lanes);
  for (std::size_t slice = first; slice < last; ++slice) {
    const auto begin = geometry.begin()[slice];
    const auto entries = static_cast<std::size_t>(geometry.begin()[slice + 1] - begin) / lanes;
    const std::int32_t* column = geometry.column() + begin;
    const double* value = geometry.value() + begin;
    const std::size_t row = slice * lanes;
    if (slice < whole)
      for (std::size_t lane = 0; lane < lanes; lane += width)
        what.template rows<width>(row + lane, column + lane, value + lane, entries);
    else
      for (std::size_t lane = 0; row + lane < geometry.rows(); ++lane)
        what.template rows<1>(row + lane, column + lane, value + lane, entries);
  }
}

#define SUPERSTEP_BOUND(name, Mean, width, ...)                                                         \
  __VA_ARGS__ void sums_##name(const SlicedRows& geometry, const NodePair* nodes, const double* bend,   \
                               std::size_t first, std::size_t last, const JacobianSums& out) noexcept { \
    pass<width>(geometry, first, last, Conduction<Mean>{nodes, bend, out});                             \
  }                                                                                                     \
  __VA_ARGS__ void heat_##name(const SlicedRows& geometry, const HeatColumns& columns,                  \
                               const double* inverse_capacity, std::size_t first, std::size_t last,     \
                               const HeatSums& out) noexcept {                                          \
    pass<width>(geometry, first, last, Heat<Mean>{columns, inverse_capacity, out});                     \
  }

SUPERSTEP_BOUND(harmonic_baseline, Harmonic, 4)
SUPERSTEP_BOUND(arithmetic_baseline, Arithmetic, 4)
#if defined(__x86_64__)
SUPERSTEP_BOUND(harmonic_avx2, Harmonic, 4, SUPERSTEP_AVX2)
SUPERSTEP_BOUND(arithmetic_avx2, Arithmetic, 4, SUPERSTEP_AVX2)
SUPERSTEP_BOUND(harmonic_avx512, Harmonic, 8, SUPERSTEP_AVX512)
SUPERSTEP_BOUND(arithmetic_avx512, Arithmetic, 8, SUPERSTEP_AVX512)
#endif

BoundKernel bound_kernel(InstructionSet set) noexcept {
  switch (set) {
#if defined(__x86_64__)
    case InstructionSet::avx512:
      return {"avx512", sums_harmonic_avx512, sums_arithmetic_avx512, heat_harmonic_avx512,
              heat_arithmetic_avx512};
    case InstructionSet::avx2:
      return {"avx2", sums_harmonic_avx2, sums_arithmetic_avx2, heat_harmonic_avx2, heat_arithmetic_avx2};
#endif
    default:
      return {"baseline", sums_harmonic_baseline, sums_arithmetic_baseline, heat_harmonic_baseline,
              heat_arithmetic_baseline};
  }
}

}  // namespace

std::span<const BoundKernel> bound_kernels() noexcept {
  static const KernelList<BoundKernel> kernels(bound_kernel);
  return kernels.all();
}

void varying_row_sums(ConductanceMean mean, const SlicedRows& geometry, const NodePair* nodes,
                      const double* bend, const JacobianSums& out) noexcept {
  const auto& kernel = bound_kernels().front();
  const auto sums = mean == ConductanceMean::harmonic ? kernel.harmonic : kernel.arithmetic;
  for_slices(geometry,
             [&](std::size_t first, std::size_t last) { sums(geometry, nodes, bend, first, last, out); });
}

void varying_heat_sums(ConductanceMean mean, const SlicedRows& geometry, const HeatColumns& columns,
                       const double* inverse_capacity, const HeatSums& out) noexcept {
  const auto& kernel = bound_kernels().front();
  const auto heat = mean == ConductanceMean::harmonic ? kernel.harmonic_heat : kernel.arithmetic_heat;
  for_slices(geometry, [&](std::size_t first, std::size_t last) {
    heat(geometry, columns, inverse_capacity, first, last, out);
  });
}

}  // namespace superstep
