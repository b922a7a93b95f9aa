#include "bench/app/cli/cli_values.hpp"

#include <fmt/format.h>

#include <limits>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/text/number.hpp"
#include "core/text/options.hpp"
#include "core/text/suggest.hpp"
#include "core/text/text_file.hpp"
#include "packing/read.hpp"

namespace superstep {
namespace {

OptionKey positive_key(const std::string& name) {
  return {.name = name, .min = 0, .min_open = true, .fallback = "", .meaning = ""};
}

double required(const Options& options, const std::string& key) {
  if (const auto value = options.given(key)) return *value;
  throw UsageError(fmt::format("--sizes {}: key '{}' is missing", in_quotes(options.spec().text), key));
}

void require_ascending(const SizeDistribution& sizes, const std::string& text) {
  if (sizes.min > sizes.max)
    throw UsageError(fmt::format("--sizes {}: min must not be larger than max", in_quotes(text)));
}

SizeDistribution lognormal(const Spec& spec, double unit) {
  const std::vector<OptionKey> keys = {positive_key("median"), positive_key("sigma"), positive_key("min"),
                                       positive_key("max")};
  const Options options(spec, keys);
  SizeDistribution sizes{.kind = SizeDistribution::Kind::lognormal,
                         .median = unit * required(options, "median"),
                         .sigma = required(options, "sigma"),
                         .min = unit * required(options, "min"),
                         .max = unit * required(options, "max"),
                         .diameters = {},
                         .weights = {}};
  require_ascending(sizes, spec.text);
  return sizes;
}

SizeDistribution uniform(const Spec& spec, double unit) {
  const std::vector<OptionKey> keys = {positive_key("min"), positive_key("max")};
  const Options options(spec, keys);
  SizeDistribution sizes;
  sizes.min = unit * required(options, "min");
  sizes.max = unit * required(options, "max");
  require_ascending(sizes, spec.text);
  return sizes;
}

SizeDistribution list_of(std::string_view diameters, double unit) {
  SizeDistribution sizes;
  sizes.kind = SizeDistribution::Kind::list;
  for (bool more = true; more;) {
    const std::size_t comma = diameters.find(',');
    sizes.diameters.push_back(unit *
                              parse_positive_option("--sizes list", std::string(diameters.substr(0, comma))));
    more = comma != std::string_view::npos;
    if (more) diameters.remove_prefix(comma + 1);
  }
  return sizes;
}

}  // namespace

std::int64_t parse_integer_option(const std::string& option, const std::string& text, std::int64_t min,
                                  std::int64_t max) {
  const auto value = parse_integer(text);
  if (value && *value >= min && *value <= max) return *value;
  const std::string range = max == std::numeric_limits<std::int64_t>::max()
                                ? fmt::format(">= {}", min)
                                : fmt::format("from {} to {}", min, max);
  throw UsageError(
      fmt::format("{} {} is not valid; it must be an integer {}", option, in_quotes(text), range));
}

double parse_positive_option(const std::string& option, const std::string& text) {
  const auto value = parse_number(text);
  if (value && *value > 0) return *value;
  throw UsageError(fmt::format("{} {} is not valid; it must be a number > 0", option, in_quotes(text)));
}

ColorMode parse_color_mode(const std::string& text) {
  if (text == "auto") return ColorMode::automatic;
  if (text == "always") return ColorMode::always;
  if (text == "never") return ColorMode::never;
  const std::vector<std::string> modes = {"auto", "always", "never"};
  throw UsageError(fmt::format("--color {} is not valid{}", in_quotes(text), suggestion(text, modes)));
}

SizeDistribution parse_sizes(const std::string& text, double unit) {
  constexpr std::string_view list = "list:";
  if (text.starts_with(list)) return list_of(std::string_view(text).substr(list.size()), unit);
  const std::string kind = text.substr(0, text.find(':'));
  const auto spec = [&] {
    try {
      return parse_spec(text);
    } catch (const UsageError&) {  // its message is about integrators
      throw UsageError(
          fmt::format("--sizes {} is not valid; write {}:key=value,key=value", in_quotes(text), kind));
    }
  };
  if (kind == "lognormal") return lognormal(spec(), unit);
  if (kind == "uniform") return uniform(spec(), unit);
  const std::vector<std::string> kinds = {"lognormal", "uniform", "list"};
  throw UsageError(
      fmt::format("--sizes: unknown distribution {}{}", in_quotes(kind), suggestion(kind, kinds)));
}

double parse_length_unit(const std::string& text) {
  try {
    return length_unit(text, "--length-unit");
  } catch (const InputError& error) {
    throw UsageError(error.what());
  }
}

}  // namespace superstep
