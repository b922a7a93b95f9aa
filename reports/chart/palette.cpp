#include "reports/chart/palette.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "core/text/options.hpp"
#include "integrators/registry.hpp"

namespace superstep {
namespace {

struct Colour {
  double red, green, blue;  // 0 .. 255
};

constexpr std::array<const char*, 3> spare_colours = {"#c44e6b", "#6f7fd0", "#7a6a4f"};
constexpr std::array markers = {Marker::circle,  Marker::square, Marker::triangle,
                                Marker::diamond, Marker::plus,   Marker::cross};
constexpr std::array<const char*, 5> dashes = {"", "7 3", "2 3", "9 3 2 3", "4 2"};
constexpr double lightest = 0.5;  // share of white in the lightest shade

Colour parse(const std::string& text) {
  const auto part = [&](std::size_t at) {
    return static_cast<double>(std::stoi(text.substr(at, 2), nullptr, 16));
  };
  return {part(1), part(3), part(5)};
}

std::string text_of(Colour c) {
  const auto part = [](double value) { return static_cast<int>(std::lround(std::clamp(value, 0.0, 255.0))); };
  return fmt::format("#{:02x}{:02x}{:02x}", part(c.red), part(c.green), part(c.blue));
}

Colour mixed(Colour a, Colour b, double share) {
  const auto mix = [&](double x, double y) { return x + share * (y - x); };
  return {mix(a.red, b.red), mix(a.green, b.green), mix(a.blue, b.blue)};
}

using Settings = std::map<std::string, std::string>;

Settings settings_of(const Spec& spec) {
  return {spec.settings.begin(), spec.settings.end()};
}

/// Values of one key in order of appearance.
std::vector<std::string> values_of(const std::vector<Settings>& all, const std::string& key) {
  std::vector<std::string> values;
  for (const auto& settings : all) {
    const auto found = settings.find(key);
    const std::string value = found == settings.end() ? "" : found->second;
    if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
  }
  return values;
}

/// Looks of the SPECs of one method.
class Family {
 public:
  Family(const std::string& integrator, const std::vector<Spec>& specs) : base_(method_look(integrator)) {
    std::vector<Settings> all;
    std::vector<std::string> keys;
    for (const auto& spec : specs) {
      all.push_back(settings_of(spec));
      for (const auto& [key, value] : spec.settings)
        if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
    }
    for (const auto& key : keys)
      if (auto values = values_of(all, key); values.size() > 1) varying_.emplace_back(key, std::move(values));
  }

  [[nodiscard]] Look look(const Spec& spec) const {
    Look out = base_;
    if (varying_.empty()) return out;
    const std::size_t shade = index(0, spec), count = varying_[0].second.size();
    out.colour =
        tinted(base_.colour, lightest * (1 - static_cast<double>(shade) / static_cast<double>(count - 1)));
    out.marker = markers[shade % markers.size()];
    if (varying_.size() > 1) out.dash = dashes[index(1, spec) % dashes.size()];
    return out;
  }

 private:
  [[nodiscard]] std::size_t index(std::size_t which, const Spec& spec) const {
    const auto& [key, values] = varying_[which];
    const Settings settings = settings_of(spec);
    const auto found = settings.find(key);
    const std::string value = found == settings.end() ? "" : found->second;
    return static_cast<std::size_t>(std::find(values.begin(), values.end(), value) - values.begin());
  }

  Look base_;
  std::vector<std::pair<std::string, std::vector<std::string>>> varying_;
};

// A SPEC of a results file need not be well-formed; its text then counts as the name.
Spec lenient_spec(const std::string& text) {
  try {
    return parse_spec(text);
  } catch (const std::exception&) {
    return {.text = text, .name = text, .settings = {}};
  }
}

}  // namespace

Look method_look(const std::string& integrator) {
  std::size_t place = 0;
  for (const auto& entry : integrators()) {
    const Marker marker = markers[place++ % markers.size()];
    if (integrator == entry.name && !entry.colour.empty()) return {entry.colour, "", marker};
  }
  for (const char c : integrator) place += static_cast<unsigned char>(c);
  return {spare_colours[place % spare_colours.size()], "", markers[place % markers.size()]};
}

std::vector<Look> looks_of(std::span<const std::string> specs) {
  std::vector<Spec> parsed;
  std::map<std::string, std::vector<Spec>> by_method;
  for (const auto& text : specs) {
    parsed.push_back(lenient_spec(text));
    by_method[parsed.back().name].push_back(parsed.back());
  }
  std::map<std::string, Family> families;
  for (const auto& [name, members] : by_method) families.emplace(name, Family(name, members));
  std::vector<Look> out;
  for (const auto& spec : parsed) out.push_back(families.at(spec.name).look(spec));
  return out;
}

Look curve_look(std::size_t k) {
  constexpr std::array hues = {"#0072b2", "#d55e00", "#009e73", "#e69f00", "#cc79a7", "#56b4e9", "#7f7f7f"};
  const std::size_t place = k % hues.size();
  return {hues[place], dashes[place % dashes.size()], markers[place % markers.size()]};
}

std::string field_colour(double fraction) {
  // Stops of increasing lightness along the hues of the "viridis" scale (S. van der Walt & N. Smith, CC0).
  constexpr Colour stops[] = {{68, 1, 84},    {65, 68, 135},  {42, 120, 142},
                              {34, 168, 132}, {122, 209, 81}, {253, 231, 37}};
  constexpr std::size_t last = std::size(stops) - 1;
  const double position =
      std::clamp(std::isfinite(fraction) ? fraction : 0.0, 0.0, 1.0) * static_cast<double>(last);
  const auto below = std::min(static_cast<std::size_t>(position), last - 1);
  return text_of(mixed(stops[below], stops[below + 1], position - static_cast<double>(below)));
}

std::string tinted(const std::string& colour, double share) {
  return text_of(mixed(parse(colour), {255, 255, 255}, share));
}

}  // namespace superstep
