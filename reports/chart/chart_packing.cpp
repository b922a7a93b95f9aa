#include "reports/chart/chart_packing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>

#include "reports/chart/chart_figure.hpp"
#include "reports/chart/colour_bar.hpp"
#include "reports/chart/svg.hpp"
#include "results/text/html_text.hpp"

namespace superstep {
namespace {

constexpr double widest = 220, highest = 280, caption_room = 24;

/// What part of space the picture shows and how large.
struct View {
  double left = std::numeric_limits<double>::infinity(), right = -left, low = left, high = -left;  // m
  double scale = 1;                                                                                // px/m

  explicit View(const Slice& slice) {
    for (const auto& s : slice.spheres) {
      left = std::min(left, s.across - s.radius);
      right = std::max(right, s.across + s.radius);
      low = std::min(low, s.height - s.radius);
      high = std::max(high, s.height + s.radius);
    }
    scale = std::min(widest / (right - left), highest / (high - low));
  }
  [[nodiscard]] double width() const { return scale * (right - left); }
  [[nodiscard]] double height() const { return scale * (high - low); }
};

std::string frame_svg(const Slice& slice, const Slice::Frame& frame, const View& view,
                      const ValueRange& range, const std::vector<std::size_t>& order) {
  Svg svg(view.width() + 2, view.height() + caption_room,
          fmt::format("{} at {}, spheres cut by the mid-plane", frame.field, time_text(frame.time)));
  // A sphere that stands for several is drawn so large that together they cover what all of them would.
  const double drawn_radius =
      std::sqrt(std::max(1.0, static_cast<double>(slice.cut) / static_cast<double>(slice.spheres.size())));
  std::string spheres = R"(<g stroke="#000" stroke-opacity="0.35" stroke-width="0.4">)";
  for (const std::size_t k : order) {
    const auto& s = slice.spheres[k];
    spheres += fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="{:.1f}" fill="{}"/>)",
                           1 + view.scale * (s.across - view.left), view.scale * (view.high - s.height),
                           std::max(0.3, view.scale * drawn_radius * s.radius),
                           field_colour(range.fraction(frame.value[k])));
  }
  svg.raw(spheres + "</g>");
  svg.text(view.width() / 2, view.height() + 17, time_text(frame.time), {"middle", R"(font-weight="600")"});
  return svg.take();
}

nlohmann::ordered_json frames_data(const Slice& slice, const std::vector<const Slice::Frame*>& frames) {
  nlohmann::ordered_json data = {{"columns", {"id", "x [m]", "z [m]", "r [m]"}},
                                 {"rows", nlohmann::ordered_json::array()}};
  for (const auto* frame : frames)
    data["columns"].push_back(fmt::format("{} [{}] at {} s", frame->field, frame->unit, frame->time));
  for (std::size_t k = 0; k < slice.spheres.size(); ++k) {
    const auto& s = slice.spheres[k];
    nlohmann::ordered_json row = {s.id, s.across, s.height, s.radius};
    for (const auto* frame : frames) row.push_back(number_json(frame->value[k], 5));
    data["rows"].push_back(std::move(row));
  }
  return data;
}

std::string field_figure(const Slice& slice, const std::vector<const Slice::Frame*>& frames,
                         const std::string& id) {
  const View view(slice);
  ValueRange range;
  for (const auto* frame : frames)
    for (const double value : frame->value) range.include(value);
  std::vector<std::size_t> order(slice.spheres.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(
      order.begin(), order.end(),  // seen from -y: what lies behind is drawn first
      [&](std::size_t a, std::size_t b) { return slice.spheres[a].depth > slice.spheres[b].depth; });
  std::string pictures = R"(<div class="frames">)";
  for (const auto* frame : frames) pictures += frame_svg(slice, *frame, view, range, order);
  pictures += "</div>" + colour_bar(frames.front()->field, frames.front()->unit, range);
  const std::string left_out = slice.cut > slice.spheres.size()
                                   ? fmt::format(
                                         " Of {} such spheres {}, chosen at random, are drawn, "
                                         "larger to fill the gaps.",
                                         count_text(slice.cut), count_text(slice.spheres.size()))
                                   : "";
  return figure(
      "packing", id + "-" + frames.front()->field,
      fmt::format("The packing, coloured by {}", frames.front()->field),
      fmt::format("Spheres that the vertical mid-plane cuts, computed by {}.{}", slice.source, left_out),
      pictures, frames_data(slice, frames));
}

}  // namespace

std::string packing_figures(const Slice& slice, const std::string& id) {
  if (slice.spheres.empty()) return {};
  std::string out;
  std::vector<std::string> done;
  for (const auto& first : slice.frames) {
    if (std::find(done.begin(), done.end(), first.field) != done.end()) continue;
    done.push_back(first.field);
    std::vector<const Slice::Frame*> frames;
    for (const auto& frame : slice.frames)
      if (frame.field == first.field) frames.push_back(&frame);
    out += field_figure(slice, frames, id);
  }
  return out;
}

}  // namespace superstep
