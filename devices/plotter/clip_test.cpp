#include "devices/plotter/clip.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace overstrike {
namespace {

constexpr Rectangle kSheet{{0, 0}, {100, 50}};

std::vector<std::vector<Vec2>> parts(std::vector<Vec2> points, std::size_t expected_cut) {
  std::vector<std::vector<Vec2>> found;
  EXPECT_EQ(clip_polyline(points, kSheet,
                          [&](auto part) { found.emplace_back(part.begin(), part.end()); }),
            expected_cut);
  return found;
}

TEST(Clip, KnownCases) {
  using Parts = std::vector<std::vector<Vec2>>;
  EXPECT_EQ(parts({{1, 1}, {2, 2}, {3, 1}}, 0), (Parts{{{1, 1}, {2, 2}, {3, 1}}}));
  EXPECT_EQ(parts({{-10, 25}, {110, 25}}, 1), (Parts{{{0, 25}, {100, 25}}}));
  EXPECT_EQ(parts({{50, 25}, {50, 75}, {60, 75}, {60, 25}}, 3),
            (Parts{{{50, 25}, {50, 50}}, {{60, 50}, {60, 25}}}));
  EXPECT_EQ(parts({{-10, 10}, {-1, 50}}, 1), Parts{});
  EXPECT_EQ(parts({{0, 0}, {100, 0}}, 0), (Parts{{{0, 0}, {100, 0}}}));  // the border is inside
  EXPECT_EQ(parts({{-10, 10}, {10, -10}}, 1), (Parts{{{0, 0}, {0, 0}}}));
  EXPECT_EQ(parts({{7, 8}}, 0), (Parts{{{7, 8}}}));
  EXPECT_EQ(parts({{7, 80}}, 1), Parts{});
  EXPECT_EQ(parts({}, 0), Parts{});
}

TEST(Clip, WhatIsNotFiniteIsLostAndCounted) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double huge = std::numeric_limits<double>::max();
  EXPECT_THAT(parts({{nan, 1}, {2, 2}}, 1), testing::IsEmpty());
  EXPECT_THAT(parts({{-huge, -huge}, {huge, huge}}, 1), testing::IsEmpty());
}

TEST(Clip, RandomSegmentsStayInsideOnTheirLineAndLoseNothingInside) {
  std::mt19937_64 random(7475);
  std::uniform_real_distribution<double> at(-150, 250), along(0, 1);
  int kept_count = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec2 a{at(random), at(random)}, b{at(random), at(random)};
    const auto kept = clip_segment(a, b, kSheet);
    const Vec2 p = a + along(random) * (b - a);
    const bool inside = p.x > 0 && p.x < 100 && p.y > 0 && p.y < 50;
    if (!kept) {
      EXPECT_FALSE(inside);
      continue;
    }
    ++kept_count;
    const double length = glm::length(b - a);
    for (const Vec2 end : {kept->first, kept->second}) {
      EXPECT_TRUE(end.x >= 0 && end.x <= 100 && end.y >= 0 && end.y <= 50);
      const double off = ((b.x - a.x) * (end.y - a.y) - (b.y - a.y) * (end.x - a.x)) / length;
      EXPECT_NEAR(off, 0, 1e-12 * 500);  // a few roundings of coordinates below 500
      const bool border = end.x == 0 || end.x == 100 || end.y == 0 || end.y == 50;
      EXPECT_TRUE(border || end == a || end == b);
    }
    if (inside) {
      EXPECT_GE(glm::dot(p - kept->first, b - a), -1e-9);
      EXPECT_GE(glm::dot(kept->second - p, b - a), -1e-9);
    }
  }
  EXPECT_GT(kept_count, 2000);
}

}  // namespace
}  // namespace overstrike
