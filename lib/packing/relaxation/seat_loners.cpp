#include "packing/relaxation/seat_loners.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "packing/near_pairs.hpp"
#include "packing/relaxation/relax.hpp"

namespace superstep {
namespace {

/// A lone sphere and one that it could be moved to.
struct Offer {
  std::size_t loner, host;
};

std::vector<char> find_touching(const std::vector<double>& radii, const std::vector<Vec3>& centres) {
  std::vector<char> touches(radii.size(), 0);
  for (const auto [i, j] : near_pairs(centres, radii))
    touches[static_cast<std::size_t>(i)] = touches[static_cast<std::size_t>(j)] = 1;
  return touches;
}

/// Offers sorted by loner: every sphere within the loner's reach, lone or not.
std::vector<Offer> find_offers(const std::vector<double>& radii, const std::vector<Vec3>& centres,
                               const std::vector<char>& touches) {
  constexpr double loner_reach = 3.0;  // radii: the sphere itself and a gap of one diameter
  std::vector<double> reach = radii;
  for (std::size_t k = 0; k < reach.size(); ++k)
    if (!touches[k]) reach[k] *= loner_reach;
  std::vector<Offer> offers;
  for (const auto [first, second] : near_pairs(centres, reach)) {
    const auto i = static_cast<std::size_t>(first), j = static_cast<std::size_t>(second);
    if (!touches[i]) offers.push_back({i, j});
    if (!touches[j]) offers.push_back({j, i});
  }
  std::stable_sort(offers.begin(), offers.end(), [](Offer a, Offer b) { return a.loner < b.loner; });
  return offers;
}

}  // namespace

void seat_loners(const Container& container, double overlap, const std::vector<double>& radii,
                 std::vector<Vec3>& centres) {
  auto touches = find_touching(radii, centres);
  const auto loners = static_cast<std::size_t>(std::count(touches.begin(), touches.end(), 0));
  constexpr std::size_t one_in = 20;
  if (loners == 0 || loners > radii.size() / one_in) return;
  const auto offers = find_offers(radii, centres, touches);
  for (auto offer = offers.begin(); offer != offers.end();) {
    const std::size_t loner = offer->loner;
    std::size_t nearest = loner;
    double smallest_gap = std::numeric_limits<double>::infinity();
    for (; offer != offers.end() && offer->loner == loner; ++offer) {
      const std::size_t host = offer->host;
      const double gap = norm(centres[host] - centres[loner]) - radii[host] - radii[loner];
      if (!touches[host] || gap >= smallest_gap) continue;
      nearest = host;
      smallest_gap = gap;
    }
    if (nearest == loner) continue;
    const Vec3 towards = centres[nearest] - centres[loner];
    const double way = smallest_gap + overlap * std::min(radii[loner], radii[nearest]);
    centres[loner] = confined(container, centres[loner] + (way / norm(towards)) * towards, radii[loner]);
    touches[loner] = 1;
  }
}

}  // namespace superstep
