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

  enum class Cells : char {
    all,
    not_before,  ///< of two members in different cells one alone sees the other
  };

  /// Calls visit(entry, together) once for each member that accept(entry) holds for, among those whose cells
  /// come nearer than `reach` [m] to `centre` along every axis; `together` where that is the cell of
  /// `centre`. Returns how many members it had to look at.
  template <class Accept, class Visit>
  std::size_t near(Vec3 centre, double reach, Cells cells, const Accept& accept, const Visit& visit) const {
    const Cell own = cell_of(centre);
    const bool half = cells == Cells::not_before;
    std::size_t looked_at = 0;
    const auto [x0, x1] = range(centre.x, reach);
    const auto [y0, y1] = range(centre.y, reach);
    const auto [z0, z1] = range(centre.z, reach);
    for (std::int64_t z = half ? own.z : z0; z <= z1; ++z)
      for (std::int64_t y = half && z == own.z ? own.y : y0; y <= y1; ++y)
        for (std::int64_t x = half && z == own.z && y == own.y ? own.x : x0; x <= x1;) {
          // A row of cells is a run of buckets, cut where the table ends.
          const std::size_t bucket = bucket_of({x, y, z});
          const std::size_t run = std::min(static_cast<std::size_t>(x1 - x + 1), mask_ + 1 - bucket);
          const std::int64_t end = x + static_cast<std::int64_t>(run);
          const std::size_t first = start_[bucket], last = start_[bucket + run];
          looked_at += last - first;
          for (std::size_t k = first; k < last; ++k) {
            if (!accept(entries_[k])) continue;
            const Cell cell = cell_of(entries_[k].centre);  // other cells may share the bucket
            if (cell.y == y && cell.z == z && cell.x >= x && cell.x < end)
              visit(entries_[k], cell.x == own.x && y == own.y && z == own.z);
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
