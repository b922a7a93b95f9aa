#pragma once
/// Spheres grouped by grid cell. Cells are hashed: empty space costs nothing, however large the bounding box
/// is.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/vec3.hpp"

namespace superstep {

struct GridEntry {
  Vec3 centre;
  double radius;
  std::int32_t index;  ///< position in the packing
};

class HashGrid {
 public:
  /// cell_width [m] > 0
  HashGrid(std::span<const GridEntry> members, double cell_width);

  /// All members, those of one cell (and most of its row of cells) side by side.
  [[nodiscard]] std::span<const GridEntry> entries() const noexcept { return entries_; }

  /// Calls visit(entry) once for each member that accept(entry) holds for, among those whose cells come
  /// nearer than `reach` [m] to `centre` along every axis. Returns how many members it had to look at.
  template <class Accept, class Visit>
  std::size_t near(Vec3 centre, double reach, const Accept& accept, const Visit& visit) const {
    std::size_t looked_at = 0;
    const auto [x0, x1] = range(centre.x, reach);
    const auto [y0, y1] = range(centre.y, reach);
    const auto [z0, z1] = range(centre.z, reach);
    for (std::int64_t z = z0; z <= z1; ++z)
      for (std::int64_t y = y0; y <= y1; ++y)
        for (std::int64_t x = x0; x <= x1;) {
          // A row of cells is a run of buckets, cut where the table ends.
          const std::size_t bucket = bucket_of({x, y, z});
          const std::size_t run = std::min(static_cast<std::size_t>(x1 - x + 1), mask_ + 1 - bucket);
          const std::int64_t end = x + static_cast<std::int64_t>(run);
          const std::size_t first = start_[bucket], last = start_[bucket + run];
          looked_at += last - first;
          for (std::size_t k = first; k < last; ++k) {
            if (!accept(entries_[k])) continue;
            const Cell cell = cell_of(entries_[k].centre);  // other cells may share the bucket
            if (cell.y == y && cell.z == z && cell.x >= x && cell.x < end) visit(entries_[k]);
          }
          x = end;
        }
    return looked_at;
  }

 private:
  struct Cell {
    std::int64_t x, y, z;
  };

  [[nodiscard]] std::pair<std::int64_t, std::int64_t> range(double coordinate, double reach) const noexcept;
  [[nodiscard]] Cell cell_of(Vec3 centre) const noexcept;
  [[nodiscard]] std::size_t bucket_of(const Cell& cell) const noexcept;

  double cell_width_;
  std::size_t mask_;                  // buckets - 1; the number of buckets is a power of two
  std::vector<std::uint32_t> start_;  // [buckets + 1] first entry of each bucket
  std::vector<GridEntry> entries_;
};

}  // namespace superstep
