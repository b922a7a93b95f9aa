#include "rhs/sweep.hpp"

#include <array>
#include <cstring>

// One text, compiled for each instruction set: inlined into functions with a `target` of their own.
#define SUPERSTEP_INLINE [[gnu::always_inline]] inline

namespace superstep {
namespace {

/// `width` doubles in a vector register.
template <std::size_t width>
struct Vector {
  typedef double type __attribute__((vector_size(width * sizeof(double))));
};

// A macro because a function that returns a vector would have an ABI that depends on the instruction set.
// Single loads beat gather instructions by half on the processors measured (AMD Zen 5).
#define SUPERSTEP_GATHER(target, y, j)                                                       \
  do {                                                                                       \
    if constexpr (width == 8)                                                                \
      target = Pack{y[j[0]], y[j[1]], y[j[2]], y[j[3]], y[j[4]], y[j[5]], y[j[6]], y[j[7]]}; \
    else                                                                                     \
      target = Pack{y[j[0]], y[j[1]], y[j[2]], y[j[3]]};                                     \
  } while (false)

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
    double value = stage.a * y[row] + stage.d * flux;
    if (stage.y2) value += stage.b * stage.y2[row];
    if (stage.y0) value += stage.c * stage.y0[row];
    if (stage.f0) value += stage.e * stage.f0[row];
    out[row] = value;
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
    for (auto k = rate.begin()[slice]; k < rate.begin()[slice + 1]; k += lanes)
      for (std::size_t p = 0; p < packs; ++p) {
        const std::int32_t* const j = rate.column() + k + p * width;
        Pack other, factor;
        SUPERSTEP_GATHER(other, y, j);
        std::memcpy(&factor, rate.value() + k + p * width, sizeof(Pack));
        flux[p] += factor * (other - own[p]);
      }
    for (std::size_t p = 0; p < packs; ++p) {
      Pack value = stage.a * own[p] + stage.d * flux[p], term;
      const auto add = [&](double factor, const double* vector) __attribute__((always_inline)) {
        std::memcpy(&term, vector + row + p * width, sizeof(Pack));
        value += factor * term;
      };
      if (stage.y2) add(stage.b, stage.y2);
      if (stage.y0) add(stage.c, stage.y0);
      if (stage.f0) add(stage.e, stage.f0);
      std::memcpy(out + row + p * width, &value, sizeof(Pack));
    }
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
    for (auto k = weight.begin()[slice]; k < weight.begin()[slice + 1]; k += lanes)
      for (std::size_t p = 0; p < packs; ++p) {
        const std::int32_t* const j = weight.column() + k + p * width;
        Pack other, factor;
        SUPERSTEP_GATHER(other, potential, j);
        std::memcpy(&factor, weight.value() + k + p * width, sizeof(Pack));
        const Pack difference = other - own[p];
        heat[p] += factor * difference * difference;
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
SUPERSTEP_KERNELS(avx2, 4, __attribute__((target("avx2,fma"))))
SUPERSTEP_KERNELS(avx512, 8, __attribute__((target("avx512f,avx512vl,avx512dq,fma"))))
#endif

struct Kernels {
  std::array<SweepKernel, 3> list;
  std::size_t count = 0;
};

Kernels find_kernels() noexcept {
  Kernels out{};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("fma"))
    out.list[out.count++] = {"avx512", sweep_avx512, heat_avx512};
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    out.list[out.count++] = {"avx2", sweep_avx2, heat_avx2};
#endif
  out.list[out.count++] = {"baseline", sweep_baseline, heat_baseline};
  return out;
}

}  // namespace

std::span<const SweepKernel> sweep_kernels() noexcept {
  static const Kernels kernels = find_kernels();
  return std::span(kernels.list).first(kernels.count);
}

void fused_sweep(const SlicedRows& rate, const Stage& stage, double* out) noexcept {
  const auto sweep = sweep_kernels().front().sweep;
  for_ranges(rate.slices(), rate.rows(),
             [&](std::size_t first, std::size_t last) { sweep(rate, stage, first, last, out); });
}

void heat_sweep(const SlicedRows& weight, const double* potential, const double* inverse_capacity,
                double* out) noexcept {
  const auto heat = sweep_kernels().front().heat;
  for_ranges(weight.slices(), weight.rows(), [&](std::size_t first, std::size_t last) {
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
