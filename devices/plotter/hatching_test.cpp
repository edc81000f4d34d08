#include "devices/plotter/hatching.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/geometry/trig.h"

namespace overstrike {
namespace {

DensityRun run(double x0, double x1, double density0, double density1) {
  return {x0, x1, density0, density1, 0, 0, Kind::lit};
}

std::vector<HatchPiece> pieces(const Hatching& hatching, int level, std::vector<DensityRun> runs) {
  std::vector<HatchPiece> found{{-1, -1}};  // replaced
  hatch_pieces(hatching, level, runs, found);
  return found;
}

using Pieces = std::vector<HatchPiece>;
const Hatching kTen{10, 12, 0};

TEST(Hatching, LevelsStandForEvenSteps) {
  EXPECT_EQ(level_density(kTen, 9), 1);
  EXPECT_DOUBLE_EQ(level_density(kTen, 3), 1 / 3.0);
  EXPECT_EQ(nearest_level(kTen, 0), 0);
  EXPECT_EQ(nearest_level(kTen, 1), 9);
  EXPECT_EQ(nearest_level(kTen, 0.5 / 9), 1);  // half-way: the darker
  EXPECT_EQ(nearest_level(kTen, 0.4999 / 9), 0);
  EXPECT_EQ(nearest_level(kTen, 1e300), 9);
  EXPECT_EQ(nearest_level(kTen, -1), 0);
}

TEST(Hatching, SpacingIsPenWidthOverDensity) {
  for (int level = 1; level <= 8; ++level) {
    EXPECT_DOUBLE_EQ(hatch_family(kTen, level).spacing * level / 9, 12) << level;
  }
  const ScanFamily solid = hatch_family(kTen, 9);
  EXPECT_EQ(solid.spacing, 12 - 1);  // rounding parts two lines by a unit at most
  EXPECT_EQ(solid.offset, solid.spacing / 2);
}

TEST(Hatching, EndsAreWholeUnitsWithinHalfAUnitOfTheLine) {
  std::mt19937_64 random(45);
  std::uniform_real_distribution<double> angle(-180, 180), at(0, 10000);
  for (int i = 0; i < 5000; ++i) {
    const double degrees = i % 3 ? angle(random) : -45;
    const ScanFamily family{degrees, 13.57, 6.8};
    const std::int64_t index = static_cast<std::int64_t>(at(random) / 20);
    const HatchLine line(family, index);
    const double c = cos_deg(degrees), s = sin_deg(degrees), x = at(random);
    const auto off_line = [&](Vec2 p) {
      return -s * p.x + c * p.y - (family.offset + double(index) * family.spacing);
    };
    const Vec2 p = line.nearest_unit(x), q = line.nearest_unit(x + 500);
    EXPECT_EQ(p, glm::floor(p));
    // Half a unit across the gentler coordinate; coordinates below 2e4 round by less than 1e-11.
    EXPECT_LE(std::abs(off_line(p)), 0.5 * std::max(std::abs(c), std::abs(s)) + 1e-11);
    EXPECT_LE(std::abs(c * p.x + s * p.y - x), std::numbers::sqrt2);
    if (degrees == -45) {
      EXPECT_NEAR(off_line(p), off_line(q), 1e-11);
    }
  }
}

TEST(Hatching, PiecesOfALevel) {
  EXPECT_EQ(pieces(kTen, 9, {run(0, 100, 1, 1)}), (Pieces{{6, 94}}));
  EXPECT_EQ(pieces(kTen, 8, {run(0, 100, 1, 1)}), Pieces{});
  EXPECT_EQ(pieces(kTen, 9, {run(0, 12, 1, 1)}), Pieces{});  // no longer than the pen is wide
  EXPECT_EQ(pieces(kTen, 1, {run(0, 100, 0.05, 0.05)}), Pieces{});  // paper
  // Parts that touch are one line, others are not.
  EXPECT_EQ(pieces(kTen, 9, {run(0, 100, 1, 1), run(100, 150, 0.98, 1), run(160, 200, 1, 1)}),
            (Pieces{{6, 144}, {166, 194}}));
  // Short parts of one line count together.
  EXPECT_EQ(pieces(kTen, 9, {run(0, 8, 1, 1), run(8, 16, 1, 1)}), (Pieces{{6, 10}}));
}

TEST(Hatching, ALinearRunIsSplitExactlyAtTheBorders) {
  const Hatching five{5, 1, 0};  // borders at 1/8, 3/8, 5/8, 7/8
  EXPECT_EQ(pieces(five, 1, {run(0, 80, 0, 1)}), (Pieces{{10.5, 29.5}}));
  EXPECT_EQ(pieces(five, 2, {run(0, 80, 0, 1)}), (Pieces{{30.5, 49.5}}));
  EXPECT_EQ(pieces(five, 4, {run(0, 80, 0, 1)}), (Pieces{{70.5, 79.5}}));
  EXPECT_EQ(pieces(five, 1, {run(0, 80, 1, 0)}), (Pieces{{50.5, 69.5}}));
  EXPECT_EQ(pieces(five, 4, {run(0, 80, 1, 0)}), (Pieces{{0.5, 9.5}}));
  EXPECT_EQ(pieces(five, 2, {run(0, 80, 0.375, 0.6)}), (Pieces{{0.5, 79.5}}));
  EXPECT_EQ(pieces(five, 2, {run(0, 80, 0.3, 0.375)}), Pieces{});  // reaches the border at its end
}

TEST(Hatching, EveryPlaceOfARunHasTheLevelNearestToItsDensity) {
  std::mt19937_64 random(10);
  std::uniform_real_distribution<double> density(-0.1, 1.1), length(0, 60);
  const double pen = 0.001;  // so that nothing is left out
  int checked = 0;
  for (int i = 0; i < 2000; ++i) {
    const Hatching hatching{2 + i % 20, pen, 0};
    const double x1 = length(random) + 1;
    const DensityRun one = run(0, x1, density(random), density(random));
    std::vector<Pieces> by_level;
    for (int level = 0; level < hatching.levels; ++level) {
      by_level.push_back(level == 0 ? Pieces{} : pieces(hatching, level, {one}));
    }
    for (int k = 0; k < 50; ++k) {
      const double x = x1 * (k + 0.5) / 50;
      const double d = one.density0 + (one.density1 - one.density0) * x / x1;
      const double from_border =
          std::abs(d * (hatching.levels - 1) + 0.5 - std::round(d * (hatching.levels - 1) + 0.5));
      if (from_border < 0.01 || x < 2 * pen || x > x1 - 2 * pen) continue;
      // Near a border the piece is half a pen shorter.
      if (std::abs(one.density1 - one.density0) * 2 * pen / x1 * hatching.levels > 0.01) continue;
      for (int level = 1; level < hatching.levels; ++level) {
        bool inked = false;
        for (const HatchPiece& p : by_level[level]) inked |= p.x0 <= x && x <= p.x1;
        EXPECT_EQ(inked, level == nearest_level(hatching, d)) << "level " << level << " at " << x;
        ++checked;
      }
    }
  }
  EXPECT_GT(checked, 100000);
}

}  // namespace
}  // namespace overstrike
