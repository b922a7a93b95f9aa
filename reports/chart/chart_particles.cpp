#include "reports/chart/chart_particles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "reports/chart/chart_figure.hpp"
#include "reports/chart/colour_bar.hpp"
#include "reports/chart/svg.hpp"
#include "results/text/html_text.hpp"

namespace superstep {
namespace {

constexpr double widest = 250, highest = 300, margin = 3, caption_room = 38;

/// What colours stand for.
struct Shown {
  double MotionFrame::Sphere::*value;
  const char *name, *unit;
};

constexpr Shown temperature{&MotionFrame::Sphere::temperature, "temperature", "K"},
    current{&MotionFrame::Sphere::electric, "current", "A"},
    potential{&MotionFrame::Sphere::electric, "potential", "V"};

/// From metres to pixels: the whole box fits.
struct View {
  double left, high, scale, width, height;

  explicit View(const MotionInput& motion)
      : left(motion.box_min[0]),
        high(motion.box_max[2]),
        scale(std::min(widest / (motion.box_max[0] - left), highest / (high - motion.box_min[2]))),
        width(scale * (motion.box_max[0] - left)),
        height(scale * (high - motion.box_min[2])) {}
  [[nodiscard]] double x(double across) const { return margin + scale * (across - left); }
  [[nodiscard]] double y(double z) const { return margin + scale * (high - z); }
};

/// The phase that a state at time t ends or lies in.
std::string phase_at(const MotionInput& motion, double t) {
  for (const auto& phase : motion.phases)
    if (t <= phase.end) return phase.name;
  return motion.phases.empty() ? "" : motion.phases.back().name;
}

std::string walls(const View& view, const MotionFrame& frame) {
  const double upper = view.y(frame.upper_wall), lower = margin + view.height, right = margin + view.width;
  return fmt::format(
      R"(<path d="M{0:.1f} {1:.1f}V{2:.1f}H{3:.1f}V{1:.1f}" fill="none" stroke="currentColor" stroke-width="1.2"/>)"
      R"(<line x1="{0:.1f}" y1="{4:.1f}" x2="{3:.1f}" y2="{4:.1f}" stroke="currentColor" stroke-width="3"/>)",
      margin, margin, lower, right, upper);
}

std::string frame_svg(const MotionInput& motion, const MotionFrame& frame, const View& view,
                      const Shown& shown, const ValueRange& range) {
  Svg svg(view.width + 2 * margin, view.height + 2 * margin + caption_room,
          fmt::format("particles coloured by {}, {}", shown.name, time_text(frame.time)));
  std::string spheres = R"(<g stroke="#000" stroke-opacity="0.35" stroke-width="0.4">)";
  for (const auto& s : frame.spheres)
    spheres += fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="{:.1f}" fill="{}"/>)", view.x(s.across),
                           view.y(s.height), std::max(0.3, view.scale * s.radius),
                           field_colour(range.fraction(s.*shown.value)));
  svg.raw(spheres + "</g>" + walls(view, frame));
  const double middle = margin + 0.5 * view.width, below = view.height + 2 * margin;
  svg.text(middle, below + 14, time_text(frame.time), {"middle", R"(font-weight="600")"});
  svg.text(middle, below + 30, shortened(phase_at(motion, frame.time), 24), {"middle"});
  return svg.take();
}

nlohmann::ordered_json frames_data(const MotionInput& motion, const Shown& shown) {
  nlohmann::ordered_json data = {
      {"columns",
       {"time [s]", "id", "x [m]", "z [m]", "r [m]", fmt::format("{} [{}]", shown.name, shown.unit)}},
      {"rows", nlohmann::ordered_json::array()}};
  constexpr int digits = 4;
  for (const auto& frame : motion.frames)
    for (const auto& s : frame.spheres)
      data["rows"].push_back({number_json(frame.time, 7), s.id, number_json(s.across, digits),
                              number_json(s.height, digits), number_json(s.radius, digits),
                              number_json(s.*shown.value, digits)});
  return data;
}

std::string caption_of(const MotionInput& motion) {
  const auto& fullest = *std::max_element(motion.frames.begin(), motion.frames.end(),
                                          [](const auto& a, const auto& b) { return a.behind < b.behind; });
  std::string text =
      "Seen from the front. The front half of the particles is left out so that the inside shows; the thick "
      "line is the upper wall.";
  if (fullest.behind > fullest.spheres.size())
    text += fmt::format(" Of up to {} particles in the rear half the {} nearest are drawn.",
                        count_text(fullest.behind), count_text(fullest.spheres.size()));
  return text;
}

ValueRange range_of(const MotionInput& motion, const Shown& shown) {
  ValueRange range;
  for (const auto& frame : motion.frames)
    for (const auto& s : frame.spheres) range.include(s.*shown.value);
  return range;
}

std::string coloured(const MotionInput& motion, const std::string& id, const Shown& shown,
                     const ValueRange& range) {
  const View view(motion);
  std::string pictures = R"(<div class="frames large">)";
  for (const auto& frame : motion.frames) pictures += frame_svg(motion, frame, view, shown, range);
  pictures += "</div>" + colour_bar(shown.name, shown.unit, range);
  return figure("packing", id, fmt::format("The particles, coloured by {}", shown.name), caption_of(motion),
                pictures, frames_data(motion, shown));
}

}  // namespace

std::string particles_figures(const MotionInput& motion, const std::string& id) {
  const ValueRange heat = range_of(motion, temperature);
  if (!(heat.low <= heat.high)) return {};
  std::string figures = coloured(motion, id, temperature, heat);
  if (motion.electric.empty()) return figures;
  const Shown& electric = motion.electric == "current" ? current : potential;
  const ValueRange range = range_of(motion, electric);
  if (range.low < range.high) figures += coloured(motion, id + "-electric", electric, range);
  return figures;
}

}  // namespace superstep
