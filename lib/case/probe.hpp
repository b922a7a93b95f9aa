#pragma once
/// Nodes whose history a case asks for.

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "case/scene.hpp"
#include "core/text/toml.hpp"

namespace superstep {

/// Reads `probe = "mid-height" | id | [ids]`. Throws InputError for an unknown id, a repeated one, or
/// "mid-height" without coordinates.
[[nodiscard]] std::vector<Probe> read_probes(const TomlValue& probe, const Scene& scene);

/// The same of a scene that finds its nodes in its own way.
struct ProbeFinder {
  std::function<Probe(const TomlValue&value)> by_id, at_mid_height;
};
[[nodiscard]] std::vector<Probe> read_probes(const TomlValue& probe, const ProbeFinder& find);

/// Of those that it is shown, the particle nearest to the axis of a packing at half its height; of several as
/// near the one of the lowest number.
class MidHeight {
 public:
  explicit MidHeight(const Bounds& box) : middle_(0.5 * (box.min + box.max)) {}
  void look_at(Vec3 centre, std::int64_t number) noexcept {
    const double distance = norm(centre - middle_);
    if (distance > distance_ || (distance == distance_ && number > nearest_)) return;
    distance_ = distance;
    nearest_ = number;
  }
  [[nodiscard]] std::int64_t nearest() const noexcept { return nearest_; }
  [[nodiscard]] double distance() const noexcept { return distance_; }  ///< of that one [m]

 private:
  Vec3 middle_;
  std::int64_t nearest_ = 0;
  double distance_ = std::numeric_limits<double>::infinity();
};

}  // namespace superstep
