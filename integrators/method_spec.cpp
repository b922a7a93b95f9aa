#include "integrators/method_spec.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <string_view>

#include "core/error.hpp"

namespace superstep {
namespace {

constexpr const char* rtol_key = "rtol";

}  // namespace

MethodSpec::MethodSpec(const std::string& text)
    : entry_(&find_integrator(parse_spec(text).name)),
      options_(parse_spec(text), entry_->keys),
      rtol_(make()->rtol()) {}

MethodSpec MethodSpec::with_tolerance(double rtol) const {
  if (std::none_of(entry_->keys.begin(), entry_->keys.end(),
                   [](const OptionKey& key) { return key.name == rtol_key; }))
    throw UsageError(fmt::format(
        "{} has no relative tolerance: it takes steps of a fixed size; leave the tolerance out, or "
        "choose a method with the key 'rtol' (see superstep list)",
        name()));
  std::string settings;
  bool there = false;
  for (const auto& [key, value] : options_.spec().settings) {
    const bool replaced = key == rtol_key;
    there = there || replaced;
    settings +=
        fmt::format("{}{}={}", settings.empty() ? ":" : ",", key, replaced ? fmt::format("{}", rtol) : value);
  }
  if (!there) settings += fmt::format("{}{}={}", settings.empty() ? ":" : ",", rtol_key, rtol);
  return {name() + settings};
}

double MethodSpec::tightest_tolerance() const noexcept {
  for (const auto& key : entry_->keys)
    if (key.name == rtol_key) return key.min;
  return 0;
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
