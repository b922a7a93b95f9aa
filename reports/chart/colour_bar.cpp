#include "reports/chart/colour_bar.hpp"

#include <fmt/format.h>

#include "reports/chart/svg.hpp"
#include "results/text/html_text.hpp"

namespace superstep {

std::string colour_bar(const std::string& field, const std::string& unit, const ValueRange& range) {
  constexpr double width = 300, height = 14;
  Svg svg(width + 60, 38, fmt::format("colour scale of the {}", field));
  constexpr int steps = 60;
  for (int k = 0; k < steps; ++k)
    svg.rectangle(30 + width * k / steps, 2, width / steps + 0.6, height,
                  fmt::format(R"(fill="{}")", field_colour((k + 0.5) / steps)));
  svg.text(30, 32, number_text(range.low), {"middle"});
  svg.text(30 + width / 2, 32, fmt::format("{} [{}]", field, unit), {"middle", R"(font-weight="600")"});
  svg.text(30 + width, 32, number_text(range.high), {"middle"});
  return svg.take();
}

std::string time_text(double t) {
  if (t == 0) return "t = 0";
  if (t < 1e-3) return fmt::format("t = {} µs", number_text(t * 1e6));
  if (t < 1) return fmt::format("t = {} ms", number_text(t * 1e3));
  return fmt::format("t = {} s", number_text(t));
}

}  // namespace superstep
