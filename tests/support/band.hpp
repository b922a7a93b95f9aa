#pragma once
/// A network that is larger than a small cache, and narrow, and stages to pass over it.

#include <omp.h>

#include "network/graph.hpp"
#include "rhs/stage.hpp"

namespace superstep::test {

constexpr std::size_t small_cache = std::size_t{3} << 20;  ///< bytes; the network takes more

/// 30 000 nodes joined to some of the next forty, with fixed values, sources and convection; radiation and
/// sources that change in time on demand.
[[nodiscard]] Graph band(bool radiating, bool changing);

/// Stage `k` of a recurrence that has every optional term, but for its first stage, which is an Euler step.
[[nodiscard]] Stage stage_of(std::size_t k, double h, const double* y1, const double* y2, const double* y0,
                             const double* f0);

/// So many threads while it lives.
class Threads {
 public:
  explicit Threads(int count) : before_(omp_get_max_threads()) { omp_set_num_threads(count); }
  ~Threads() { omp_set_num_threads(before_); }
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;

 private:
  int before_;
};

}  // namespace superstep::test
