#include "packing/formats/inside_cell.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"

namespace superstep {
namespace {

std::string box_words(const Cell& cell, double unit) {
  const Vec3 low = (1 / unit) * cell.origin, high = (1 / unit) * (cell.origin + cell.shift({1, 1, 1}));
  return fmt::format("({:g}, {:g}, {:g}) to ({:g}, {:g}, {:g})", low.x, low.y, low.z, high.x, high.y, high.z);
}

std::string box_name(std::span<const std::size_t> lines) {
  return lines.empty() ? "of [packing] box" : "that the file states";
}

[[noreturn]] void refuse_far_outside(const Packing& packing, std::size_t k, const std::string& path,
                                     std::span<const std::size_t> lines) {
  const double unit = packing.length_unit;
  const Vec3 c = (1 / unit) * packing.centre[k];
  throw InputError(fmt::format(
      "{}: centre is ({:g}, {:g}, {:g}), far outside the box {} {}; {}mend the box",
      lines.empty() ? fmt::format("{}: particle {}", path, packing.id[k])
                    : fmt::format("{}:{}", path, lines[k]),
      c.x, c.y, c.z, box_words(*packing.cell, unit), box_name(lines),
      lines.empty()
          ? ""
          : "its columns may stand in another order: mend them, or declare them where the file does not name "
            "them, as in [packing] columns = [\"id\", \"type\", \"x\", \"y\", \"z\", \"diameter\", "
            "\"density\"], or "));
}

}  // namespace

void require_inside_cell(Packing& packing, bool unwrapped, const std::string& path,
                         std::span<const std::size_t> lines) {
  const Cell& cell = *packing.cell;
  if (!(cell.volume() > 0)) return;  // a flat box says nothing, and only a periodic one has to
  const double largest = *std::max_element(packing.radius.begin(), packing.radius.end());
  std::size_t outside = 0;
  double farthest = 0;
  for (std::size_t k = 0; k < packing.size(); ++k) {
    const Vec3 at = cell.fraction(packing.centre[k]);
    double beyond = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (unwrapped && cell.periodic[axis]) continue;
      const double part = axis == 0 ? at.x : axis == 1 ? at.y : at.z, height = cell.height(axis);
      const double distance = height * std::max(-part, part - 1);
      beyond = std::max(beyond, distance);
      if (distance > 0.5 * height + 2 * largest) refuse_far_outside(packing, k, path, lines);
    }
    if (beyond > packing.radius[k]) ++outside;
    farthest = std::max(farthest, beyond);
  }
  if (outside > 0)
    packing.warnings.push_back(fmt::format("{}: {} of {} centres lie outside the box {}, by up to {:.3g} m",
                                           path, outside, packing.size(), box_name(lines), farthest));
}

}  // namespace superstep
