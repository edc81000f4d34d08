// Scenes with shadows on bodies, interpenetration, round bodies and many small ones.
#include <gtest/gtest.h>

#include "tests/round_trip/expect.h"
#include "tests/round_trip/picture.h"
#include "tests/round_trip/sheet.h"

namespace overstrike {
namespace {

class RoundTripOf : public testing::TestWithParam<const char*> {};

TEST_P(RoundTripOf, ThePageIsThePicture) { expect_page_is_picture(GetParam()); }
TEST_P(RoundTripOf, TheSheetIsThePicture) { expect_sheet_is_picture(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Scenes, RoundTripOf,
                         testing::Values("nn74-e-hospital.yaml", "interpenetrating.yaml",
                                         "village.yaml", "still-life.yaml"));

// Sheets of solids are not compared: shadows that solids cast have no outlines yet.
class PageOfSolids : public testing::TestWithParam<const char*> {};

TEST_P(PageOfSolids, IsThePicture) { expect_page_is_picture(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Scenes, PageOfSolids,
                         testing::Values("cut-cube.yaml", "pipe-cross.yaml", "nine-prisms.yaml",
                                         "dovetail.yaml"));

// The comparison can fail: under a light 10 degrees higher tones and shadows are others, and with
// the camera 1 degree round all borders are, too.
TEST(RoundTrip, AnotherSheetIsSeen) {
  const Scene scene = scene_of("ten-lines.yaml");
  Scene other = scene;
  other.light->elevation_deg += 10;
  other.camera.from.azimuth_deg += 1;
  const SheetReport sheet = compare_sheet(scene, other);
  EXPECT_GT(sheet.off, 20);
  EXPECT_GT(sheet.unmarked, 1000);
  EXPECT_GT(sheet.blots, 100);
}

}  // namespace
}  // namespace overstrike
