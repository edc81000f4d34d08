#include "cli/progress.h"

#include <gtest/gtest.h>

namespace overstrike {
namespace {

TEST(Progress, TheBarFillsFromTheLeft) {
  EXPECT_EQ(progress_bar(0), "[........................................]   0%");
  EXPECT_EQ(progress_bar(0.5), "[####################....................]  50%");
  EXPECT_EQ(progress_bar(1), "[########################################] 100%");
  EXPECT_EQ(progress_bar(-1), progress_bar(0));
  EXPECT_EQ(progress_bar(7), progress_bar(1));
}

TEST(Progress, ShortWorkShowsNothing) {
  testing::internal::CaptureStderr();
  {
    Progress progress(true);
    progress.show(0.5);
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace overstrike
