#include "emulators/plotter/plotter.h"

#include <cairo.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <sstream>

#include "emulators/plotter/profile.h"

namespace overstrike::emulator {
namespace {

namespace fs = std::filesystem;

class EmulatedPlotter : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) / "overstrike_emulated_plotter_test";
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string drawn(const std::string& hpgl, const PlotterOptions& options, const char* name) {
    emulate_plotter(hpgl, options, folder_ / name);
    std::ifstream in(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  std::string error_of(const PlotterOptions& options, const char* name) {
    try {
      emulate_plotter("IN;", options, folder_ / name);
    } catch (const Error& error) {
      return error.what();
    }
    return "none";
  }

  struct Pixels {
    int width, height;
    std::vector<std::uint32_t> rgb;
    std::uint32_t at(int x, int y) const { return rgb[std::size_t(y) * width + x]; }
  };

  Pixels png(const std::string& hpgl, const PlotterOptions& options) {
    drawn(hpgl, options, "sheet.png");
    cairo_surface_t* surface = cairo_image_surface_create_from_png((folder_ / "sheet.png").c_str());
    Pixels pixels{
        cairo_image_surface_get_width(surface), cairo_image_surface_get_height(surface), {}};
    for (int y = 0; y < pixels.height; ++y) {
      const auto* row = reinterpret_cast<const std::uint32_t*>(
          cairo_image_surface_get_data(surface) + y * cairo_image_surface_get_stride(surface));
      for (int x = 0; x < pixels.width; ++x) pixels.rgb.push_back(row[x] & 0xffffff);
    }
    cairo_surface_destroy(surface);
    return pixels;
  }

  fs::path folder_;
};

TEST_F(EmulatedPlotter, AnEmptyStreamIsAWhiteSheet) {
  const Pixels sheet = png("", {});
  EXPECT_EQ(sheet.width, 1169);  // 297 mm at 100 dpi
  EXPECT_EQ(sheet.height, 827);
  for (const std::uint32_t pixel : sheet.rgb) ASSERT_EQ(pixel, 0xffffffu);
}

TEST_F(EmulatedPlotter, InkHasItsPlaceWidthAndColour) {
  PlotterOptions options;
  options.dpi = 254;  // 10 pixels to the mm
  options.pen_width_mm = 2;
  options.pens = {"#ff0000", "#0000ff"};
  // The origin lies 10 mm from the left and 4 mm from the lower edge. 4000 units are 99.52 mm.
  const Pixels sheet = png("SP1;PU0,4000;PD8000,4000;SP2;PU4000,0;PD4000,7721;", options);
  EXPECT_EQ(sheet.width, 2970);
  EXPECT_EQ(sheet.height, 2100);
  const int line_y = 2100 - 40 - 995, line_x = 100 + 995;
  EXPECT_EQ(sheet.at(300, line_y), 0xff0000u);
  EXPECT_EQ(sheet.at(300, line_y - 8), 0xff0000u);
  EXPECT_EQ(sheet.at(300, line_y + 8), 0xff0000u);
  EXPECT_EQ(sheet.at(300, line_y - 12), 0xffffffu);
  EXPECT_EQ(sheet.at(300, line_y + 12), 0xffffffu);
  EXPECT_EQ(sheet.at(92, line_y), 0xff0000u);  // the round end
  EXPECT_EQ(sheet.at(91, line_y - 9), 0xffffffu);
  EXPECT_EQ(sheet.at(line_x, line_y), 0x0000ffu);  // later ink covers
  EXPECT_EQ(sheet.at(line_x, 200), 0x0000ffu);
}

TEST_F(EmulatedPlotter, HalfCoveredPixelsReflectHalfTheLight) {
  PlotterOptions options;
  options.dpi = 25.4;  // a pixel is 1 mm; the pen covers half of each pixel on its line
  options.pen_width_mm = 0.5;
  const Pixels sheet = png("SP1;PU0,4000;PD8000,4000;", options);
  // Reflectance 1/2 is 188 in sRGB.
  EXPECT_EQ(sheet.at(100, 210 - 4 - 100), 0xbcbcbcu);
}

TEST_F(EmulatedPlotter, DrawingALineTwiceChangesNothing) {
  const std::string line = "SP1;PU100,100;PD5000,3210;PU;";
  EXPECT_EQ(drawn(line, {}, "once.png"), drawn(line + line, {}, "twice.png"));
}

TEST_F(EmulatedPlotter, PapersAndResolutions) {
  PlotterOptions options;
  options.paper = "B";
  options.dpi = 50;
  const Pixels sheet = png("", options);
  EXPECT_EQ(sheet.width, 850);
  EXPECT_EQ(sheet.height, 550);
}

TEST_F(EmulatedPlotter, VectorSheets) {
  const std::string hpgl = "IN;SP1;PU0,0;PD1000,1000;";
  const std::string pdf = drawn(hpgl, {}, "sheet.pdf"), svg = drawn(hpgl, {}, "sheet.SVG");
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  EXPECT_NE(pdf.find("/MediaBox [ 0 0 841.8"), std::string::npos);
  EXPECT_NE(svg.find("<svg"), std::string::npos);
  EXPECT_NE(svg.find("stroke-linecap:round"), std::string::npos);
  EXPECT_EQ(drawn(hpgl, {}, "again.pdf"), pdf);
}

TEST_F(EmulatedPlotter, Errors) {
  PlotterOptions options;
  EXPECT_EQ(error_of(options, "sheet.jpg"),
            (folder_ / "sheet.jpg").string() + ": a sheet is drawn as .png, .pdf or .svg");
  options.paper = "A5";
  EXPECT_EQ(error_of(options, "sheet.png"), "no paper 'A5' for the plotter, it takes A4, A3, A, B");
  options = {};
  options.dpi = 10000;
  EXPECT_EQ(error_of(options, "sheet.png"), "10000 dpi, expected 10 to 600");
  options = {};
  options.pens = {"red"};
  EXPECT_EQ(error_of(options, "sheet.png"), "'red' is no colour, expected #rrggbb");
  options.pens = std::vector<std::string>(7, "#000000");
  EXPECT_EQ(error_of(options, "sheet.png"), "7 colours for 6 pens");
  options = {};
  options.machine = "none";
  EXPECT_EQ(error_of(options, "sheet.png").substr(0, 42),
            "data file plotters/none.profile is missing");
  options.machine = (folder_ / "none.profile").string();
  EXPECT_EQ(error_of(options, "sheet.png"), options.machine + ": cannot be read");
  std::ofstream(folder_ / "bad.profile") << "# mine\nunit: 0\n";
  options.machine = (folder_ / "bad.profile").string();
  EXPECT_EQ(error_of(options, "sheet.png"),
            options.machine + ":2: not as a plotter profile has it");
  for (const auto& entry : fs::directory_iterator(folder_)) {
    EXPECT_EQ(entry.path().filename(), "bad.profile");  // no sheet, whole or half
  }
}

/// The device takes the first, too.
TEST_F(EmulatedPlotter, OfTwoPapersOfOneNameTheFirstCounts) {
  const fs::path file = folder_ / "two.profile";
  std::ofstream(file) << "unit: 0.025\npaper: A4 297 210 10 4 11040 7721\n"
                         "paper: A4 100 100 1 1 99 99\npen: 1 0.3 #000000\n";
  EXPECT_EQ(read_machine(file, "A4").width_mm, 297);
}

TEST_F(EmulatedPlotter, AStreamThatCannotBeRead) {
  std::ifstream none(folder_ / "none.hpgl");
  EXPECT_THROW(emulate_plotter(none, {}, folder_ / "sheet.png"), Error);
  std::ifstream folder(folder_);
  EXPECT_THROW(emulate_plotter(folder, {}, folder_ / "sheet.png"), Error);
  EXPECT_TRUE(fs::is_empty(folder_));
}

}  // namespace
}  // namespace overstrike::emulator
