#include "core/geometry/polyline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace overstrike {
namespace {

TEST(Polyline, WhatLiesOnALineGoes) {
  const std::vector<Vec2> bent{{0, 0}, {1, 0.01}, {2, 0}, {3, 3}, {4, 6.01}, {5, 9}};
  const std::vector<Vec2> expected{{0, 0}, {2, 0}, {5, 9}};
  EXPECT_EQ(simplified(bent, 0.02), expected);
  EXPECT_EQ(simplified(bent, 0), bent);
}

TEST(Polyline, AClosedOneComesToAPointWhereItIsSmall) {
  const std::vector<Vec2> closed{{0, 0}, {1, 0}, {1, 1}, {0, 0}};
  EXPECT_EQ(simplified(closed, 0.1), closed);
  EXPECT_EQ(simplified(closed, 2).size(), 2u);
}

double distance(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  const double square = glm::dot(d, d);
  const double t = square > 0 ? std::fmin(std::fmax(glm::dot(p - a, d) / square, 0), 1) : 0;
  return glm::distance(p, a + d * t);
}

TEST(Polyline, StaysWithinTheTolerance) {
  std::mt19937 random(1);
  for (int n = 0; n < 200; ++n) {
    std::vector<Vec2> walk{{0, 0}};
    for (int i = 0; i < 60; ++i)
      walk.push_back(walk.back() + Vec2(1 + random() % 3, double(random() % 5) - 2));
    const double tolerance = 0.5 + n % 4;
    const std::vector<Vec2> left = simplified(walk, tolerance);
    EXPECT_EQ(left.front(), walk.front());
    EXPECT_EQ(left.back(), walk.back());
    std::size_t at = 0;
    for (const Vec2& p : walk) {
      if (at + 1 < left.size() && p.x > left[at + 1].x) ++at;
      const std::size_t next = std::min(at + 1, left.size() - 1);
      EXPECT_LE(distance(p, left[at], left[next]), tolerance * (1 + 1e-12));
    }
  }
}

}  // namespace
}  // namespace overstrike
