// One scene there and back; round_trip_long_test takes the others.
#include <gtest/gtest.h>

#include "tests/round_trip/expect.h"
#include "tests/round_trip/page.h"
#include "tests/round_trip/picture.h"

namespace overstrike {
namespace {

TEST(RoundTrip, ThePageIsThePicture) { expect_page_is_picture("ten-lines.yaml"); }
TEST(RoundTrip, TheSheetIsThePicture) { expect_sheet_is_picture("ten-lines.yaml"); }

// The comparison can fail: under a light 10 degrees higher tones and shadows are others.
TEST(RoundTrip, AnotherPageIsSeen) {
  const Scene scene = scene_of("ten-lines.yaml");
  Scene other = scene;
  other.light->elevation_deg += 10;
  EXPECT_GT(compare_page(scene, other).off, 1000);
}

}  // namespace
}  // namespace overstrike
