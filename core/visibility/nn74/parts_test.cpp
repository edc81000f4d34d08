// The parts of NN74's method: what it refuses, planes between bodies, contours and their order,
// shadows in face coordinates, cells.
#include <gtest/gtest.h>

#include <array>
#include <span>

#include "core/drawing.h"
#include "core/visibility/nn74/conditions.h"
#include "core/visibility/nn74/light_phase.h"
#include "core/visibility/nn74/pairs.h"
#include "core/visibility/nn74/separation.h"
#include "core/visibility/nn74/test_scenes.h"

namespace overstrike::nn74 {
namespace {

using overstrike::testing::look_down;
using overstrike::testing::square_grid;
using testing::add;
using testing::Dice;
using testing::town;

struct Prepared {
  explicit Prepared(const Scene& scene, const Grid& grid = square_grid(60, 50))
      : view(make_view(scene, grid)), canonical(canonicalize(scene, view, 0.05, warnings)) {}
  std::vector<Diagnostic> warnings;
  View view;
  Canonical canonical;
};

/// The texts of a refusal, one a line; empty when the scene is drawn.
std::string refusal(const Scene& scene) {
  DrawOptions options;
  options.method = Method::nn74;
  try {
    Drawing(scene, square_grid(20, 20), options);
  } catch (const InputError& error) {
    std::string text;
    for (const Diagnostic& d : error.diagnostics()) text += to_string(d) + '\n';
    return text;
  }
  return {};
}

Body& named(Body& body, const std::string& name, int line) {
  body.name = name;
  body.place = {"scene.yaml", line, 5};
  return body;
}

TEST(Nn74Refuses, TwoThatInterpenetrate) {
  Scene scene;
  named(add(scene, Box{{1, 1, 1}}), "hall", 3);
  named(add(scene, Box{{1, 1, 1}}, {1, 0, 0}), "annexe", 4);
  named(add(scene, Frustum{.5, 0, 1, 7}, {1.3, 0, .9}), "spire", 5);
  EXPECT_EQ(refusal(scene), "scene.yaml:4:5: error: method nn74: box 'annexe' and " +
                                std::string(shape_name(*scene.bodies[2].shape)) +
                                " 'spire' interpenetrate (method line draws them)\n");
}

TEST(Nn74Refuses, EveryBodyThatIsNotConvex) {
  Scene scene;
  const Region corner{{{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}}};
  const Region frame{{{{0, 0}, {3, 0}, {3, 3}, {0, 3}}, {{1, 1}, {1, 2}, {2, 2}, {2, 1}}}};
  named(add(scene, Extrusion{corner, 1}), "corner", 3);
  named(add(scene, Extrusion{frame, 1}, {5, 0, 0}), "frame", 4);
  named(add(scene, FlatPolygon{{{{0, 5, 0}, {2, 5, 0}, {1, 5, .5}, {0, 5, 2}}}}), "dart", 5);
  named(add(scene, Torus{2, .5}, {0, -9, 1}), "ring", 6);
  EXPECT_EQ(
      refusal(scene),
      "scene.yaml:3:5: error: method nn74: extrusion 'corner' is not convex: a face is not "
      "(method line draws it)\n"
      "scene.yaml:4:5: error: method nn74: extrusion 'frame' is not convex: a face has a hole "
      "(method line draws it)\n"
      "scene.yaml:5:5: error: method nn74: polygon 'dart' is not convex (method line draws it)\n"
      "scene.yaml:6:5: error: method nn74: torus 'ring' is not convex (method line draws it)\n");
}

TEST(Nn74Refuses, OpenBodies) {
  Scene scene;
  Mesh tent;
  for (const Vec3& p :
       {Vec3(0, 0, 1), Vec3(1, 0, 1), Vec3(0, 1, 0), Vec3(1, 1, 0), Vec3(0, -1, 0), Vec3(1, -1, 0)})
    tent.polyhedron.add_vertex(p);
  tent.polyhedron.add_face({0, 1, 3, 2});
  tent.polyhedron.add_face({1, 0, 4, 5});
  named(add(scene, tent), "tent", 9);
  EXPECT_EQ(refusal(scene), "scene.yaml:9:5: error: method nn74: " +
                                std::string(shape_name(*scene.bodies[0].shape)) +
                                " 'tent' is neither closed nor one flat polygon (method line draws "
                                "it)\n");
}

/// All four faces of the tetrahedron lie in one plane.
TEST(Nn74Refuses, BodiesFoldedOntoThemselves) {
  Scene scene;
  Mesh folded;
  for (const Vec3& p : {Vec3(0, 0, 1), Vec3(2, 0, 1), Vec3(2, 2, 1), Vec3(0, 2, 1)})
    folded.polyhedron.add_vertex(p);
  for (const auto& face : {std::array<Index, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
    folded.polyhedron.add_face(std::span<const Index>(face));
  named(add(scene, folded), "napkin", 9);
  EXPECT_EQ(refusal(scene), "scene.yaml:9:5: error: method nn74: " +
                                std::string(shape_name(*scene.bodies[0].shape)) +
                                " 'napkin' is closed but has no inside (method line draws it)\n");
}

TEST(Nn74Refuses, SmoothBodies) {
  Scene scene;
  named(add(scene, Frustum{1, 1, 2, 0}), "column", 7).shading = Shading::smooth;
  EXPECT_EQ(refusal(scene), "scene.yaml:7:5: error: method nn74: " +
                                std::string(shape_name(*scene.bodies[0].shape)) +
                                " 'column' is smooth; nn74 draws flat shading only (method line "
                                "draws it)\n");
}

TEST(Nn74Refuses, CopiesOnce) {
  Scene scene;
  for (int i = 0; i < 3; ++i) named(add(scene, Torus{2, .5}, {9.0 * i, 0, 1}), "ring", 6);
  EXPECT_EQ(refusal(scene),
            "scene.yaml:6:5: error: method nn74: torus 'ring' is not convex (method line draws "
            "it)\n");
}

TEST(Nn74Refuses, BodiesInAGroundThatIsSeen) {
  Scene scene;
  named(add(scene, Box{{1, 1, 1}}, {0, 0, -.25}), "cellar", 2);
  scene.ground_z = 0;
  EXPECT_EQ(refusal(scene),
            "scene.yaml:2:5: error: method nn74: box 'cellar' reaches below the ground (method "
            "line draws it)\n");
  scene.camera.from.elevation_deg = -20;
  EXPECT_EQ(refusal(scene), "") << "from below there is no ground";
}

/// By one last place: it is not seen.
TEST(Nn74Refuses, ASheetBelowAGroundThatIsSeen) {
  Scene scene;
  named(add(scene, FlatPolygon{{{{0, 0, 1}, {2, 0, 1}, {0, 2, 1}}}}), "mat", 4);
  scene.ground_z = 1;
  EXPECT_EQ(refusal(scene), "");
  scene.ground_z = 1 + 0x1p-52;
  EXPECT_EQ(refusal(scene),
            "scene.yaml:4:5: error: method nn74: polygon 'mat' reaches below the ground (method "
            "line draws it)\n");
}

TEST(Nn74Draws, BodiesThatTouch) {
  Scene scene;
  add(scene, Box{{1, 1, 1}});
  add(scene, Box{{1, 1, 1}}, {1, 0, 0});
  add(scene, Box{{1, 1, 1}}, {.3, .2, 1}, 33);
  add(scene, Frustum{.5, 0, 1, 5}, {1, 1, 0});
  add(scene, FlatPolygon{{{{-.2, -.5, .2}, {.2, -.5, .2}, {0, -.5, .6}}}});
  add(scene, FlatPolygon{{{{-.2, -.5, .3}, {.2, -.5, .3}, {0, -.5, .7}}}});
  for (const double turn : {0.0, 10.0, 77.0}) {
    Scene turned = scene;
    const Mat3 round(Vec3(cos_deg(turn), sin_deg(turn), 0), Vec3(-sin_deg(turn), cos_deg(turn), 0),
                     Vec3(0, 0, 1));
    for (Body& body : turned.bodies)
      body.placement = Affine{round, Vec3(3, 7, .1)} * body.placement;
    EXPECT_EQ(refusal(turned), "") << turn;
  }
}

/// Law: a plane between two bodies has all of each on its side; and two that share a point inside
/// have none.
TEST(Nn74Separation, HasEachBodyOnItsSide) {
  int apart = 0, together = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    Dice dice(seed);
    Scene scene;
    add(scene, Box{{1, 1, 1}}, {0, 0, -.5}, dice.between(0, 360));
    const Vec3 at(dice.between(-1.2, 1.2), dice.between(-1.2, 1.2), dice.between(-1.2, 1.2));
    testing::tilt(add(scene, Frustum{.6, .2, 1, 5}, at, dice.between(0, 360)),
                  dice.between(0, 360));
    const Prepared p(scene);
    const Canonical& c = p.canonical;
    const auto plane = separate(c, c.bodies[0], c, c.bodies[1]);
    if (!plane) {
      ++together;
      continue;
    }
    ++apart;
    for (int b : {0, 1})
      for (Index v = c.bodies[b].first_vertex; v < c.bodies[b].end_vertex; ++v) {
        const double h = glm::dot(plane->normal, c.vertices[v]) - plane->offset;
        EXPECT_GE(b == 0 ? h : -h, -4 * kTouch) << seed;
      }
  }
  EXPECT_GT(apart, 100);
  EXPECT_GT(together, 100);
}

TEST(Nn74Contour, OfACubeSeenFromACornerIsAHexagon) {
  Scene scene;
  add(scene, Box{{1, 1, 1}});
  scene.camera.from = {45, 35};
  const Prepared p(scene);
  const ConvexView view = view_from_eye(p.canonical, p.view);
  ASSERT_EQ(view.bodies.size(), 1u);
  EXPECT_EQ(view.faces.size(), 3u);
  EXPECT_EQ(view.bodies[0].sides.size(), 6u);
  std::size_t interior = 0;
  for (const Side& side : view.sides) interior += side.across != kNone;
  EXPECT_EQ(interior, 6u) << "three interior edges, from both faces";
}

/// Law: contours turn one way, and each side starts where the one before ends.
TEST(Nn74Contour, IsConvexAndClosed) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const Prepared p(town(seed));
    const ConvexView view = view_from_eye(p.canonical, p.view);
    for (const Contour& contour : view.bodies)
      for (std::size_t i = 0; i < contour.sides.size(); ++i) {
        const Side& side = view.sides[contour.sides[i]];
        const Side& next = view.sides[contour.sides[(i + 1) % contour.sides.size()]];
        EXPECT_EQ(side.to, next.from);
        const Vec2 a = view.points[side.to].at - view.points[side.from].at;
        const Vec2 b = view.points[next.to].at - view.points[next.from].at;
        EXPECT_GE(a.x * b.y - a.y * b.x, -1e-9) << seed;
      }
  }
}

/// Law: what contours tell of the order, by (7)(8) or (9)(10), a plane between the bodies tells
/// too.
TEST(Nn74Pairs, ContoursAndPlanesTellOneOrder) {
  int told = 0;
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Prepared p(town(seed));
    const ConvexView eye = view_from_eye(p.canonical, p.view);
    const ConvexView light = view_from_light(p.canonical, LightFrame(*p.canonical.light));
    for (const ConvexView* view : {&eye, &light})
      for (Index a = 0; a < view->bodies.size(); ++a)
        for (Index b = a + 1; b < view->bodies.size(); ++b) {
          const Overlap overlap = overlap_of(*view, a, *view, b);
          if (overlap == Overlap::independent) continue;
          const int front = front_by_contours(*view, a, *view, b, overlap);
          if (front == 0) continue;
          ++told;
          EXPECT_EQ(front, front_by_separation(*view, a, *view, b)) << seed << ' ' << a << ' ' << b;
          EXPECT_EQ(front, -front_of(*view, b, *view, a, overlap_of(*view, b, *view, a)));
        }
  }
  EXPECT_GT(told, 500);
}

/// A box of height 1 on a slab, light at 45 degrees from -X: its shadow is 1 long, and lies where
/// the face coordinates say.
TEST(Nn74Light, ShadowsStandInFaceCoordinates) {
  Scene scene;
  look_down(scene, 10, 8);
  scene.light = Direction{180, 45};
  add(scene, Box{{8, 6, 1}}, {5, -4, 0});
  add(scene, Box{{1, 2, 1}}, {3, -4, 1});
  const Prepared p(scene, square_grid(10, 8));
  const LightPhase light = cast(p.canonical, p.canonical, p.view);
  ASSERT_EQ(light.shadows.size(), 1u);
  const FaceShadow& shadow = light.shadows[0];
  const auto& v = p.canonical.vertices;
  Vec3 low(1e300), high(-1e300);
  for (const ShadowCorner& s : shadow.corners) {
    const Vec3 p2 = v[shadow.frame[1]];
    const Vec3 at = p2 + (v[shadow.frame[0]] - p2) * s.t1 + (v[shadow.frame[2]] - p2) * s.t2;
    low = glm::min(low, at + p.view.origin), high = glm::max(high, at + p.view.origin);
    EXPECT_FALSE(s.own) << "the shadow reaches no edge of the slab";
  }
  const Vec3 expected_low(2.5, -5, 1), expected_high(4.5, -3, 1);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(low[i], expected_low[i], 1e-12);
    EXPECT_NEAR(high[i], expected_high[i], 1e-12);
  }
}

TEST(Nn74Light, CoversFacesWhollyInside) {
  Scene scene;
  look_down(scene, 10, 8);
  scene.light = Direction{180, 45};
  add(scene, Box{{1, 6, 6}}, {1, -4, 0});
  add(scene, Box{{1, 1, 1}}, {4, -4, 0});
  const Prepared p(scene, square_grid(10, 8));
  const LightPhase light = cast(p.canonical, p.canonical, p.view);
  EXPECT_TRUE(light.shadows.empty());
  int covered = 0;
  for (const char c : light.covered) covered += c;
  EXPECT_EQ(covered, 1) << "the small box's top; the eye sees no other face that is lit";
}

/// Law: cells by this method, averaged over lines, are within the tolerance of the exact areas, of
/// each of the few borders in a cell.
TEST(Nn74Cells, AreThoseOfTheLineMethodWithinTheTolerance) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE(seed);
    const Scene scene = town(seed);
    std::vector<float> cells[2];
    for (const Method method : {Method::line, Method::nn74}) {
      DrawOptions options;
      options.method = method;
      Drawing(scene, square_grid(80, 60), options).cells([&](const CellRow& row) {
        auto& out = cells[method == Method::nn74];
        out.insert(out.end(), row.density.begin(), row.density.end());
      });
    }
    ASSERT_EQ(cells[0].size(), cells[1].size());
    for (std::size_t i = 0; i < cells[0].size(); ++i)
      EXPECT_NEAR(cells[0][i], cells[1][i], 2 * 0.05) << i;
  }
}

TEST(Nn74Strokes, AreThoseOfTheCommonResolver) {
  const Scene scene = town(5);
  DrawOptions line, nn74;
  nn74.method = Method::nn74;
  const auto a = Drawing(scene, square_grid(80, 60), line).strokes({});
  const auto b = Drawing(scene, square_grid(80, 60), nn74).strokes({});
  ASSERT_EQ(a.size(), b.size());
  ASSERT_FALSE(a.empty());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].points, b[i].points);
}

}  // namespace
}  // namespace overstrike::nn74
