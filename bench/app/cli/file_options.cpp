/// Options of commands that read a packing file without a case.

#include <fmt/format.h>

#include <algorithm>

#include "bench/app/cli/cli_values.hpp"
#include "bench/app/cli/command_entry.hpp"
#include "contact/neck.hpp"
#include "core/error.hpp"
#include "core/text/suggest.hpp"
#include "core/text/text_file.hpp"
#include "packing/units.hpp"

namespace superstep {
namespace {

std::optional<double> positive(const char* option, const std::string& text) {
  if (text.empty()) return std::nullopt;
  return parse_positive_option(option, text);
}

std::string one_of(const char* option, const std::string& text, const std::vector<std::string>& words) {
  if (std::find(words.begin(), words.end(), text) == words.end())
    throw UsageError(
        fmt::format("{} {} is not valid{}", option, superstep::in_quotes(text), suggestion(text, words)));
  return text;
}

}  // namespace

std::vector<OptionEntry> file_options() {
  return {
      {"--conductivity", &Arguments::conductivity, "of a packing's material [W/(m K)]", "K"},
      {"--density", &Arguments::density, "of a packing's material [kg/m3] (default 2500)", "RHO"},
      {"--specific-heat", &Arguments::specific_heat, "of a packing's material [J/(kg K)] (default 700)", "C"},
      {"--axis", &Arguments::axis, "x, y or z: along which heat is led (default: the longest open one)",
       "AXIS"},
      {"--neck", &Arguments::neck, "neck law (default hertz)", "LAW"},
      {"--length-unit", &Arguments::file_unit, "of a packing file: m, cm, mm, um, nm (default: as it says)",
       "UNIT"},
      {"--units", &Arguments::units, "unit style of the code that wrote a packing file, as in cgs", "STYLE"},
      {"--periodic", &Arguments::periodic,
       "sides of a packing's box that are joined: none, or as in xy (default: as it says)", "AXES"}};
}

FileOptions file_options_of(const Arguments& values) {
  FileOptions options;
  for (const auto& option : file_options())
    if (!(values.*std::get<std::string Arguments::*>(option.target)).empty())
      options.given.push_back(option.name);
  options.conductivity = positive("--conductivity", values.conductivity);
  options.density = positive("--density", values.density);
  options.specific_heat = positive("--specific-heat", values.specific_heat);
  if (!values.axis.empty()) options.axis = one_of("--axis", values.axis, {"x", "y", "z"})[0];
  if (!values.neck.empty()) {
    std::vector<std::string> laws;
    for (const auto& law : neck_laws()) laws.push_back(law.name);
    options.neck = one_of("--neck", values.neck, laws);
  }
  options.reading.place = "the command line";
  options.length_unit = values.file_unit;
  if (!values.file_unit.empty()) options.reading.length_unit = parse_length_unit(values.file_unit);
  if (!values.units.empty()) options.reading.units = one_of("--units", values.units, unit_styles());
  if (!values.periodic.empty()) {
    if (values.periodic != "none" && values.periodic.find_first_not_of("xyz") != std::string::npos)
      throw UsageError(fmt::format("--periodic {} is not valid; it must be none, or axes such as x, xy, xyz",
                                   superstep::in_quotes(values.periodic)));
    options.reading.periodic = values.periodic;
  }
  return options;
}

}  // namespace superstep
