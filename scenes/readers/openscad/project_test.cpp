// What solids made flat must be, in closed form.
#include "scenes/readers/openscad/project.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "scenes/readers/openscad/scene.h"

namespace overstrike::openscad {
namespace {

using testing::HasSubstr;

std::vector<FlatPolygon> polygons(const std::string& text) {
  std::vector<FlatPolygon> all;
  for (const Body& body : read_scene(text, "m.csg", "/nonexistent").scene.bodies)
    all.push_back(std::get<FlatPolygon>(*body.shape));
  return all;
}

double area(const std::vector<FlatPolygon>& polygons) {
  double twice = 0;
  for (const FlatPolygon& polygon : polygons)
    for (const auto& loop : polygon.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec3 &a = loop[i], &b = loop[(i + 1) % loop.size()];
        twice += a.x * b.y - a.y * b.x;
      }
  return twice / 2;
}

std::size_t corners(const std::vector<FlatPolygon>& polygons) {
  std::size_t count = 0;
  for (const FlatPolygon& polygon : polygons)
    for (const auto& loop : polygon.loops) count += loop.size();
  return count;
}

/// A plate of 10 by 10 by 10 less a square bore of 3 by 3 that leans, and moves by `lean` in x from
/// the bottom to the top.
std::string bored(double lean, double bottom) {
  // In few digits, which are what they say.
  const auto text = [](double number) { return std::to_string(number).substr(0, 3); };
  return "projection() { difference() { cube(size = 10); multmatrix([[1, 0, " + text(lean / 10) +
         ", 2], [0, 1, 0, 3], [0, 0, 1, " + text(bottom) +
         "], [0, 0, 0, 1]]) { multmatrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, -5], [0, 0, 0, "
         "1]]) { cube(size = [3, 3, 20]); } } } }";
}

TEST(CsgProjection, AHoleIsWhereOneSeesThroughIt) {
  const auto straight = polygons(bored(0, 0));
  EXPECT_NEAR(area(straight), 100 - 9, 1e-6);
  EXPECT_EQ(corners(straight), 8u);
  const auto leaning = polygons(bored(2, 0));
  EXPECT_NEAR(area(leaning), 100 - 3 * (3 - 2), 1e-6);
  EXPECT_EQ(corners(leaning), 8u);
  EXPECT_NEAR(area(polygons(bored(4, 0))), 100, 1e-6) << "leans too much";
  EXPECT_NEAR(area(polygons(bored(0, 6))), 100, 1e-6) << "is blind";
}

/// Where both reach, as everything upright.
TEST(CsgProjection, OfAnIntersectionIsThatOfWhatBothHave) {
  const std::string text =
      "projection() { intersection() { cube(size = [10, 4, 4]); multmatrix([[1, 0, 0, 3], [0, 1, "
      "0, 1], [0, 0, 1, 2], [0, 0, 0, 1]]) { cube(size = [3, 9, 9]); } } }";
  EXPECT_NEAR(area(polygons(text)), 9, 1e-6);
  EXPECT_EQ(corners(polygons(text)), 4u);
}

/// A cone's halves above and below a plate that is taken away: the larger circle less nothing.
TEST(CsgProjection, RoundSolidsHaveTheirOutline) {
  constexpr int kSides = 24;
  const std::string text =
      "projection() { difference() { sphere(r = 5, $fn = 24); cylinder(r1 = 2, r2 = 2, h = 20, "
      "center = true, $fn = 24); } }";
  const double ring = 5 * std::sin(std::numbers::pi * 11 / 24);  // half a ring from the equator
  const auto of_circle = [](double r) {
    return kSides / 2.0 * r * r * std::sin(2 * std::numbers::pi / kSides);
  };
  const auto found = polygons(text);
  EXPECT_NEAR(area(found), of_circle(ring) - of_circle(2), 1e-6);
  EXPECT_EQ(corners(found), 2u * kSides);
}

/// Of boxes with their sides along the axes, in any tree, by columns of unit cubes.
TEST(CsgProjection, AgreesWithColumnsOfCubes) {
  constexpr int kSize = 6;
  std::mt19937 random(2);
  const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
  for (int n = 0; n < 60; ++n) {
    std::string text = "projection() { difference() { cube(size = 6); ";
    bool solid[kSize][kSize][kSize];
    for (auto& plane : solid)
      for (auto& row : plane)
        for (bool& cube : row) cube = true;
    for (int box = 0; box < 6; ++box) {
      const int x = below(5), y = below(5), z = below(7) - 1;
      const int w = 1 + below(4), d = 1 + below(4), h = 1 + below(6);
      const auto number = [](int i) { return std::to_string(i); };
      text += "multmatrix([[1, 0, 0, " + number(x) + "], [0, 1, 0, " + number(y) + "], [0, 0, 1, " +
              number(z) + "], [0, 0, 0, 1]]) { cube(size = [" + number(w) + ", " + number(d) +
              ", " + number(h) + "]); } ";
      for (int i = x; i < std::min(kSize, x + w); ++i)
        for (int j = y; j < std::min(kSize, y + d); ++j)
          for (int k = std::max(z, 0); k < std::min(kSize, z + h); ++k) solid[i][j][k] = false;
    }
    int columns = 0;
    for (auto& plane : solid)
      for (auto& row : plane) columns += std::any_of(row, row + kSize, [](bool c) { return c; });
    ASSERT_NEAR(area(polygons(text + "} }")), columns, 1e-5) << text;
  }
}

/// The bore ends half a unit of the sixth digit below the plate's face, where both were meant.
TEST(CsgProjection, AFlushHoleIsOpen) {
  const std::string text =
      "projection() { difference() { multmatrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 123.457], "
      "[0, 0, 0, 1]]) { cube(size = 10); } multmatrix([[1, 0, 0, 3], [0, 1, 0, 3], [0, 0, 1, "
      "122.457], [0, 0, 0, 1]]) { cube(size = [3, 3, 10.9995]); } } }";
  EXPECT_NEAR(area(polygons(text)), 100 - 9, 1e-6);
}

TEST(CsgProjection, OfTooManyFacesIsRefused) {
  try {
    polygons("projection() { difference() { sphere(r = 5, $fn = 256); cube(size = 3); } }");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("m.csg:1:1: error: 'projection' cannot be drawn: so many "
                                        "faces take too long to project"));
  }
}

}  // namespace
}  // namespace overstrike::openscad
