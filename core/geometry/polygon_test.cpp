#include "core/geometry/polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace overstrike {
namespace {

/// Exact for whole coordinates below 2^52 in size.
int whole_turn_of(const Vec2& a, const Vec2& b, const Vec2& c) {
  __extension__ using Wide = __int128;
  const auto w = [](double x) { return static_cast<Wide>(x); };
  const Wide d = w(a.x - c.x) * w(b.y - c.y) - w(a.y - c.y) * w(b.x - c.x);
  return (d > 0) - (d < 0);
}

/// Three points on a line of whole steps, then pushed off it by at most one.
TEST(Polygon, TurnIsExactNextToALine) {
  std::mt19937_64 random(3);
  std::uniform_int_distribution<long long> step(-(1 << 25), 1 << 25), push(-1, 1);
  int straight = 0;
  for (int i = 0; i < 200000; ++i) {
    const Vec2 d{double(step(random)), double(step(random))};
    const Vec2 a{double(step(random)), double(step(random))};
    const Vec2 b = a + d * double(step(random)),
               c = a + d * double(step(random)) + Vec2{double(push(random)), double(push(random))};
    const int turn = turn_of(a, b, c);
    ASSERT_EQ(turn, whole_turn_of(a, b, c));
    ASSERT_EQ(turn_of(b, c, a), turn);
    ASSERT_EQ(turn_of(b, a, c), -turn);
    straight += turn == 0;
  }
  EXPECT_GT(straight, 1000);
}

TEST(Polygon, TurnSeesTheLastPlace) {
  const Vec2 a{0.1, 0.1}, b{0.3, 0.3};
  EXPECT_EQ(turn_of(a, b, {0.7, 0.7}), 0);
  EXPECT_EQ(turn_of(a, b, {0.7, std::nextafter(0.7, 1)}), 1);
  EXPECT_EQ(turn_of(a, b, {0.7, std::nextafter(0.7, 0)}), -1);
  EXPECT_EQ(turn_of({1e-60, 1e-60}, {1e60, 1e60}, {3, 3}), 0);
}

TEST(Polygon, RepeatsAreDropped) {
  const Loop2 loop{{0, 0}, {0, 0}, {1, 0}, {1, 1}, {1, 1}, {0, 0}};
  EXPECT_EQ(without_repeats(loop), (Loop2{{0, 0}, {1, 0}, {1, 1}}));
  EXPECT_EQ(without_repeats({{2, 2}, {2, 2}}).size(), 1u);
}

TEST(Polygon, SimpleLoopsHaveNoContact) {
  EXPECT_FALSE(find_contact({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}}));
  EXPECT_FALSE(find_contact({{{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}}}));  // a point on an edge
  EXPECT_FALSE(find_contact({{{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}}}));
  EXPECT_FALSE(find_contact({{{0, 0}, {4, 0}, {0, 4}}, {{1, 1}, {2, 1}, {1, 2}}}));
}

struct Touching {
  std::vector<Loop2> loops;
  std::size_t first, second;
};

TEST(Polygon, ContactsAreFound) {
  const std::vector<Touching> cases{
      {{{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}, 0, 0},                  // a bow tie
      {{{{0, 0}, {4, 0}, {2, 0}, {2, 3}}}, 0, 0},                  // folded back
      {{{{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}}, 0, 0},          // a corner on an edge
      {{{{0, 0}, {2, 2}, {4, 0}, {4, 4}, {2, 2}, {0, 4}}}, 0, 0},  // two corners in a point
      {{{{0, 0}, {1, 1}, {2, 2}}}, 0, 0},                          // no area
      {{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {5, 1}, {1, 3}}}, 0, 1},  // crossing loops
      {{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{0, 2}, {1, 1}, {1, 3}}}, 0, 1},  // a hole at the rim
      {{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{0, 1}, {1, 1}, {1, 3}, {0, 3}}}, 0, 1},
      {{{{0, 0}, {1, 0}, {0, 1}}, {{0, 0}, {1, 0}, {0, 1}}}, 0, 1},  // the same loop twice
  };
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const std::optional<Contact> contact = find_contact(cases[i].loops);
    ASSERT_TRUE(contact) << i;
    EXPECT_EQ(contact->first, cases[i].first) << i;
    EXPECT_EQ(contact->second, cases[i].second) << i;
    EXPECT_EQ(glm::clamp(contact->near, 0.0, 4.0), contact->near) << i;
  }
}

/// A star of random radii about the origin is simple; with two corners exchanged, distant ones, it
/// is not.
TEST(Polygon, RandomStars) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> radius(1, 2);
  for (int i = 0; i < 300; ++i) {
    Loop2 star;
    for (int k = 0; k < 40; ++k) {
      const double r = radius(random);
      star.push_back({r * std::cos(k * 0.157), r * std::sin(k * 0.157)});
    }
    EXPECT_FALSE(find_contact({star}));
    EXPECT_TRUE(is_counter_clockwise(star));
    EXPECT_TRUE(contains(star, {0.3, -0.4}));
    EXPECT_FALSE(contains(star, {2.1, 0}));
    EXPECT_FALSE(contains(star, {-2.1, 0}));
    std::swap(star[static_cast<std::size_t>(i % 10)], star[static_cast<std::size_t>(20 + i % 7)]);
    EXPECT_TRUE(find_contact({star}));
  }
}

TEST(Polygon, NestedLoopsAreOrdered) {
  const auto square = [](double r) { return Loop2{{-r, -r}, {-r, r}, {r, r}, {r, -r}}; };
  const OrderedRegion region =
      in_order({square(1), square(4), {{9, 0}, {9, 1}, {10, 0}}, square(3), square(2)});
  ASSERT_EQ(region.pieces.size(), 3u);
  EXPECT_EQ(region.pieces[0].outline, 1u);
  EXPECT_EQ(region.pieces[0].holes, std::vector<std::size_t>{3});
  EXPECT_EQ(region.pieces[1].outline, 2u);
  EXPECT_EQ(region.pieces[2].outline, 4u);
  EXPECT_EQ(region.pieces[2].holes, std::vector<std::size_t>{0});
  for (std::size_t l : {1u, 2u, 4u}) EXPECT_TRUE(is_counter_clockwise(region.loops[l])) << l;
  for (std::size_t l : {0u, 3u}) EXPECT_FALSE(is_counter_clockwise(region.loops[l])) << l;
}

/// Battlements: the tops are one line, the feet another, and the ends of the base line too.
TEST(Polygon, LinesAreNumbered) {
  const Loop2 wall{{3, 1}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 0}, {2, 0}, {3, 0}};
  const std::vector<Index> lines = line_numbers({wall}).front();
  EXPECT_EQ(lines[0], lines[9]);  // the right side goes on past the loop's end
  EXPECT_EQ(lines[1], lines[5]);
  EXPECT_EQ(lines[7], lines[8]);
  EXPECT_NE(lines[0], lines[1]);
  EXPECT_NE(lines[3], lines[1]);
  EXPECT_NE(lines[2], lines[4]);
}

}  // namespace
}  // namespace overstrike
