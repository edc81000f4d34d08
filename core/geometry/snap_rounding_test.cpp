#include "core/geometry/snap_rounding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "core/geometry/polygon.h"

namespace overstrike {
namespace {

/// On a lattice of 12 x 12, no longer than `longest` steps in x and y.
std::vector<Segment2> random_segments(std::mt19937_64& random, int count, double step,
                                      int longest = 12) {
  const auto coordinate = [&] { return static_cast<double>(random() % 12); };
  std::vector<Segment2> segments;
  while (static_cast<int>(segments.size()) < count) {
    const Vec2 a(coordinate(), coordinate()), b(coordinate(), coordinate());
    const bool within = std::fabs(a.x - b.x) <= longest && std::fabs(a.y - b.y) <= longest;
    if (a != b && within) segments.push_back({a * step, b * step});
  }
  return segments;
}

bool cross(const Segment2& e, const Segment2& f) {
  return turn_of(f.from, f.to, e.from) * turn_of(f.from, f.to, e.to) < 0 &&
         turn_of(e.from, e.to, f.from) * turn_of(e.from, e.to, f.to) < 0;
}

TEST(NearPairs, NoCrossingIsMissed) {
  std::mt19937_64 random(1);
  for (int n = 0; n < 50; ++n) {
    const std::vector<Segment2> segments = random_segments(random, 200, 1, 3);
    std::set<std::pair<Index, Index>> found;
    crossing_pairs(segments, [&](Index i, Index j) { found.insert({i, j}); });
    EXPECT_LT(found.size(), segments.size() * segments.size() / 4);
    for (Index j = 0; j < segments.size(); ++j)
      for (Index i = 0; i < j; ++i)
        ASSERT_GE(found.count({i, j}), cross(segments[i], segments[j]) ? 1u : 0u) << n;
  }
}

TEST(NearPairs, NoSquareThatIsPassedIsMissed) {
  std::mt19937_64 random(2);
  for (int n = 0; n < 50; ++n) {
    const std::vector<Segment2> segments = random_segments(random, 100, 1, 3);
    std::vector<Vec2> points;
    for (const Segment2& s : random_segments(random, 100, 0.5)) points.push_back(s.from);
    std::set<std::pair<Index, Index>> found;
    near_pairs(segments, points, 0.25, [&](Index i, Index j) { found.insert({i, j}); });
    EXPECT_LT(found.size(), segments.size() * points.size() / 2);
    for (Index i = 0; i < segments.size(); ++i)
      for (Index j = 0; j < points.size(); ++j)
        ASSERT_GE(found.count({i, j}), passes(segments[i], points[j], 0.5) ? 1u : 0u) << n;
  }
}

/// Rays of a fan have nothing in common but an end, and are told apart along one another.
TEST(NearPairs, FansAndParallelsAreNotAllPairs) {
  std::vector<Segment2> fan, parallels;
  for (int i = 0; i < 2000; ++i) {
    const double t = i / 2000.0;
    fan.push_back({{0, 0}, {1, t}});
    parallels.push_back({{t, t}, {t + 1, t - 1}});
  }
  for (const auto& segments : {fan, parallels}) {
    std::size_t pairs = 0;
    crossing_pairs(segments, [&](Index, Index) { ++pairs; });
    EXPECT_LT(pairs, 50 * segments.size());
  }
}

TEST(SnapRounding, SquaresHoldTheirLowerBorders) {
  const Vec2 middle(4, 4);
  const auto passed = [&](Vec2 a, Vec2 b) {
    const bool either = passes({a, b}, middle, 2);
    EXPECT_EQ(passes({b, a}, middle, 2), either);
    return either;
  };
  EXPECT_TRUE(passed({3, 0}, {3, 9}));
  EXPECT_FALSE(passed({5, 0}, {5, 9}));
  EXPECT_TRUE(passed({0, 3}, {9, 3}));
  EXPECT_FALSE(passed({0, 5}, {9, 5}));
  EXPECT_TRUE(passed({2, 4}, {4, 2})) << "through the lower left corner";
  EXPECT_FALSE(passed({4, 6}, {6, 4})) << "through the upper right one";
  EXPECT_FALSE(passed({2, 4}, {4, 6}));
  EXPECT_FALSE(passed({4, 2}, {6, 4}));
  EXPECT_TRUE(passed({0, 0}, {9, 9}));
  EXPECT_FALSE(passed({0, 0}, {2.5, 2.5}));
}

/// Coordinates of one last place, where squares are a few of them, and of none.
TEST(SnapRounding, PathsMeetInSitesOnly) {
  std::mt19937_64 random(3);
  for (int n = 0; n < 300; ++n) {
    const double step = n % 2 == 0 ? 1 : 0x1p-51;
    std::vector<Segment2> segments = random_segments(random, 12, step);
    if (n % 2 != 0)
      for (Segment2& s : segments) s.from += 1.0, s.to += 1.0;
    const SnapRounded found = snap_round(segments);
    std::vector<Segment2> pieces;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const auto path = found.path(i);
      ASSERT_FALSE(path.empty());
      for (const Index site : path)
        EXPECT_TRUE(passes(segments[i], found.middles[site], found.side));
      for (std::size_t k = 0; k + 1 < path.size(); ++k)
        pieces.push_back({found.middles[path[k]], found.middles[path[k + 1]]});
    }
    for (const Segment2& p : pieces) {
      for (const Segment2& q : pieces) ASSERT_FALSE(cross(p, q)) << n;
      for (const Vec2& m : found.middles) {
        const bool between = turn_of(p.from, p.to, m) == 0 && m != p.from && m != p.to &&
                             glm::dot(m - p.from, m - p.to) < 0;
        ASSERT_FALSE(between) << n;
      }
    }
  }
}

TEST(SnapRounding, OrderAndDirectionAreNotSeen) {
  std::mt19937_64 random(4);
  for (int n = 0; n < 50; ++n) {
    std::vector<Segment2> segments = random_segments(random, 20, 0.1);
    const SnapRounded found = snap_round(segments);
    std::vector<Segment2> other = segments;
    std::reverse(other.begin(), other.end());
    for (Segment2& s : other) std::swap(s.from, s.to);
    const SnapRounded turned = snap_round(other);
    EXPECT_EQ(found.points, turned.points);
    for (std::size_t i = 0; i < segments.size(); ++i) {
      const auto there = found.path(i), back = turned.path(segments.size() - 1 - i);
      EXPECT_TRUE(std::equal(there.begin(), there.end(), back.rbegin(), back.rend()));
    }
  }
}

}  // namespace
}  // namespace overstrike
