#pragma once
/// A few shapes of SVG, with coordinates rounded to a tenth of a pixel.

#include <fmt/format.h>

#include <string>
#include <string_view>

#include "core/text/append.hpp"
#include "reports/chart/palette.hpp"

namespace superstep {

class Svg {
 public:
  /// Begins a picture that scales with the page; `label` is read out by screen readers.
  Svg(double width, double height, std::string_view label);

  struct TextStyle {
    const char* anchor = "start";  ///< start, middle, end
    const char* extra = "";        ///< further attributes
  };
  void text(double x, double y, std::string_view content, TextStyle style = {"start", ""});
  void line(double x1, double y1, double x2, double y2, std::string_view attributes);
  void rectangle(double x, double y, double width, double height, std::string_view attributes,
                 std::string_view note = {});
  /// A mark of a series, with a tooltip when `note` is not empty.
  void marker(double x, double y, Marker marker, const std::string& colour, std::string_view note = {});
  void raw(std::string_view markup) { out_.append(markup); }
  /// The whole element; the picture is empty afterwards.
  [[nodiscard]] std::string take();

 private:
  template <class... Args>
  void add(fmt::format_string<Args...> format, const Args&... arguments) {
    append(out_, format, arguments...);
  }
  std::string out_;
};

/// Width of text in the charts' font, estimated [px].
[[nodiscard]] double text_width(std::string_view text) noexcept;

}  // namespace superstep
