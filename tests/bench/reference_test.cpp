#include "bench/harness/reference.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>

#include "bench/app/loaded_case.hpp"
#include "bench/harness/reference_cache.hpp"
#include "core/hash.hpp"
#include "integrators/registry.hpp"
#include "support/temporary_case.hpp"

namespace superstep {
namespace {

using test::CaseFolder;
using test::Rod;

class CachedReferenceTest : public testing::Test {
 protected:
  ReferenceResult obtain(const std::string& spec = "cvode:rtol=1e-8", bool use_cache = true) {
    return obtain_reference(scene_, probes_, {.spec = spec, .use_cache = use_cache}, silent_);
  }
  [[nodiscard]] std::string cached_file() const {
    for (const auto& entry : std::filesystem::directory_iterator(folder_.cache()))
      return entry.path().string();
    return {};
  }
  // The next reference must be integrated anew, equal the first one, and repair the file.
  void expect_recomputed(const Reference& first) {
    const auto again = obtain();
    ASSERT_TRUE(again.reference);
    EXPECT_FALSE(again.reference->from_cache);
    EXPECT_EQ(again.reference->states, first.states);
    EXPECT_TRUE(obtain().reference->from_cache);
  }

  CaseFolder folder_;
  Scene scene_ = std::get<Scene>(load_bench_case(write_rod(folder_, Rod{})).content);
  ProbeSet probes_{scene_};
  Progress silent_{false};
};

TEST_F(CachedReferenceTest, TheSecondTimeCostsNoIntegration) {
  const auto first = obtain();
  ASSERT_TRUE(first.reference) << first.outcome.reason;
  EXPECT_FALSE(first.reference->from_cache);
  EXPECT_GT(first.reference->cpu_seconds, 0);

  const auto sweeps = scene_.rhs->counters().sweeps;
  const auto second = obtain();
  ASSERT_TRUE(second.reference);
  EXPECT_TRUE(second.reference->from_cache);
  EXPECT_EQ(second.reference->cpu_seconds, 0);
  EXPECT_EQ(scene_.rhs->counters().sweeps, sweeps);
  EXPECT_EQ(second.reference->states, first.reference->states);
  EXPECT_EQ(second.reference->error_bar, first.reference->error_bar);
  EXPECT_EQ(second.reference->history.size(), first.reference->history.size());
  EXPECT_EQ(second.reference->history.at(33.3, 0), first.reference->history.at(33.3, 0));
}

TEST_F(CachedReferenceTest, AnyNumberThatTheAnswerDependsOnMissesAndATitleHits) {
  const auto from_cache = [&](const Rod& rod) {
    const Scene scene = std::get<Scene>(load_bench_case(write_rod(folder_, rod)).content);
    const ProbeSet probes(scene);
    return obtain_reference(scene, probes, {.spec = "cvode:rtol=1e-8"}, silent_).reference->from_cache;
  };
  EXPECT_FALSE(from_cache(Rod{}));
  Rod renamed, stiffer, longer;
  renamed.title = "another title";
  renamed.bench = "baseline = \"cvode\"\n";
  stiffer.conductance = 1 + 1e-15;
  longer.head = "t_end = 100\noutput_times = [10, 51, 100]\nprobe = 10\n";
  EXPECT_TRUE(from_cache(renamed));
  EXPECT_FALSE(from_cache(stiffer));
  EXPECT_FALSE(from_cache(longer));
}

TEST_F(CachedReferenceTest, ASceneThatNothingNamesIsNotCached) {
  scene_.content_hash.clear();
  (void)obtain();
  EXPECT_FALSE(std::filesystem::exists(folder_.cache()));
}

TEST_F(CachedReferenceTest, AnotherSpecIsAnotherReference) {
  (void)obtain();
  const auto other = obtain("cvode:rtol=1e-7");
  EXPECT_FALSE(other.reference->from_cache);
  EXPECT_EQ(other.reference->spec, "cvode:rtol=1e-7");
}

TEST_F(CachedReferenceTest, WithoutCacheNothingIsReadOrWritten) {
  (void)obtain("cvode:rtol=1e-8", false);
  EXPECT_FALSE(std::filesystem::exists(folder_.cache()));
  (void)obtain();
  EXPECT_FALSE(obtain("cvode:rtol=1e-8", false).reference->from_cache);
}

TEST_F(CachedReferenceTest, ADamagedFileIsIgnoredAndRewritten) {
  const auto first = obtain();
  {
    std::fstream file(cached_file(), std::ios::binary | std::ios::in | std::ios::out);
    file.seekp(200);
    file.put('\x55');
  }
  expect_recomputed(*first.reference);
}

TEST_F(CachedReferenceTest, ATruncatedFileIsIgnoredAndRewritten) {
  const auto first = obtain();
  std::filesystem::resize_file(cached_file(), 100);
  expect_recomputed(*first.reference);
}

TEST_F(CachedReferenceTest, AForeignFileIsIgnoredAndRewritten) {
  const auto first = obtain();
  std::ofstream(cached_file(), std::ios::trunc) << "not ours";
  expect_recomputed(*first.reference);
}

TEST_F(CachedReferenceTest, AChecksumThatFitsIsNotEnough) {
  const auto sealed = [&](double order) {
    std::string body;
    for (const std::vector<double>& values :
         std::vector<std::vector<double>>{{0}, {0}, {}, {}, {}, {1}, {1.0}, {order}, {0.0, 0.0}}) {
      const std::uint64_t size = values.size();
      body.append(reinterpret_cast<const char*>(&size), sizeof size);
      body.append(reinterpret_cast<const char*>(values.data()), size * sizeof(double));
    }
    return read_cached_reference(
        folder_.write("made.reference", "SSREF002" + ContentHash().add(body).text() + body));
  };
  EXPECT_TRUE(sealed(1)) << "a line at one probe";
  for (const double order : {-1.0, 101.0, 1e300, std::nan("")}) EXPECT_FALSE(sealed(order)) << order;
}

TEST_F(CachedReferenceTest, AnUnwritableCacheIsAWarning) {
  folder_.write("cache", "a file where the folder should be");
  const auto result = obtain();
  EXPECT_TRUE(result.reference);
  ASSERT_EQ(result.warnings.size(), 1U);
  EXPECT_NE(result.warnings[0].find("not cached"), std::string::npos);
}

TEST_F(CachedReferenceTest, TheExponentialGivesALinearSceneItsErrorBar) {
  const auto result = obtain("forward-euler:step=0.1");
  ASSERT_TRUE(result.reference);
  ASSERT_EQ(result.reference->error_bar.size(), 1u);
  const auto finer = obtain("forward-euler:step=0.05");
  EXPECT_NEAR(finer.reference->error_bar[0] / result.reference->error_bar[0], 0.5,
              0.05);  // its own, first-order error
  EXPECT_TRUE(obtain("forward-euler:step=0.1").reference->from_cache);
}

TEST(ReferenceOfALaw, IsNotKnownBetterThanTheToleranceItWasComputedWith) {
  const Scene scene = load_scene(std::string(SUPERSTEP_SOURCE_DIR) + "/tests/trouble/hot_surroundings.toml");
  Progress silent(false);
  const auto result = obtain_reference(scene, ProbeSet(scene), {.spec = "", .use_cache = false}, silent);
  ASSERT_TRUE(result.reference) << result.outcome.reason;
  ASSERT_NE(result.reference->spec.substr(0, 11), "exponential");
  const double own = make_method(result.reference->spec)->rtol() * result.reference->spans[0];
  EXPECT_GE(result.reference->error_bar[0], own);
  EXPECT_LE(result.reference->error_bar[0], 1e-8 * result.reference->spans[0]) << "what the project aims at";
}

TEST_F(CachedReferenceTest, AFailingReferenceSaysWhyAndIsNotCached) {
  const auto result = obtain("forward-euler:step=0.7");
  EXPECT_FALSE(result.reference);
  EXPECT_EQ(result.outcome.status, Status::unstable);
  EXPECT_FALSE(std::filesystem::exists(folder_.cache()));
}

// Before the two runs another one looks how far the values go: some tenths of a second here.
TEST(ReferenceLimits, HoldForThePilotRunAsWell) {
  const CaseFolder folder;
  const std::string file =
      folder.write("driven.toml",
                   "t_end = 50\n[network]\ngenerator = \"ladder\"\nsize = 20000\ncontrast = 1e9\ninlet = 1\n"
                   "source = { times = [0.0, 1.0], values = [1.0, 2.0] }\n");
  const Scene scene = std::get<Scene>(load_bench_case(file).content);
  const ProbeSet probes(scene);
  Progress silent(false);
  const auto found = obtain_reference(
      scene, probes, {.spec = {}, .use_cache = false, .limits = {.seconds = 1e-3, .of_cpu = true}}, silent);
  EXPECT_FALSE(found.reference);
  EXPECT_EQ(found.outcome.status, Status::timeout);
  EXPECT_NE(found.outcome.reason.find("the span of the fields is not found after 0.001 s"), std::string::npos)
      << found.outcome.reason;
}

}  // namespace
}  // namespace superstep
