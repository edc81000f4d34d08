// The plotter device's bytes through the emulated plotter: what was drawn is what was meant.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>
#include <sstream>

#include "devices/plotter/plotter.h"
#include "emulators/plotter/machine.h"
#include "emulators/plotter/plotter.h"
#include "tests/plotter/patches.h"
#include "tests/plotter/picture.h"

namespace overstrike {
namespace {

namespace fs = std::filesystem;
using emulator::PenPoint;

constexpr double kUnitMm = 0.02488;

class Recorder final : public emulator::Ink {
 public:
  void line(int pen, std::span<const PenPoint> points) override {
    pens.push_back(pen);
    lines.emplace_back(points.begin(), points.end());
  }
  std::vector<int> pens;
  std::vector<std::vector<PenPoint>> lines;
};

emulator::PlotterLimits a4() {
  emulator::PlotterLimits limits;
  limits.clip_x = 11040;
  limits.clip_y = 7721;
  return limits;
}

GreyPicture sheet(const std::string& hpgl, double dpi) {
  const fs::path file = fs::path(testing::TempDir()) / "overstrike_round_trip_test.png";
  emulator::PlotterOptions options;
  options.dpi = dpi;
  emulator::emulate_plotter(hpgl, options, file);
  GreyPicture picture = read_png(file);
  fs::remove(file);
  return picture;
}

/// Pixels of the A4 sheet from grid coordinates with no margin: (0, 7721) lies 10 mm from the left
/// and 210 - 4 - 7721 units from the top.
struct Pixels {
  double dpi;
  int x(double grid_x) const { return int(std::lround((10 + grid_x * kUnitMm) * dpi / 25.4)); }
  int y(double grid_y) const {
    return int(std::lround((206 + (grid_y - 7721) * kUnitMm) * dpi / 25.4));
  }
};

/// Flat patches of every level but paper, in rows of three, and how far ink strays from the wish.
double worst_coverage(Settings settings, int levels, double dpi) {
  settings.emplace_back("margin", "0");
  settings.emplace_back("levels", std::to_string(levels));
  double worst = 0;
  const Vec2 size{3400, 2300};
  for (int first = 1; first < levels; first += 9) {
    std::vector<Patch> patches;
    for (int i = 0; i < 9 && first + i < levels; ++i) {
      const Vec2 low{100 + 3600 * (i % 3), 100 + 2500 * (i / 3)};
      const double density = double(first + i) / (levels - 1);
      patches.push_back({low, low + size, density, density});
    }
    const GreyPicture picture = sheet(plotted(settings, patches, {}), dpi);
    const Pixels at{dpi};
    for (const Patch& p : patches) {
      const double inset = 120;  // as far as a lightest line may lie from the patch's border
      const double ink = picture.coverage(at.x(p.low.x + inset), at.y(p.low.y + inset),
                                          at.x(p.high.x - inset), at.y(p.high.y - inset));
      worst = std::max(worst, std::abs(ink - p.left));
      testing::Test::RecordProperty(
          fmt::format("angle_{}_density_{:.3f}", settings.size() > 2 ? settings[0].second : "45",
                      p.left),
          fmt::format("{:.4f}", ink));
    }
  }
  return worst;
}

TEST(PlotterRoundTrip, InkCoversWhatTheDensityAsksFor) {
  EXPECT_LE(worst_coverage({}, 10, 100), 0.01);
  EXPECT_LE(worst_coverage({{"hatch-angle", "0"}}, 10, 100), 0.01);
  EXPECT_LE(worst_coverage({{"hatch-angle", "-63.5"}}, 4, 100), 0.01);
}

TEST(PlotterRoundTrip, SolidIsSolid) {
  const Patch patch{{1000, 1000}, {5000, 4000}, 1, 1};
  for (const char* angle : {"0", "45", "90", "17"}) {
    const std::string hpgl =
        plotted({{"margin", "0"}, {"hatch-angle", angle}}, std::vector{patch}, {});
    const GreyPicture picture = sheet(hpgl, 100);
    const Pixels at{100};
    EXPECT_EQ(picture.coverage(at.x(1050), at.y(1050), at.x(4950), at.y(3950)), 1) << angle;
    // No ink beyond half a pen and half a unit outside the patch.
    const double whole =
        picture.coverage(0, 0, picture.width, picture.height) * picture.width * picture.height;
    const double inside = double(at.x(5010) - at.x(990)) * (at.y(4010) - at.y(990));
    EXPECT_LE(whole, inside) << angle;
  }
}

TEST(PlotterRoundTrip, IsTheRightWayUpAndInItsPlace) {
  // A short thick line near the sheet's upper left corner.
  const GreyPicture picture = sheet(
      plotted({{"margin", "0"}}, {}, {{{{500, 300}, {1500, 300}}, StrokeKind::segment, 0}}), 100);
  const Pixels at{100};
  EXPECT_LT(picture.at(at.x(1000), at.y(300)), 0.5);
  EXPECT_EQ(picture.at(at.x(1000), at.y(7721 - 300)), 1);
  EXPECT_EQ(picture.at(at.x(11040 - 1000), at.y(300)), 1);
  EXPECT_EQ(picture.at(at.x(1600), at.y(300)), 1);
}

TEST(PlotterRoundTrip, PointsArriveWithinHalfAUnitAndInsideTheClip) {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> x(0, 11040), y(0, 7721);
  std::vector<Stroke> strokes;
  for (int i = 0; i < 500; ++i) {
    Stroke stroke{{}, StrokeKind::contour, 0};
    for (int k = 0; k < 2 + i % 50; ++k) stroke.points.push_back({x(random), y(random)});
    strokes.push_back(stroke);
  }
  std::istringstream hpgl(plotted({{"margin", "0"}}, {}, strokes));
  Recorder drawn;
  const auto report = run_plotter(hpgl, a4(), drawn);
  EXPECT_EQ(report.clipped, 0u);
  EXPECT_EQ(report.unknown, 0u);
  EXPECT_TRUE(report.warnings.empty());
  std::vector<PenPoint> points;
  for (const auto& line : drawn.lines) points.insert(points.end(), line.begin(), line.end());
  double worst = 0;
  for (const Stroke& stroke : strokes) {
    for (const Vec2& p : stroke.points) {
      double nearest = 1e9;
      for (const PenPoint& q : points) {
        nearest = std::min(nearest, std::max(std::abs(q.x - p.x), std::abs(7721 - q.y - p.y)));
      }
      worst = std::max(worst, nearest);
    }
  }
  EXPECT_LE(worst, 0.5);
  double meant_mm = 0;
  for (const Stroke& stroke : strokes) {
    for (std::size_t k = 1; k < stroke.points.size(); ++k) {
      meant_mm += glm::length(stroke.points[k] - stroke.points[k - 1]) * kUnitMm;
    }
  }
  EXPECT_NEAR(report.pen_down_mm, meant_mm, 1e-4 * meant_mm);
}

TEST(PlotterRoundTrip, WildStrokesStayInsideTheHardClip) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> wild(-30000, 40000);
  std::vector<Stroke> strokes;
  for (int i = 0; i < 2000; ++i) {
    strokes.push_back(
        {{{wild(random), wild(random)}, {wild(random), wild(random)}, {wild(random), wild(random)}},
         StrokeKind::segment,
         kNoSurface});
  }
  for (const char* paper : {"A4", "A3", "A", "B"}) {
    for (const char* margin : {"0", "25.4"}) {
      const Settings settings{{"paper", paper}, {"margin", margin}};
      std::string unused;
      const Layout layout = plotter_kind().make(settings, "-", open_memory(unused))->layout();
      std::istringstream hpgl(plotted(settings, {}, strokes));
      emulator::PlotterLimits limits;
      limits.clip_x = limits.clip_y = limits.range;  // cuts nothing
      Recorder all;
      run_plotter(hpgl, limits, all);
      double low_x = 1e9, high_x = -1e9, low_y = 1e9, high_y = -1e9;
      for (const auto& line : all.lines) {
        for (const PenPoint& p : line) {
          low_x = std::min(low_x, p.x), high_x = std::max(high_x, p.x);
          low_y = std::min(low_y, p.y), high_y = std::max(high_y, p.y);
        }
      }
      // The extremes are reached, and never passed.
      EXPECT_EQ(high_x - low_x, layout.grid.columns) << paper << margin;
      EXPECT_EQ(high_y - low_y, layout.grid.rows) << paper << margin;
      EXPECT_GE(low_x, 0);
      EXPECT_GE(low_y, 0);
    }
  }
}

}  // namespace
}  // namespace overstrike
