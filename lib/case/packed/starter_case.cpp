#include "case/packed/starter_case.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <optional>
#include <string_view>
#include <vector>

#include "case/inputs/column_unit.hpp"
#include "contact/neck.hpp"
#include "contact/search.hpp"
#include "core/error.hpp"
#include "core/text/append.hpp"

namespace superstep {
namespace {

std::string toml_string(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + "\"";
}

/// The attribute that holds temperatures, by the names that codes give it: "temperature", "T", LIGGGHTS'
/// "f_Temp[0]". Nothing where there is none, or several, or one with gaps.
std::optional<std::string> temperature_column(const Packing& packing) {
  std::optional<std::string> found;
  for (const auto& attribute : packing.attributes) {
    const auto [written, unit] = split_column_unit(attribute.name);
    std::string name = bare_name(written);
    for (const std::string_view prefix : {"f_", "c_", "v_"})
      if (name.starts_with(prefix)) name.erase(0, prefix.size());
    if (name != "temperature" && name != "temp" && name != "t") continue;
    const bool is_whole =
        std::ranges::all_of(attribute.value, [](double kelvin) { return std::isfinite(kelvin); });
    if (found || !is_whole || !(unit.empty() || unit == "K")) return std::nullopt;
    found = attribute.name;
  }
  return found;
}

/// A number as TOML takes it for a float.
std::string number(double value) {
  std::string out = fmt::format("{}", value);
  return out.find_first_of(".e") == std::string::npos ? out + ".0" : out;
}

class Starter {
 public:
  Starter(const Packing& packing, const StarterSettings& settings)
      : packing_(packing), settings_(settings), axis_(starter_axis(packing, settings)) {}

  std::string text() {
    head();
    packing();
    materials();
    contact();
    thermal();
    return out_;
  }

 private:
  /// One line with its remark in a column of its own.
  void line(const std::string& code, const std::string& remark = {}) {
    constexpr std::size_t column = 34;
    out_ += code;
    if (!remark.empty())
      append(out_, "{}  # {}", std::string(code.size() < column ? column - code.size() : 0, ' '), remark);
    out_ += '\n';
  }
  static std::string example(bool given, const char* unit) {
    return given ? unit : fmt::format("{}; an example: put in your own", unit);
  }

  void head() {
    line(
        "# A case to start from. `superstep info`, `run` and `bench` take it; `superstep list --keys` lists "
        "every key.");
    line(fmt::format("title = {}", toml_string(std::filesystem::path(settings_.file).stem().string())));
    line(fmt::format("t_end = {}", number(settings_.t_end)),
         "s; about what heat needs from one side to the other");
    line("");
  }

  void packing() {
    line("[packing]");
    line(fmt::format("file = {}", toml_string(settings_.file)),
         fmt::format("{}, {} particles", packing_.format, packing_.size()));
    if (!settings_.length_unit.empty()) line(fmt::format("length_unit = \"{}\"", settings_.length_unit));
    if (settings_.units != "auto") line(fmt::format("units = \"{}\"", settings_.units));
    for (const auto& note : packing_.notes) line("# " + note);
    if (!packing_.cell || packing_.cell->periodic_axes() == "none") {
      if (settings_.periodic != "auto") line(fmt::format("periodic = \"{}\"", settings_.periodic));
    } else {
      std::string others;
      for (const char c : packing_.cell->periodic_axes())
        if (c != axis_) others += c;
      const bool is_cut = others != packing_.cell->periodic_axes();
      line(fmt::format("periodic = \"{}\"", others.empty() ? "none" : others),
           is_cut ? fmt::format(
                        "the box is periodic along {}; it is cut open along {}, where heat enters and leaves",
                        packing_.cell->periodic_axes(), axis_)
                  : "");
    }
    line("");
  }

  void materials() {
    line("[material]");
    line(fmt::format("density = {}", number(settings_.density)), example(settings_.given_density, "kg/m3"));
    if (packing_.material_names.size() > 1)
      line(
          fmt::format("# The packing has materials of its own ({}): [[materials]] describes them one by one.",
                      fmt::join(packing_.material_names, ", ")));
    line("");
  }

  void contact() {
    std::vector<std::string> others;
    for (const auto& law : neck_laws())
      if (law.name != settings_.neck) others.push_back(law.name);
    line("[contact]");
    line(fmt::format("neck = {}", toml_string(settings_.neck)),
         fmt::format("or {}, or given", fmt::join(others, ", ")));
    const double smallest = *std::min_element(packing_.radius.begin(), packing_.radius.end());
    constexpr double nearly = 1e-3, narrow = 0.1;  // of the smallest radius
    const std::size_t touching = find_contacts(packing_).size();
    if (2 * touching < packing_.size() && find_contacts(packing_, nearly * smallest).size() > 2 * touching) {
      const double unit = packing_.length_unit;
      line(fmt::format("gap = {}", number(nearly * smallest / unit)),
           "the particles only just touch: those this close do");
      line(fmt::format("bond_radius = {}", number(narrow * smallest / unit)),
           "radius of such necks; an assumption");
    }
    line("");
  }

  void thermal() {
    line("[thermal]");
    line(fmt::format("conductivity = {}", number(settings_.conductivity)),
         example(settings_.given_conductivity, "W/(m K)"));
    line(fmt::format("specific_heat = {}", number(settings_.specific_heat)),
         example(settings_.given_specific_heat, "J/(kg K)"));
    if (const auto column = temperature_column(packing_))
      line(fmt::format("initial = {{ column = {} }}", toml_string(*column)), "K; or one number for all");
    else
      line("initial = 293.15", "K; or { column = \"name\" } of the packing file");
    if (packing_.size() == 1) {
      line("convection = [ { where = \"all\", coefficient = 10.0, ambient = 393.15 } ]");
      return;
    }
    const auto [low, high] = ends();
    line(settings_.held_once
             ? fmt::format("fixed = [ {{ where = {}, value = 393.15 }} ]", high)
             : fmt::format("fixed = [ {{ where = {}, value = 393.15 }}, {{ where = {}, value = 293.15 }} ]",
                           high, low));
    line("# source = [ { where = \"all\", value = 1e-6 } ]", "W each");
    line("# convection = [ { where = \"all\", coefficient = 10.0, ambient = 293.15 } ]", "W/(m2 K)");
    line("# radiation = [ { where = \"all\", emissivity = 0.8, ambient = 293.15 } ]",
         "K; temperatures are absolute");
  }

  /// Layers at both ends, or, where those would meet or leave nothing free, the outermost particles.
  [[nodiscard]] std::pair<std::string, std::string> ends() const {
    const Bounds box = surface_bounds(packing_);
    const double mean = 2 * std::accumulate(packing_.radius.begin(), packing_.radius.end(), 0.0) /
                        static_cast<double>(packing_.size());
    constexpr double room = 2.5;  // mean diameters: two layers of one, and something between
    if (!settings_.held_once && component(box.max - box.min, axis_) > room * mean)
      return {fmt::format("\"-{}\"", axis_), fmt::format("\"+{}\"", axis_)};
    const auto before = [&](Vec3 a, Vec3 b) { return component(a, axis_) < component(b, axis_); };
    const auto [low, high] = std::minmax_element(packing_.centre.begin(), packing_.centre.end(), before);
    const auto by_id = [&](auto place) {
      return fmt::format("{{ ids = [{}] }}",
                         packing_.id[static_cast<std::size_t>(place - packing_.centre.begin())]);
    };
    return {by_id(low), by_id(high)};
  }

  const Packing& packing_;
  const StarterSettings& settings_;
  char axis_;
  std::string out_;
};

}  // namespace

char starter_axis(const Packing& packing, const StarterSettings& settings) {
  if (settings.axis != 0) return settings.axis;
  const Bounds box = surface_bounds(packing);
  char best = 'z';
  double longest = 0;
  bool best_is_open = false;
  for (const char axis : {'z', 'y', 'x'}) {
    const bool is_open = !packing.cell || !packing.cell->periodic[static_cast<std::size_t>(axis - 'x')];
    const double length = component(box.max - box.min, axis);
    constexpr double clearly = 1.001;
    if ((is_open && !best_is_open) || (is_open == best_is_open && length > clearly * longest)) {
      best = axis;
      longest = length;
      best_is_open = is_open;
    }
  }
  return best;
}

std::string starter_case(const Packing& packing, const StarterSettings& settings) {
  return Starter(packing, settings).text();
}

}  // namespace superstep
