#include "bench/press/sintering_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "core/round_marks.hpp"
#include "core/text/append.hpp"

namespace superstep {
namespace {

using dynamics::HistoryRow;
using Rows = std::span<const HistoryRow>;
using Value = std::function<double(const HistoryRow&)>;

constexpr double width = 760, panel_height = 220, left = 70, right = 20, top = 40, gap = 50;

struct Curve {
  const char *name, *color;
  Value value;
};

/// Text that XML can hold.
std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text)
    if (c == '<')
      out.append("&lt;");
    else if (c == '&')
      out.append("&amp;");
    else
      out.push_back(c);
  return out;
}

/// One panel of the picture: a frame, marks and curves.
class Panel {
 public:
  Panel(std::string& out, double offset, Rows rows, double t_end, std::span<const Curve> curves)
      : out_(out), offset_(offset), t_end_(t_end) {
    low_ = high_ = curves.front().value(rows.front());
    for (const auto& curve : curves)
      for (const auto& row : rows) {
        low_ = std::min(low_, curve.value(row));
        high_ = std::max(high_, curve.value(row));
      }
    const auto [low, high] = room_for_marks(low_, high_);
    const double margin = 0.05 * (high - low);
    low_ = low - margin;
    high_ = high + margin;
  }

  void frame(const char* label) {
    put(R"(<rect x="{}" y="{}" width="{}" height="{}" fill="none" stroke="#888"/>)", left, offset_,
        width - left - right, panel_height);
    put(R"svg(<text x="16" y="{0}" transform="rotate(-90 16 {0})" text-anchor="middle">{1}</text>)svg",
        offset_ + panel_height / 2, label);
    for (const double value : round_marks(low_, high_, round_step(high_ - low_)))
      put(R"(<text x="{}" y="{:.1f}" text-anchor="end">{:.4g}</text>)", left - 6, y(value) + 4, value);
    for (const double time : round_marks(0, t_end_, round_step(t_end_)))
      put(R"(<text x="{:.1f}" y="{}" text-anchor="middle">{:.3g}</text>)", x(time),
          offset_ + panel_height + 16, time);
  }

  void phases(const Press& one, bool named) {
    for (const auto& phase : one.model.schedule.phases()) {
      if (phase.begin >= t_end_) break;
      const double end = std::min(phase.end, t_end_);
      put(R"(<line x1="{0:.1f}" y1="{1}" x2="{0:.1f}" y2="{2}" stroke="#ccc"/>)", x(end), offset_,
          offset_ + panel_height);
      if (named)
        put(R"(<text x="{:.1f}" y="{}" text-anchor="middle" fill="#666">{}</text>)",
            0.5 * (x(phase.begin) + x(end)), offset_ - 6, escaped(phase.name));
    }
  }

  void draw(const Curve& curve, Rows rows, std::size_t number) {
    put(R"(<polyline fill="none" stroke="{}" stroke-width="1.5" points=")", curve.color);
    for (const auto& row : rows) put("{:.2f},{:.2f} ", x(row.time), y(curve.value(row)));
    put("\"/>\n");
    put(R"(<text x="{}" y="{}" fill="{}">{}</text>)", left + 10,
        offset_ + 18 + 16 * static_cast<double>(number), curve.color, curve.name);
  }

 private:
  template <class... Args>
  void put(fmt::format_string<Args...> format, const Args&... arguments) {
    append(out_, format, arguments...);
  }
  [[nodiscard]] double x(double time) const { return left + (width - left - right) * time / t_end_; }
  [[nodiscard]] double y(double value) const {
    return offset_ + panel_height * (high_ - value) / (high_ - low_);
  }

  std::string& out_;
  double offset_, t_end_, low_ = 0, high_ = 1;
};

}  // namespace

std::string history_svg(const Press& one, Rows history) {
  std::string out;
  const double height = top + 2 * panel_height + gap + 50;
  append(out,
         R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0} {1}" width="{0}" height="{1}" )"
         R"(font-family="sans-serif" font-size="12"><rect width="100%" height="100%" fill="white"/>)",
         width, height);
  const std::vector<Curve> density = {{"volume fraction below the lowest position of the upper wall",
                                       "#1b6ca8", [](const HistoryRow& row) { return row.volume_fraction; }}};
  const std::vector<Curve> heat = {
      {"mean temperature", "#b8341b", [](const HistoryRow& row) { return row.mean_temperature; }},
      {"highest temperature", "#e0a030", [](const HistoryRow& row) { return row.max_temperature; }}};
  bool named = true;
  double offset = top;
  for (const auto& [curves, label] :
       {std::pair{&density, "volume fraction"}, std::pair{&heat, "temperature [K]"}}) {
    Panel panel(out, offset, history, one.t_end, *curves);
    panel.phases(one, named);
    panel.frame(label);
    for (std::size_t k = 0; k < curves->size(); ++k) panel.draw((*curves)[k], history, k);
    offset += panel_height + gap;
    named = false;
  }
  append(out, R"(<text x="{}" y="{}" text-anchor="middle">time [s]</text></svg>)", (left + width - right) / 2,
         height - 12);
  out.push_back('\n');
  return out;
}

}  // namespace superstep
