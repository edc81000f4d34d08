// Empty operands. What is expected is what OpenSCAD 2021.01 makes of these files.
#include <gtest/gtest.h>

#include "scenes/readers/openscad/hull.h"
#include "scenes/readers/openscad/scene.h"

namespace overstrike::openscad {
namespace {

Scene scene_of(const std::string& text) { return read_scene(text, "m.csg", "/nonexistent").scene; }

/// Those that are operands of solids with them.
std::size_t bodies(const std::string& text) { return scene_of(text).bodies.size(); }

double width(const std::string& text) {
  const Scene scene = scene_of(text);
  EXPECT_EQ(scene.bodies.size(), 1u) << text;
  double low = HUGE_VAL, high = -HUGE_VAL;
  for (const Vec3& p : corners_of({scene.bodies.at(0).shape, scene.bodies.at(0).placement}))
    low = std::fmin(low, p.x), high = std::fmax(high, p.x);
  return high - low;
}

std::string extruded(const std::string& text) {
  return "linear_extrude(height = 2) { " + text + " }";
}

constexpr const char* kEmpties[] = {
    "group();",
    "union();",
    "group() { group(); }",
    "render(convexity = 1);",
    "color([1, 0, 0, 1]);",
    "multmatrix([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]);",
    "hull();",
    "minkowski();",
    "difference() { group(); MINE }",
    "intersection() { MINE group(); }",
    "group() { *MINE }",
};
constexpr const char* kEmptySolids[] = {
    "cube(size = 0);",
    "linear_extrude(height = 2);",
    "linear_extrude(height = 2) { square(size = 0); }",
};
constexpr const char* kEmptyFlats[] = {
    "square(size = 0);",
    "projection();",
    "projection() { difference() { group(); cube(size = 3); } }",
    "offset(delta = 1) { intersection() { square(size = 3); group(); } }",
    "difference() { square(size = 1); square(size = 1); }",
    "minkowski() { group(); square(size = 1); }",
};

std::string of(std::string text, const std::string& shape) {
  for (std::size_t at; (at = text.find("MINE")) != std::string::npos;) text.replace(at, 4, shape);
  return text;
}

TEST(CsgEmpty, NothingIsLeftOfWhatHasAnEmptyOperand) {
  const std::string cube = "cube(size = 3);", square = "square(size = 3);";
  const auto expect_nothing = [](const std::string& empty, const std::string& shape, bool flat) {
    for (const std::string& text :
         {"difference() { " + empty + shape + " }", "intersection() { " + empty + shape + " }",
          "intersection() { " + shape + shape + empty + " }",
          "difference() { *" + shape + empty + shape + " }"})
      EXPECT_EQ(bodies(flat ? extruded(text) : text), 0u) << text;
  };
  for (const char* const empty : kEmpties) {
    expect_nothing(of(empty, cube), cube, false);
    expect_nothing(of(empty, square), square, true);
    expect_nothing(of(empty, square), square, false);
  }
  for (const char* const empty : kEmptySolids) expect_nothing(empty, cube, false);
  for (const char* const empty : kEmptyFlats) expect_nothing(empty, square, true);
}

TEST(CsgEmpty, WhatIsLeftOutForItsMarkIsNoOperand) {
  for (const char* const mark : {"%", "*"}) {
    const std::string marked = mark + std::string("square(size = 9); ");
    EXPECT_EQ(width(extruded("difference() { " + marked + "square(size = 3); }")), 3);
    EXPECT_EQ(width(extruded("intersection() { square(size = 3);" + marked + " }")), 3);
    EXPECT_EQ(width(extruded("minkowski() { square(size = 3);" + marked + " }")), 3);
    EXPECT_EQ(bodies(extruded("difference() { group() { " + marked + "} square(size = 3); }")), 0u);
  }
  EXPECT_EQ(width("difference() { *group(); cube(size = 3); }"), 3);
  EXPECT_EQ(bodies("difference() { group() { %cube(size = 9); } cube(size = 3); }"), 1u);
  EXPECT_TRUE(scene_of("difference() { group() { %cube(size = 9); } cube(size = 3); }")
                  .solids.at(0)
                  .background);
}

TEST(CsgEmpty, AnotherDimensionIsEmpty) {
  EXPECT_EQ(bodies("intersection() { cube(size = 3); square(size = 2); }"), 0u);
  EXPECT_EQ(bodies(extruded("intersection() { square(size = 3); group() { cube(); } }")), 0u);
  EXPECT_EQ(bodies(extruded("minkowski() { square(size = 3); cube(); }")), 0u);
  EXPECT_EQ(width("difference() { cube(size = 3); square(size = 2); }"), 3);
}

TEST(CsgEmpty, UnionsAndToolsDoWithout) {
  EXPECT_EQ(width("union() { group(); cube(size = 3); }"), 3);
  EXPECT_EQ(width("difference() { cube(size = 3); group(); }"), 3);
  EXPECT_EQ(width("hull() { group(); cube(size = 3); cube(size = 0); }"), 3);
}

TEST(CsgEmpty, SumsInSpaceDoWithout) {
  EXPECT_EQ(width("minkowski() { group(); cube(size = 3); }"), 3);
  EXPECT_EQ(width("minkowski() { cube(size = 3); cube(size = 0); }"), 3);
  EXPECT_EQ(width("minkowski() { cube(size = 0); cube(size = 3); group(); cube(size = 1); }"), 4);
}

TEST(CsgEmpty, SumsInThePlaneNeedTheFirstAndAnother) {
  EXPECT_EQ(bodies(extruded("minkowski() { square(size = 0); square(size = 3); }")), 0u);
  EXPECT_EQ(bodies(extruded("minkowski() { group(); square(size = 1); square(size = 1); }")), 0u);
  EXPECT_EQ(bodies(extruded("minkowski() { square(size = 3); group(); }")), 0u);
  EXPECT_EQ(width(extruded("minkowski() { square(size = 3); }")), 3);
  EXPECT_EQ(
      width(extruded("minkowski() { square(size = 3); square(size = 0); square(size = 1); }")), 4);
  EXPECT_EQ(width(extruded("minkowski() { square(size = 3); square(size = 1); cube(); }")), 4);
}

}  // namespace
}  // namespace overstrike::openscad
