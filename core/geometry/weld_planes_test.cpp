#include "core/geometry/weld_planes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/geometry/direction.h"
#include "core/geometry/rank_set.h"

namespace overstrike {
namespace {

struct Faces {
  std::vector<PlaneSample> samples;
  std::vector<VertexError> errors;  ///< each is a body's of its own
  std::vector<Vec3> points;
  void add(const std::vector<Vec3>& loop, double error) {
    PlaneFitter fitter;
    fitter.add(loop.size(), [&](std::size_t i) { return loop[i]; });
    const Index first = static_cast<Index>(points.size());
    points.insert(points.end(), loop.begin(), loop.end());
    samples.push_back({fitter.fit(), first, static_cast<Index>(points.size()),
                       static_cast<Index>(samples.size())});
    errors.push_back({error, error});
  }
  WeldedPlanes weld(const std::vector<std::pair<Index, Index>>& neighbours = {}) const {
    return weld_planes(samples, errors, points, [&] { return neighbours; });
  }
};

class Turn {
 public:
  explicit Turn(std::mt19937_64& random) {
    std::uniform_real_distribution<double> u(-1, 1);
    x_ = unit(Vec3(u(random), u(random), u(random)));
    y_ = unit(glm::cross(x_, Vec3(u(random), u(random), u(random))));
    z_ = glm::cross(x_, y_);
    offset_ = Vec3(u(random), u(random), u(random)) * 10.0;
  }
  Vec3 operator()(const Vec3& p) const { return x_ * p.x + y_ * p.y + z_ * p.z + offset_; }

 private:
  Vec3 x_, y_, z_, offset_;
};

/// A rectangle of the plane z = height, turned.
std::vector<Vec3> rectangle(const Turn& turn, Vec2 low, Vec2 size, double height, bool down) {
  std::vector<Vec3> loop{turn({low.x, low.y, height}), turn({low.x + size.x, low.y, height}),
                         turn({low.x + size.x, low.y + size.y, height}),
                         turn({low.x, low.y + size.y, height})};
  if (down) std::reverse(loop.begin(), loop.end());
  return loop;
}

constexpr double kError = 64 * 0x1p-53 * 20;

TEST(WeldPlanes, TurnedRectanglesOfOnePlaneShareItAndOthersDoNot) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> u(0.1, 3);
  for (int trial = 0; trial < 2000; ++trial) {
    const Turn turn(random);
    const auto any = [&] { return Vec2(u(random) - 1.5, u(random) - 1.5) * 3.0; };
    const auto size = [&] { return Vec2(u(random), u(random)); };
    Faces faces;
    faces.add(rectangle(turn, any(), size(), 1, false), kError);
    faces.add(rectangle(turn, any(), size(), 1, true), kError);
    faces.add(rectangle(turn, any(), size() * 0.01, 1, false), kError);
    faces.add(rectangle(turn, any(), size(), 1 + 1e-6, true), kError);
    const WeldedPlanes welded = faces.weld();
    EXPECT_EQ(welded.group[0], welded.group[1]) << trial;
    EXPECT_EQ(welded.group[0], welded.group[2]) << trial;
    EXPECT_NE(welded.group[0], welded.group[3]) << trial;
  }
}

TEST(WeldPlanes, DoesNotDependOnTheOrder) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> u(0.1, 3);
  std::vector<std::vector<Vec3>> loops;
  const Turn turn(random);
  for (int i = 0; i < 400; ++i)
    loops.push_back(rectangle(turn, Vec2(u(random), u(random)), Vec2(u(random), u(random)),
                              static_cast<double>(i % 40), i % 3 == 0));
  std::vector<Index> order(loops.size());
  for (Index i = 0; i < order.size(); ++i) order[i] = i;
  std::vector<Vec3> first_normals;
  for (int trial = 0; trial < 5; ++trial) {
    Faces faces;
    for (const Index i : order) faces.add(loops[i], 1e-12);
    const WeldedPlanes welded = faces.weld();
    EXPECT_EQ(welded.representative.size(), 40u);
    std::vector<Vec3> normals(loops.size());
    for (std::size_t k = 0; k < order.size(); ++k)
      normals[order[k]] = faces.samples[welded.representative[welded.group[k]]].fit.normal;
    if (trial == 0) first_normals = normals;
    EXPECT_EQ(normals, first_normals);
    std::shuffle(order.begin(), order.end(), random);
  }
}

TEST(WeldPlanes, FacetsOfASphereStayApart) {
  Faces faces;
  const int n = 60;
  const auto at = [&](int i, int j) {
    const double a = 2 * M_PI * i / n, b = M_PI * j / n;
    return Vec3(std::cos(a) * std::sin(b), std::sin(a) * std::sin(b), std::cos(b));
  };
  for (int i = 0; i < n; ++i)
    for (int j = 1; j + 1 < n; ++j)
      faces.add({at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)}, 1e-14);
  EXPECT_EQ(faces.weld().representative.size(), faces.samples.size());
}

TEST(WeldPlanes, ASliverJoinsItsNeighbour) {
  Faces faces;
  faces.add({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, 1e-7);
  faces.add({{1, 0, 0}, {1.000001, 0.5, 5e-8}, {1, 1, 0}}, 1e-7);
  EXPECT_EQ(faces.weld().representative.size(), 2u);
  EXPECT_EQ(faces.weld({{0, 1}}).representative.size(), 1u);
}

TEST(RankSet, FindsWhatASortedListFinds) {
  std::mt19937_64 random(3);
  for (const std::size_t n : {1u, 64u, 65u, 5000u, 20000u}) {
    RankSet set(n);
    std::vector<std::size_t> list;
    for (int k = 0; k < 12; ++k) {
      const std::size_t probe = random() % n;
      const auto it = std::lower_bound(list.begin(), list.end(), probe);
      EXPECT_EQ(set.up(probe), it == list.end() ? RankSet::kNothing : *it);
      const auto after = std::upper_bound(list.begin(), list.end(), probe);
      EXPECT_EQ(set.down(probe), after == list.begin() ? RankSet::kNothing : *(after - 1));
      const std::size_t fresh = random() % n;
      set.insert(fresh);
      list.insert(std::lower_bound(list.begin(), list.end(), fresh), fresh);
    }
  }
}

/// Two faces a millionth apart, each of which may be a thousandth from its place: of two bodies
/// they may be one plane, of one body they are two, for what moved it has moved both.
TEST(WeldPlanes, WhatMovesABodyDoesNotPressItIntoOnePlane) {
  std::mt19937_64 random(12);
  for (int trial = 0; trial < 100; ++trial) {
    const Turn turn(random);
    Faces faces;
    faces.add(rectangle(turn, {0, 0}, {2, 1}, 0, false), 1e-3);
    faces.add(rectangle(turn, {0, 0}, {1, 1}, 1e-6, true), 1e-3);
    EXPECT_EQ(faces.weld().representative.size(), 1u);
    for (VertexError& e : faces.errors) e.in_body = kError;
    EXPECT_EQ(faces.weld().representative.size(), 1u);
    faces.samples[1].body = 0;
    EXPECT_EQ(faces.weld().representative.size(), 2u);
    faces.samples[1].body = 1;
    EXPECT_EQ(faces.weld().representative.size(), 1u);
  }
}

}  // namespace
}  // namespace overstrike
