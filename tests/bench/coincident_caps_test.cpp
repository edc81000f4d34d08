// A scene is the same wherever it stands: nine prisms with all their caps in two planes (scene H1),
// turned so that rounding takes the caps apart, and moved up to 1e8 times their size away. No pixel
// differs from the oracle's picture of the scene where it was defined.
#include <gtest/gtest.h>

#include <cstdio>

#include "tests/bench/levels.h"
#include "tests/bench/solid_scenes.h"

namespace overstrike::bench {
namespace {

#ifdef OVERSTRIKE_CAPS_LONG
constexpr int kSize = 512;
#else
constexpr int kSize = 128;
#endif
constexpr int kSides = 32;

class CoincidentCaps : public ::testing::TestWithParam<int> {};

/// With 8 cut, an open ring; with all united, or four cut, the caps are one.
TEST_P(CoincidentCaps, AreNoWrongPixelWhereverTheyStand) {
  const Grid grid = square_grid(kSize);
  for (const double half_height : {1.0, 1.2}) {
    const Scene scene = nine_prisms(kSides, GetParam(), half_height);
    const Levels truth = true_levels(prepare(scene, grid));
    for (const Turned turned : {Turned::no, Turned::placed, Turned::baked})
      for (const double far : {0.0, 1e2, 1e4, 1e6, 1e8}) {
        const Levels found = drawn_levels(prepare(moved(scene, turned, far), grid));
        EXPECT_EQ(wrong_pixels(truth, found), 0)
            << "half height " << half_height << ", turned " << static_cast<int>(turned)
            << ", moved by " << far;
      }
  }
}

INSTANTIATE_TEST_SUITE_P(Cuts, CoincidentCaps, ::testing::Values(0, 4, 8));

TEST(WrongPixels, AreSeen) {
  EXPECT_EQ(wrong_pixels({0, 100, 200}, {0, 103, 198}), 1);
  const Grid grid = square_grid(64);
  const Levels ring = true_levels(prepare(nine_prisms(kSides, 8, 1.0), grid));
  const Levels whole = true_levels(prepare(nine_prisms(kSides, 0, 1.0), grid));
  EXPECT_GT(wrong_pixels(ring, whole), 100);
}

}  // namespace
}  // namespace overstrike::bench
