// The law: what is drawn of a random scene is what the oracle sees.
#include <gtest/gtest.h>

#include "tests/oracle/random_scenes.h"
#include "tests/oracle/trial.h"

namespace overstrike::oracle {
namespace {

TEST(Agreement, RandomScenesUnderThreeViews) {
  constexpr double kTolerance = 2;  // few facets: the tolerance is not what is tried here
  int skipped = 0;
  for (int n = 0; n < kRandomScenes; ++n) {
    const Scene scene = random_scene(n);
    for (int view = 0; view < kViews; ++view) {
      Trial trial(seen_from(scene, n, view), Grid{48, 60}, kTolerance, describe(n, view));
      trial.judge(kPoints, kEnds);
      skipped += trial.skipped();
    }
  }
  EXPECT_LE(skipped, kMaxSkipped * kPoints * kRandomScenes * kViews);
}

}  // namespace
}  // namespace overstrike::oracle
