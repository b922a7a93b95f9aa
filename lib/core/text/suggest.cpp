#include "core/text/suggest.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "core/text/delimited.hpp"

namespace superstep {
namespace {

constexpr std::size_t longest = 200;  // hostile names must not cost quadratic time

/// Insertions, deletions, substitutions and swaps of neighbours that turn a into b, no piece edited twice.
/// Source: "optimal string alignment", a restriction of Damerau (1964), doi:10.1145/363958.363994.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  const std::size_t width = b.size() + 1;
  std::vector<std::size_t> before(width), last(width), row(width);  // rows i-2, i-1 and i
  std::iota(last.begin(), last.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(last);
    last.swap(row);
  }
  return last[b.size()];
}

/// "euler" in "forward-euler"; a few letters stand in too many words to mean something.
bool one_holds_the_other(std::string_view a, std::string_view b) {
  constexpr std::size_t fewest = 4;
  if (a.size() > b.size()) std::swap(a, b);
  return a.size() >= fewest && b.find(a) != std::string_view::npos;
}

}  // namespace

std::string nearest_by_spelling(std::string_view name, std::span<const std::string> candidates) {
  if (name.size() > longest) return {};
  std::string best;
  // Of a single letter nothing is left when it is changed.
  std::size_t best_distance = name.size() < 2 ? 1 : 1 + std::max<std::size_t>(1, name.size() / 3);
  for (const auto& candidate : candidates) {
    const std::size_t distance = edit_distance(lower_case(name), lower_case(candidate));
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

std::string nearest_name(std::string_view name, std::span<const std::string> candidates) {
  if (name.size() > longest) return {};
  std::string best = nearest_by_spelling(name, candidates);
  if (!best.empty()) return best;
  std::size_t best_distance = longest;
  for (const auto& candidate : candidates) {
    if (!one_holds_the_other(name, candidate)) continue;
    const std::size_t distance = edit_distance(name, candidate);
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

std::string near_miss(std::string_view name, std::span<const std::string> candidates) {
  const std::string near = nearest_name(name, candidates);
  return near.empty() ? std::string{} : fmt::format("; did you mean '{}'?", near);
}

std::string suggestion(std::string_view name, std::span<const std::string> candidates) {
  if (const std::string near = near_miss(name, candidates); !near.empty()) return near;
  return candidates.empty() ? std::string{} : fmt::format("; valid are: {}", fmt::join(candidates, ", "));
}

}  // namespace superstep
