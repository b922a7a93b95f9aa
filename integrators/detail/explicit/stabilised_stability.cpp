#include "integrators/detail/explicit/stabilised_stability.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <memory>
#include <string>

namespace superstep {
namespace {

/// The last stages of the ROCK methods multiply the roundings of their recurrence by w(-l). Those of a stage
/// reach the end of a Chebyshev recurrence at its stiff end multiplied by the stages that follow, and add up
/// like a walk at random: to 0.58 s^1.5 units, if each stage makes one. It makes less: measured 0.02 to
/// 0.04 s^1.5 at 8 to 100 stages of ROCK4.
double rounding_at_stiff_end(const StabilisedFamily& family, int stages) {
  constexpr double walk = 0.1;
  return walk * std::pow(stages, 1.5) * std::numeric_limits<double>::epsilon() * family.stiff_end *
         std::pow(stages, family.rounding_power);
}

StabilityModel model_of(const OfferedFamily& offered, int stages) {
  const auto& family = offered.family();
  const auto scheme = std::make_shared<ThreeTermScheme>(family.scheme(stages));
  const std::string head = fmt::format("{}stages={}", offered.spec_head, stages);
  return {.family = family.name,
          .parameters = fmt::format("s={}", stages),
          .stages = stages,
          .beta = scheme->beta,
          .z_stiff = stability_margin * scheme->beta,
          .rounding = rounding_at_stiff_end(family, stages),
          .response = [scheme](double z) { return stability_polynomial(*scheme, -z); },
          .spec = [head](double step) { return fmt::format("{},step={:.17g}", head, step); }};
}

std::vector<int> stage_counts(const StabilisedFamily& family, bool quick) {
  if (family.order == 4) return quick ? std::vector{5, 20} : std::vector{5, 8, 10, 20, 50, 100};
  if (family.fewest_stages > 2)
    return quick ? std::vector{3, 5, 21} : std::vector{3, 5, 11, 21, 51, 101, 199};
  return quick ? std::vector{2, 5, 20} : std::vector{2, 3, 5, 10, 20, 50, 100, 200};
}

}  // namespace

StabilityTheory stabilised_theory(const std::vector<OfferedFamily>& families) {
  return {.functions =
              [families](bool quick) {
                std::vector<StabilityModel> models;
                for (const auto& offered : families)
                  for (const int stages : stage_counts(offered.family(), quick))
                    models.push_back(model_of(offered, stages));
                return models;
              },
          .limits =
              [families](bool quick) {
                std::vector<StabilityModel> models;
                for (const auto& offered : families)
                  if (offered.limit_when_quick || !quick)
                    models.push_back(model_of(offered, offered.limit_stages));
                return models;
              }};
}

}  // namespace superstep
