#include "tests/round_trip/expect.h"

#include <gtest/gtest.h>

#include "tests/round_trip/page.h"
#include "tests/round_trip/picture.h"
#include "tests/round_trip/sheet.h"

namespace overstrike {

void expect_page_is_picture(const std::string& name) {
  const Scene scene = scene_of(name);
  const PageReport page = compare_page(scene, scene);
  EXPECT_EQ(page.off, 0) << name << ": worst " << page.worst << " of " << kToneBound;
  EXPECT_EQ(page.cells + page.halfway, 135 * 180) << name;
  EXPECT_LE(page.halfway, 135 * 180 / 100) << name;
  EXPECT_GE(page.inked, 0.1) << name;
}

void expect_sheet_is_picture(const std::string& name) {
  const Scene scene = scene_of(name);
  const SheetReport sheet = compare_sheet(scene, scene);
  EXPECT_EQ(sheet.off, 0) << name << ": of " << sheet.blocks << " blocks";
  EXPECT_NEAR(sheet.mean, 0, 0.01) << name;
  EXPECT_EQ(sheet.unmarked, 0) << name << ": of " << sheet.borders << " borders";
  EXPECT_EQ(sheet.blots, 0) << name;
  // There was something to compare.
  EXPECT_GE(sheet.blocks, 50) << name;
  EXPECT_GE(sheet.levels, 4) << name;
  EXPECT_GE(sheet.borders, 4000) << name;
  EXPECT_GE(sheet.paper, 300000) << name;
  testing::Test::RecordProperty(name + " mean", std::to_string(sheet.mean));
}

}  // namespace overstrike
