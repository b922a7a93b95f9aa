#pragma once
/// What every sweep does with the flux into a row, and how far ahead it asks for what comes.

#include "rhs/kernels/packs.hpp"
#include "rhs/stage.hpp"

namespace superstep {

// Distance that pays beyond the cache on the processors measured (AMD Zen 5): processors stop prefetching at
// the end of a page, so entries are asked for a page ahead.
inline constexpr std::int64_t entries_ahead = 512;

/// out[row] = a*own + b*y2 + c*y0 + d*flux + e*f0 of one row.
SUPERSTEP_INLINE void write_row(const Stage& stage, double own, double flux, std::size_t row, double* out) {
  double value = stage.a * own + stage.d * flux;
  if (stage.y2) value += stage.b * stage.y2[row];
  if (stage.y0) value += stage.c * stage.y0[row];
  if (stage.f0) value += stage.e * stage.f0[row];
  out[row] = value;
}

/// The same of `width` rows from `row` on.
template <std::size_t width>
SUPERSTEP_INLINE void write_rows(const Stage& stage, const typename Vector<width>::type& own,
                                 const typename Vector<width>::type& flux, std::size_t row, double* out) {
  using Pack = typename Vector<width>::type;
  Pack value = stage.a * own + stage.d * flux, term;
  const auto add = [&](double factor, const double* vector) __attribute__((always_inline)) {
    std::memcpy(&term, vector + row, sizeof(Pack));
    value += factor * term;
  };
  if (stage.y2) add(stage.b, stage.y2);
  if (stage.y0) add(stage.c, stage.y0);
  if (stage.f0) add(stage.e, stage.f0);
  std::memcpy(out + row, &value, sizeof(Pack));
}

}  // namespace superstep
