#include "reports/chart/chart_figure.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/text/number.hpp"
#include "reports/chart/chart.hpp"
#include "results/text/html_text.hpp"

namespace superstep {
namespace {

using Json = nlohmann::ordered_json;

const char* kind_name(ChartSeries::Kind kind) {
  switch (kind) {
    case ChartSeries::Kind::line:
      return "line";
    case ChartSeries::Kind::points:
      return "points";
    case ChartSeries::Kind::columns:
      return "columns";
  }
  return "";
}

Json values_json(const std::vector<double>& values) {
  constexpr int digits = 7;  // more than a screen shows
  Json out = Json::array();
  for (const double value : values) out.push_back(number_json(value, digits));
  return out;
}

Json axis_json(const ChartAxis& axis) {
  return {{"label", axis.label}, {"log", axis.logarithmic}};
}

}  // namespace

Json number_json(double value, int digits) {
  if (!std::isfinite(value)) return nullptr;
  return parse_number(fmt::format("{:.{}g}", value, digits)).value_or(0.0);
}

std::string script_json(const Json& json) {
  std::string text = json.dump(-1, ' ', /*ensure_ascii=*/true, Json::error_handler_t::replace);
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;) text.replace(at, 1, "\\u003c");
  return text;
}

std::string figure(const std::string& kind, const std::string& id, const std::string& title,
                   const std::string& caption, const std::string& picture, const Json& data) {
  std::string out = fmt::format(R"(<figure class="{}" id="{}"><figcaption><b>{}</b>)", kind, html_text(id),
                                html_text(title));
  if (!caption.empty()) out += fmt::format(" <span>{}</span>", html_text(caption));
  out += "</figcaption>" + picture;
  if (!data.empty()) out += fmt::format(R"(<script type="application/json">{}</script>)", script_json(data));
  return out + "</figure>\n";
}

std::string chart_figure(const Chart& chart) {
  Json data = {{"title", chart.title},
               {"x", axis_json(chart.x)},
               {"y", axis_json(chart.y)},
               {"series", Json::array()}};
  for (const auto& series : chart.series)
    data["series"].push_back({{"name", series.name},
                              {"kind", kind_name(series.kind)},
                              {"colour", series.look.colour},
                              {"dash", series.look.dash},
                              {"x", values_json(series.x)},
                              {"y", values_json(series.y)}});
  for (const auto& span : chart.spans)
    data["spans"].push_back({number_json(span.begin, 7), number_json(span.end, 7)});
  return figure("xy", chart.id, chart.title, chart.caption, chart_svg(chart), data);
}

}  // namespace superstep
