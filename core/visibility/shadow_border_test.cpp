#include "core/visibility/shadow_border.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>

namespace overstrike {
namespace {

/// Corners on few places, so that sides are shared and heights vanish on corners.
class Draw {
 public:
  explicit Draw(unsigned seed) : bits_(seed) {}
  double place() { return static_cast<double>(bits_() % 9) - 4; }
  Vec2 corner() { return {place(), place()}; }
  /// A height over the plane, different for each face that has the corner.
  double height() { return bits_() % 4 == 0 ? 0 : uniform_(bits_); }
  Vec2 anywhere() { return {5 * uniform_(bits_), 5 * uniform_(bits_)}; }

 private:
  std::mt19937_64 bits_;
  std::uniform_real_distribution<double> uniform_{-1, 1};
};

/// Of what is cut: any number.
constexpr Index kPlane = 7;

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

ShadowPolygon cut_by(const std::vector<Vec2>& corners, const std::vector<double>& heights) {
  ShadowPolygon polygon, result;
  assign(polygon, corners);
  const auto crossing = [&](std::size_t i) {
    double a = heights[i], b = heights[i + 1 == heights.size() ? 0 : i + 1];
    if (polygon[i].t0 == 1) std::swap(a, b);
    return a / (a - b);
  };
  cut(polygon, heights, crossing, kPlane, result);
  return result;
}

void add(const ShadowPolygon& polygon, std::vector<ShadowBorder>& borders) {
  for (SidePart part : polygon) {
    const int winding = part.t0 < part.t1 ? 1 : -1;
    if (winding < 0) std::swap(part.t0, part.t1);
    borders.push_back({part, winding});
  }
}

TEST(ShadowBorder, WhatIsCutIsClosed) {
  Draw draw(1);
  for (int i = 0; i < 2000; ++i) {
    const std::vector<Vec2> corners{draw.corner(), draw.corner(), draw.corner(), draw.corner()};
    const ShadowPolygon left =
        cut_by(corners, {draw.height(), draw.height(), draw.height(), draw.height()});
    for (std::size_t k = 0; k < left.size(); ++k)
      EXPECT_EQ(left[k].to(), left[k + 1 == left.size() ? 0 : k + 1].from());
  }
}

/// The sides that were there before keep no plane, however they are cut.
TEST(ShadowBorder, WhatRunsAlongTheCutIsOfItsPlane) {
  Draw draw(4);
  int along = 0, kept = 0;
  for (int i = 0; i < 2000; ++i) {
    const std::vector<Vec2> corners{draw.corner(), draw.corner(), draw.corner()};
    ShadowPolygon sides;
    assign(sides, corners);
    for (const SidePart& part : cut_by(corners, {draw.height(), draw.height(), draw.height()})) {
      const bool old = std::any_of(sides.begin(), sides.end(), [&](const SidePart& side) {
        return side.a == part.a && side.b == part.b;
      });
      const bool whole = std::fabs(part.t1 - part.t0) == 1;
      if (!old) {
        EXPECT_EQ(part.plane, kPlane);
      } else if (!whole) {
        EXPECT_EQ(part.plane, kNone);
      }
      kept += old && !whole;
      along += part.plane == kPlane;
    }
  }
  EXPECT_GT(along, 1000);
  EXPECT_GT(kept, 1000);
}

/// A triangle's height is linear: a point of it is kept where that is not negative.
TEST(ShadowBorder, CuttingKeepsWhatIsAbove) {
  Draw draw(2);
  int above = 0, below = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec2 a = draw.corner(), b = draw.corner(), c = draw.corner(), p = draw.anywhere();
    const double area = cross(b - a, c - a);
    if (area == 0) continue;
    const Vec3 at(draw.height(), draw.height(), draw.height());
    const Vec3 part = Vec3(cross(c - b, p - b), cross(a - c, p - c), cross(b - a, p - a)) / area;
    const double height = glm::dot(part, at);
    std::vector<ShadowBorder> borders;
    add(cut_by({a, b, c}, {at.x, at.y, at.z}), borders);
    const bool inside = std::min({part.x, part.y, part.z}) > 1e-9;
    const bool outside = std::min({part.x, part.y, part.z}) < -1e-9;
    if (!inside && !outside) continue;
    if (std::fabs(height) < 1e-9) continue;
    const int expected = inside && height > 0 ? (area > 0 ? 1 : -1) : 0;
    EXPECT_EQ(winding_at(p, borders), expected);
    if (inside) ++(height > 0 ? above : below);
  }
  EXPECT_GT(above, 20);
  EXPECT_GT(below, 20);
}

/// Faces about one corner, each cut by a plane of its own. What they share cancels, the rest is
/// closed to the bit, and no count changes.
TEST(ShadowBorder, CancellingLeavesClosedBordersAndTheSameCounts) {
  Draw draw(3);
  std::size_t cancelled = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec2 hub = draw.corner();
    std::vector<Vec2> rim;
    for (int k = 0; k < 5; ++k) rim.push_back(draw.corner());
    std::vector<ShadowBorder> all;
    for (std::size_t k = 0; k < rim.size(); ++k)
      add(cut_by({hub, rim[k], rim[(k + 1) % rim.size()]},
                 {draw.height(), draw.height(), draw.height()}),
          all);
    std::vector<ShadowBorder> left = all;
    cancel(left);
    std::map<std::pair<double, double>, int> ends;
    double before = 0, after = 0;
    for (const ShadowBorder& b : all) before += glm::length(b.part.to() - b.part.from());
    for (const ShadowBorder& b : left) {
      EXPECT_LT(b.part.t0, b.part.t1);
      after += glm::length(b.part.to() - b.part.from());
      ends[{b.part.from().x, b.part.from().y}] += b.winding;
      ends[{b.part.to().x, b.part.to().y}] -= b.winding;
    }
    for (const auto& [point, count] : ends) EXPECT_EQ(count, 0);
    cancelled += after < before - 1e-9;
    const Vec2 p = draw.anywhere();
    EXPECT_EQ(winding_at(p, left), winding_at(p, all));
  }
  EXPECT_GT(cancelled, 500u);
}

/// Two faces cut their common side at different places: of it there remains what lies between.
TEST(ShadowBorder, OfASharedSideRemainsWhatOneHas) {
  std::vector<ShadowBorder> borders;
  add(cut_by({{0, 0}, {4, 0}, {0, 4}}, {1, -1, 1}), borders);
  add(cut_by({{4, 0}, {0, 0}, {0, -4}}, {-1, 3, 3}), borders);
  cancel(borders);
  int on_side = 0;
  for (const ShadowBorder& b : borders) {
    if (b.part.a != Vec2(0, 0) || b.part.b != Vec2(4, 0)) continue;
    ++on_side;
    EXPECT_EQ(b.part.from(), Vec2(2, 0));
    EXPECT_EQ(b.part.to(), Vec2(3, 0));
    EXPECT_EQ(b.winding, -1);
  }
  EXPECT_EQ(on_side, 1);
}

}  // namespace
}  // namespace overstrike
