#include "bench/host/progress.hpp"

#include <gtest/gtest.h>

namespace superstep {
namespace {

TEST(ProgressText, ExtrapolatesFromTheLastKnownPosition) {
  EXPECT_EQ(progress_text(0.25, 1, 10, 10), "25 %, 0.025/s, 30 s left");
  EXPECT_EQ(progress_text(0.25, 1, 10, 15), "25 %, 0.025/s, 25 s left");
  EXPECT_EQ(progress_text(0.25, 1, 10, 90), "25 %, 0.025/s, 0 s left");
}

TEST(ProgressText, SaysOnlyTheTimeWhileNothingIsKnown) {
  EXPECT_EQ(progress_text(0, 1, 0, 2.5), "2.5 s");
}

TEST(Progress, OnlyAnEnabledOneWatches) {
  EXPECT_EQ(Progress(false).watched(), nullptr);
  EXPECT_NE(Progress(true).watched(), nullptr);
}

TEST(Progress, ADisabledOneIsSilent) {
  testing::internal::CaptureStderr();
  {
    Progress progress(false);
    progress.begin("work", 1);
    progress.reached(0.5);
    progress.begin_timed("timed");
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace superstep
