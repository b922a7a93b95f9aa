#include "bench/host/yardstick.hpp"

#include <utility>

#include "core/stopwatch.hpp"

namespace superstep {

Yardstick::Yardstick() : row_begin_{0} {
  constexpr std::int32_t side = 24, layer = side * side, size = layer * side;
  for (std::int32_t node = 0; node < size; ++node) {
    const std::int32_t x = node % side, y = node / side % side, z = node / layer;
    const auto join = [&](bool there, std::int32_t other) {
      if (!there) return;
      column_.push_back(other);
      rate_.push_back(1.0);
    };
    join(z > 0, node - layer);
    join(y > 0, node - side);
    join(x > 0, node - 1);
    join(x + 1 < side, node + 1);
    join(y + 1 < side, node + side);
    join(z + 1 < side, node + layer);
    row_begin_.push_back(static_cast<std::int64_t>(column_.size()));
    state_.push_back(static_cast<double>(node % 7));
  }
  next_ = state_;
}

void Yardstick::work() {
  constexpr int sweeps = 200;
  constexpr double step = 0.1;  // stable: the largest row sum is 6
  for (int k = 0; k < sweeps; ++k) {
    reference_sweep({row_begin_, column_, rate_}, {.y1 = state_.data(), .a = 1, .d = step}, next_.data());
    std::swap(state_, next_);
  }
}

double Yardstick::seconds(double at_least) {
  const double begin = process_cpu_seconds();
  double elapsed = 0;
  int times = 0;
  do {
    work();
    ++times;
    elapsed = process_cpu_seconds() - begin;
  } while (elapsed < at_least);
  return elapsed / times;
}

}  // namespace superstep
