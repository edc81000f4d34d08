// The triangles of twisted walls. Those expected are those of OpenSCAD 2021.01's export.
#include <gtest/gtest.h>

#include "core/geometry/tessellate.h"
#include "scenes/readers/openscad/scene.h"

namespace overstrike::openscad {
namespace {

constexpr const char* kRing =
    "difference() { square(size = [40, 40], center = true); polygon(points = [[2, 0], [6, 5], [10, "
    "0]]); }";
constexpr const char* kTriangle = "polygon(points = [[2, 0], [10, 0], [6, 5]]);";

Polyhedron extruded(const std::string& arguments, const std::string& flat) {
  const std::string text = "linear_extrude(height = 10, " + arguments + ") { " + flat + " }";
  return tessellate(*read_scene(text, "m.csg", "/nonexistent").scene.bodies.at(0).shape, 1, false);
}

bool has_edge(const Polyhedron& p, const Vec3& a, const Vec3& b) {
  for (Index l = 0; l < p.loop_ends.size(); ++l) {
    const auto loop = p.loop(l);
    for (std::size_t i = 0; i < loop.size(); ++i)
      if (glm::distance(p.vertices[loop[i]], a) < 1e-9 &&
          glm::distance(p.vertices[loop[(i + 1) % loop.size()]], b) < 1e-9)
        return true;
  }
  return false;
}

/// Where a corner is after a quarter turn clockwise.
Vec3 above(const Vec2& p) { return {p.y, -p.x, 10}; }

/// The ends of a diagonal, from below.
::testing::AssertionResult has_diagonal(const Polyhedron& p, const Vec2& low, const Vec3& high) {
  if (has_edge(p, Vec3(low, 0), high)) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "no edge from " << low.x << ", " << low.y;
}

const Vec2 kNear(2, 0), kFar(10, 0), kPeak(6, 5);

TEST(CsgTwist, WallsAreSplitAlongTheShorterDiagonal) {
  const Polyhedron p = extruded("twist = 90, slices = 1", kTriangle);
  EXPECT_TRUE(has_diagonal(p, kFar, above(kPeak)));
  EXPECT_TRUE(has_diagonal(p, kNear, above(kPeak)));
}

TEST(CsgTwist, EqualDiagonalsGoWithTheTwist) {
  EXPECT_TRUE(has_diagonal(extruded("twist = 90, slices = 1", kTriangle), kNear, above(kFar)));
  EXPECT_TRUE(
      has_diagonal(extruded("twist = -90, slices = 1", kTriangle), kFar, Vec3(0, kNear.x, 10)));
  // An edge from the axis, and one through it.
  EXPECT_TRUE(has_diagonal(
      extruded("twist = 90, slices = 1", "polygon(points = [[0, 0], [10, 0], [6, 5]]);"), Vec2(0.0),
      above(kFar)));
  EXPECT_TRUE(has_diagonal(
      extruded("twist = 90, slices = 1", "polygon(points = [[-5, 0], [10, 0], [6, 5]]);"),
      Vec2(-5, 0), above(kFar)));
  // A half turn: all are.
  const Polyhedron half = extruded("twist = 180, slices = 1", kTriangle);
  EXPECT_TRUE(has_diagonal(half, kFar, Vec3(-kPeak, 10)));
  EXPECT_TRUE(has_diagonal(half, kPeak, Vec3(-kNear, 10)));
}

TEST(CsgTwist, RoundAHoleTheyGoAgainstIt) {
  EXPECT_TRUE(has_diagonal(extruded("twist = 90, slices = 1", kRing), kNear, above(kFar)));
  EXPECT_TRUE(has_diagonal(extruded("twist = -90, slices = 1", kRing), kFar, Vec3(0, kNear.x, 10)));
  EXPECT_TRUE(has_diagonal(
      extruded("scale = [0.5, 2], slices = 1",
               "difference() { square(size = [40, 40], center = true); polygon(points = [[-3, 0], "
               "[0, 5], [3, 0]]); }"),
      Vec2(3, 0), Vec3(-1.5, 0, 10)));
}

TEST(CsgTwist, DiagonalsAsEqualAsOpenscadHasThemAreEqual) {
  // The near corner so far off the ray that the first diagonal is longer by that part of the mean.
  const auto splits_with_twist = [](double part) {
    const Vec2 near(2, 5.2 * part);
    const std::string y = std::to_string(static_cast<long>(near.y * 1e12)) + "e-12";
    const Polyhedron p =
        extruded("twist = 90, slices = 1", "polygon(points = [[2, " + y + "], [10, 0], [6, 5]]);");
    return has_edge(p, Vec3(near, 0), above(kFar));
  };
  EXPECT_TRUE(splits_with_twist(-2e-5));
  EXPECT_TRUE(splits_with_twist(0.98e-5));
  EXPECT_FALSE(splits_with_twist(1.02e-5));
}

TEST(CsgTwist, BelowAnEdgeTheOtherDiagonalIsTaken) {
  EXPECT_TRUE(
      has_diagonal(extruded("scale = [0, 1], slices = 1", kTriangle), kFar, Vec3(0, kPeak.y, 10)));
}

}  // namespace
}  // namespace overstrike::openscad
