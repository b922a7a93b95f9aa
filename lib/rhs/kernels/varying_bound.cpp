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

template <std::size_t width>
SUPERSTEP_INLINE void pick(const double* values, const std::int32_t* column,
                           typename Vector<width>::type& out) {
  for (std::size_t lane = 0; lane < width; ++lane) out[lane] = values[column[lane]];
}

/// Rows of a slice that are not all there, one by one.
template <class Mean>
SUPERSTEP_INLINE void sum_rows(const SlicedRows& geometry, const NodePair* nodes, const double* bend,
                               std::size_t slice, const JacobianSums& out) {
  for (std::size_t row = slice * lanes; row < geometry.rows(); ++row) {
    double conduction = 0, laws = 0;
    for (auto k = geometry.begin()[slice]; k < geometry.begin()[slice + 1]; k += lanes) {
      const auto entry = k + static_cast<std::int64_t>(row % lanes);
      const auto column = static_cast<std::size_t>(geometry.column()[entry]);
      double rate, law;
      Mean::sums(geometry.value()[entry], nodes[row].s + nodes[column].s, bend[row] + bend[column], rate,
                 law);
      const double difference = nodes[column].value - nodes[row].value;
      conduction += rate;
      laws += law * (difference < 0 ? -difference : difference);
    }
    out.conduction[row] = conduction;
    out.laws[row] = laws;
  }
}

template <std::size_t width, class Mean>
SUPERSTEP_INLINE void sum_slices(const SlicedRows& geometry, const NodePair* nodes, const double* bend,
                                 std::size_t first, std::size_t last, const JacobianSums& out) {
  using Pack = typename Vector<width>::type;
  constexpr std::size_t packs = lanes / width;
  const std::size_t whole = std::min(last, geometry.rows() / lanes);
  for (std::size_t slice = first; slice < whole; ++slice)
    for (std::size_t p = 0; p < packs; ++p) {
      const std::size_t row = slice * lanes + p * width;
      Pack own, own_s, own_bend, conduction{}, laws{};
      own_nodes<width>(nodes, row, own, own_s);
      std::memcpy(&own_bend, bend + row, sizeof(Pack));
      for (auto k = geometry.begin()[slice]; k < geometry.begin()[slice + 1]; k += lanes) {
        const std::int32_t* column = geometry.column() + k + p * width;
        Pack other, s, other_bend, factor, rate, law;
        gather_pairs<width>(nodes, column, other, s);
        pick<width>(bend, column, other_bend);
        std::memcpy(&factor, geometry.value() + k + p * width, sizeof(Pack));
        Mean::sums(factor, Pack(own_s + s), Pack(own_bend + other_bend), rate, law);
        const Pack difference = other - own;
        conduction += rate;
        laws += law * (difference < 0 ? -difference : difference);
      }
      std::memcpy(out.conduction.data() + row, &conduction, sizeof(Pack));
      std::memcpy(out.laws.data() + row, &laws, sizeof(Pack));
    }
  if (whole < last) sum_rows<Mean>(geometry, nodes, bend, whole, out);
}

template <class Mean>
SUPERSTEP_INLINE void heat_rows(const SlicedRows& geometry, const HeatColumns& columns,
                                const double* inverse_capacity, std::size_t slice, const HeatSums& out) {
  for (std::size_t row = slice * lanes; row < geometry.rows(); ++row) {
    double temperatures = 0, potentials = 0;
    for (auto k = geometry.begin()[slice]; k < geometry.begin()[slice + 1]; k += lanes) {
      const auto entry = k + static_cast<std::int64_t>(row % lanes);
      const auto column = static_cast<std::size_t>(geometry.column()[entry]);
      const NodePair own = columns.nodes[row], other = columns.nodes[column];
      double share, slope;
      Mean::heat(own.s, other.s, columns.bend[row], columns.bend[column], share, slope);
      const double difference = other.value - own.value, factor = geometry.value()[entry];
      temperatures += factor * (difference * difference) * slope;
      potentials += factor * (difference < 0 ? -difference : difference) * share *
                    (columns.moves[row] + columns.moves[column]);
    }
    out.temperatures[row] += temperatures * inverse_capacity[row];
    out.potentials[row] += 2 * potentials * inverse_capacity[row];
  }
}

template <std::size_t width, class Mean>
SUPERSTEP_INLINE void heat_slices(const SlicedRows& geometry, const HeatColumns& columns,
                                  const double* inverse_capacity, std::size_t first, std::size_t last,
                                  const HeatSums& out) {
  using Pack = typename Vector<width>::type;
  constexpr std::size_t packs = lanes / width;
  const std::size_t whole = std::min(last, geometry.rows() / lanes);
  for (std::size_t slice = first; slice < whole; ++slice)
    for (std::size_t p = 0; p < packs; ++p) {
      const std::size_t row = slice * lanes + p * width;
      Pack own, own_s, own_bend, own_moves, temperatures{}, potentials{};
      own_nodes<width>(columns.nodes, row, own, own_s);
      std::memcpy(&own_bend, columns.bend + row, sizeof(Pack));
      std::memcpy(&own_moves, columns.moves + row, sizeof(Pack));
      for (auto k = geometry.begin()[slice]; k < geometry.begin()[slice + 1]; k += lanes) {
        const std::int32_t* column = geometry.column() + k + p * width;
        Pack other, s, bend, moves, factor, share, slope;
        gather_pairs<width>(columns.nodes, column, other, s);
        pick<width>(columns.bend, column, bend);
        pick<width>(columns.moves, column, moves);
        std::memcpy(&factor, geometry.value() + k + p * width, sizeof(Pack));
        Mean::heat(own_s, s, own_bend, bend, share, slope);
        const Pack difference = other - own;
        temperatures += factor * (difference * difference) * slope;
        potentials += factor * (difference < 0 ? -difference : difference) * share * (own_moves + moves);
      }
      Pack scale, before;
      std::memcpy(&scale, inverse_capacity + row, sizeof(Pack));
      std::memcpy(&before, out.temperatures.data() + row, sizeof(Pack));
      const Pack own_sum = before + temperatures * scale;
      std::memcpy(out.temperatures.data() + row, &own_sum, sizeof(Pack));
      std::memcpy(&before, out.potentials.data() + row, sizeof(Pack));
      const Pack cross_sum = before + 2 * potentials * scale;
      std::memcpy(out.potentials.data() + row, &cross_sum, sizeof(Pack));
    }
  if (whole < last) heat_rows<Mean>(geometry, columns, inverse_capacity, whole, out);
}

#define SUPERSTEP_BOUND(name, Mean, width, ...)                                                         \
  __VA_ARGS__ void sums_##name(const SlicedRows& geometry, const NodePair* nodes, const double* bend,   \
                               std::size_t first, std::size_t last, const JacobianSums& out) noexcept { \
    sum_slices<width, Mean>(geometry, nodes, bend, first, last, out);                                   \
  }                                                                                                     \
  __VA_ARGS__ void heat_##name(const SlicedRows& geometry, const HeatColumns& columns,                  \
                               const double* inverse_capacity, std::size_t first, std::size_t last,     \
                               const HeatSums& out) noexcept {                                          \
    heat_slices<width, Mean>(geometry, columns, inverse_capacity, first, last, out);                    \
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
