#include "rhs/sweep.hpp"

namespace superstep {
namespace {

enum class Terms { y1, y1_y2, y1_y2_y0_f0 };

template <Terms terms>
void sweep_rows(const SweepRows& rows, const Stage& stage, double* out) noexcept {
  const std::size_t n = rows.row_begin.size() - 1;
  const std::int64_t* begin = rows.row_begin.data();
  const std::int32_t* column = rows.column.data();
  const double* rate = rows.rate.data();
  const double* y = stage.y1;
  std::int64_t k = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double centre = y[i];
    double flux = 0;
    for (const std::int64_t end = begin[i + 1]; k < end; ++k) flux += rate[k] * (y[column[k]] - centre);
    double value = stage.a * centre + stage.d * flux;
    if constexpr (terms != Terms::y1) value += stage.b * stage.y2[i];
    if constexpr (terms == Terms::y1_y2_y0_f0) value += stage.c * stage.y0[i] + stage.e * stage.f0[i];
    out[i] = value;
  }
}

}  // namespace

void fused_sweep(const SweepRows& rows, const Stage& stage, double* out) noexcept {
  if (stage.y0 != nullptr) return sweep_rows<Terms::y1_y2_y0_f0>(rows, stage, out);
  if (stage.y2 != nullptr) return sweep_rows<Terms::y1_y2>(rows, stage, out);
  sweep_rows<Terms::y1>(rows, stage, out);
}

}  // namespace superstep
