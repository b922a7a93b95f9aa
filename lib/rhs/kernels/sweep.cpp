#include "rhs/kernels/sweep.hpp"

#include "rhs/kernels/stage_kernel.hpp"

namespace superstep {
namespace {

constexpr std::size_t nodes_ahead = 64;

/// Asks for what slices further on will read: entries, and the first touch of a neighbour's value, which
/// comes at the largest distance from the own row and which no processor foresees.
SUPERSTEP_INLINE void prefetch_entries(const SlicedRows& rows, std::int64_t k) {
  __builtin_prefetch(rows.value() + k + entries_ahead);
  __builtin_prefetch(rows.column() + k + entries_ahead);
}
SUPERSTEP_INLINE void prefetch_node(const SlicedRows& rows, const double* y, std::size_t row) {
  __builtin_prefetch(y + std::min(row + rows.reach() + nodes_ahead, rows.rows()));
}

/// Values of `width` neighbours. Single loads beat gather instructions by half on the processors measured,
/// and halves put together what compilers make of eight.
/// Not returned: the ABI of a function that returns a vector depends on the instruction set.
template <std::size_t width>
SUPERSTEP_INLINE void gather(const double* y, const std::int32_t* column, typename Vector<width>::type& out) {
  if constexpr (width == 4) {
    const NeighbourPair a(column), b(column + 2);
    out = typename Vector<4>::type{y[a.first()], y[a.second()], y[b.first()], y[b.second()]};
  } else {
    typename Vector<4>::type low, high;
    gather<4>(y, column, low);
    gather<4>(y, column + 4, high);
    out = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
  }
}

/// Rows of a slice that are not all there, one by one.
SUPERSTEP_INLINE void sweep_rows(const SlicedRows& rate, const Stage& stage, std::size_t slice, double* out) {
  constexpr auto lanes = SlicedRows::lanes;
  const double* y = stage.y1;
  for (std::size_t row = slice * lanes; row < rate.rows(); ++row) {
    double flux = 0;
    for (auto k = rate.begin()[slice]; k < rate.begin()[slice + 1]; k += lanes) {
      const auto entry = k + static_cast<std::int64_t>(row % lanes);
      flux += rate.value()[entry] * (y[rate.column()[entry]] - y[row]);
    }
    write_row(stage, y[row], flux, row, out);
  }
}

template <std::size_t width>
SUPERSTEP_INLINE void sweep_slices(const SlicedRows& rate, const Stage& stage, std::size_t first,
                                   std::size_t last, double* out) {
  using Pack = typename Vector<width>::type;
  constexpr std::size_t lanes = SlicedRows::lanes, packs = lanes / width;
  const std::size_t whole = std::min(last, rate.rows() / lanes);
  const double* const y = stage.y1;
  for (std::size_t slice = first; slice < whole; ++slice) {
    const std::size_t row = slice * lanes;
    Pack own[packs], flux[packs];
    for (std::size_t p = 0; p < packs; ++p) {
      std::memcpy(&own[p], y + row + p * width, sizeof(Pack));
      flux[p] = Pack{};
    }
    prefetch_node(rate, y, row);
    for (auto k = rate.begin()[slice]; k < rate.begin()[slice + 1]; k += lanes) {
      prefetch_entries(rate, k);
      for (std::size_t p = 0; p < packs; ++p) {
        Pack other, factor;
        gather<width>(y, rate.column() + k + p * width, other);
        std::memcpy(&factor, rate.value() + k + p * width, sizeof(Pack));
        flux[p] += factor * (other - own[p]);
      }
    }
    for (std::size_t p = 0; p < packs; ++p) write_rows<width>(stage, own[p], flux[p], row + p * width, out);
  }
  if (whole < last) sweep_rows(rate, stage, whole, out);
}

SUPERSTEP_INLINE void heat_rows(const SlicedRows& weight, const double* potential,
                                const double* inverse_capacity, std::size_t slice, double* out) {
  constexpr auto lanes = SlicedRows::lanes;
  for (std::size_t row = slice * lanes; row < weight.rows(); ++row) {
    double heat = 0;
    for (auto k = weight.begin()[slice]; k < weight.begin()[slice + 1]; k += lanes) {
      const auto entry = k + static_cast<std::int64_t>(row % lanes);
      const double difference = potential[weight.column()[entry]] - potential[row];
      heat += weight.value()[entry] * difference * difference;
    }
    out[row] = heat * inverse_capacity[row];
  }
}

template <std::size_t width>
SUPERSTEP_INLINE void heat_slices(const SlicedRows& weight, const double* potential,
                                  const double* inverse_capacity, std::size_t first, std::size_t last,
                                  double* out) {
  using Pack = typename Vector<width>::type;
  constexpr std::size_t lanes = SlicedRows::lanes, packs = lanes / width;
  const std::size_t whole = std::min(last, weight.rows() / lanes);
  for (std::size_t slice = first; slice < whole; ++slice) {
    const std::size_t row = slice * lanes;
    Pack own[packs], heat[packs];
    for (std::size_t p = 0; p < packs; ++p) {
      std::memcpy(&own[p], potential + row + p * width, sizeof(Pack));
      heat[p] = Pack{};
    }
    prefetch_node(weight, potential, row);
    for (auto k = weight.begin()[slice]; k < weight.begin()[slice + 1]; k += lanes) {
      prefetch_entries(weight, k);
      for (std::size_t p = 0; p < packs; ++p) {
        Pack other, factor;
        gather<width>(potential, weight.column() + k + p * width, other);
        std::memcpy(&factor, weight.value() + k + p * width, sizeof(Pack));
        const Pack difference = other - own[p];
        heat[p] += factor * difference * difference;
      }
    }
    for (std::size_t p = 0; p < packs; ++p) {
      Pack scale;
      std::memcpy(&scale, inverse_capacity + row + p * width, sizeof(Pack));
      const Pack value = heat[p] * scale;
      std::memcpy(out + row + p * width, &value, sizeof(Pack));
    }
  }
  if (whole < last) heat_rows(weight, potential, inverse_capacity, whole, out);
}

#define SUPERSTEP_KERNELS(suffix, width, ...)                                                         \
  __VA_ARGS__ void sweep_##suffix(const SlicedRows& rate, const Stage& stage, std::size_t first,      \
                                  std::size_t last, double* out) noexcept {                           \
    sweep_slices<width>(rate, stage, first, last, out);                                               \
  }                                                                                                   \
  __VA_ARGS__ void heat_##suffix(const SlicedRows& weight, const double* potential,                   \
                                 const double* inverse_capacity, std::size_t first, std::size_t last, \
                                 double* out) noexcept {                                              \
    heat_slices<width>(weight, potential, inverse_capacity, first, last, out);                        \
  }

SUPERSTEP_KERNELS(baseline, 4)
#if defined(__x86_64__)
SUPERSTEP_KERNELS(avx2, 4, SUPERSTEP_AVX2)
SUPERSTEP_KERNELS(avx512, 8, SUPERSTEP_AVX512)
#endif

SweepKernel sweep_kernel(InstructionSet set) noexcept {
  switch (set) {
#if defined(__x86_64__)
    case InstructionSet::avx512:
      return {"avx512", sweep_avx512, heat_avx512};
    case InstructionSet::avx2:
      return {"avx2", sweep_avx2, heat_avx2};
#endif
    default:
      return {"baseline", sweep_baseline, heat_baseline};
  }
}

}  // namespace

std::span<const SweepKernel> sweep_kernels() noexcept {
  static const KernelList<SweepKernel> kernels(sweep_kernel);
  return kernels.all();
}

void fused_sweep(const SlicedRows& rate, const Stage& stage, std::size_t first, std::size_t last,
                 double* out) noexcept {
  sweep_kernels().front().sweep(rate, stage, first, last, out);
}

void fused_sweep(const SlicedRows& rate, const Stage& stage, double* out) noexcept {
  for_slices(rate, [&](std::size_t first, std::size_t last) { fused_sweep(rate, stage, first, last, out); });
}

void heat_sweep(const SlicedRows& weight, const double* potential, const double* inverse_capacity,
                double* out) noexcept {
  const auto heat = sweep_kernels().front().heat;
  for_slices(weight, [&](std::size_t first, std::size_t last) {
    heat(weight, potential, inverse_capacity, first, last, out);
  });
}

void reference_sweep(const SweepRows& rows, const Stage& stage, double* out) noexcept {
  const double* y = stage.y1;
  for (std::size_t i = 0; i + 1 < rows.row_begin.size(); ++i) {
    double flux = 0;
    for (auto k = static_cast<std::size_t>(rows.row_begin[i]);
         k < static_cast<std::size_t>(rows.row_begin[i + 1]); ++k)
      flux += rows.rate[k] * (y[rows.column[k]] - y[i]);
    double value = stage.a * y[i] + stage.d * flux;
    if (stage.y2) value += stage.b * stage.y2[i];
    if (stage.y0) value += stage.c * stage.y0[i];
    if (stage.f0) value += stage.e * stage.f0[i];
    out[i] = value;
  }
}

}  // namespace superstep
