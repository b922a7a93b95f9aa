#include "bench/scene_facts.hpp"

namespace superstep {

std::size_t main_field(const Rhs& rhs) noexcept {
  const auto fields = rhs.fields();
  for (std::size_t f = 0; f < fields.size(); ++f)
    if (fields[f].name == "temperature") return f;
  return 0;
}

std::vector<SkippedWork> skipped_work(const Scene& scene) {
  std::vector<SkippedWork> out;
  for (const auto& skip : scene.skips) out.push_back({skip.what, skip.because});
  return out;
}

}  // namespace superstep
