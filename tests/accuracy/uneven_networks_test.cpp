/// Krylov spaces on networks whose conductances and capacities differ by orders of magnitude from place to
/// place: there estimates of the error were seen to be ten times too small.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "bench/harness/reference.hpp"
#include "bench/harness/verification.hpp"

namespace superstep {
namespace {

class UnevenNetwork : public testing::TestWithParam<const char*> {};

TEST_P(UnevenNetwork, LanczosKeepsItsTolerance) {
  const Scene scene = load_scene(fmt::format("{}/cases/corpus/{}.toml", SUPERSTEP_SOURCE_DIR, GetParam()));
  const ProbeSet probes(scene);
  Progress silent(false);
  ReferenceRequest request;
  request.use_cache = false;
  const auto found = obtain_reference(scene, probes, request, silent);
  ASSERT_TRUE(found.reference) << found.outcome.reason;
  for (const double rtol : {1e-2, 1e-4}) {
    const auto run = verify(scene, probes, fmt::format("exponential:basis=lanczos,rtol={}", rtol),
                            &*found.reference, nullptr, nullptr, {});
    ASSERT_TRUE(run.outcome.ok()) << run.outcome.reason;
    constexpr double most = 3;  // what any method may miss its tolerance by
    EXPECT_LT(run.errors.front().delivered.value(), most) << rtol;
  }
}

INSTANTIATE_TEST_SUITE_P(Corpus, UnevenNetwork, testing::Values("two_materials_1000", "fibres_1000"));

}  // namespace
}  // namespace superstep
