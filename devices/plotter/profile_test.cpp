#include "devices/plotter/profile.h"

#include <gtest/gtest.h>

#include <fstream>

#include "core/error.h"
#include "devices/data_files.h"

namespace overstrike {
namespace {

std::string error_of(const std::string& text) {
  const std::filesystem::path file = std::filesystem::path(::testing::TempDir()) / "a.profile";
  std::ofstream(file) << text;
  try {
    read_plotter_profile(file);
  } catch (const InputError& error) {
    const std::string what = error.what();
    return what.substr(what.find("a.profile"));
  }
  return "none";
}

TEST(PlotterProfile, OfThe7475A) {
  const PlotterProfile profile = read_plotter_profile(find_data_file("plotters/hp7475a.profile"));
  EXPECT_EQ(profile.name, "HP 7475A");
  EXPECT_EQ(profile.unit_mm, 0.02488);
  EXPECT_EQ(profile.pens, 6);
  EXPECT_EQ(profile.fastest_cm_s, 38.1);
  EXPECT_EQ(profile.paper_names(), "A4, A3, A, B");
  ASSERT_NE(profile.paper("A3"), nullptr);
  EXPECT_EQ(profile.paper("A3")->clip_x, 16158);
  EXPECT_EQ(profile.paper("A5"), nullptr);
  for (const PlotterPaper& paper : profile.papers) {  // the pen stays on the paper
    EXPECT_LE(paper.origin_x_mm + paper.clip_x * profile.unit_mm, paper.width_mm);
    EXPECT_LE(paper.origin_y_mm + paper.clip_y * profile.unit_mm, paper.height_mm);
  }
}

TEST(PlotterProfile, Errors) {
  EXPECT_EQ(error_of("unit: 0.02\nunti: 3\n"),
            "a.profile:2: error: unti: is '3' (expected name:, unit:, buffer:, range:, speed:, "
            "paper: or pen:)");
  EXPECT_EQ(error_of("unit: wide  # or not\n"),
            "a.profile:1: error: unit: is 'wide' (expected the length of a plotter unit in mm)");
  EXPECT_EQ(error_of("# nothing\n"),
            "a.profile: error: is no plotter profile (expected at least unit:, one paper: and one "
            "pen:)");
  EXPECT_EQ(error_of("paper: A4 297 210 10 4 11040\n"),
            "a.profile:1: error: paper: is 'A4 297 210 10 4 11040' (expected a name, width, "
            "height, origin x and y in mm, hard clip X and Y in units)");
  EXPECT_EQ(error_of("paper: A4 297 210 10 4 1e300 5\n").substr(0, 19), "a.profile:1: error:");
  EXPECT_EQ(error_of("pen: 1 0.3 #000000\n").substr(0, 16), "a.profile: error");
  EXPECT_EQ(error_of("unit: -1\n").substr(0, 12), "a.profile:1:");
  EXPECT_EQ(error_of("unit: nan\n").substr(0, 12), "a.profile:1:");
}

/// The first overflowed an int, the second was cut to 5 while the emulator took 5.5.
TEST(PlotterProfile, WholeNumbersAreWholeAndNotTooLarge) {
  EXPECT_EQ(error_of("pen: 1e10 0.3 #000000\n").substr(0, 12), "a.profile:1:");
  EXPECT_EQ(error_of("pen: 1.5 0.3 #000000\n").substr(0, 12), "a.profile:1:");
  EXPECT_EQ(error_of("pen: 0 0.3 #000000\n").substr(0, 12), "a.profile:1:");
  EXPECT_EQ(error_of("paper: A4 297 210 10 4 5.5 5\n").substr(0, 12), "a.profile:1:");
}

TEST(PlotterProfile, MissingFile) {
  EXPECT_THROW(read_plotter_profile("/nowhere/none.profile"), InputError);
}

}  // namespace
}  // namespace overstrike
