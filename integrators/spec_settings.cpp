#include "integrators/spec_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

#include "core/error.hpp"
#include "core/text/number.hpp"
#include "integrators/registry.hpp"

namespace superstep {
namespace {

const std::string tolerance_key = "rtol";

const OptionKey* tolerance_of(const IntegratorEntry& entry) {
  const auto found = std::find_if(entry.keys.begin(), entry.keys.end(),
                                  [](const OptionKey& key) { return key.name == tolerance_key; });
  return found == entry.keys.end() ? nullptr : &*found;
}

}  // namespace

std::string with_setting(const std::string& spec, const std::string& key, const std::string& value) {
  Spec parsed = parse_spec(spec);
  const auto found = std::find_if(parsed.settings.begin(), parsed.settings.end(),
                                  [&](const auto& setting) { return setting.first == key; });
  if (found == parsed.settings.end())
    parsed.settings.emplace_back(key, value);
  else
    found->second = value;
  std::string out = parsed.name;
  for (std::size_t k = 0; k < parsed.settings.size(); ++k)
    out += fmt::format("{}{}={}", k == 0 ? ":" : ",", parsed.settings[k].first, parsed.settings[k].second);
  return out;
}

std::string with_tolerance(const std::string& spec, double rtol) {
  const Spec parsed = parse_spec(spec);
  if (!tolerance_of(find_integrator(parsed.name)))
    throw UsageError(fmt::format(
        "--tolerance: {} has no relative tolerance; choose a method with the key 'rtol' (see superstep list)",
        parsed.name));
  std::string out = with_setting(spec, tolerance_key, fmt::format("{}", rtol));
  (void)make_integrator(out);  // checks the range
  return out;
}

std::optional<std::string> loosened(const std::string& spec) {
  constexpr double factor = 10;
  const Spec parsed = parse_spec(spec);
  const IntegratorEntry& entry = find_integrator(parsed.name);
  if (!entry.adaptive || !tolerance_of(entry)) return std::nullopt;
  std::string current = tolerance_of(entry)->fallback;
  for (const auto& [key, value] : parsed.settings)
    if (key == tolerance_key) current = value;
  const auto rtol = parse_number(current);
  if (!rtol) return std::nullopt;
  try {
    return with_tolerance(spec, factor * *rtol);
  } catch (const UsageError&) {  // 10 times looser is out of range, or fixed steps were asked for
    return std::nullopt;
  }
}

std::string folder_name(const std::string& spec) {
  constexpr std::string_view kept = "-._=";
  constexpr std::size_t longest = 100;  // file systems allow 255; leave room for a suffix
  std::string out;
  for (const char c : spec) {
    const bool keep =
        std::isalnum(static_cast<unsigned char>(c)) != 0 || kept.find(c) != std::string_view::npos;
    if (keep) out += c;
    if (!keep && (out.empty() || out.back() != '_')) out += '_';
  }
  return out.substr(0, longest);
}

}  // namespace superstep
