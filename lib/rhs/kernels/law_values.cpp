#include "rhs/kernels/law_values.hpp"

#include <algorithm>

#include "rhs/kernels/packs.hpp"

namespace superstep {
namespace {

/// exp of every lane: 2^n times a Taylor polynomial on half an octave to either side, good to two roundings.
template <std::size_t width>
SUPERSTEP_INLINE void exponential(const typename Vector<width>::type& argument,
                                  typename Vector<width>::type& out) {
  using Pack = typename Vector<width>::type;
  using Whole = typename Vector<width>::integer;
  constexpr double log2_e = 1.4426950408889634, ln2_high = 6.93147180369123816490e-01,
                   ln2_low = 1.90821492927058770002e-10;  // high: its products with n are exact
  constexpr double to_integer = 6755399441055744.0;       // 1.5 * 2^52: adding it rounds to an integer
  constexpr double largest = 700;                         // beyond, a logistic is 0 or 1 to rounding
  Pack x = argument < -largest ? Pack{} - largest : argument;
  x = x > largest ? Pack{} + largest : x;
  const Pack shifted = x * log2_e + to_integer;
  const Pack n = shifted - to_integer;
  const Pack r = (x - n * ln2_high) - n * ln2_low;
  constexpr std::array<double, 14> inverse_factorial = {1.0,
                                                        1.0,
                                                        1.0 / 2,
                                                        1.0 / 6,
                                                        1.0 / 24,
                                                        1.0 / 120,
                                                        1.0 / 720,
                                                        1.0 / 5040,
                                                        1.0 / 40320,
                                                        1.0 / 362880,
                                                        1.0 / 3628800,
                                                        1.0 / 39916800,
                                                        1.0 / 479001600,
                                                        1.0 / 6227020800.0};
  Pack p = Pack{} + inverse_factorial.back();
  for (std::size_t k = inverse_factorial.size() - 1; k-- > 0;) p = p * r + inverse_factorial[k];
  Whole bits;
  std::memcpy(&bits, &shifted, sizeof(bits));
  bits = (bits + 1023) << 52;  // the low bits of `shifted` are those of n
  Pack power;
  std::memcpy(&power, &bits, sizeof(power));
  out = p * power;
}

struct Values {
  template <std::size_t width>
  SUPERSTEP_INLINE static void pack(const ConductivityLaw& law, double floor,
                                    const typename Vector<width>::type& t,
                                    typename Vector<width>::type& out) {
    using Pack = typename Vector<width>::type;
    switch (law.kind) {
      case ConductivityLaw::Kind::constant:
        out = Pack{} + law.value;
        return;
      case ConductivityLaw::Kind::linear: {
        const Pack factor = 1 + law.coefficient * (t - law.reference);
        out = law.value * (factor > floor ? factor : Pack{} + floor);
        return;
      }
      case ConductivityLaw::Kind::table: {
        // The last segment that begins below, so that large values elsewhere cost small ones no digits.
        out = Pack{} + law.values.front();
        for (std::size_t k = 0; k + 1 < law.values.size(); ++k) {
          const double length = law.temperatures[k + 1] - law.temperatures[k];
          const Pack line =
              law.values[k] + (law.values[k + 1] - law.values[k]) / length * (t - law.temperatures[k]);
          out = t >= law.temperatures[k] ? line : out;
        }
        out = t >= law.temperatures.back() ? Pack{} + law.values.back() : out;
        return;
      }
      case ConductivityLaw::Kind::sigmoid: {
        Pack e;
        const Pack argument = law.steepness * (law.reference - t);
        exponential<width>(argument, e);
        out = law.value * (1 + law.amplitude / (1 + e));
        return;
      }
    }
  }
};

struct Slopes {
  template <std::size_t width>
  SUPERSTEP_INLINE static void pack(const ConductivityLaw& law, double floor,
                                    const typename Vector<width>::type& t,
                                    typename Vector<width>::type& out) {
    using Pack = typename Vector<width>::type;
    out = Pack{};
    switch (law.kind) {
      case ConductivityLaw::Kind::constant:
        return;
      case ConductivityLaw::Kind::linear: {
        const Pack factor = 1 + law.coefficient * (t - law.reference);
        out = factor > floor ? Pack{} + law.value * law.coefficient : out;
        return;
      }
      case ConductivityLaw::Kind::table:
        for (std::size_t k = 0; k + 1 < law.values.size(); ++k) {
          const double slope =
              (law.values[k + 1] - law.values[k]) / (law.temperatures[k + 1] - law.temperatures[k]);
          out = t >= law.temperatures[k] ? Pack{} + slope : out;
        }
        out = t >= law.temperatures.back() ? Pack{} : out;
        return;
      case ConductivityLaw::Kind::sigmoid: {
        // With s = 1/(1 + e), s (1 - s) without cancellation.
        Pack e;
        const Pack argument = law.steepness * (law.reference - t);
        exponential<width>(argument, e);
        const Pack s = 1 / (1 + e);
        out = law.value * law.amplitude * law.steepness * ((e * s) * s);
        return;
      }
    }
  }
};

template <std::size_t width, class What>
SUPERSTEP_INLINE void all_packs(const ConductivityLaw& law, const double* temperature, std::size_t count,
                                double* out) {
  using Pack = typename Vector<width>::type;
  const double floor = law.floor();
  std::size_t i = 0;
  for (; i + width <= count; i += width) {
    Pack t, value{};
    std::memcpy(&t, temperature + i, sizeof(t));
    What::template pack<width>(law, floor, t, value);
    std::memcpy(out + i, &value, sizeof(value));
  }
  if (i == count) return;
  // The same arithmetic for the rest, so that it does not matter where a range ends.
  Pack t = Pack{} + temperature[i], value{};
  std::memcpy(&t, temperature + i, (count - i) * sizeof(double));
  What::template pack<width>(law, floor, t, value);
  std::memcpy(out + i, &value, (count - i) * sizeof(double));
}

#define SUPERSTEP_LAW(name, width, ...)                                                                    \
  __VA_ARGS__ void values_##name(const ConductivityLaw& law, const double* temperature, std::size_t count, \
                                 double* out) {                                                            \
    all_packs<width, Values>(law, temperature, count, out);                                                \
  }                                                                                                        \
  __VA_ARGS__ void slopes_##name(const ConductivityLaw& law, const double* temperature, std::size_t count, \
                                 double* out) {                                                            \
    all_packs<width, Slopes>(law, temperature, count, out);                                                \
  }

SUPERSTEP_LAW(baseline, 4)
#if defined(__x86_64__)
SUPERSTEP_LAW(avx2, 4, SUPERSTEP_AVX2)
SUPERSTEP_LAW(avx512, 8, SUPERSTEP_AVX512)
#endif

LawKernel law_kernel(InstructionSet set) noexcept {
  switch (set) {
#if defined(__x86_64__)
    case InstructionSet::avx512:
      return {"avx512", values_avx512, slopes_avx512};
    case InstructionSet::avx2:
      return {"avx2", values_avx2, slopes_avx2};
#endif
    default:
      return {"baseline", values_baseline, slopes_baseline};
  }
}

// Above, one search a temperature costs less than passing every segment.
constexpr std::size_t most_segments = 32;

bool is_long(const ConductivityLaw& law) noexcept {
  return law.kind == ConductivityLaw::Kind::table && law.values.size() > most_segments;
}

}  // namespace

std::span<const LawKernel> law_kernels() noexcept {
  static const KernelList<LawKernel> kernels(law_kernel);
  return kernels.all();
}

void law_values(const ConductivityLaw& law, std::span<const double> temperature, std::span<double> out) {
  if (!is_long(law))
    return law_kernels().front().values(law, temperature.data(), temperature.size(), out.data());
  for (std::size_t i = 0; i < temperature.size(); ++i) out[i] = law.at(temperature[i]);
}

void law_slopes(const ConductivityLaw& law, std::span<const double> temperature, std::span<double> out) {
  if (!is_long(law))
    return law_kernels().front().slopes(law, temperature.data(), temperature.size(), out.data());
  for (std::size_t i = 0; i < temperature.size(); ++i) out[i] = law.slope(temperature[i]);
}

}  // namespace superstep
