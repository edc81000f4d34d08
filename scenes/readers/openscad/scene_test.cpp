// .csg -> Scene. Coordinates in expectations are those that OpenSCAD 2021.01 exports.
#include "scenes/readers/openscad/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/drawing.h"
#include "core/geometry/tessellate.h"
#include "scenes/readers/openscad/bodies.h"
#include "scenes/readers/openscad/hull.h"
#include "scenes/readers/openscad/program.h"

namespace overstrike::openscad {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Scene scene_of(const std::string& text) {
  return read_scene(text, "m.csg", OVERSTRIKE_SOURCE_DIR "/scenes/readers/openscad").scene;
}

std::string error_of(const std::string& text) {
  try {
    scene_of(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

/// The corners of a scene's one body, in the world.
std::vector<Vec3> corners_of_one(const std::string& text) {
  const Scene scene = scene_of(text);
  EXPECT_EQ(scene.bodies.size(), 1u) << text;
  return corners_of({scene.bodies.at(0).shape, scene.bodies.at(0).placement});
}

bool has_corner(const std::vector<Vec3>& corners, const Vec3& wanted, double near = 5e-5) {
  for (const Vec3& p : corners)
    if (glm::distance(p, wanted) < near) return true;
  return false;
}

double volume_of(const Body& body) {
  const Polyhedron p = tessellate(*body.shape, 1, false);
  double six = 0;
  for (Index l = 0; l < p.loop_ends.size(); ++l) {
    const auto loop = p.loop(l);
    for (std::size_t i = 2; i < loop.size(); ++i)
      six +=
          glm::dot(p.vertices[loop[0]], glm::cross(p.vertices[loop[i - 1]], p.vertices[loop[i]]));
  }
  return six / 6;
}

TEST(Csg, SpheresHaveRingsAndNoPoles) {
  const std::vector<Vec3> corners = corners_of_one("sphere($fn = 8, r = 2);");
  EXPECT_EQ(corners.size(), 32u);
  const double polar = std::acos(-1) / 8;  // half a ring of 45 degrees
  EXPECT_TRUE(has_corner(corners, {2 * std::sin(polar), 0, 2 * std::cos(polar)}, 1e-12));
  EXPECT_FALSE(has_corner(corners, {0, 0, 2}, 0.1));
}

TEST(Csg, FacetsFollowFnFaFs) {
  const auto sides = [](const std::string& arguments) {
    const Scene scene = scene_of("cylinder(h = 1, r1 = 3, r2 = 3" + arguments + ");");
    return std::get<Frustum>(*scene.bodies.at(0).shape).sides;
  };
  EXPECT_EQ(sides(""), 10);             // 2 pi 3 / 2, up
  EXPECT_EQ(sides(", $fs = 0.1"), 30);  // 360 / 12
  EXPECT_EQ(sides(", $fs = 100"), 5);   // never fewer
  EXPECT_EQ(sides(", $fn = 2"), 3);
  EXPECT_EQ(sides(", $fn = 7.9, $fs = 0.1"), 7);
  EXPECT_THAT(error_of("cylinder(h = 1, r1 = 3, r2 = 3, $fn = 1e9);"),
              HasSubstr("m.csg:1:1: error: too many facets round a circle: 1e+09"));
  EXPECT_THAT(error_of("circle(r = 3, $fn = 1e117);"), HasSubstr("too many facets"));
  EXPECT_THAT(error_of("linear_extrude(height = 1, slices = 1e117, twist = 9) { square(); }"),
              HasSubstr("too many slices"));
}

TEST(Csg, TwistedExtrusionsHaveOpenscadsSlices) {
  const std::string text =
      "linear_extrude(height = 20, twist = 90, scale = [1, 1]) { square(size = [20, 10], center = "
      "true); }";
  const std::vector<Vec3> corners = corners_of_one(text);
  EXPECT_EQ(corners.size(), 4u * 9);
  EXPECT_TRUE(has_corner(corners, {8.8324, -6.85483, 2.5}));
  EXPECT_TRUE(has_corner(corners, {-10.7833, -2.95302, 2.5}));
  EXPECT_TRUE(has_corner(corners, {5, 10, 20}));
}

TEST(Csg, ExtrusionsAreWhatTheyEnclose) {
  const auto volume = [](const std::string& text) {
    return volume_of(scene_of(text).bodies.at(0));
  };
  EXPECT_NEAR(volume("linear_extrude(height = 3, center = true) { difference() { square(size = [4, "
                     "4]); multmatrix([[1,0,0,1],[0,1,0,1],[0,0,1,0],[0,0,0,1]]) { square(size = "
                     "[2, 2]); } } }"),
              36, 1e-12);
  EXPECT_NEAR(
      volume("linear_extrude(height = 3, scale = [0, 0]) { square(size = 2, center = true); }"), 4,
      1e-12);
  // A ring of square section, of 4 sides: 4 prisms between half diagonals.
  EXPECT_NEAR(
      volume("rotate_extrude($fn = 4) { multmatrix([[1,0,0,1],[0,1,0,0],[0,0,1,0],[0,0,0,1]])"
             " { square(size = [1, 1]); } }"),
      2 * (4 - 1), 1e-12);
  EXPECT_NEAR(volume("rotate_extrude(angle = -90, $fn = 4) { square(size = [1, 1]); }"), 0.5,
              1e-12);
  EXPECT_NEAR(
      volume("hull() { cube(size = [1, 1, 1]); multmatrix([[1,0,0,0],[0,1,0,0],[0,0,1,1],[0,0,"
             "0,1]]) { cube(size = [1, 1, 1]); } }"),
      2, 1e-12);
  EXPECT_NEAR(volume("minkowski() { cube(size = [1, 2, 3]); cube(size = [2, 2, 2]); }"), 60, 1e-12);
  EXPECT_NEAR(
      volume("resize(newsize = [2, 0, 0], auto = true) { cube(size = [1, 1, 1]); }") *
          glm::determinant(scene_of("resize(newsize = [2, 0, 0], auto = true) { cube(size = "
                                    "[1, 1, 1]); }")
                               .bodies.at(0)
                               .placement.linear),
      8, 1e-12);
  EXPECT_NEAR(volume("linear_extrude(height = 1) { offset(delta = 1) { square(size = [2, 2]); } }"),
              16, 1e-12);
  EXPECT_NEAR(volume("linear_extrude(height = 1) { offset(r = -1) { square(size = [4, 4]); } }"), 4,
              1e-12);
  EXPECT_NEAR(
      volume("linear_extrude(height = 1) { projection(cut = true) { difference() { cube(size "
             "= [4, 4, 4], center = true); cube(size = [2, 2, 5], center = true); } } }"),
      12, 1e-12);
  EXPECT_NEAR(
      volume("polyhedron(points = [[0,0,0],[1,0,0],[0,1,0],[0,0,1]], faces = [[0,1,2],[0,3,1],"
             "[0,2,3],[1,3,2]]);"),
      1.0 / 6, 1e-12);
}

TEST(Csg, ConsumersRefuseWhatHasNoSurface) {
  EXPECT_THAT(error_of("hull() { difference() { cube(); sphere(); } }"),
              HasSubstr("m.csg:1:1: error: 'hull' of a difference cannot be drawn"));
  EXPECT_THAT(error_of("group() { resize(newsize = [1, 2, 3]) { intersection() { cube(); sphere(); "
                       "} } }"),
              HasSubstr("m.csg:1:11: error: 'resize' of an intersection cannot be drawn"));
  EXPECT_THAT(
      error_of("minkowski() { rotate_extrude() { multmatrix([[1,0,0,9],[0,1,0,0],[0,0,1,0],[0,"
               "0,0,1]]) { circle(r = 1); } } cube(); }"),
      HasSubstr("'minkowski' cannot be drawn: an operand is not convex"));
}

TEST(Csg, LightGoesWithTheEye) {
  const Scene scene = scene_of("cube();");
  EXPECT_TRUE(scene.light_beside_eye);
  EXPECT_FALSE(scene.light);
}

TEST(Csg, UnionsFallApartAndDifferencesAreSolids) {
  const Scene scene = scene_of(
      "group() { cube(); union() { sphere(); } difference() { cube(); group(); cylinder(); } }"
      "difference() { cube(size = 0); sphere(); }"
      "intersection() { cube(); }");
  EXPECT_EQ(scene.bodies.size(), 5u);
  ASSERT_EQ(scene.solids.size(), 2u);
  ASSERT_EQ(scene.solids[0].nodes.size(), 3u);
  EXPECT_EQ(scene.solids[0].nodes[0].operation, SetOperation::subtract);
  EXPECT_EQ(scene.solids[0].nodes[0].end, 3u);
  EXPECT_EQ(scene.solids[0].nodes[2].end, 3u);
}

TEST(Csg, EqualShapesAreShared) {
  const Scene scene = scene_of("sphere($fn = 20, r = 3); sphere(r = 3, $fn = 20); sphere(r = 4);");
  EXPECT_EQ(scene.bodies[0].shape, scene.bodies[1].shape);
  EXPECT_NE(scene.bodies[0].shape, scene.bodies[2].shape);
}

TEST(Csg, TheOutermostColourCounts) {
  const Scene scene = scene_of(
      "color([1, 0, 0, 1]) { color([0, 0, 1, 1]) { cube(); } } color([1, 1, 1, 1]) { cube(); } "
      "cube();");
  EXPECT_DOUBLE_EQ(scene.bodies[0].density_factor, 1 - 0.75 * 0.2126);
  EXPECT_EQ(scene.bodies[0].pen, 2);
  EXPECT_DOUBLE_EQ(scene.bodies[1].density_factor, 0.25);
  EXPECT_EQ(scene.bodies[1].pen, 1);
  EXPECT_EQ(scene.bodies[2].density_factor, 1);
  EXPECT_EQ(scene.bodies[2].pen, 0);
}

TEST(Csg, PensGoByHue) {
  EXPECT_EQ(pen_of({1, 0, 0}), 2);
  EXPECT_EQ(pen_of({1, 0.9, 0}), 3);
  EXPECT_EQ(pen_of({0.9, 1, 0}), 3);
  EXPECT_EQ(pen_of({0, 1, 0}), 4);
  EXPECT_EQ(pen_of({0, 1, 1}), 5);
  EXPECT_EQ(pen_of({0, 0, 1}), 5);
  EXPECT_EQ(pen_of({1, 0, 1}), 6);
  EXPECT_EQ(pen_of({0.5, 0.5, 0.5}), 1);
}

TEST(Csg, OtherDimensionsAreLeftOutWithAWarning) {
  const ReadResult read = read_scene("cube(); square();", "m.csg", "");
  EXPECT_EQ(read.scene.bodies.size(), 1u);
  ASSERT_EQ(read.warnings.size(), 1u);
  EXPECT_EQ(read.warnings[0].message, "a flat shape among solids is left out");
}

/// A plate turned and displaced, and a hole through it that is flush with both its faces; matrices
/// have OpenSCAD's six digits.
constexpr const char* kFlushHole =
    "difference() { multmatrix([[0.699397, -0.652198, 0.292372, 123.457], [0.694716, 0.524195, "
    "-0.492533, -77.7778], [0.167969, 0.547592, 0.819713, 31.4159], [0, 0, 0, 1]]) { cube(size = "
    "[20, 20, 10]); } multmatrix([[0.295514, -0.9095, 0.292372, 123.929], [0.861747, 0.121667, "
    "-0.492533, -65.5887], [0.412387, 0.397501, 0.819713, 38.5715], [0, 0, 0, 1]]) { cylinder(h = "
    "10, r1 = 5, r2 = 5, $fn = 24); } }";

/// Densities along the line through the middle of a picture of the plate, seen along its hole.
std::vector<double> seen_along_hole(Scene scene, double side) {
  const Vec3 middle(125.390635, -68.0513322, 42.6701034), axis(0.292372, -0.492533, 0.819713);
  scene.camera.eye = middle + axis * side;
  scene.camera.target = middle;
  scene.camera.up = Vec3(0.699397, 0.694716, 0.167969);
  scene.camera.parallel = true;
  scene.camera.window_width = 40;
  Drawing drawing(scene, Grid{40, 40, 1, 1}, {});
  std::vector<double> densities;
  drawing.cells([&](const CellRow& row) {
    if (row.row == 20) densities.assign(row.density.begin(), row.density.end());
  });
  return densities;
}

TEST(Csg, AHoleFlushWithBothFacesIsOpen) {
  for (const double side : {100.0, -100.0}) {
    const std::vector<double> seen = seen_along_hole(scene_of(kFlushHole), side);
    ASSERT_EQ(seen.size(), 40u);
    EXPECT_EQ(seen[20], 0) << "open";
    EXPECT_GT(seen[12], 0.1) << "the plate beside it";
    EXPECT_GT(seen[28], 0.1) << "the plate beside it";
    Scene apart = scene_of(kFlushHole);
    for (Body& body : apart.bodies) body.precision = 0;
    EXPECT_GT(seen_along_hole(apart, side)[20], 0.1) << "without the bound a skin closes it";
  }
}

TEST(Csg, BoundsOfPlacesFollowTheirDigits) {
  const Scene scene = scene_of(
      "cube(size = [1, 2, 3]); multmatrix([[1, 0, 0, 123.457], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, "
      "0, "
      "1]]) { cube(size = 1); }");
  EXPECT_EQ(scene.bodies[0].precision, 0);
  EXPECT_DOUBLE_EQ(scene.bodies[1].precision, 5e-4);
}

TEST(OpenscadProgram, WhatItSaysHasItsLine) {
  const std::vector<Diagnostic> all = said(
      "ECHO: 1\nWARNING: Ignoring unknown module 'foo' in file a.scad, line 2\n"
      "ERROR: Parser error: syntax error in file \"b.scad\", line 4\nCan't parse file\n",
      "here/a.scad");
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(to_string(all[0]), "here/a.scad:2: warning: OpenSCAD: Ignoring unknown module 'foo'");
  EXPECT_EQ(to_string(all[1]), "b.scad:4: error: OpenSCAD: Parser error: syntax error");
}

TEST(Hull, IsTheCornersAndNothingElse) {
  const std::optional<Polyhedron> cube = hull({{0, 0, 0},
                                               {1, 0, 0},
                                               {0, 1, 0},
                                               {1, 1, 0},
                                               {0, 0, 1},
                                               {1, 0, 1},
                                               {0, 1, 1},
                                               {1, 1, 1},
                                               {0.5, 0.5, 0.5}});
  ASSERT_TRUE(cube);
  EXPECT_EQ(cube->vertices.size(), 8u);
  EXPECT_EQ(cube->face_count(), 12u);
  EXPECT_FALSE(hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}})) << "flat";
  EXPECT_EQ(hull({{0, 0}, {2, 0}, {1, 0}, {2, 2}, {1, 1}, {0, 2}}).size(), 4u);
}

}  // namespace
}  // namespace overstrike::openscad
