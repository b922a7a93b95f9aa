#pragma once
/// What a process has of a scene that nobody has as a whole.

#include <cstdint>
#include <functional>

#include "core/vec3.hpp"

namespace superstep {

/// A node as files of results show it.
struct ShownNode {
  std::int64_t id = 0;
  bool is_fixed = false;
  double fixed_value = 0;
  Vec3 centre;        ///< m, of a sphere
  double radius = 0;  ///< m
};

/// Nodes of all processes are numbered in one order, that of their rows; each process has consecutive ones.
class OwnNodes {
 public:
  virtual ~OwnNodes() = default;

  std::int64_t begin = 0, end = 0;  ///< nodes that are here
  std::int64_t edges = 0;           ///< of the whole scene

  [[nodiscard]] virtual std::int64_t nodes() const = 0;  ///< of the whole scene
  /// Else they have no places.
  [[nodiscard]] virtual bool are_spheres() const = 0;
  /// Calls each(node) for those that are here.
  virtual void show(const std::function<void(const ShownNode&)>& each) = 0;
};

}  // namespace superstep
