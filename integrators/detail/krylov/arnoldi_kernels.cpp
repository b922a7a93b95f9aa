#include "integrators/detail/krylov/arnoldi_kernels.hpp"

#include "integrators/detail/krylov/lanes.hpp"

namespace superstep {
namespace {

/// w += factor(i) * v; returns the sum of w * with.
template <std::size_t width, class Factor>
SUPERSTEP_INLINE double add_and_project(double* w, const Factor& factor, const double* v, const double* with,
                                        std::size_t first, std::size_t last) {
  using Pack = typename Vector<width>::type;
  return sum_in_lanes<width>(
      first, last,
      [&](std::size_t i, Pack & sum) __attribute__((always_inline)) {
        Pack now, value, f, other;
        load<width>(w + i, now);
        load<width>(v + i, value);
        factor.template get<width>(i, f);
        now += f * value;
        store<width>(now, w + i);
        load<width>(with + i, other);  // what was just stored, where it is w
        sum += now * other;
      },
      [&](std::size_t i) __attribute__((always_inline)) {
        w[i] += factor.one(i) * v[i];
        return w[i] * with[i];
      });
}

struct SameFactor {
  double factor;
  template <std::size_t width>
  SUPERSTEP_INLINE void get(std::size_t, typename Vector<width>::type& out) const {
    out = typename Vector<width>::type{} + factor;
  }
  SUPERSTEP_INLINE double one(std::size_t) const { return factor; }
};

struct Factors {
  const double* factor;
  template <std::size_t width>
  SUPERSTEP_INLINE void get(std::size_t at, typename Vector<width>::type& out) const {
    load<width>(factor + at, out);
  }
  SUPERSTEP_INLINE double one(std::size_t i) const { return factor[i]; }
};

#define SUPERSTEP_ARNOLDI(suffix, width, ...)                                                         \
  __VA_ARGS__ double add_diagonal_##suffix(double* w, const double* diagonal, const double* v,        \
                                           const double* with, std::size_t first, std::size_t last) { \
    return add_and_project<width>(w, Factors{diagonal}, v, with, first, last);                        \
  }                                                                                                   \
  __VA_ARGS__ double subtract_##suffix(double* w, double part, const double* v, const double* with,   \
                                       std::size_t first, std::size_t last) {                         \
    return add_and_project<width>(w, SameFactor{-part}, v, with, first, last);                        \
  }

SUPERSTEP_ARNOLDI(baseline, 4)
#if defined(__x86_64__)
SUPERSTEP_ARNOLDI(avx2, 4, SUPERSTEP_AVX2)
SUPERSTEP_ARNOLDI(avx512, 8, SUPERSTEP_AVX512)
#endif

ArnoldiKernel kernel_of(InstructionSet set) noexcept {
  switch (set) {
#if defined(__x86_64__)
    case InstructionSet::avx512:
      return {"avx512", add_diagonal_avx512, subtract_avx512};
    case InstructionSet::avx2:
      return {"avx2", add_diagonal_avx2, subtract_avx2};
#endif
    default:
      return {"baseline", add_diagonal_baseline, subtract_baseline};
  }
}

}  // namespace

std::span<const ArnoldiKernel> arnoldi_kernels() noexcept {
  static const KernelList<ArnoldiKernel> kernels(kernel_of);
  return kernels.all();
}

}  // namespace superstep
