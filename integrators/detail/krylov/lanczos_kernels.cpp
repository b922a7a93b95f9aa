#include "integrators/detail/krylov/lanczos_kernels.hpp"

#include "integrators/detail/krylov/lanes.hpp"

namespace superstep {
namespace {

/// Next vector, the one now, and capacities, from entry i on.
template <std::size_t width, class Pack>
SUPERSTEP_INLINE void load_all(const LanczosPass& pass, std::size_t i, Pack& next, Pack& now,
                               Pack& capacity) {
  load<width>(pass.next + i, next);
  load<width>(pass.now + i, now);
  load<width>(pass.capacity + i, capacity);
}

template <std::size_t width, class Kept>
SUPERSTEP_INLINE double keep_and_project(const LanczosPass& pass, double unit, Kept* kept, std::size_t first,
                                         std::size_t last) {
  using Pack = typename Vector<width>::type;
  return sum_in_lanes<width>(
      first, last,
      [&](std::size_t i, Pack & sum) __attribute__((always_inline)) {
        Pack w, v, c;
        load_all<width>(pass, i, w, v, c);
        store<width>(unit * v, kept + i);
        sum += c * w * v;
      },
      [&](std::size_t i) __attribute__((always_inline)) {
        kept[i] = static_cast<Kept>(unit * pass.now[i]);
        return pass.capacity[i] * pass.next[i] * pass.now[i];
      });
}

template <std::size_t width>
SUPERSTEP_INLINE double subtract(const LanczosPass& pass, double part, std::size_t first, std::size_t last) {
  using Pack = typename Vector<width>::type;
  return sum_in_lanes<width>(
      first, last,
      [&](std::size_t i, Pack & sum) __attribute__((always_inline)) {
        Pack w, v, c;
        load_all<width>(pass, i, w, v, c);
        w -= part * v;
        store<width>(w, pass.next + i);
        sum += c * w * w;
      },
      [&](std::size_t i) __attribute__((always_inline)) {
        const double w = pass.next[i] -= part * pass.now[i];
        return pass.capacity[i] * w * w;
      });
}

template <std::size_t width, class Kept>
SUPERSTEP_INLINE void add_four(const Kept* const* vector, const double* factor, double* sum,
                               std::size_t first, std::size_t last) {
  const double c0 = factor[0], c1 = factor[1], c2 = factor[2], c3 = factor[3];
  const Kept *v0 = vector[0], *v1 = vector[1], *v2 = vector[2], *v3 = vector[3];
  std::size_t i = first;
  for (; i + width <= last; i += width) {
    typename Vector<width>::type s, a, b, c, d;
    load<width>(sum + i, s);
    load<width>(v0 + i, a);
    load<width>(v1 + i, b);
    load<width>(v2 + i, c);
    load<width>(v3 + i, d);
    s += (c0 * a + c1 * b) + (c2 * c + c3 * d);
    store<width>(s, sum + i);
  }
  for (; i < last; ++i) sum[i] += (c0 * v0[i] + c1 * v1[i]) + (c2 * v2[i] + c3 * v3[i]);
}

#define SUPERSTEP_LANCZOS(suffix, width, ...)                                                      \
  template <class Kept>                                                                            \
  __VA_ARGS__ double keep_and_project_##suffix(const LanczosPass& pass, double unit, Kept* kept,   \
                                               std::size_t first, std::size_t last) {              \
    return keep_and_project<width>(pass, unit, kept, first, last);                                 \
  }                                                                                                \
  __VA_ARGS__ double subtract_##suffix(const LanczosPass& pass, double part, std::size_t first,    \
                                       std::size_t last) {                                         \
    return subtract<width>(pass, part, first, last);                                               \
  }                                                                                                \
  template <class Kept>                                                                            \
  __VA_ARGS__ void add_four_##suffix(const Kept* const* vector, const double* factor, double* sum, \
                                     std::size_t first, std::size_t last) {                        \
    add_four<width>(vector, factor, sum, first, last);                                             \
  }

SUPERSTEP_LANCZOS(baseline, 4)
#if defined(__x86_64__)
SUPERSTEP_LANCZOS(avx2, 4, SUPERSTEP_AVX2)
SUPERSTEP_LANCZOS(avx512, 8, SUPERSTEP_AVX512)
#endif

template <class Kept>
LanczosKernel<Kept> kernel_of(InstructionSet set) noexcept {
  switch (set) {
#if defined(__x86_64__)
    case InstructionSet::avx512:
      return {"avx512", keep_and_project_avx512<Kept>, subtract_avx512, add_four_avx512<Kept>};
    case InstructionSet::avx2:
      return {"avx2", keep_and_project_avx2<Kept>, subtract_avx2, add_four_avx2<Kept>};
#endif
    default:
      return {"baseline", keep_and_project_baseline<Kept>, subtract_baseline, add_four_baseline<Kept>};
  }
}

}  // namespace

template <class Kept>
std::span<const LanczosKernel<Kept>> lanczos_kernels() noexcept {
  static const KernelList<LanczosKernel<Kept>> kernels(kernel_of<Kept>);
  return kernels.all();
}

template std::span<const LanczosKernel<float>> lanczos_kernels() noexcept;
template std::span<const LanczosKernel<double>> lanczos_kernels() noexcept;

}  // namespace superstep
