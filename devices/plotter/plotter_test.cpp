#include "devices/plotter/plotter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "core/error.h"

namespace overstrike {
namespace {

struct Plot {
  explicit Plot(const Settings& settings)
      : device(plotter_kind().make(settings, "a.hpgl", open_memory(bytes))) {}
  std::string bytes;
  std::unique_ptr<Device> device;
};

Stroke stroke(std::vector<Vec2> points, int pen = 0, bool hidden = false) {
  return {std::move(points), StrokeKind::contour, 0, pen, hidden};
}

DensityRun solid(double x0, double x1) { return {x0, x1, 1, 1, 0, 0, Kind::shadow}; }

std::string error_of(const Settings& settings) {
  try {
    Plot plot(settings);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

TEST(Plotter, IsFoundByNameAndExtension) {
  ASSERT_NE(find_device("plotter"), nullptr);
  for (const char* file : {"a.hpgl", "a.plt", "a.HGL", "a.gl"}) {
    ASSERT_NE(device_for_file(file), nullptr) << file;
    EXPECT_EQ(device_for_file(file)->name, "plotter");
  }
}

TEST(Plotter, AsksForOnePlotterUnitACell) {
  const Layout layout = Plot(Settings{}).device->layout();
  // A4: 10 mm free on the left is where the pen's reach begins, and 10.3 mm on the right are out
  // of it; below it begins at 4 mm: 6 mm more are ceil(6 / 0.02488) = 242 units.
  EXPECT_EQ(layout.grid.columns, 11040);
  EXPECT_EQ(layout.grid.rows, 7721 - 242);
  EXPECT_EQ(layout.grid.pitch_x_mm, 0.02488);
  EXPECT_EQ(layout.grid.pitch_y_mm, 0.02488);
  EXPECT_TRUE(layout.strokes);
  EXPECT_FALSE(layout.cells);
  EXPECT_EQ(layout.tolerance, 2);
  ASSERT_EQ(layout.hatches.size(), 9u);
  EXPECT_EQ(layout.hatches[0].angle_deg, -45);
  EXPECT_DOUBLE_EQ(layout.hatches[0].spacing, 9 * 0.3 / 0.02488);
  EXPECT_TRUE(Plot(Settings{{"tone", "none"}}).device->layout().hatches.empty());
  EXPECT_EQ(Plot(Settings{{"paper", "A3"}, {"margin", "30"}}).device->layout().grid.columns,
            std::floor((420 - 30 - 15) / 0.02488) - std::ceil(15 / 0.02488));
}

TEST(Plotter, ExactBytesOfAPicture) {
  Plot plot(Settings{{"margin", "0"}, {"hatch-angle", "0"}, {"levels", "2"}, {"speed", "12.5"}});
  const double spacing = plot.device->layout().hatches[0].spacing;
  EXPECT_EQ(plot.device->layout().grid.rows, 7721);
  plot.device->begin();
  // y turns round: the grid's top is the sheet's. Two lines that meet become one, drawn from the
  // end that is nearer to the pen's stall at 0, 0.
  plot.device->strokes(std::vector{stroke({{0, 0}, {100, 0}}), stroke({{50, 21}, {60, 21.4}}, 3),
                                   stroke({{100, 721}, {100, 0.2}}),
                                   stroke({{1, 1}, {9, 9}}, 0, true)});
  const DensityRun run = solid(100, 200);
  for (int i = 0; i < 3; ++i) plot.device->hatch(0, {i, {&run, 1}});
  plot.device->hatch(0, {3, {}});
  plot.device->end();
  const auto y = [&](int i) { return std::to_string(7721 - std::lround(spacing * (i + 0.5))); };
  EXPECT_EQ(plot.bytes,
            "IN;\nVS12.5;\n"
            "PU;SP1;\nPU100,7000;PD100,7721,0,7721;\n"
            "PU;SP3;\nPU50,7700;PD60,7700;\n"
            "PU;SP2;\n"
            "PU106," +
                y(0) + ";PD194," + y(0) +
                ";\n"
                "PU194," +
                y(1) + ";PD106," + y(1) +
                ";\n"
                "PU106," +
                y(2) + ";PD194," + y(2) +
                ";\n"
                "PU;SP0;\n");
  EXPECT_TRUE(plot.device->warnings().empty());
}

TEST(Plotter, AnEmptyPicture) {
  Plot plot(Settings{});
  plot.device->begin();
  plot.device->strokes({});
  plot.device->hatch(0, {0, {}});
  plot.device->end();
  EXPECT_EQ(plot.bytes, "IN;\nPU;SP0;\n");
}

TEST(Plotter, HatchingRisesToTheRightOnPaper) {
  Plot plot(Settings{{"levels", "2"}});
  plot.device->begin();
  const DensityRun run = solid(-1000, 1000);
  plot.device->hatch(0, {300, {&run, 1}});
  plot.device->end();
  int x0, y0, x1, y1;
  ASSERT_EQ(std::sscanf(plot.bytes.c_str(), "IN;\nPU;SP2;\nPU%d,%d;PD%d,%d;", &x0, &y0, &x1, &y1),
            4)
      << plot.bytes;
  EXPECT_NEAR(y1 - y0, x1 - x0, 1);
  EXPECT_GT(x1 - x0, 100);
}

TEST(Plotter, LinesOffTheSheetAreCutAndCounted) {
  Plot plot(Settings{{"margin", "0"}});
  plot.device->begin();
  // Half a unit outside rounds onto the border and is not cut.
  plot.device->strokes(std::vector{stroke({{-0.4, 10}, {11040.4, 10}}),
                                   stroke({{-5000, 20}, {20000, 20}}),
                                   stroke({{-10, 100}, {-10, 200}})});
  plot.device->end();
  EXPECT_EQ(plot.bytes, "IN;\nPU;SP1;\nPU0,7701;PD11040,7701;\nPU11040,7711;PD0,7711;\nPU;SP0;\n");
  ASSERT_EQ(plot.device->warnings().size(), 1u);
  EXPECT_EQ(plot.device->warnings()[0].message, "2 lines were cut at the border of the sheet");
}

TEST(Plotter, RefusesBadSettings) {
  EXPECT_EQ(error_of({{"paper", "A5"}}).substr(0, 52),
            "error: paper must be one of A4, A3, A, B, found 'A5'");
  EXPECT_EQ(error_of({{"size", "80x24"}}),
            "error: a plot has no size in cells, found size '80x24' (paper and margin say how "
            "large it is)");
  EXPECT_EQ(error_of({{"margin", "105"}}), "error: margin 105 mm leaves nothing of the paper");
  EXPECT_EQ(error_of({{"levels", "1"}}),
            "error: levels must be a whole number between 2 and 64, found '1'");
  EXPECT_EQ(error_of({{"line-pen", "7"}}),
            "error: line-pen must be a whole number between 1 and 6, found '7'");
  EXPECT_EQ(error_of({{"speed", "100"}}),
            "error: speed must be a number between 0.38 and 38.1, found '100'");
  EXPECT_EQ(error_of({{"tone", "dots"}}).substr(0, 52),
            "error: tone must be one of hatch, none, found 'dots'");
}

}  // namespace
}  // namespace overstrike
