#include "devices/plotter/pen_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

namespace overstrike {
namespace {

using Lines = std::vector<PlotLine>;

/// Every pair of neighbouring points, turned so that the lesser comes first, with its count.
std::map<std::array<int, 4>, int> ink(const Lines& lines) {
  std::map<std::array<int, 4>, int> found;
  for (const PlotLine& line : lines) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      std::array<int, 2> a{line[i - 1].x, line[i - 1].y}, b{line[i].x, line[i].y};
      if (b < a) std::swap(a, b);
      ++found[{a[0], a[1], b[0], b[1]}];
    }
  }
  return found;
}

double travel(const Lines& lines) {
  double length = 0;
  PlotPoint at{0, 0};
  for (const PlotLine& line : lines) {
    length += std::hypot(line.front().x - at.x, line.front().y - at.y);
    at = line.back();
  }
  return length;
}

Lines random_segments(int count, int width, int height, int reach, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> x(0, width), y(0, height), step(-reach, reach);
  Lines lines;
  for (int i = 0; i < count; ++i) {
    const PlotPoint p{x(random), y(random)};
    lines.push_back({p, {p.x + step(random), p.y + step(random)}});
  }
  return lines;
}

TEST(PenPath, JoinsWhatMeets) {
  EXPECT_EQ(joined({{{0, 0}, {1, 0}}, {{2, 0}, {1, 0}}, {{2, 0}, {3, 3}}}),
            (Lines{{{0, 0}, {1, 0}, {2, 0}, {3, 3}}}));
  EXPECT_EQ(joined({{{0, 0}, {1, 0}}, {{5, 5}, {6, 5}}}),
            (Lines{{{0, 0}, {1, 0}}, {{5, 5}, {6, 5}}}));
  // A square from its four sides: one closed line.
  EXPECT_EQ(joined({{{0, 0}, {9, 0}}, {{9, 9}, {0, 9}}, {{9, 0}, {9, 9}}, {{0, 9}, {0, 0}}}),
            (Lines{{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}}}));
  // The middle segment comes first, yet the chain begins at its end.
  EXPECT_EQ(joined({{{1, 0}, {2, 0}}, {{0, 0}, {1, 0}}, {{2, 0}, {3, 0}}}),
            (Lines{{{0, 0}, {1, 0}, {2, 0}, {3, 0}}}));
  EXPECT_EQ(joined({{{4, 4}}, {}}), (Lines{{{4, 4}}}));
  EXPECT_EQ(joined({}), Lines{});
}

TEST(PenPath, JoiningKeepsAllInk) {
  const Lines lines = random_segments(3000, 30, 30, 5, 1);
  const Lines chains = joined(lines);
  EXPECT_EQ(ink(chains), ink(lines));
  EXPECT_LT(chains.size(), lines.size() / 3);
}

TEST(PenPath, ManyLinesInOnePointTakeLinearTime) {
  Lines fan;
  for (int i = 0; i < 200000; ++i) fan.push_back({{0, 0}, {i + 1, 7}});
  const Lines chains = joined(fan);
  EXPECT_EQ(chains.size(), 100000u);
}

TEST(PenPath, OrderTakesTheNearestEndNext) {
  const Lines lines = random_segments(400, 1000, 700, 80, 2);
  const Lines order = ordered(lines, {0, 0});
  EXPECT_EQ(ink(order), ink(lines));
  PlotPoint at{0, 0};
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto square = [&](const PlotPoint& p) {
      const double dx = p.x - at.x, dy = p.y - at.y;
      return dx * dx + dy * dy;
    };
    for (std::size_t k = i; k < order.size(); ++k) {
      EXPECT_LE(square(order[i].front()), square(order[k].front()));
      EXPECT_LE(square(order[i].front()), square(order[k].back()));
    }
    at = order[i].back();
  }
}

TEST(PenPath, ManyLinesAreDrawnWithLittleTravel) {
  const Lines lines = random_segments(10000, 40000, 28000, 4000, 3);
  EXPECT_LT(travel(ordered(lines, {0, 0})), 0.02 * travel(lines));
}

TEST(PenPath, ClustersFarApart) {
  Lines lines = random_segments(200, 10, 10, 3, 4);
  for (const PlotLine& line : random_segments(200, 10, 10, 3, 5)) {
    lines.push_back({{line[0].x + 2000000, line[0].y}, {line[1].x + 2000000, line[1].y}});
  }
  const Lines order = ordered(lines, {0, 0});
  EXPECT_EQ(ink(order), ink(lines));
  EXPECT_LT(travel(order), 2000000 + 400 * 20);
}

}  // namespace
}  // namespace overstrike
