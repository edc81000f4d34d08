#include "core/geometry/region_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "core/geometry/polygon.h"
#include "core/visibility/test_scenes.h"

namespace overstrike {
namespace {

using testing::operand_tree;
using testing::tree_of;
using Nodes = std::vector<SolidNode>;
using Regions = std::vector<Region>;
constexpr SetOperation kUnite = SetOperation::unite, kSubtract = SetOperation::subtract,
                       kIntersect = SetOperation::intersect;

/// Areas of regions within the unit of their coordinates, of a few hundred products each.
constexpr double kAreaError = 1e3 * 0x1p-53;

Loop2 box(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}
Region region(std::vector<Loop2> loops) { return {std::move(loops)}; }

bool holds(const Region& region, const Vec2& p) {
  bool inside = false;
  for (const Loop2& loop : region.loops) inside = inside != contains(loop, p);
  return inside;
}

/// The definition.
bool holds(const Nodes& nodes, Index at, const Regions& operands, const Vec2& p) {
  const SolidNode& n = nodes[at];
  if (n.operation == SetOperation::operand) return holds(operands[n.body], p);
  bool result = false;
  for (Index i = at + 1; i < n.end; i = nodes[i].end) {
    const bool in = holds(nodes, i, operands, p);
    if (i == at + 1)
      result = in;
    else if (n.operation == kUnite)
      result = result || in;
    else if (n.operation == kSubtract)
      result = result && !in;
    else
      result = result && in;
  }
  return result;
}

double area(const Loop2& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
    sum += (a.x - b.x) * (a.y + b.y) / 2;
  }
  return sum;
}
double area(const Region& region) {
  double sum = 0;
  for (const Loop2& loop : region.loops) sum += area(loop);
  return sum;
}

bool on(const Vec2& p, const Vec2& a, const Vec2& b) {
  return turn_of(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
         std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}

/// Edges a b and c d have nothing in common but ends of both.
bool apart(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  if (turn_of(a, b, c) * turn_of(a, b, d) < 0 && turn_of(c, d, a) * turn_of(c, d, b) < 0)
    return false;
  for (const Vec2& p : {c, d})
    if (p != a && p != b && on(p, a, b)) return false;
  for (const Vec2& p : {a, b})
    if (p != c && p != d && on(p, c, d)) return false;
  return !((a == c && b == d) || (a == d && b == c));
}

/// What the header promises of every result, by looking at all pairs.
void expect_tidy(const Region& found) {
  std::vector<std::pair<Vec2, Vec2>> edges;
  std::map<std::pair<double, double>, int> visits;
  for (const Loop2& loop : found.loops) {
    ASSERT_GE(loop.size(), 3u);
    std::map<std::pair<double, double>, int> own;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      edges.push_back({loop[i], loop[(i + 1) % loop.size()]});
      ++visits[{loop[i].x, loop[i].y}];
      EXPECT_EQ((++own[{loop[i].x, loop[i].y}]), 1) << "a loop that touches itself";
    }
  }
  for (std::size_t i = 0; i < edges.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_TRUE(apart(edges[i].first, edges[i].second, edges[j].first, edges[j].second));
  for (std::size_t l = 0; l < found.loops.size(); ++l) {
    const Loop2& loop = found.loops[l];
    if (l > 0) {
      EXPECT_LE(found.loops[l - 1].front().x, loop.front().x);
    }
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 &a = loop[(i + loop.size() - 1) % loop.size()], &b = loop[(i + 1) % loop.size()];
      EXPECT_TRUE(loop.front().x < loop[i].x ||
                  (loop.front().x == loop[i].x && loop.front().y <= loop[i].y));
      if (visits[{loop[i].x, loop[i].y}] == 1) {
        EXPECT_NE(turn_of(a, loop[i], b), 0) << "straight on";
      }
    }
    // Just beside the middle of its longest edge the region lies on its left.
    std::size_t longest = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
      if (glm::distance(loop[i], loop[(i + 1) % loop.size()]) >
          glm::distance(loop[longest], loop[(longest + 1) % loop.size()]))
        longest = i;
    const Vec2 &a = loop[longest], &b = loop[(longest + 1) % loop.size()];
    const Vec2 middle = (a + b) / 2.0, left = Vec2(a.y - b.y, b.x - a.x) * 1e-9;
    EXPECT_TRUE(holds(found, middle + left)) << "the left of an edge is outside";
    EXPECT_FALSE(holds(found, middle - left)) << "the right of an edge is inside";
  }
}

Region random_on_lattice(std::mt19937_64& random, std::size_t n) {
  Region region;
  for (std::size_t loops = 1 + random() % 2; loops > 0; --loops) {
    Loop2 loop;
    for (std::size_t corners = 3 + random() % 4; corners > 0; --corners)
      loop.push_back({static_cast<double>(random() % n), static_cast<double>(random() % n)});
    region.loops.push_back(std::move(loop));
  }
  return region;
}

Nodes random_tree(std::mt19937_64& random, int depth, Index operands) {
  if (depth == 0 || random() % 4 == 0) return operand_tree(static_cast<Index>(random() % operands));
  std::vector<Nodes> members;
  for (std::size_t i = 2 + random() % 2; i > 0; --i)
    members.push_back(random_tree(random, depth - 1, operands));
  return tree_of(static_cast<SetOperation>(1 + random() % 3), members);
}

TEST(RegionSets, OfTwoSquaresThatOverlap) {
  const Regions both{region({box(0, 0, 2, 2)}), region({box(1, 1, 3, 3)})};
  EXPECT_EQ(combine(kIntersect, both).loops, std::vector<Loop2>{box(1, 1, 2, 2)});
  EXPECT_EQ(combine(kSubtract, both).loops,
            (std::vector<Loop2>{{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}}));
  EXPECT_EQ(combine(kUnite, both).loops,
            (std::vector<Loop2>{{{0, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 3}, {1, 3}, {1, 2}, {0, 2}}}));
}

TEST(RegionSets, SquaresSideBySideAreOneAndMeetInNothing) {
  const Regions both{region({box(0, 0, 1, 1)}), region({box(1, 0, 2, 1)})};
  EXPECT_EQ(combine(kUnite, both).loops, std::vector<Loop2>{box(0, 0, 2, 1)});
  EXPECT_TRUE(combine(kIntersect, both).loops.empty());
  EXPECT_EQ(combine(kSubtract, both).loops, both[0].loops);
}

TEST(RegionSets, WhatMeetsInAPointStaysTwoLoops) {
  const Regions both{region({box(0, 0, 1, 1)}), region({box(1, 1, 2, 2)})};
  EXPECT_EQ(combine(kUnite, both).loops, (std::vector<Loop2>{box(0, 0, 1, 1), box(1, 1, 2, 2)}));
  const Regions hole{region({box(0, 0, 4, 4)}), region({{{0, 2}, {2, 1}, {2, 3}}})};
  EXPECT_EQ(
      combine(kSubtract, hole).loops,
      (std::vector<Loop2>{{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 2}}, {{0, 2}, {2, 3}, {2, 1}}}));
  // A hole that reaches from side to side makes two of it.
  const Regions across{region({box(0, 0, 4, 4)}), region({{{0, 2}, {2, 1}, {4, 2}, {2, 3}}})};
  EXPECT_EQ(combine(kSubtract, across).loops,
            (std::vector<Loop2>{{{0, 0}, {4, 0}, {4, 2}, {2, 1}, {0, 2}},
                                {{0, 2}, {2, 3}, {4, 2}, {4, 4}, {0, 4}}}));
}

TEST(RegionSets, AHoleIsClockwise) {
  const Regions both{region({box(0, 0, 4, 4)}), region({box(1, 1, 2, 2)})};
  EXPECT_EQ(combine(kSubtract, both).loops,
            (std::vector<Loop2>{box(0, 0, 4, 4), {{1, 1}, {1, 2}, {2, 2}, {2, 1}}}));
}

TEST(RegionSets, OperandsAreWhatLiesWithinAnOddNumberOfLoops) {
  const Regions hollow{region({box(0, 0, 3, 3), box(1, 1, 2, 2)}), region({box(1, 1, 2, 2)})};
  EXPECT_EQ(combine(kUnite, hollow).loops, std::vector<Loop2>{box(0, 0, 3, 3)});
  const Regions bow{region({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}})};
  EXPECT_EQ(combine(kUnite, bow).loops,
            (std::vector<Loop2>{{{0, 0}, {1, 1}, {0, 2}}, {{1, 1}, {2, 0}, {2, 2}}}));
  const Regions twice{region({box(0, 0, 1, 1), box(0, 0, 1, 1)})};
  EXPECT_TRUE(combine(kUnite, twice).loops.empty());
}

TEST(RegionSets, WhatHasNoWidthIsLeftOut) {
  const Regions spike{region({{{0, 0}, {2, 0}, {3, 0}, {2, 0}, {2, 2}, {0, 2}}})};
  EXPECT_EQ(combine(kUnite, spike).loops, std::vector<Loop2>{box(0, 0, 2, 2)});
  const Regions slit{region({box(0, 0, 2, 2)}), region({{{1, 0}, {1, 1}}})};
  EXPECT_EQ(combine(kSubtract, slit).loops, std::vector<Loop2>{box(0, 0, 2, 2)});
}

TEST(RegionSets, OfNothingThereIsNothing) {
  for (const SetOperation operation : {kUnite, kSubtract, kIntersect}) {
    EXPECT_TRUE(combine(operation, {}).loops.empty());
    EXPECT_TRUE(combine(operation, Regions{Region{}}).loops.empty());
  }
  const Regions operands{region({box(0, 0, 1, 1)}), Region{}};
  EXPECT_EQ(combine(kSubtract, operands).loops, operands[0].loops);
  EXPECT_EQ(combine(kUnite, operands).loops, operands[0].loops);
  EXPECT_TRUE(combine(kIntersect, operands).loops.empty());
}

/// 0.1 and 0.3 are on no lattice of powers of two that 1000 is on.
TEST(RegionSets, CoordinatesStayToTheBit) {
  const Loop2 odd{{0.1, 0.3}, {0.7, 0.1}, {1.0 / 3, 0.9}}, far = box(900.1, 900.3, 1000, 1000);
  EXPECT_EQ(combine(kUnite, Regions{region({far}), region({odd})}).loops,
            (std::vector<Loop2>{odd, far}));
  // Sides along the axes cross in their own coordinates.
  const Regions both{region({box(0.1, 0.1, 0.7, 0.7), far}), region({box(0.3, 0.3, 1.1, 1.1)})};
  EXPECT_EQ(combine(kIntersect, both).loops, std::vector<Loop2>{box(0.3, 0.3, 0.7, 0.7)});
}

/// Coincident corners and edges are the rule there. The points asked about lie on no line through
/// two points of the lattice, by far more than crossings are rounded.
TEST(RegionSets, AreWhatTheirTreeSays) {
  std::mt19937_64 random(1);
  int inside = 0;
  for (int n = 0; n < 3000; ++n) {
    Regions operands;
    for (std::size_t i = 1 + random() % 5; i > 0; --i)
      operands.push_back(random_on_lattice(random, 3 + random() % 5));
    const Nodes tree = random_tree(random, 3, static_cast<Index>(operands.size()));
    const Region found = resolve(tree, operands);
    expect_tidy(found);
    for (int x = 0; x < 7; ++x)
      for (int y = 0; y < 7; ++y) {
        const Vec2 p(x + 0.3141592, y + 0.7182818);
        const bool in = holds(tree, 0, operands, p);
        inside += in;
        EXPECT_EQ(holds(found, p), in) << p.x << ", " << p.y;
      }
    if (HasFailure()) FAIL() << "tree " << n;
  }
  EXPECT_GT(inside, 5'000);
}

TEST(RegionSets, DependNeitherOnOrderNorOnWhereLoopsBegin) {
  std::mt19937_64 random(2);
  for (int n = 0; n < 500; ++n) {
    Regions operands;
    for (int i = 0; i < 4; ++i) operands.push_back(random_on_lattice(random, 7));
    Regions other = operands;
    std::shuffle(other.begin() + 1, other.end(), random);
    for (Region& r : other) {
      std::shuffle(r.loops.begin(), r.loops.end(), random);
      for (Loop2& loop : r.loops) {
        if (random() % 2 == 0) std::reverse(loop.begin(), loop.end());
        std::rotate(loop.begin(), loop.begin() + static_cast<long>(random() % 3), loop.end());
      }
    }
    for (const SetOperation operation : {kUnite, kSubtract, kIntersect})
      ASSERT_EQ(combine(operation, operands).loops, combine(operation, other).loops) << n;
  }
}

/// One arrangement, so that even rounded crossings are the same.
TEST(RegionSets, HowASetIsWrittenIsNotSeen) {
  std::mt19937_64 random(3);
  const Nodes a = operand_tree(0), b = operand_tree(1), c = operand_tree(2), f = operand_tree(3);
  const auto unite = [](const Nodes& x, const Nodes& y) { return tree_of(kUnite, {x, y}); };
  const auto without = [](const Nodes& x, const Nodes& y) { return tree_of(kSubtract, {x, y}); };
  const auto both = [](const Nodes& x, const Nodes& y) { return tree_of(kIntersect, {x, y}); };
  const std::pair<Nodes, Nodes> laws[] = {
      {without(f, unite(a, b)), both(without(f, a), without(f, b))},
      {without(f, both(a, b)), unite(without(f, a), without(f, b))},
      {unite(a, both(a, b)), a},
      {both(a, unite(a, b)), a},
      {both(a, unite(b, c)), unite(both(a, b), both(a, c))},
      {unite(a, both(b, c)), both(unite(a, b), unite(a, c))},
      {without(a, without(a, b)), both(a, b)},
      {unite(a, a), a},
      {both(a, a), a},
      {without(a, a), tree_of(kUnite, {})}};
  for (int n = 0; n < 300; ++n) {
    Regions operands;
    for (int i = 0; i < 3; ++i) operands.push_back(random_on_lattice(random, 6));
    operands.push_back(region({box(-1, -1, 7, 7)}));
    for (const auto& [left, right] : laws)
      ASSERT_EQ(resolve(left, operands).loops, resolve(right, operands).loops) << n;
  }
}

/// On results, too: a tidy region is itself, and where boxes cross nothing is rounded.
TEST(RegionSets, LawsHoldStepByStep) {
  std::mt19937_64 random(4);
  for (int n = 0; n < 300; ++n) {
    Regions s;
    for (int i = 0; i < 3; ++i) {
      Region boxes;
      for (int k = 0; k < 3; ++k) {
        // Tenths, each rounded once.
        const auto x = static_cast<double>(random() % 7), y = static_cast<double>(random() % 7);
        const auto wide = static_cast<double>(1 + random() % 4);
        const auto high = static_cast<double>(1 + random() % 4);
        boxes.loops.push_back(box(x / 10, y / 10, (x + wide) / 10, (y + high) / 10));
      }
      s.push_back(combine(kUnite, Regions{boxes}));
    }
    const auto unite = [](const Region& a, const Region& b) {
      return combine(kUnite, Regions{a, b});
    };
    const auto both = [](const Region& a, const Region& b) {
      return combine(kIntersect, Regions{a, b});
    };
    ASSERT_EQ(unite(s[0], s[0]).loops, s[0].loops);
    ASSERT_EQ(unite(s[0], both(s[0], s[1])).loops, s[0].loops);
    ASSERT_EQ(both(s[0], unite(s[0], s[1])).loops, s[0].loops);
    ASSERT_EQ(both(s[0], unite(s[1], s[2])).loops, unite(both(s[0], s[1]), both(s[0], s[2])).loops);
    ASSERT_TRUE(combine(kSubtract, Regions{s[0], s[0]}).loops.empty());
    ASSERT_NEAR(area(s[0]) + area(s[1]), area(unite(s[0], s[1])) + area(both(s[0], s[1])),
                kAreaError);
  }
}

Region star(std::mt19937_64& random, int corners) {
  std::uniform_real_distribution<double> u(-0.5, 0.5);
  Region region;
  for (int l = 0; l < 2; ++l) {
    Loop2 loop;
    for (int i = 0; i < corners; ++i) loop.push_back({u(random), u(random)});
    region.loops.push_back(std::move(loop));
  }
  return region;
}

TEST(RegionSets, AreasAddUpWhereCrossingsAreRounded) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> u(-0.5, 0.5);
  for (int n = 0; n < 100; ++n) {
    const Regions both{star(random, 12), star(random, 12)};
    const Region united = combine(kUnite, both), common = combine(kIntersect, both);
    expect_tidy(united), expect_tidy(common);
    EXPECT_NEAR(area(combine(kUnite, Regions{both[0]})) + area(combine(kUnite, Regions{both[1]})),
                area(united) + area(common), kAreaError);
    for (int i = 0; i < 50; ++i) {
      const Vec2 p(u(random), u(random));
      EXPECT_EQ(holds(common, p), holds(both[0], p) && holds(both[1], p));
    }
    if (HasFailure()) FAIL() << n;
  }
}

/// Copies whose corners are off by last places cross in crowds of squares next to one another.
TEST(RegionSets, StayTidyWhereRoundingDecides) {
  std::mt19937_64 random(6);
  const auto shaken = [&](Region r, double by) {
    for (Loop2& loop : r.loops)
      for (Vec2& p : loop)
        p +=
            Vec2(static_cast<double>(random() % 5) - 2, static_cast<double>(random() % 5) - 2) * by;
    return r;
  };
  for (int n = 0; n < 400; ++n) {
    const Region first = n % 2 == 0 ? star(random, 6) : random_on_lattice(random, 5);
    // Up to the sides of some squares.
    const double by = std::ldexp(1.0, -54 + static_cast<int>(random() % 6));
    Regions operands{first};
    for (int i = 0; i < 3; ++i) operands.push_back(shaken(first, by));
    for (const SetOperation operation : {kUnite, kSubtract, kIntersect}) {
      const Region found = combine(operation, operands);
      std::vector<std::pair<Vec2, Vec2>> edges;
      for (const Loop2& loop : found.loops) {
        EXPECT_GE(loop.size(), 3u);
        for (std::size_t i = 0; i < loop.size(); ++i)
          edges.push_back({loop[i], loop[(i + 1) % loop.size()]});
      }
      for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
          EXPECT_TRUE(apart(edges[i].first, edges[i].second, edges[j].first, edges[j].second));
      EXPECT_NEAR(area(found), operation == kSubtract ? 0 : area(combine(kUnite, Regions{first})),
                  1e-11);
    }
    if (HasFailure()) FAIL() << n;
  }
}

}  // namespace
}  // namespace overstrike
