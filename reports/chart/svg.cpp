#include "reports/chart/svg.hpp"

#include "results/text/html_text.hpp"

namespace superstep {

Svg::Svg(double width, double height, std::string_view label) {
  add(R"(<svg xmlns="http://www.w3.org/2000/svg" class="plot" viewBox="0 0 {:.0f} {:.0f}" role="img" aria-label="{}" font-family="system-ui, sans-serif" font-size="12" fill="currentColor">)",
      width, height, html_text(label));
}

void Svg::text(double x, double y, std::string_view content, TextStyle style) {
  if (content.empty()) return;
  add(R"(<text x="{:.1f}" y="{:.1f}" text-anchor="{}"{}{}>{}</text>)", x, y, style.anchor,
      *style.extra ? " " : "", style.extra, html_text(content));
}

void Svg::line(double x1, double y1, double x2, double y2, std::string_view attributes) {
  add(R"(<line x1="{:.1f}" y1="{:.1f}" x2="{:.1f}" y2="{:.1f}" {}/>)", x1, y1, x2, y2, attributes);
}

void Svg::rectangle(double x, double y, double width, double height, std::string_view attributes,
                    std::string_view note) {
  add(R"(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" {})", x, y, width, height, attributes);
  out_ += note.empty() ? "/>" : fmt::format("><title>{}</title></rect>", html_text(note));
}

void Svg::marker(double x, double y, Marker marker, const std::string& colour, std::string_view note) {
  constexpr double r = 3.6;
  std::string shape;
  switch (marker) {
    case Marker::none:
      return;
    case Marker::circle:
      shape = fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="{}" fill="{}")", x, y, r, colour);
      break;
    case Marker::square:
      shape = fmt::format(R"(<path d="M{:.1f} {:.1f}h6.4v6.4h-6.4z" fill="{}")", x - 3.2, y - 3.2, colour);
      break;
    case Marker::triangle:
      shape = fmt::format(R"(<path d="M{:.1f} {:.1f}l4.2 7.4h-8.4z" fill="{}")", x, y - 4.6, colour);
      break;
    case Marker::diamond:
      shape = fmt::format(R"(<path d="M{:.1f} {:.1f}l4.4 4.4l-4.4 4.4l-4.4 -4.4z" fill="{}")", x, y - 4.4,
                          colour);
      break;
    case Marker::plus:
      shape = fmt::format(
          R"(<path d="M{:.1f} {:.1f}v8.4m-4.2 -4.2h8.4" stroke="{}" stroke-width="2.2" fill="none")", x,
          y - 4.2, colour);
      break;
    case Marker::cross:
      shape = fmt::format(
          R"(<path d="M{:.1f} {:.1f}l6.6 6.6m-6.6 0l6.6 -6.6" stroke="{}" stroke-width="2.2" fill="none")",
          x - 3.3, y - 3.3, colour);
      break;
  }
  if (note.empty()) {
    add("{}/>", shape);
    return;
  }
  const std::string_view tag = marker == Marker::circle ? "circle" : "path";
  add("{}><title>{}</title></{}>", shape, html_text(note), tag);
}

std::string Svg::take() {
  return std::move(out_) + "</svg>";
}

double text_width(std::string_view text) noexcept {
  constexpr double per_character = 6.5;  // average of common sans-serif fonts at 12 px
  return per_character * static_cast<double>(characters(text));
}

}  // namespace superstep
