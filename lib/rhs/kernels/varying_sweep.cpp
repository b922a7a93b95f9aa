#include "rhs/kernels/varying_sweep.hpp"

#include "rhs/kernels/node_pairs.hpp"
#include "rhs/kernels/stage_kernel.hpp"

namespace superstep {
namespace {

constexpr std::size_t lanes = SlicedRows::lanes;

// Results by reference: the ABI of a function that returns a vector depends on the instruction set.
struct Harmonic {
  template <class Number>
  SUPERSTEP_INLINE static void conductance(const Number& geometry, const Number& own, const Number& other,
                                           Number& out) {
    out = geometry / (own + other);
  }
  /// heat(a, b) = 2 a b^2/(a+b)^2 = 2 s_a/(s_a + s_b)^2: the factor s_a comes at the end of the row.
  template <class Number>
  SUPERSTEP_INLINE static void heat(const Number& geometry, const Number& own, const Number& other,
                                    Number& out) {
    const Number sum = own + other;
    out = geometry / (sum * sum);
  }
  template <class Number>
  SUPERSTEP_INLINE static void finish(const Number& own, Number& heat) {
    heat *= own;
  }
};

struct Arithmetic {
  template <class Number>
  SUPERSTEP_INLINE static void conductance(const Number& geometry, const Number& own, const Number& other,
                                           Number& out) {
    out = geometry * (own + other);
  }
  template <class Number>
  SUPERSTEP_INLINE static void heat(const Number& geometry, const Number& /*own*/, const Number& other,
                                    Number& out) {
    out = geometry * other;
  }
  template <class Number>
  SUPERSTEP_INLINE static void finish(const Number& /*own*/, Number& /*heat*/) {}
};

/// Rows of a slice that are not all there, one by one.
template <class Mean>
SUPERSTEP_INLINE void sweep_rows(const SlicedRows& geometry, const NodePair* nodes, const Stage& stage,
                                 std::size_t slice, double* out) {
  for (std::size_t row = slice * lanes; row < geometry.rows(); ++row) {
    const NodePair own = nodes[row];
    double flux = 0;
    for (auto k = geometry.begin()[slice]; k < geometry.begin()[slice + 1]; k += lanes) {
      const auto entry = k + static_cast<std::int64_t>(row % lanes);
      const NodePair other = nodes[geometry.column()[entry]];
      double conductance;
      Mean::conductance(geometry.value()[entry], own.s, other.s, conductance);
      flux += conductance * (other.value - own.value);
    }
    write_row(stage, own.value, flux, row, out);
  }
}

template <std::size_t width, class Mean>
SUPERSTEP_INLINE void sweep_slices(const SlicedRows& geometry, const NodePair* nodes, const Stage& stage,
                                   std::size_t first, std::size_t last, double* out) {
  using Pack = typename Vector<width>::type;
  constexpr std::size_t packs = lanes / width;
  const std::size_t whole = std::min(last, geometry.rows() / lanes);
  for (std::size_t slice = first; slice < whole; ++slice) {
    const std::size_t row = slice * lanes;
    Pack own[packs], own_s[packs], flux[packs];
    for (std::size_t p = 0; p < packs; ++p) {
      own_nodes<width>(nodes, row + p * width, own[p], own_s[p]);
      flux[p] = Pack{};
    }
    for (auto k = geometry.begin()[slice]; k < geometry.begin()[slice + 1]; k += lanes) {
      __builtin_prefetch(geometry.value() + k + entries_ahead);
      __builtin_prefetch(geometry.column() + k + entries_ahead);
      for (std::size_t p = 0; p < packs; ++p) {
        Pack other, s, factor, conductance;
        gather_pairs<width>(nodes, geometry.column() + k + p * width, other, s);
        std::memcpy(&factor, geometry.value() + k + p * width, sizeof(Pack));
        Mean::conductance(factor, own_s[p], s, conductance);
        flux[p] += conductance * (other - own[p]);
      }
    }
    for (std::size_t p = 0; p < packs; ++p) write_rows<width>(stage, own[p], flux[p], row + p * width, out);
  }
  if (whole < last) sweep_rows<Mean>(geometry, nodes, stage, whole, out);
}

template <class Mean>
SUPERSTEP_INLINE void heat_rows(const SlicedRows& geometry, const NodePair* nodes,
                                const double* inverse_capacity, std::size_t slice, double* out) {
  for (std::size_t row = slice * lanes; row < geometry.rows(); ++row) {
    const NodePair own = nodes[row];
    double heat = 0;
    for (auto k = geometry.begin()[slice]; k < geometry.begin()[slice + 1]; k += lanes) {
      const auto entry = k + static_cast<std::int64_t>(row % lanes);
      const NodePair other = nodes[geometry.column()[entry]];
      const double difference = other.value - own.value;
      double weight;
      Mean::heat(geometry.value()[entry], own.s, other.s, weight);
      heat += weight * (difference * difference);
    }
    Mean::finish(own.s, heat);
    out[row] = heat * inverse_capacity[row];
  }
}

template <std::size_t width, class Mean>
SUPERSTEP_INLINE void heat_slices(const SlicedRows& geometry, const NodePair* nodes,
                                  const double* inverse_capacity, std::size_t first, std::size_t last,
                                  double* out) {
  using Pack = typename Vector<width>::type;
  constexpr std::size_t packs = lanes / width;
  const std::size_t whole = std::min(last, geometry.rows() / lanes);
  for (std::size_t slice = first; slice < whole; ++slice) {
    const std::size_t row = slice * lanes;
    Pack own[packs], own_s[packs], heat[packs];
    for (std::size_t p = 0; p < packs; ++p) {
      own_nodes<width>(nodes, row + p * width, own[p], own_s[p]);
      heat[p] = Pack{};
    }
    for (auto k = geometry.begin()[slice]; k < geometry.begin()[slice + 1]; k += lanes)
      for (std::size_t p = 0; p < packs; ++p) {
        Pack other, s, factor, weight;
        gather_pairs<width>(nodes, geometry.column() + k + p * width, other, s);
        std::memcpy(&factor, geometry.value() + k + p * width, sizeof(Pack));
        Mean::heat(factor, own_s[p], s, weight);
        const Pack difference = other - own[p];
        heat[p] += weight * (difference * difference);
      }
    for (std::size_t p = 0; p < packs; ++p) {
      Pack scale;
      std::memcpy(&scale, inverse_capacity + row + p * width, sizeof(Pack));
      Mean::finish(own_s[p], heat[p]);
      const Pack value = heat[p] * scale;
      std::memcpy(out + row + p * width, &value, sizeof(Pack));
    }
  }
  if (whole < last) heat_rows<Mean>(geometry, nodes, inverse_capacity, whole, out);
}

#define SUPERSTEP_VARYING(name, Mean, width, ...)                                                      \
  __VA_ARGS__ void sweep_##name(const SlicedRows& geometry, const NodePair* nodes, const Stage& stage, \
                                std::size_t first, std::size_t last, double* out) noexcept {           \
    sweep_slices<width, Mean>(geometry, nodes, stage, first, last, out);                               \
  }                                                                                                    \
  __VA_ARGS__ void heat_##name(const SlicedRows& geometry, const NodePair* nodes,                      \
                               const double* inverse_capacity, std::size_t first, std::size_t last,    \
                               double* out) noexcept {                                                 \
    heat_slices<width, Mean>(geometry, nodes, inverse_capacity, first, last, out);                     \
  }

SUPERSTEP_VARYING(harmonic_baseline, Harmonic, 4)
SUPERSTEP_VARYING(arithmetic_baseline, Arithmetic, 4)
#if defined(__x86_64__)
SUPERSTEP_VARYING(harmonic_avx2, Harmonic, 4, SUPERSTEP_AVX2)
SUPERSTEP_VARYING(arithmetic_avx2, Arithmetic, 4, SUPERSTEP_AVX2)
SUPERSTEP_VARYING(harmonic_avx512, Harmonic, 8, SUPERSTEP_AVX512)
SUPERSTEP_VARYING(arithmetic_avx512, Arithmetic, 8, SUPERSTEP_AVX512)
#endif

VaryingKernel varying_kernel(InstructionSet set) noexcept {
  switch (set) {
#if defined(__x86_64__)
    case InstructionSet::avx512:
      return {"avx512", sweep_harmonic_avx512, sweep_arithmetic_avx512, heat_harmonic_avx512,
              heat_arithmetic_avx512};
    case InstructionSet::avx2:
      return {"avx2", sweep_harmonic_avx2, sweep_arithmetic_avx2, heat_harmonic_avx2, heat_arithmetic_avx2};
#endif
    default:
      return {"baseline", sweep_harmonic_baseline, sweep_arithmetic_baseline, heat_harmonic_baseline,
              heat_arithmetic_baseline};
  }
}

}  // namespace

std::span<const VaryingKernel> varying_kernels() noexcept {
  static const KernelList<VaryingKernel> kernels(varying_kernel);
  return kernels.all();
}

void varying_sweep(ConductanceMean mean, const SlicedRows& geometry, const NodePair* nodes,
                   const Stage& stage, std::size_t first, std::size_t last, double* out) noexcept {
  varying_kernels().front().sweep(mean)(geometry, nodes, stage, first, last, out);
}

void varying_heat(ConductanceMean mean, const SlicedRows& geometry, const NodePair* nodes,
                  const double* inverse_capacity, double* out) noexcept {
  const auto heat = varying_kernels().front().heat(mean);
  for_slices(geometry, [&](std::size_t first, std::size_t last) {
    heat(geometry, nodes, inverse_capacity, first, last, out);
  });
}

void reference_varying_sweep(ConductanceMean mean, std::span<const std::int64_t> row_begin,
                             std::span<const std::int32_t> column, std::span<const double> geometry,
                             std::span<const double> conductivity, const Stage& stage, double* out) noexcept {
  with_mean(mean, [&](auto mix) {
    for (std::size_t i = 0; i + 1 < row_begin.size(); ++i) {
      double flux = 0;
      for (auto k = static_cast<std::size_t>(row_begin[i]); k < static_cast<std::size_t>(row_begin[i + 1]);
           ++k) {
        const auto j = static_cast<std::size_t>(column[k]);
        flux += geometry[k] * mix.value(conductivity[i], conductivity[j]) * (stage.y1[j] - stage.y1[i]);
      }
      double value = stage.a * stage.y1[i] + stage.d * flux;
      if (stage.y2) value += stage.b * stage.y2[i];
      if (stage.y0) value += stage.c * stage.y0[i];
      if (stage.f0) value += stage.e * stage.f0[i];
      out[i] = value;
    }
  });
}

}  // namespace superstep
