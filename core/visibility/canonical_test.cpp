#include "core/visibility/canonical.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>

#include "core/geometry/direction.h"
#include "core/shading/density_law.h"
#include "core/visibility/clip.h"
#include "core/visibility/depth.h"
#include "core/visibility/view.h"

namespace overstrike {
namespace {

ShapePtr shape(Shape s) { return std::make_shared<const Shape>(std::move(s)); }

Body body(ShapePtr s, const Affine& placement = {}) {
  Body b;
  b.shape = std::move(s);
  b.placement = placement;
  return b;
}

struct Canon {
  Canonical canonical;
  std::vector<std::string> warnings;
};
Canon canon(const Scene& scene, double chord_cells = 0.05) {
  std::vector<Diagnostic> warnings;
  Canon result;
  result.canonical = canonicalize(scene, make_view(scene, {}), chord_cells, warnings);
  for (const Diagnostic& d : warnings) result.warnings.push_back(to_string(d));
  return result;
}

Affine turn(std::mt19937_64& random, const Vec3& offset = Vec3(0.0)) {
  std::uniform_real_distribution<double> u(-1, 1);
  const Vec3 x = unit(Vec3(u(random), u(random), u(random)));
  const Vec3 y = unit(glm::cross(x, Vec3(u(random), u(random), u(random))));
  return {Mat3(x, y, glm::cross(x, y)), offset};
}

double volume(const Canonical& c, const CanonicalBody& b) {
  double six = 0;
  for (Index f = b.first_face; f < b.end_face; ++f)
    for (Index l = c.faces[f].first_loop; l < c.faces[f].end_loop; ++l)
      for (std::size_t i = 1; i + 1 < c.loop(l).size(); ++i)
        six += glm::dot(c.vertices[c.loop(l)[0]],
                        glm::cross(c.vertices[c.loop(l)[i]], c.vertices[c.loop(l)[i + 1]]));
  return six / 6;
}
double volume(const Canonical& c) {
  double sum = 0;
  for (const CanonicalBody& b : c.bodies) sum += volume(c, b);
  return sum;
}

/// Every side of every loop is in one winged edge, on the side that it says, and the faces' planes
/// hold their vertices and look outwards.
void expect_sound(const Canonical& c) {
  std::map<std::pair<Index, Index>, int> sides;
  for (const CanonicalFace& face : c.faces) {
    ASSERT_LT(face.plane, c.planes.size());
    for (Index l = face.first_loop; l < face.end_loop; ++l)
      for (std::size_t i = 0; i < c.loop(l).size(); ++i) {
        const Vec3 p = c.vertices[c.loop(l)[i]];
        const Plane& plane = c.planes[face.plane];
        EXPECT_NEAR(glm::dot(plane.normal, p), plane.offset, 1e-12 * (1 + max_norm(p)));
        ++sides[{c.loop(l)[i], c.loop(l)[(i + 1) % c.loop(l).size()]}];
      }
  }
  for (const CanonicalBody& b : c.bodies)
    for (Index e = b.first_edge; e < b.end_edge; ++e) {
      const WingedEdge& edge = c.edges[e];
      ASSERT_GE(edge.left, b.first_face);
      ASSERT_LT(edge.left, b.end_face);
      EXPECT_EQ(--(sides[{edge.from, edge.to}]), 0);
      if (edge.right != kNone) {
        EXPECT_EQ(--(sides[{edge.to, edge.from}]), 0);
      }
      EXPECT_TRUE(edge.right != kNone || !b.closed);
    }
  for (const auto& [side, count] : sides) EXPECT_EQ(count, 0);
}

std::size_t creases(const Canonical& c) {
  return std::count_if(c.edges.begin(), c.edges.end(),
                       [](const WingedEdge& e) { return e.crease; });
}

TEST(Canonical, ABox) {
  Scene scene;
  scene.bodies.push_back(body(shape(Box{{2, 3, 4}}), {Mat3(1.0), {1, 0, 0}}));
  const Canonical c = canon(scene).canonical;
  expect_sound(c);
  EXPECT_EQ(c.vertices.size(), 8u);
  EXPECT_EQ(c.faces.size(), 6u);
  EXPECT_EQ(c.edges.size(), 12u);
  EXPECT_EQ(c.planes.size(), 6u);
  EXPECT_EQ(creases(c), 12u);
  EXPECT_TRUE(c.bodies[0].closed);
  EXPECT_EQ(volume(c), 24);
  EXPECT_TRUE(c.corner_normals.empty());
}

TEST(Canonical, MirroredBodiesAreNotInsideOut) {
  Scene scene;
  scene.camera.look_at = Vec3(0.0);  // the origin of the view
  Mat3 mirror(1.0);
  mirror[0][0] = -2;
  scene.bodies.push_back(body(shape(Box{}), {mirror, {0, 0, 0}}));
  scene.bodies.push_back(body(shape(Ellipsoid{}), {mirror, {9, 0, 0}}));
  scene.bodies[1].shading = Shading::smooth;
  const Canonical c = canon(scene).canonical;
  expect_sound(c);
  EXPECT_EQ(volume(c, c.bodies[0]), 2);
  EXPECT_NEAR(volume(c, c.bodies[1]), 8 * M_PI / 3, 0.1);
  for (Index f = c.bodies[1].first_face; f < c.bodies[1].end_face; ++f) {
    const Index first = c.faces[f].first_loop == 0 ? 0 : c.loop_ends[c.faces[f].first_loop - 1];
    for (Index i = first; i < c.loop_ends[c.faces[f].first_loop]; ++i) {
      const Vec3 out = c.vertices[c.corners[i]] - Vec3(9, 0, 0);
      const Vec3 truth = unit(Vec3(out.x / 4, out.y, out.z));
      EXPECT_LT(max_norm(c.corner_normals[i] - truth), 1e-12);
    }
  }
}

TEST(Canonical, RoundShapesHaveCreasesOnlyAtTheirRims) {
  Scene scene;
  scene.bodies.push_back(body(shape(Ellipsoid{})));
  EXPECT_EQ(creases(canon(scene, 5).canonical), 0u);
  EXPECT_EQ(creases(canon(scene, 0.1).canonical), 0u);
  scene.bodies[0] = body(shape(Frustum{}));
  const Canonical cylinder = canon(scene).canonical;
  expect_sound(cylinder);
  EXPECT_EQ(3 * creases(cylinder), 2 * cylinder.edges.size());
  scene.bodies[0] = body(shape(Frustum{1, 0, 2, 0}));
  const Canonical cone = canon(scene).canonical;
  EXPECT_EQ(2 * creases(cone), cone.edges.size());
  scene.bodies[0] = body(shape(Frustum{1, 1, 1, 6}));
  EXPECT_EQ(creases(canon(scene).canonical), 18u);
}

TEST(Canonical, GluedTurnedBoxesShareThePlaneBetweenThem) {
  std::mt19937_64 random(21);
  std::uniform_real_distribution<double> u(0.2, 4);
  for (int i = 0; i < 500; ++i) {
    const Vec3 a(u(random), u(random), u(random)), b(u(random), u(random), u(random));
    const Affine place = turn(random, Vec3(u(random), u(random), u(random)) * 100.0);
    Scene scene;
    scene.bodies.push_back(body(shape(Box{a}), place));
    scene.bodies.push_back(body(shape(Box{b}), place * Affine{Mat3(1.0), {0, 0, a.z}}));
    EXPECT_EQ(canon(scene).canonical.planes.size(), 11u);
    scene.bodies[1].placement = place * Affine{Mat3(1.0), {0, 0, a.z * (1 + 1e-6)}};
    EXPECT_EQ(canon(scene).canonical.planes.size(), 12u);
  }
}

TEST(Canonical, DoesNotDependOnTheOrderOfBodies) {
  std::mt19937_64 random(8);
  std::uniform_int_distribution<int> grid(-3, 3);
  Scene scene;
  const Affine place = turn(random, {1, 2, 3});
  for (int i = 0; i < 60; ++i) {
    const Vec3 at(grid(random), grid(random), grid(random));
    scene.bodies.push_back(body(shape(Box{}), place * Affine{Mat3(1.0), at}));
    scene.bodies.back().pen = i;
  }
  const auto planes_of = [](const Canonical& c) {
    std::map<int, std::vector<double>> planes;
    for (const CanonicalBody& b : c.bodies)
      for (Index f = b.first_face; f < b.end_face; ++f) {
        const Plane& p = c.planes[c.faces[f].plane];
        for (const double d : {p.normal.x, p.normal.y, p.normal.z, p.offset})
          planes[b.pen].push_back(d);
      }
    return planes;
  };
  const auto first = planes_of(canon(scene).canonical);
  for (int i = 0; i < 5; ++i) {
    std::shuffle(scene.bodies.begin(), scene.bodies.end(), random);
    EXPECT_EQ(planes_of(canon(scene).canonical), first);
  }
}

TEST(Canonical, FinerChordsGiveMoreFacetsAndNearOnesToo) {
  Scene scene;
  scene.bodies.push_back(body(shape(Ellipsoid{})));
  EXPECT_LT(canon(scene, 1).canonical.faces.size(), canon(scene, 0.1).canonical.faces.size());
  scene.bodies.push_back(body(scene.bodies[0].shape, {Mat3(1.0), {20, 0, 0}}));
  scene.camera.eye = Vec3(-5, 0, 0);
  scene.camera.target = Vec3(20, 0, 0);
  const Canonical c = canon(scene).canonical;
  EXPECT_GT(c.bodies[0].end_face - c.bodies[0].first_face,
            2 * (c.bodies[1].end_face - c.bodies[1].first_face));
}

TEST(Canonical, AnEyeInsideASphereDoesNotExplode) {
  Scene scene;
  scene.bodies.push_back(body(shape(Ellipsoid{{10, 10, 10}})));
  scene.camera.eye = Vec3(0, 0, 0);
  scene.camera.target = Vec3(1, 0, 0);
  EXPECT_LT(canon(scene).canonical.faces.size(), 300'000u);
}

TEST(Canonical, WarningsNameTheBodyAndItsPlace) {
  Mesh mesh;
  for (const Vec3 v : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}) mesh.polyhedron.add_vertex(v);
  mesh.polyhedron.add_face({0, 1, 2});
  Scene scene;
  scene.bodies.push_back(body(shape(mesh)));
  scene.bodies[0].name = "sail";
  scene.bodies[0].place = {"boat.yaml", 7, 3};
  const Canon result = canon(scene);
  ASSERT_EQ(result.warnings.size(), 1u);
  EXPECT_THAT(result.warnings[0],
              testing::MatchesRegex("boat.yaml:7:3: warning: [a-z]+ 'sail': open: 3 edges have one "
                                    "face only: .0, 0, 0. to .1, 0, 0., .*"));
  EXPECT_FALSE(result.canonical.bodies[0].closed);
  scene.bodies[0] = body(shape(FlatPolygon{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}}));
  EXPECT_TRUE(canon(scene).warnings.empty());
}

TEST(Canonical, TellsWhatToleranceWasReached) {
  Scene scene;
  scene.bodies = {body(shape(Frustum{})), body(shape(Box{}))};
  scene.bodies[0].name = "tank";
  EXPECT_THAT(canon(scene, 1e-3).warnings, testing::IsEmpty());
  EXPECT_THAT(canon(scene, 1e-300).warnings,
              testing::ElementsAre(testing::MatchesRegex(
                  ".*cylinder 'tank': drawn to [0-9.]+e-0[5-6] cells instead of 1e-300: "
                  "finer would take too many facets")));
}

TEST(Canonical, FlattenedBodiesKeepTheFacesThatHaveAnArea) {
  Scene scene;
  scene.camera.look_at = Vec3(0.0);  // the origin of the view
  Mat3 press(1.0);
  press[2][2] = 0;
  scene.bodies.push_back(body(shape(Box{}), {press, {0, 0, 1}}));
  const Canon result = canon(scene);
  EXPECT_EQ(result.canonical.faces.size(), 2u);
  EXPECT_EQ(result.canonical.planes.size(), 1u);
  EXPECT_EQ(result.canonical.planes[0].offset, 1);
  ASSERT_FALSE(result.warnings.empty());
  EXPECT_EQ(result.warnings[0], "warning: box: flattened by its place");
  scene.bodies[0].placement.linear = Mat3(0.0);
  EXPECT_EQ(canon(scene).canonical.faces.size(), 0u);
}

/// Where the last place of a coordinate is larger than the body itself.
TEST(Canonical, ASmallBodyFarAwayKeepsItsFaces) {
  std::mt19937_64 random(4);
  Scene scene;
  for (const double far : {0.0, 1e6, 1e10, 1e14}) {
    Affine placement = turn(random, Vec3(far, -far, far / 2));
    for (int c = 0; c < 3; ++c) placement.linear[c] *= 1e-6;
    scene.bodies = {body(shape(Box{}), placement)};
    const Canon result = canon(scene);
    EXPECT_EQ(result.canonical.planes.size(), 6u) << far;
    EXPECT_TRUE(result.warnings.empty()) << far;
  }
}

TEST(Canonical, PatternsAndSegmentsArePlaced) {
  Scene scene;
  scene.camera.look_at = Vec3(0.0);  // the origin of the view
  scene.bodies.push_back(body(shape(Box{}), {Mat3(2.0), {1, 0, 0}}));
  scene.bodies[0].patterns.push_back({{{0, 0, 1}, {0.25, 0, 1}}, 3});
  scene.segments.push_back({{0, 0, 0}, {1, 1, 1}, 2});
  const Canonical c = canon(scene).canonical;
  ASSERT_EQ(c.patterns.size(), 1u);
  EXPECT_EQ(c.patterns[0].points[1], Vec3(1.5, 0, 2));
  EXPECT_EQ(c.patterns[0].pen, 3);
  EXPECT_EQ(c.segments.size(), 1u);
}

/// Seen from far away on the side that is cut off.
Canonical cut(const Canonical& c, const Plane& keep) {
  return clip(c, keep, Vec4(-keep.normal, 0));
}

TEST(Clip, HalvesAddUpAndStayClosed) {
  std::mt19937_64 random(31);
  std::uniform_real_distribution<double> u(-1, 1);
  Scene scene;
  scene.bodies.push_back(body(shape(Torus{2, 0.5}), turn(random)));
  scene.bodies.push_back(body(shape(Box{}), turn(random, {1, 1, 1})));
  scene.bodies.push_back(body(shape(Frustum{}), turn(random, {-1, 0, 1})));
  scene.bodies[0].shading = Shading::smooth;
  const Canonical c = canon(scene, 1).canonical;
  for (int i = 0; i < 40; ++i) {
    const Plane keep{unit(Vec3(u(random), u(random), u(random))), u(random)};
    ASSERT_TRUE(needs_clip(c, keep));
    const Canonical a = cut(c, keep), b = cut(c, {-keep.normal, -keep.offset});
    expect_sound(a);
    for (const CanonicalBody& part : a.bodies) EXPECT_TRUE(part.closed);
    EXPECT_NEAR(volume(a) + volume(b), volume(c), 1e-12 * volume(c));
    EXPECT_FALSE(
        needs_clip(cut(a, {keep.normal, keep.offset - 1e-9}), {keep.normal, keep.offset - 1e-9}));
    EXPECT_EQ(a.corner_normals.size(), a.corners.size());
  }
}

TEST(Clip, CapsAreCutFacesThatLookToTheRemovedSide) {
  Scene scene;
  scene.camera.look_at = Vec3(0.0);  // the origin of the view
  scene.bodies.push_back(body(shape(Box{})));
  scene.bodies.push_back(body(shape(Box{}), {Mat3(1.0), {0, 0, 5}}));
  scene.bodies.push_back(body(shape(Box{}), {Mat3(1.0), {0, 0, -5}}));
  scene.segments.push_back({{3, 0, 0}, {3, 0, 1}, 4});
  scene.bodies[0].patterns.push_back({{{0.5, 0, 0}, {0.5, 0, 1}, {0.5, 0.25, 0}}, 0});
  const Canonical c = cut(canon(scene).canonical, {{0, 0, 1}, 0.25});
  ASSERT_EQ(c.bodies.size(), 2u);
  std::vector<CanonicalFace> caps;
  for (const CanonicalFace& f : c.faces)
    if (f.cut) caps.push_back(f);
  ASSERT_EQ(caps.size(), 1u);
  EXPECT_EQ(c.outward(caps[0]), Vec3(0, 0, -1));
  EXPECT_EQ(c.planes[caps[0].plane].offset, 0.25);
  ASSERT_EQ(c.segments.size(), 1u);
  EXPECT_EQ(c.segments[0].from, Vec3(3, 0, 0.25));
  ASSERT_EQ(c.patterns.size(), 1u);
  EXPECT_EQ(c.patterns[0].points.size(), 3u);
  const Canonical whole = canon(scene).canonical;
  EXPECT_FALSE(needs_clip(whole, {{0, 0, 1}, -5}));
}

/// Vertices that lie in the clip plane, where the stored plane of their face is one last place
/// beyond or before it: what is stored decides.
TEST(Clip, FacesNearlyInThePlaneAreWhereTheirPlanesAre) {
  Scene scene;
  scene.camera.look_at = Vec3(0.0);                                     // the origin of the view
  scene.bodies.push_back(body(shape(Box{}), {Mat3(1.0), {0, 0, -1}}));  // from -1 to 0
  Canonical c = canon(scene).canonical;
  const Plane keep{{0, 0, 1}, 0};
  EXPECT_TRUE(cut(c, keep).bodies.empty());
  for (Plane& p : c.planes)
    if (p.offset == 0 && p.normal.z == 1) p.offset = 0x1p-52;
  const Canonical kept = cut(c, keep);
  ASSERT_EQ(kept.bodies.size(), 1u);
  EXPECT_TRUE(kept.bodies[0].closed);
  EXPECT_EQ(std::count_if(kept.faces.begin(), kept.faces.end(),
                          [](const CanonicalFace& f) { return f.cut; }),
            1);
  const Plane turned{{0, 0, -1}, 0};
  EXPECT_TRUE(needs_clip(c, turned));
  for (Plane& p : c.planes)
    if (p.offset == 0x1p-52) p.offset = -0x1p-52;
  EXPECT_TRUE(cut(c, keep).bodies.empty());
  EXPECT_FALSE(needs_clip(c, turned));
}

/// A sheet is seen from either side; cut between a corner that faces the light and one that does
/// not, it keeps its tones.
TEST(Clip, TonesOfSheetsStayWhereTheyAre) {
  Mesh mesh;
  mesh.polyhedron.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
  mesh.polyhedron.add_face({0, 1, 2});
  mesh.polyhedron.corner_normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, -1}};
  Scene scene;
  scene.camera.look_at = Vec3(0.0);  // the origin of the view
  scene.light = Direction{0, 90};
  scene.bodies.push_back(body(std::make_shared<const Shape>(std::move(mesh))));
  scene.bodies[0].shading = Shading::smooth;
  const Canonical c = canon(scene).canonical;
  for (const double side : {1.0, -1.0}) {
    const Vec4 eye(0, side, 0, 0);
    const bool behind = side_of_eye(c.planes[c.faces[0].plane], c.faces[0].flipped, eye) < 0;
    const auto tone = [&](const Canonical& of, Index corner) {
      const Vec3 normal = of.corner_normals[corner];
      return lit_density(of, of.bodies[0], behind ? -normal : normal);
    };
    const Canonical half = clip(c, {{0, 0, 1}, 0.25}, eye);
    for (Index i = 0; i < half.corners.size(); ++i) {
      const double z = half.vertices[half.corners[i]].z;
      EXPECT_NEAR(tone(half, i), (1 - z) * tone(c, 0) + z * tone(c, 2), 0x1p-50)
          << side << ' ' << z;
    }
  }
}

/// A face may be seen from behind where an operand is inside out.
TEST(Clip, TonesOfOperandsStayWhereTheyAreFromBehind) {
  Mesh mesh;
  mesh.polyhedron.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}};
  for (const auto& face : {std::array<Index, 3>{0, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}})
    mesh.polyhedron.add_face(face);
  mesh.polyhedron.corner_normals.assign(12, Vec3(0, 0, 1));
  mesh.polyhedron.corner_normals[2] = {0, 0, -1};
  Scene scene;
  scene.camera.look_at = Vec3(0.0);  // the origin of the view
  scene.light = Direction{0, 90};
  scene.bodies.push_back(body(std::make_shared<const Shape>(std::move(mesh))));
  scene.bodies[0].shading = Shading::smooth;
  scene.solids.push_back({{{SetOperation::operand, 0, 1}}, {}, {}, 0});
  const Canonical c = canon(scene).canonical;
  const auto tone = [](const Canonical& of, Index corner) {
    return lit_density(of, of.bodies[0], -of.corner_normals[corner]);
  };
  const Canonical half = clip(c, {{0, 0, 1}, 0.25}, Vec4(0, 1, 0, 0));
  int looked_at = 0;
  for (const CanonicalFace& f : half.faces) {
    if (f.plane != c.faces[0].plane) continue;
    for (Index i = half.first_corner(f.first_loop); i < half.loop_ends[f.first_loop]; ++i) {
      const double z = half.vertices[half.corners[i]].z;
      EXPECT_NEAR(tone(half, i), (1 - z) * tone(c, 0) + z * tone(c, 2), 0x1p-50) << z;
      ++looked_at;
    }
  }
  EXPECT_EQ(looked_at, 3);
}

/// What lies in the plane is not before it, whichever side of it is seen and whatever hangs on it.
TEST(Clip, AnOpenBodyThatEndsInThePlaneEndsWithWhatLiesInIt) {
  for (const bool turned : {false, true}) {
    Mesh mesh;
    mesh.polyhedron.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
    turned ? mesh.polyhedron.add_face({0, 2, 1}) : mesh.polyhedron.add_face({0, 1, 2});
    turned ? mesh.polyhedron.add_face({0, 1, 3}) : mesh.polyhedron.add_face({1, 0, 3});
    Scene scene;
    scene.camera.look_at = Vec3(0.0);  // the origin of the view
    scene.bodies.push_back(body(std::make_shared<const Shape>(std::move(mesh))));
    const Canonical left = cut(canon(scene).canonical, {{0, 0, 1}, 0});
    ASSERT_EQ(left.bodies.size(), 1u);
    ASSERT_EQ(left.faces.size(), 1u);
    EXPECT_EQ(left.loop(0).size(), 3u);
    EXPECT_EQ(left.edges.size(), 3u);
  }
}

TEST(DensityLaw, IsNishitaAndNakamaes) {
  Scene scene;
  scene.bodies.push_back(body(shape(Box{})));
  scene.law = {0.8, 0.9, 0.85, 0.5};
  scene.light = Direction{0, 30};
  const auto shade = [&](const Vec3& outward, bool behind = false) {
    const Canonical c = canon(scene).canonical;
    for (const CanonicalFace& f : c.faces)
      if (max_norm(c.outward(f) - outward) < 1e-9) return shade_of(c, f, behind);
    return FaceShade{-1, false};
  };
  EXPECT_DOUBLE_EQ(shade({0, 0, 1}).density, 0.9 * (1 - 0.8 * 0.5));
  EXPECT_TRUE(shade({0, 0, 1}).lit);
  EXPECT_DOUBLE_EQ(shade({1, 0, 0}).density, 0.9 * (1 - 0.8 * std::sqrt(0.75)));
  EXPECT_DOUBLE_EQ(shade({0, 0, -1}).density, 0.9);
  EXPECT_FALSE(shade({0, 0, -1}).lit);
  EXPECT_FALSE(shade({0, 1, 0}).lit);
  EXPECT_DOUBLE_EQ(shade({0, 0, -1}, true).density, 0.54);
  EXPECT_FALSE(shade({0, 0, 1}, true).lit);
  scene.bodies[0].density_factor = 0.5;
  EXPECT_DOUBLE_EQ(shade({0, 0, -1}).density, 0.45);
  scene.bodies[0].density_factor = 2;
  EXPECT_EQ(shade({0, 0, -1}).density, 1);
  scene.bodies[0].density_factor = 1;
  scene.light.reset();
  EXPECT_DOUBLE_EQ(shade({0, 0, -1}).density, 0.9 * (1 - 0.8));
  EXPECT_TRUE(shade({0, 0, -1}).lit);
  const Canonical half = cut(canon(scene).canonical, {{0, 0, 1}, 0.5});
  for (const CanonicalFace& f : half.faces)
    if (f.cut) {
      EXPECT_DOUBLE_EQ(shade_of(half, f, false).density, 0.45);
    }
}

/// A line along the seam of two boxes that stand on one another far from zero looked between them:
/// their planes were one, their vertices not.
TEST(Canonicalize, BoxesOnOneAnotherShareTheSeamToTheBit) {
  std::mt19937_64 random(7);
  const auto tenths = [&](double most) {
    return std::round(std::uniform_real_distribution<double>(-10 * most, 10 * most)(random)) / 10;
  };
  for (const double far : {10.0, 1e3, 1e5})
    for (int n = 0; n < 100; ++n) {
      const Vec3 foot(tenths(far), tenths(far), tenths(far));
      const double height = 0.1 + std::fabs(tenths(3));
      Scene scene;
      scene.bodies.push_back(body(shape(Box{{2, 3, height}}), {Mat3(1), foot}));
      scene.bodies.push_back(
          body(shape(Box{{2, 2, 1.3}}), {Mat3(1), {foot.x, foot.y, foot.z + height}}));
      const Canonical c = canon(scene).canonical;
      double top = -HUGE_VAL, bottom = HUGE_VAL;
      for (Index v = c.bodies[0].first_vertex; v < c.bodies[0].end_vertex; ++v)
        top = std::max(top, c.vertices[v].z);
      for (Index v = c.bodies[1].first_vertex; v < c.bodies[1].end_vertex; ++v)
        bottom = std::min(bottom, c.vertices[v].z);
      ASSERT_EQ(top, bottom) << far << ", " << n;
    }
}

/// A quadrilateral of two corners that are all but one has no area, and a plane that says nothing:
/// its vertices were pressed into that, a unit away.
TEST(Canonicalize, AFaceWithoutAnAreaMovesNoVertices) {
  Mesh mesh;
  mesh.polyhedron.vertices = {{-1, 1 + 0x1p-52, -2}, {1, -2, 1}, {1, 1, 2},
                              {-1, 1, -2},           {2, 2, 1},  {1, -2, 2},
                              {-1, -1, 0},           {2, 2, 2}};
  for (const auto& face : {std::array<Index, 4>{0, 1, 3, 2},
                           {4, 6, 7, 5},
                           {0, 4, 5, 1},
                           {2, 3, 7, 6},
                           {0, 2, 6, 4},
                           {1, 5, 7, 3}})
    mesh.polyhedron.add_face(face);
  const std::vector<Vec3> meant = mesh.polyhedron.vertices;
  Scene scene;
  scene.bodies.push_back(body(shape(mesh)));
  scene.camera.look_at = Vec3(0.0);
  for (const Vec3& found : canon(scene).canonical.vertices) {
    double nearest = HUGE_VAL;
    for (const Vec3& p : meant) nearest = std::min(nearest, glm::distance(p, found));
    EXPECT_LT(nearest, 1e-12) << found.x << " " << found.y << " " << found.z;
  }
}

}  // namespace
}  // namespace overstrike
