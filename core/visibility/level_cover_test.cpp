#include "core/visibility/level_cover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "core/drawing.h"
#include "core/geometry/tessellate.h"
#include "core/visibility/test_scenes.h"

namespace overstrike {
namespace {

struct Front {
  double x0, x1, depth;
  bool over(double x) const { return x0 <= x && x <= x1; }
};

double uniform(std::mt19937& random, double low, double high) {
  return low + (high - low) * (random() / 4294967296.0);
}

/// Half of the ends lie where cells begin.
Front any_front(std::mt19937& random, double columns, double widest) {
  const auto place = [&](double x) {
    return random() % 2 == 0 ? std::floor(x * 2048 / columns) * columns / 2048 : x;
  };
  const double x0 = place(uniform(random, -widest, columns));
  return {x0, x0 + place(uniform(random, 0, widest)), uniform(random, 0, 1)};
}

/// Somewhere in it, within the level, no single front is nearer.
bool shows(const Front& what, const std::vector<Front>& fronts, double columns) {
  std::vector<double> places = {what.x0, what.x1};
  for (const Front& f : fronts)
    for (const double x : {f.x0, f.x1})
      places.insert(places.end(), {std::nextafter(x, -1e9), x, std::nextafter(x, 1e9)});
  return std::any_of(places.begin(), places.end(), [&](double x) {
    const bool asked = what.over(x) && x >= 0 && x < columns;
    return asked && std::none_of(fronts.begin(), fronts.end(),
                                 [&](const Front& f) { return f.over(x) && f.depth > what.depth; });
  });
}

TEST(LevelCover, HidesOnlyWhatHasAFrontBeforeItEverywhere) {
  std::mt19937 random(7);
  int hidden = 0;
  for (const double columns : {0.7, 131.0, 512.0, 5000.0}) {
    LevelCover cover(columns);
    for (int round = 0; round < 200; ++round) {
      cover.clear();
      std::vector<Front> fronts;
      for (int i = 0; i < 40; ++i) {
        fronts.push_back(any_front(random, columns, columns / 4));
        cover.cover(fronts.back().x0, fronts.back().x1, fronts.back().depth);
      }
      for (int i = 0; i < 20; ++i) {
        const Front what = any_front(random, columns, columns / 8);
        if (!cover.hides(what.x0, what.x1, what.depth)) continue;
        EXPECT_FALSE(shows(what, fronts, columns)) << what.x0 << ' ' << what.x1 << ' ' << columns;
        ++hidden;
      }
    }
  }
  EXPECT_GT(hidden, 4000) << "of 16000; else nothing was tried";
}

TEST(LevelCover, OneDepthHidesNothing) {
  LevelCover cover(100);
  cover.cover(-1, 101, 0.5);
  EXPECT_FALSE(cover.hides(20, 30, 0.5));
  EXPECT_TRUE(cover.hides(20, 30, std::nextafter(0.5, 0.0)));
}

/// Of boxes seen from straight above, the one whose lid is highest is seen.
TEST(RowSweep, ACrowdShowsItsHighestLids) {
  constexpr double kColumns = 64, kRows = 24;
  constexpr int kBoxes = 600;
  std::mt19937 random(11);
  Scene scene;
  testing::look_down(scene, kColumns, kRows);
  std::vector<std::pair<Vec3, Vec3>> boxes;  // low, high
  for (int i = 0; i < kBoxes; ++i) {
    const auto u = [&](double low, double high) { return uniform(random, low, high); };
    const Vec3 size(u(1, 6), u(2, 8), u(0.1, 3));
    const Vec3 at(u(-3, kColumns), u(-kRows, 3), u(-8, 8));
    testing::add(scene, Box{size}, at);
    const Bounds bounds_of_box = bounds(*scene.bodies.back().shape, scene.bodies.back().placement);
    boxes.emplace_back(bounds_of_box.low, bounds_of_box.high);
  }
  const auto highest = [&](double x, double y) {
    Index best = kNoSurface;
    for (Index i = 0; i < boxes.size(); ++i) {
      const auto& [low, high] = boxes[i];
      if (x < low.x || x > high.x || y < low.y || y > high.y) continue;
      if (best == kNoSurface || high.z > boxes[best].second.z) best = i;
    }
    return best;
  };
  Drawing drawing(scene, testing::square_grid(kColumns, kRows), {});
  int rows = 0;
  drawing.runs({}, [&](const RunRow& row) {
    const double y = -(static_cast<double>(row.index) + 0.5);
    double x = 0;
    const auto bare_until = [&](double end) {
      if (end - x > 1e-9) {
        EXPECT_EQ(highest((x + end) / 2, y), kNoSurface) << row.index << ' ' << x;
      }
    };
    for (const DensityRun& run : row.runs) {
      bare_until(run.x0);
      EXPECT_EQ(highest((run.x0 + run.x1) / 2, y), run.body) << row.index << ' ' << run.x0;
      x = run.x1;
    }
    bare_until(kColumns);
    ++rows;
  });
  EXPECT_EQ(rows, kRows);
}

}  // namespace
}  // namespace overstrike
