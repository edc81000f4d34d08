#include "scenes/readers/read.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <variant>

#include "core/geometry/trig.h"

namespace overstrike {
namespace {

Scene scene(const std::string& text) {
  ReadResult result = read_scene_text(text, "yaml", "s.yaml", "");
  EXPECT_TRUE(result.warnings.empty());
  return std::move(result.scene);
}

/// The one body of a flow map.
Body body(const std::string& text) {
  Scene s = scene("bodies:\n  - {" + text + "}\n");
  EXPECT_EQ(s.bodies.size(), 1u);
  return s.bodies.at(0);
}

template <class T>
T shape(const std::string& text) {
  return std::get<T>(*body(text).shape);
}

void expect_near(const Vec3& a, const Vec3& b) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-12) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(YamlScene, WhatIsNotSaidStandsAtItsDefault) {
  const Scene s = scene("bodies: []");
  EXPECT_FALSE(s.light || s.ground_z);
  EXPECT_FALSE(s.camera.look_at || s.camera.distance || s.camera.eye || s.camera.window_width ||
               s.camera.fov_deg || s.camera.near_distance || s.camera.parallel);
  EXPECT_EQ(s.camera.from.azimuth_deg, -60);
  EXPECT_EQ(s.law.ground_shadow_factor, 0.85);
  EXPECT_EQ(s.source, "s.yaml");
}

TEST(YamlScene, LightGroundAndDensity) {
  const Scene s = scene(
      "light: {azimuth: -20, elevation: 45}\nground: -1.5\n"
      "density: {k: .5, hmax: 0.9, ground-shadow: 0.7, cut: 0.25}\nbodies: []");
  EXPECT_EQ(s.light->azimuth_deg, -20);
  EXPECT_EQ(s.light->elevation_deg, 45);
  EXPECT_EQ(*s.ground_z, -1.5);
  EXPECT_EQ(s.law.k, 0.5);
  EXPECT_EQ(s.law.hmax, 0.9);
  EXPECT_EQ(s.law.ground_shadow_factor, 0.7);
  EXPECT_EQ(s.law.cut_factor, 0.25);
  const Scene none = scene("light: none\nground: none\nbodies: []");
  EXPECT_FALSE(none.light || none.ground_z);
}

TEST(YamlScene, Cameras) {
  const Camera around = scene(
                            "camera: {look-at: [1, 2, 3], distance: 20, azimuth: 10, elevation: "
                            "-5, fov: 40, near: 2}\n"
                            "bodies: []")
                            .camera;
  EXPECT_EQ(*around.look_at, Vec3(1, 2, 3));
  EXPECT_EQ(*around.distance, 20);
  EXPECT_EQ(around.from.azimuth_deg, 10);
  EXPECT_EQ(around.from.elevation_deg, -5);
  EXPECT_EQ(*around.fov_deg, 40);
  EXPECT_EQ(*around.near_distance, 2);
  const Camera eye = scene(
                         "camera: {eye: [9, 0, 1], target: [0, 0, 1], up: [0, 1, 0], "
                         "projection: parallel, window: 12}\nbodies: []")
                         .camera;
  EXPECT_EQ(*eye.eye, Vec3(9, 0, 1));
  EXPECT_EQ(*eye.target, Vec3(0, 0, 1));
  EXPECT_EQ(eye.up, Vec3(0, 1, 0));
  EXPECT_TRUE(eye.parallel);
  EXPECT_EQ(*eye.window_width, 12);
  EXPECT_FALSE(scene("camera: {window: fit}\nbodies: []").camera.window_width);
}

TEST(YamlScene, FlatFacedShapes) {
  EXPECT_EQ(shape<Box>("box: [1, 2, 3]").size, Vec3(1, 2, 3));
  EXPECT_EQ(shape<Box>("box: {size: 2}").size, Vec3(2));
  const auto wedge = shape<Wedge>("wedge: {size: [4, 3, 1], top: 2, shift: -1}");
  EXPECT_EQ(wedge.size, Vec3(4, 3, 1));
  EXPECT_EQ(wedge.top, 2);
  EXPECT_EQ(wedge.top_shift, -1);
  const auto four = shape<Tetrahedron>("tetrahedron: [[0,0,0], [1,0,0], [0,1,0], [0,0,1]]");
  EXPECT_EQ(four.vertices[3], Vec3(0, 0, 1));
}

TEST(YamlScene, PrismsAndRoundShapes) {
  const auto is = [](const Frustum& f, double bottom, double top, double height, int sides) {
    return f.bottom_radius == bottom && f.top_radius == top && f.height == height &&
           f.sides == sides;
  };
  EXPECT_TRUE(is(shape<Frustum>("prism: {sides: 6, radius: 2, height: 3}"), 2, 2, 3, 6));
  EXPECT_TRUE(is(shape<Frustum>("cylinder: {radius: 2, height: 3}"), 2, 2, 3, 0));
  EXPECT_TRUE(is(shape<Frustum>("cylinder: {radius: 2, height: 3, sides: 20}"), 2, 2, 3, 20));
  EXPECT_TRUE(is(shape<Frustum>("pyramid: {sides: 4, radius: 2, height: 3}"), 2, 0, 3, 4));
  EXPECT_TRUE(is(shape<Frustum>("cone: {radius: 2, height: 3}"), 2, 0, 3, 0));
  EXPECT_TRUE(is(shape<Frustum>("frustum: {bottom: 2, top: 1, height: 3, sides: 5}"), 2, 1, 3, 5));
  EXPECT_EQ(shape<Ellipsoid>("sphere: 2").radii, Vec3(2));
  EXPECT_EQ(shape<Ellipsoid>("ellipsoid: [1, 2, 3]").radii, Vec3(1, 2, 3));
  const auto globe = shape<Ellipsoid>("sphere: {radius: 1, sides: 18, rings: 5}");
  EXPECT_EQ(globe.sides, 18);
  EXPECT_EQ(globe.rings, 5);
  const auto torus = shape<Torus>("torus: {major: 3, minor: 1}");
  EXPECT_EQ(torus.major, 3);
  EXPECT_EQ(torus.minor, 1);
}

TEST(YamlScene, SweptShapes) {
  const auto slab = shape<Extrusion>(
      "extrusion: {outline: [[0,0], [4,0], [4,4], [0,4]], holes: [[[1,1], [2,1], [1,2]]], height: "
      "2}");
  ASSERT_EQ(slab.region.loops.size(), 2u);
  EXPECT_EQ(slab.region.loops[1][1], Vec2(2, 1));
  EXPECT_EQ(slab.height, 2);
  const auto vase =
      shape<Revolution>("revolution: {profile: [[0,0], [2,0], [0,3]], angle: 270, sides: 9}");
  EXPECT_EQ(vase.profile[1], Vec2(2, 0));
  EXPECT_EQ(vase.angle_deg, 270);
  EXPECT_EQ(vase.sides, 9);
  const auto pipe = shape<Sweep>(
      "sweep: {profile: [[0,0], [.1,0], [0,.1]], path: [[0,0,0], [4,0,0], [4,4,0]], closed: true}");
  EXPECT_EQ(pipe.path.size(), 3u);
  EXPECT_TRUE(pipe.closed_path);
}

TEST(YamlScene, RegionsAreResolved) {
  using Loops = std::vector<std::vector<Vec2>>;
  const auto plate = shape<Extrusion>(
      "extrusion: {height: 2, region: {difference: [{rectangle: [4, 2]}, {rectangle: 1}]}}");
  EXPECT_EQ(plate.region.loops, (Loops{{{-2, -1}, {2, -1}, {2, 1}, {-2, 1}},
                                       {{-.5, -.5}, {-.5, .5}, {.5, .5}, {.5, -.5}}}));
  const auto moved = shape<Extrusion>(
      "extrusion: {height: 1, region: {union: [[[0,0], [1,0], [0,1]], {rectangle: 2, scale: [2, "
      "1], "
      "rotate: 90, at: [5, 0]}], at: [0, 1]}}");
  EXPECT_EQ(moved.region.loops,
            (Loops{{{0, 1}, {1, 1}, {0, 2}}, {{4, -1}, {6, -1}, {6, 3}, {4, 3}}}));
  const auto hexagon =
      shape<Extrusion>("extrusion: {height: 1, region: {circle: {radius: 2, sides: 6}}}");
  EXPECT_EQ(hexagon.region.loops.at(0).size(), 6u);
  EXPECT_EQ(hexagon.region.loops.at(0)[0], Vec2(-2, 0));
  const auto round = shape<Extrusion>("extrusion: {height: 1, region: {circle: 2}}");
  EXPECT_EQ(round.region.loops.at(0).size(), 64u);
}

TEST(YamlScene, RegionsAreTurnedSweptAndDrawnFlat) {
  const auto ring = shape<Revolution>(
      "revolution: {region: {difference: [{rectangle: 2, at: [3, 0]}, {rectangle: 1, at: [3, "
      "0]}]}}");
  EXPECT_EQ(ring.profile.size(), 4u);
  EXPECT_EQ(ring.more_loops.size(), 1u);
  const auto beam = shape<Sweep>("sweep: {region: {rectangle: 1}, path: [[0,0,0], [4,0,0]]}");
  EXPECT_EQ(beam.profile.size(), 4u);
  const auto sheet =
      shape<FlatPolygon>("polygon: {region: {difference: [{rectangle: 2}, {rectangle: 1}]}}");
  ASSERT_EQ(sheet.loops.size(), 2u);
  EXPECT_EQ(sheet.loops[0][0], Vec3(-1, -1, 0));
}

/// One body each; what is drawn on them is drawn once.
TEST(YamlScene, FlatRegionsInPiecesAreSeveralSheets) {
  const Scene s = scene(
      "bodies:\n  - {polygon: {region: {difference: [{rectangle: 2}, {rectangle: [1, 3]}]}}, at: "
      "[0, 0, 5], "
      "pen: 3, patterns: [{points: [[0,0,0], [1,0,0]]}]}\n");
  ASSERT_EQ(s.bodies.size(), 2u);
  std::size_t patterns = 0;
  for (const Body& b : s.bodies) {
    EXPECT_EQ(std::get<FlatPolygon>(*b.shape).loops.size(), 1u);
    EXPECT_EQ(b.placement.offset, Vec3(0, 0, 5));
    EXPECT_EQ(b.pen, 3);
    patterns += b.patterns.size();
  }
  EXPECT_EQ(patterns, 1u);
}

TEST(YamlScene, Faces) {
  const auto solid = shape<Mesh>(
      "polyhedron: {vertices: [[0,0,0], [4,0,0], [0,4,0], [1,1,0], [2,1,0], [1,2,0], [0,0,4]], "
      "faces: "
      "[{outline: [0, 2, 1], holes: [[3, 4, 5]]}, [0, 1, 6]]}");
  ASSERT_EQ(solid.polyhedron.face_count(), 2u);
  ASSERT_EQ(solid.polyhedron.loop_ends.size(), 3u);
  EXPECT_EQ(solid.polyhedron.loop(1)[2], 5u);
  EXPECT_EQ(solid.polyhedron.loop(2)[2], 6u);
  EXPECT_EQ(solid.lines, (std::vector<int>{2, 2}));
  const auto sheet = shape<FlatPolygon>(
      "polygon: {outline: [[0,0,1], [4,0,1], [4,4,1]], holes: [[[2,1,1], [3,1,1], [3,2,1]]]}");
  EXPECT_EQ(sheet.loops.size(), 2u);
  EXPECT_EQ(shape<FlatPolygon>("polygon: [[0,0,1], [4,0,1], [4,4,1]]").loops[0][2], Vec3(4, 4, 1));
}

TEST(YamlScene, Looks) {
  const Body b = body(
      "box: 1, name: house, density: 0.5, shading: smooth, pen: 3, patterns: "
      "[{points: [[0,0,1], [1,0,1], [1,1,1]], closed: true, pen: 2}]");
  EXPECT_EQ(b.name, "house");
  EXPECT_EQ(b.density_factor, 0.5);
  EXPECT_EQ(b.shading, Shading::smooth);
  EXPECT_EQ(b.pen, 3);
  ASSERT_EQ(b.patterns.size(), 1u);
  EXPECT_EQ(b.patterns[0].points.size(), 4u);
  EXPECT_EQ(b.patterns[0].points[3], b.patterns[0].points[0]);
  EXPECT_EQ(b.patterns[0].pen, 2);
  EXPECT_EQ(b.place.line, 2);
  EXPECT_EQ(b.place.column, 5);
}

TEST(YamlScene, RoundShapesAreSmoothUnlessTold) {
  EXPECT_EQ(body("sphere: 1").shading, Shading::smooth);
  EXPECT_EQ(body("cylinder: {radius: 1, height: 1}").shading, Shading::smooth);
  EXPECT_EQ(body("cylinder: {radius: 1, height: 1, sides: 20}").shading, Shading::flat);
  EXPECT_EQ(body("sphere: 1, shading: flat").shading, Shading::flat);
  EXPECT_EQ(body("box: 1").shading, Shading::flat);
}

TEST(YamlScene, Segments) {
  const Scene s = scene(
      "segments:\n  - {from: [0, 0, 0], to: [1, 2, 3], pen: 2}\n"
      "  - {points: [[0, 0, 0], [1, 0, 0], [1, 1, 0]], closed: true}\n");
  ASSERT_EQ(s.segments.size(), 4u);
  EXPECT_EQ(s.segments[0].to, Vec3(1, 2, 3));
  EXPECT_EQ(s.segments[0].pen, 2);
  EXPECT_EQ(s.segments[3].from, Vec3(1, 1, 0));
  EXPECT_EQ(s.segments[3].to, Vec3(0, 0, 0));
}

TEST(YamlScene, TransformKeysApplyScaleMirrorRotateAt) {
  // however they are written
  const Body b = body("box: 1, at: [10, 0, 0], rotate: 90, mirror: x, scale: [2, 3, 4]");
  EXPECT_EQ(b.placement(Vec3(1, 0, 0)), Vec3(10, -2, 0));
  EXPECT_EQ(b.placement(Vec3(0, 1, 0)), Vec3(7, 0, 0));
  EXPECT_EQ(b.placement(Vec3(0, 0, 1)), Vec3(10, 0, 4));
}

TEST(YamlScene, TransformListsApplyFromFirstToLast) {
  const Body b = body("box: 1, transform: [{at: [1, 0, 0]}, {rotate: 90}, {scale: 2}]");
  EXPECT_EQ(b.placement(Vec3(0)), Vec3(0, 2, 0));
}

TEST(YamlScene, RightAnglesAreExact) {
  EXPECT_EQ(body("box: 1, rotate: [90, 0, 0]").placement(Vec3(0, 1, 0)), Vec3(0, 0, 1));
  EXPECT_EQ(body("box: 1, rotate: [0, 90, 0]").placement(Vec3(0, 0, 1)), Vec3(1, 0, 0));
  EXPECT_EQ(body("box: 1, rotate: [0, 0, 90]").placement(Vec3(1, 0, 0)), Vec3(0, 1, 0));
  EXPECT_EQ(body("box: 1, rotate: {axis: [0, 0, -2], angle: 450}").placement(Vec3(1, 0, 0)),
            Vec3(0, -1, 0));
  // about x, then y, then z
  EXPECT_EQ(body("box: 1, rotate: [90, 90, 0]").placement(Vec3(0, 1, 0)), Vec3(1, 0, 0));
  EXPECT_EQ(body("box: 1, mirror: z").placement(Vec3(1, 2, 3)), Vec3(1, 2, -3));
}

TEST(YamlScene, TurnsAboutAnyAxisKeepItAndLengths) {
  const Affine a = body("box: 1, rotate: {axis: [1, 1, 1], angle: 120}").placement;
  expect_near(a(Vec3(1, 0, 0)), Vec3(0, 1, 0));
  expect_near(a(Vec3(0, 1, 0)), Vec3(0, 0, 1));
  const Affine tilted = body("box: 1, rotate: {axis: [1, -2, 0.5], angle: 33}").placement;
  expect_near(tilted(Vec3(1, -2, 0.5)), Vec3(1, -2, 0.5));
  expect_near(glm::transpose(tilted.linear) * tilted.linear * Vec3(1, 2, 3), Vec3(1, 2, 3));
  EXPECT_NEAR(glm::determinant(tilted.linear), 1, 1e-12);
}

TEST(YamlScene, MirrorsAcrossAnyDirection) {
  const Affine a = body("box: 1, mirror: [1, 1, 0]").placement;
  expect_near(a(Vec3(1, 0, 0)), Vec3(0, -1, 0));
  EXPECT_NEAR(glm::determinant(a.linear), -1, 1e-12);
}

TEST(YamlScene, LinearArraysStepAndShareTheShape) {
  const Scene s =
      scene("bodies:\n  - {box: 1, at: [5, 0, 0], array: {linear: {count: 4, step: [2, 0, 1]}}}");
  ASSERT_EQ(s.bodies.size(), 4u);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(s.bodies[i].placement.offset, Vec3(5 + 2 * i, 0, i));
    EXPECT_EQ(s.bodies[i].shape, s.bodies[0].shape);
  }
}

TEST(YamlScene, PolarArraysGoRound) {
  const Scene s =
      scene("bodies:\n  - {box: 1, at: [5, 0, 0], array: {polar: {count: 4, center: [1, 0, 0]}}}");
  ASSERT_EQ(s.bodies.size(), 4u);
  EXPECT_EQ(s.bodies[1].placement.offset, Vec3(1, 4, 0));
  EXPECT_EQ(s.bodies[2].placement.offset, Vec3(-3, 0, 0));
  EXPECT_EQ(s.bodies[3].placement(Vec3(1, 0, 0)), Vec3(1, -5, 0));  // copies turn, too
  const Scene fan =
      scene("bodies:\n  - {box: 1, at: [0, 2, 0], array: {polar: {count: 3, step: 90, axis: x}}}");
  EXPECT_EQ(fan.bodies[1].placement.offset, Vec3(0, 0, 2));
  EXPECT_EQ(fan.bodies[2].placement.offset, Vec3(0, -2, 0));
}

TEST(YamlScene, ListsOfArraysNest) {
  const Scene s = scene(
      "bodies:\n  - {box: 1, array: [{linear: {count: 3, step: [1, 0, 0]}}, "
      "{linear: {count: 2, step: [0, 10, 0]}}]}");
  ASSERT_EQ(s.bodies.size(), 6u);
  EXPECT_EQ(s.bodies[2].placement.offset, Vec3(2, 0, 0));
  EXPECT_EQ(s.bodies[3].placement.offset, Vec3(0, 10, 0));
  EXPECT_EQ(s.bodies[5].placement.offset, Vec3(2, 10, 0));
}

TEST(YamlScene, GroupsHandDown) {
  const Scene s = scene(
      "bodies:\n"
      "  - group:\n"
      "      - {box: 1, at: [1, 0, 0], density: 0.5}\n"
      "      - {sphere: 1, shading: flat, pen: 4, name: ball}\n"
      "      - group: [{box: 2, at: [0, 0, 1]}]\n"
      "        rotate: 180\n"
      "    at: [0, 10, 0]\n"
      "    scale: 2\n"
      "    density: 0.5\n"
      "    shading: smooth\n"
      "    pen: 2\n"
      "    name: yard\n"
      "    array: {linear: {count: 2, step: [100, 0, 0]}}\n");
  ASSERT_EQ(s.bodies.size(), 6u);
  EXPECT_EQ(s.bodies[0].placement.offset, Vec3(2, 10, 0));
  EXPECT_EQ(s.bodies[0].density_factor, 0.25);
  EXPECT_EQ(s.bodies[0].shading, Shading::smooth);
  EXPECT_EQ(s.bodies[0].pen, 2);
  EXPECT_EQ(s.bodies[0].name, "yard");
  EXPECT_EQ(s.bodies[1].shading, Shading::flat);
  EXPECT_EQ(s.bodies[1].pen, 4);
  EXPECT_EQ(s.bodies[1].name, "ball");
  EXPECT_EQ(s.bodies[2].placement(Vec3(1, 0, 0)), Vec3(-2, 10, 2));
  EXPECT_EQ(s.bodies[3].placement.offset, Vec3(102, 10, 0));
  EXPECT_EQ(s.bodies[3].shape, s.bodies[0].shape);
}

/// The tree as text: + union, - difference, * intersection, bodies by their numbers.
std::string tree_of(const Solid& solid, std::uint32_t at = 0) {
  const SolidNode& node = solid.nodes[at];
  if (node.operation == SetOperation::operand) return std::to_string(node.body);
  std::string text(1, " +-*"[static_cast<int>(node.operation)]);
  text += '(';
  for (std::uint32_t i = at + 1; i < node.end; i = solid.nodes[i].end) {
    if (i > at + 1) text += ' ';
    text += tree_of(solid, i);
  }
  text += ')';
  return text;
}

TEST(YamlScene, SolidsAreTreesOfBodies) {
  const Scene made = scene(
      "define:\n"
      "  hole: {cylinder: {radius: 1, height: 2}}\n"
      "bodies:\n"
      "  - box: 1\n"
      "  - name: plate\n"
      "    density: 0.5\n"
      "    at: [0, 0, 3]\n"
      "    difference:\n"
      "      - box: 4\n"
      "      - {use: hole, array: {linear: {count: 3, step: [1, 0, 0]}}}\n"
      "      - group: [{box: 1}, {intersection: [{box: 2, density: 0.5}, {sphere: 1}]}]\n"
      "  - {union: [{box: 1}], array: {linear: {count: 2, step: [0, 5, 0]}}}\n");
  ASSERT_EQ(made.solids.size(), 3u);
  EXPECT_EQ(tree_of(made.solids[0]), "-(1 +(2 3 4) +(5 *(6 7)))");
  EXPECT_EQ(tree_of(made.solids[1]), "+(8)");
  EXPECT_EQ(tree_of(made.solids[2]), "+(9)");
  EXPECT_EQ(made.solids[0].name, "plate");
  EXPECT_EQ(made.bodies[6].density_factor, 0.25);
  EXPECT_EQ(made.bodies[4].placement.offset, Vec3(2, 0, 3));
  EXPECT_EQ(made.bodies[2].shape, made.bodies[4].shape);
  EXPECT_EQ(made.bodies[9].placement.offset, Vec3(0, 5, 0));
}

TEST(YamlScene, DefinitionsAreUsedManyTimesAndShareShapes) {
  const Scene s = scene(
      "define:\n"
      "  tower: [{use: room}, {use: room, at: [0, 0, 3], name: loft}]\n"  // of what comes later,
                                                                          // too
      "  room: {box: 3, at: [1, 0, 0]}\n"
      "bodies:\n"
      "  - use: tower\n"
      "  - use: tower\n"
      "    at: [10, 0, 0]\n");
  ASSERT_EQ(s.bodies.size(), 4u);
  std::set<const Shape*> shapes;
  for (const Body& b : s.bodies) shapes.insert(b.shape.get());
  EXPECT_EQ(shapes.size(), 1u);
  EXPECT_EQ(s.bodies[3].placement.offset, Vec3(11, 0, 3));
  EXPECT_EQ(s.bodies[0].name, "room");
  EXPECT_EQ(s.bodies[1].name, "loft");
}

TEST(YamlScene, AliasesRepeatWhatTheyName) {
  const Scene s = scene("bodies:\n  - &a {box: 1}\n  - *a\n");
  EXPECT_EQ(s.bodies.size(), 2u);
}

TEST(YamlScene, NumbersAsPeopleWriteThem) {
  EXPECT_EQ(shape<Box>("box: [+1, .5, 2.]").size, Vec3(1, 0.5, 2));
  EXPECT_EQ(shape<Box>("box: [1e-2, 1E3, 0.1]").size, Vec3(0.01, 1000, 0.1));
}

TEST(YamlScene, CopiesUpToTheLimit) {
  const Scene s = scene(
      "bodies:\n  - {box: 1, array: [{linear: {count: 1000, step: [1, 0, 0]}}, "
      "{linear: {count: 100, step: [0, 1, 0]}}]}");
  EXPECT_EQ(s.bodies.size(), 100000u);
}

}  // namespace
}  // namespace overstrike
