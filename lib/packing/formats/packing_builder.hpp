#pragma once
/// Spheres of a packing file on their way into a checked Packing.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "packing/packing.hpp"

namespace superstep {

class PackingBuilder {
 public:
  ///   unit [m]  length of one unit of the file
  ///   row       what its spheres stand on, for messages
  PackingBuilder(std::string path, double unit, std::string row = "line");

  /// A sphere in the file's units. Throws InputError for a radius <= 0 and for lengths that cannot be
  /// computed with.
  void add(std::size_t line, std::int64_t id, Vec3 centre, double radius);
  /// Material of the sphere added last. Either every sphere has one or none: InputError otherwise, at the
  /// latest from `finish`.
  void set_material(std::string_view name);
  /// Forgets a material that all spheres share: the mere number 1 in a format that always numbers its
  /// materials.
  void drop_single_material();

  /// "file:line", or "file: point 7", to begin an error message with.
  [[nodiscard]] std::string where(std::size_t line) const;
  [[nodiscard]] std::size_t size() const noexcept { return packing_.size(); }
  /// Lines of the spheres [n], until they are finished.
  [[nodiscard]] const std::vector<std::size_t>& lines() const noexcept { return line_; }
  /// The packing. Throws InputError when it is empty or when ids or centres coincide.
  [[nodiscard]] Packing finish();

 private:
  [[nodiscard]] double metres(std::size_t line, double length, std::string_view what) const;
  void require_materials() const;
  void check_ids() const;
  void check_centres() const;

  std::string path_;
  double unit_;
  std::string row_;
  Packing packing_;
  std::vector<std::size_t> line_;  // [n] for error messages
  std::unordered_map<std::string, std::int32_t> material_index_;
};

}  // namespace superstep
