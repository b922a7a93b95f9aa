#include "results/thinning.hpp"

#include <algorithm>
#include <numeric>

#include "core/random.hpp"

namespace superstep {

std::vector<std::size_t> evenly_thinned(std::size_t n, std::size_t most) {
  std::vector<std::size_t> kept;
  const std::size_t count = std::min(n, most);
  for (std::size_t k = 0; k < count; ++k) kept.push_back(count < 2 ? 0 : k * (n - 1) / (count - 1));
  return kept;
}

std::vector<std::size_t> randomly_thinned(std::size_t n, std::size_t most) {
  std::vector<std::size_t> kept(n);
  std::iota(kept.begin(), kept.end(), std::size_t{0});
  if (n <= most) return kept;
  Random random(1);
  random.shuffle(kept);
  kept.resize(most);
  std::sort(kept.begin(), kept.end());
  return kept;
}

}  // namespace superstep
