#include "core/visibility/strokes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/drawing.h"
#include "core/geometry/trig.h"

namespace overstrike {
namespace {

ShapePtr box(const Vec3& size) { return std::make_shared<const Shape>(Box{size}); }

Body placed(ShapePtr shape, const Vec3& at, double turn_deg = 0) {
  Body body;
  body.shape = std::move(shape);
  const double c = cos_deg(turn_deg), s = sin_deg(turn_deg);
  body.placement.linear = Mat3(Vec3(c, s, 0), Vec3(-s, c, 0), Vec3(0, 0, 1));
  body.placement.offset = at;
  return body;
}

Scene from(double azimuth, double elevation, std::vector<Body> bodies) {
  Scene scene;
  scene.bodies = std::move(bodies);
  scene.camera.from = {azimuth, elevation};
  scene.camera.look_at = Vec3(0, 0, 0);
  scene.camera.parallel = true;
  scene.camera.window_width = 10;
  return scene;
}

const Grid kPage{100, 100, 1, 1};

/// A scene on its way to strokes.
struct Picture {
  explicit Picture(const Scene& scene, const Grid& grid = kPage)
      : view(make_view(scene, grid)),
        seen(canonicalize(scene, view, 0.05, warnings)),
        shadows(cast_shadows(seen, seen, view)) {}
  std::vector<Stroke> strokes(const StrokeOptions& options = {}) const {
    return visible_strokes(seen, seen, view, shadows, options, 0.05);
  }
  Vec2 at(double x, double y, double z) const { return Vec2(view.project({x, y, z})); }

  std::vector<Diagnostic> warnings;
  View view;
  Canonical seen;
  std::vector<Shadow> shadows;
};

std::vector<Stroke> of_kind(const std::vector<Stroke>& strokes, StrokeKind kind) {
  std::vector<Stroke> result;
  for (const Stroke& s : strokes)
    if (s.kind == kind) result.push_back(s);
  return result;
}

double length_of(const std::vector<Stroke>& strokes) {
  double sum = 0;
  for (const Stroke& s : strokes)
    for (std::size_t i = 1; i < s.points.size(); ++i)
      sum += glm::length(s.points[i] - s.points[i - 1]);
  return sum;
}

/// The points in this order or the other.
void expect_points(const Stroke& stroke, std::vector<Vec2> points, double within) {
  ASSERT_EQ(stroke.points.size(), points.size());
  if (glm::length(stroke.points[0] - points[0]) > within ||
      glm::length(stroke.points[1] - points[1]) > within)
    std::reverse(points.begin(), points.end());
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_LE(glm::length(stroke.points[i] - points[i]), within) << i;
}

TEST(Strokes, ACubeHasNineEdgesWithExactEnds) {
  const Picture picture(from(-60, 25, {placed(box(Vec3(4)), {0, 0, 0})}));
  const std::vector<Stroke> strokes = picture.strokes();
  const auto contours = of_kind(strokes, StrokeKind::contour);
  const auto creases = of_kind(strokes, StrokeKind::crease);
  ASSERT_EQ(contours.size(), 1u);
  EXPECT_EQ(contours[0].points.size(), 7u);
  EXPECT_EQ(contours[0].points.front(), contours[0].points.back());
  ASSERT_EQ(creases.size(), 3u);
  EXPECT_EQ(strokes.size(), 4u);
  const auto is_vertex = [&](const Vec2& p) {
    return std::any_of(picture.seen.vertices.begin(), picture.seen.vertices.end(),
                       [&](const Vec3& v) { return Vec2(picture.view.project(v)) == p; });
  };
  for (const Stroke& s : strokes)
    for (const Vec2& p : s.points) EXPECT_TRUE(is_vertex(p));
  for (const Stroke& s : creases) {
    ASSERT_EQ(s.points.size(), 2u);
    const Vec2 near = picture.at(2, -2, 4);
    EXPECT_TRUE(s.points[0] == near || s.points[1] == near);
  }
}

TEST(Strokes, OptionsLeaveKindsOut) {
  const Picture picture(from(-60, 25, {placed(box(Vec3(4)), {0, 0, 0})}));
  StrokeOptions options;
  options.creases = false;
  EXPECT_EQ(picture.strokes(options).size(), 1u);
  options = {};
  options.contours = false;
  EXPECT_EQ(picture.strokes(options).size(), 3u);
}

TEST(Strokes, ABoxHidesTheMiddleOfTheOneBehind) {
  // Seen along +y: ten cells to the unit, the middle of the page at (0, 0, 0).
  const Picture picture(
      from(-90, 0, {placed(box({2, 1, 3}), {0, -2, -1.5}), placed(box({6, 1, 1}), {0, 2, -0.5})}));
  const std::vector<Stroke> strokes = picture.strokes();
  ASSERT_EQ(strokes.size(), 3u);
  expect_points(strokes[0], {{40, 35}, {40, 65}, {60, 65}, {60, 35}, {40, 35}}, 0);
  expect_points(strokes[1], {{40, 45}, {20, 45}, {20, 55}, {40, 55}}, 0);
  expect_points(strokes[2], {{60, 45}, {80, 45}, {80, 55}, {60, 55}}, 0);
}

TEST(Strokes, EqualBoxesOneBehindTheOtherAreDrawnOnce) {
  const Picture picture(
      from(-90, 0, {placed(box({2, 1, 2}), {0, 2, 0}), placed(box({2, 1, 2}), {0, -2, 0})}));
  EXPECT_EQ(length_of(picture.strokes()), 80);
}

TEST(Strokes, AnInteriorEdgeHidesWhatLiesRightBehindIt) {
  // A roof whose ridge covers, seen from above, a thin rod's edges exactly.
  Wedge roof{{4, 4, 1}, 0, 0};
  const Picture picture(from(-90, 90,
                             {placed(std::make_shared<const Shape>(roof), {0, 0, 0}),
                              placed(box({2, 2, 1}), {1, 0, -3})}));
  for (const Stroke& s : picture.strokes()) EXPECT_EQ(s.body, 0u);
}

TEST(Strokes, BodiesThatPassThroughEachOtherShowWhereTheyMeet) {
  const Picture picture(
      from(-60, 30, {placed(box({4, 4, 1}), {0, 0, 0}), placed(box({1, 1, 3}), {0, 0, -1})}));
  const auto meet = of_kind(picture.strokes(), StrokeKind::intersection);
  ASSERT_EQ(meet.size(), 1u);
  expect_points(meet[0],
                {picture.at(-0.5, -0.5, 1), picture.at(0.5, -0.5, 1), picture.at(0.5, 0.5, 1)},
                1e-12);
}

TEST(Strokes, ABodyInTheGroundEndsThere) {
  Scene scene = from(-60, 30, {placed(box({2, 2, 2}), {0, 0, -1})});
  scene.ground_z = 0;
  const Picture picture(scene);
  const std::vector<Stroke> strokes = picture.strokes();
  const auto meet = of_kind(strokes, StrokeKind::intersection);
  ASSERT_EQ(meet.size(), 1u);
  expect_points(meet[0], {picture.at(-1, -1, 0), picture.at(1, -1, 0), picture.at(1, 1, 0)}, 1e-12);
  for (const Stroke& s : strokes)
    for (const Vec2& p : s.points) EXPECT_LE(p.y, picture.at(1, -1, 0).y + 1e-12);
  // The top's four edges, and the upper halves of three uprights.
  const auto distance = [](const Vec2& a, const Vec2& b) { return glm::length(a - b); };
  const double top = 2 * distance(picture.at(-1, -1, 1), picture.at(1, -1, 1)) +
                     2 * distance(picture.at(1, -1, 1), picture.at(1, 1, 1));
  const double upright = distance(picture.at(1, -1, 0), picture.at(1, -1, 1));
  EXPECT_NEAR(length_of(strokes), top + 3 * upright + length_of(meet), 1e-10);
}

TEST(Strokes, GluedBoxesDrawTheirCommonEdgesOnce) {
  // Turned by 17 degrees, so that the common corners are rounded apart.
  const double c = cos_deg(17), s = sin_deg(17);
  const Picture apart(from(
      -60, 30,
      {placed(box({2, 1, 1}), Vec3(c, s, 0), 17), placed(box({2, 1, 1}), -Vec3(c, s, 0), 17)}));
  const Picture whole(from(-60, 30, {placed(box({4, 1, 1}), {0, 0, 0}, 17)}));
  const auto distance = [&](const Vec3& p, const Vec3& q) {
    return glm::length(Vec2(whole.view.project(p)) - Vec2(whole.view.project(q)));
  };
  const Vec3 across(-s * 0.5, c * 0.5, 0), up(0, 0, 1);
  const double joint = distance(up - across, up + across) + distance(-across, up - across);
  EXPECT_NEAR(length_of(apart.strokes()), length_of(whole.strokes()) + joint, 1e-9);
}

TEST(Strokes, ABoxOnABoxDrawsTheContactOnce) {
  const Picture picture(
      from(-60, 30, {placed(box({4, 4, 1}), {0, 0, 0}), placed(box({1, 1, 0.25}), {0, 0, 1})}));
  const Picture lower(from(-60, 30, {placed(box({4, 4, 1}), {0, 0, 0})}));
  const Picture upper(from(-60, 30, {placed(box({1, 1, 0.25}), {0, 0, 1})}));
  EXPECT_TRUE(of_kind(picture.strokes(), StrokeKind::intersection).empty());
  // The upper box is too low to hide the lower one's far edges.
  EXPECT_NEAR(length_of(picture.strokes()), length_of(lower.strokes()) + length_of(upper.strokes()),
              1e-10);
}

TEST(Strokes, TheGroundShadowOfACubeIsItsHull) {
  Scene scene = from(-90, 90, {placed(box(Vec3(2)), {0, 0, 0})});
  scene.ground_z = 0;
  scene.light = Direction{45, 45};
  const Picture picture(scene);
  const auto outline = of_kind(picture.strokes(), StrokeKind::shadow_outline);
  ASSERT_EQ(outline.size(), 1u);
  EXPECT_EQ(outline[0].body, kNoSurface);
  // NN74 (3): the top moves by -(cos 45, sin 45) cot 45 of its height.
  const double d = 2 * std::numbers::sqrt2 / 2;
  expect_points(outline[0],
                {picture.at(-1, 1, 0), picture.at(-1 - d, 1 - d, 0), picture.at(-1 - d, -1 - d, 0),
                 picture.at(1 - d, -1 - d, 0), picture.at(1, -1, 0)},
                1e-11);
}

TEST(Strokes, TheGroundEndsAtTheNearPlane) {
  // From 45 degrees; the near plane meets the ground in y = 0 and cuts the shadow there.
  Scene scene = from(-90, 45, {placed(box({2, 2, 1}), {0, 4, 2})});
  scene.ground_z = 0;
  scene.light = Direction{90, 30};
  scene.camera.distance = 10;
  scene.camera.near_distance = 10;
  scene.segments.push_back({{3, -3, -3}, {3, 4, -3}, 0});
  const Picture picture(scene);
  const double cut = picture.at(0, 0, 0).y;
  double lowest = 0;
  for (const Stroke& s : of_kind(picture.strokes(), StrokeKind::shadow_outline))
    if (s.body == kNoSurface)
      for (const Vec2& p : s.points) lowest = std::max(lowest, p.y);
  EXPECT_NEAR(lowest, cut, 1e-11);
  const auto segments = of_kind(picture.strokes(), StrokeKind::segment);
  ASSERT_EQ(segments.size(), 1u);
  // What lies under the ground is in sight where the ground is cut away.
  EXPECT_NEAR(segments[0].points[0].y, cut, 1e-11);
}

/// A square of side 2 at height z.
Body plate(double x, double y, double z) {
  const FlatPolygon square{{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}}};
  return placed(std::make_shared<const Shape>(square), {x, y, z});
}

TEST(Strokes, ShadowsThatOverlapHaveOneOutline) {
  // Light from +x, 45 degrees high: shadows fall on the page, the plates are beside it.
  Scene scene = from(-90, 90, {plate(8, 0, 8), plate(10, 1, 9), plate(8, 0.25, 8.25)});
  scene.bodies[2].placement.linear *= 0.5;
  scene.ground_z = 0;
  scene.light = Direction{0, 45};
  const Picture picture(scene);
  const auto strokes = picture.strokes();
  ASSERT_EQ(strokes.size(), 1u);
  EXPECT_EQ(strokes[0].kind, StrokeKind::shadow_outline);
  const auto at = [&](double x, double y) { return picture.at(x, y, 0); };
  expect_points(strokes[0],
                {at(-1, 1), at(0, 1), at(0, 2), at(2, 2), at(2, 0), at(1, 0), at(1, -1), at(-1, -1),
                 at(-1, 1)},
                1e-11);
}

/// Of a plate that the near plane cuts, the hole that is left whole comes before the outline.
TEST(Strokes, APlateThatIsCutHidesWhatLiesBelowIt) {
  const FlatPolygon holed{{{{-9, -20, 0}, {9, -20, 0}, {9, 6, 0}, {-9, 6, 0}},
                           {{-8, 4, 0}, {-7, 4, 0}, {-7, 5, 0}, {-8, 5, 0}}}};
  Scene scene;
  scene.bodies = {placed(std::make_shared<const Shape>(holed), {0, 0, 0}),
                  placed(box({2, 2, 1}), {0, 0, -2})};
  scene.camera.eye = Vec3(0, -10, 4);
  scene.camera.target = Vec3(0, 0, 0);
  scene.camera.near_distance = 0.5;
  scene.camera.fov_deg = 90;
  const auto strokes = Drawing(scene, kPage, {}).strokes({});
  EXPECT_FALSE(strokes.empty());
  for (const Stroke& s : strokes) EXPECT_EQ(s.body, 0u) << to_string(s.kind);
}

TEST(Strokes, APatternOnAFaceIsSeenAsTheFaceIs) {
  for (const double turn : {0.0, 17.0, 45.0, 111.1}) {
    Body body = placed(box({2, 2, 2}), {0.3, 0.1, -0.7}, turn);
    for (int side = 0; side < 4; ++side) {
      const double c = cos_deg(90 * side), s = sin_deg(90 * side);
      const auto on = [&](double u, double v) { return Vec3(c - s * u, s + c * u, v); };
      body.patterns.push_back({{on(-0.5, 0.3), on(0.6, 0.4), on(0.1, 1.7)}, side + 1});
    }
    const Picture picture(from(-60, 25, {body}));
    std::size_t seen_faces = 0;
    for (int side = 0; side < 4; ++side) {
      const Vec3 normal(cos_deg(90 * side + turn), sin_deg(90 * side + turn), 0);
      seen_faces += glm::dot(normal, Vec3(picture.view.eye)) > 0;
    }
    const auto patterns = of_kind(picture.strokes(), StrokeKind::pattern);
    ASSERT_EQ(patterns.size(), seen_faces);
    for (const Stroke& s : patterns) {
      const auto& points = body.patterns[s.pen - 1].points;
      std::vector<Vec2> expected;
      for (const Vec3& p : points)
        expected.push_back(Vec2(picture.view.project(body.placement(p))));
      expect_points(s, expected, 1e-12);
    }
  }
}

TEST(Strokes, ASegmentIsHiddenInsideABox) {
  Scene scene = from(-90, 0, {placed(box({2, 2, 2}), {0, 0, -1})});
  scene.segments.push_back({{-3, 0, 0}, {3, 0, 0}, 7});
  scene.segments.push_back({{-2, -1, 0.5}, {2, -1, 0.5}, 8});  // on its front face
  const Picture picture(scene);
  const auto segments = of_kind(picture.strokes(), StrokeKind::segment);
  ASSERT_EQ(segments.size(), 3u);
  expect_points(segments[0], {{20, 50}, {40, 50}}, 0);
  expect_points(segments[1], {{60, 50}, {80, 50}}, 0);
  expect_points(segments[2], {{30, 45}, {70, 45}}, 0);
  EXPECT_EQ(segments[2].pen, 8);
}

TEST(Strokes, EndAtThePageExactly) {
  Scene scene = from(-90, 0, {});
  scene.segments.push_back({{-50, 0, 1}, {70, 0, 3}, 0});
  scene.segments.push_back({{-50, 0, 30}, {70, 0, 30}, 0});
  const auto strokes = Picture(scene).strokes();
  ASSERT_EQ(strokes.size(), 1u);
  EXPECT_EQ(strokes[0].points[0].x, 0);
  EXPECT_EQ(strokes[0].points[1].x, 100);
}

TEST(Strokes, ASphereHasOneSmoothContour) {
  const Picture picture(
      from(-60, 25, {placed(std::make_shared<const Shape>(Ellipsoid{Vec3(3)}), {0, 0, 0})}));
  const auto strokes = picture.strokes();
  ASSERT_EQ(strokes.size(), 1u);
  EXPECT_EQ(strokes[0].points.front(), strokes[0].points.back());
  EXPECT_LT(strokes[0].points.size(), 100u);
  // Facets stay within the tolerance of the sphere, the simplified contour of theirs.
  for (std::size_t i = 1; i < strokes[0].points.size(); ++i) {
    const Vec2 &p = strokes[0].points[i - 1], &q = strokes[0].points[i];
    EXPECT_NEAR(glm::length(p - Vec2(50)), 30, 0.1 + 1e-9);
    EXPECT_NEAR(glm::length((p + q) * 0.5 - Vec2(50)), 30, 0.1 + 1e-9);
  }
}

/// Boxes and prisms anywhere, many of them through each other.
Scene random_scene(unsigned seed, bool parallel) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> u(-1, 1);
  Scene scene;
  for (int i = 0; i < 14; ++i) {
    const Vec3 at(2 * u(random), 2 * u(random), 2 * u(random));
    ShapePtr shape = i % 3 == 2 ? std::make_shared<const Shape>(Frustum{1, 0.3, 1.2, 5})
                                : box(Vec3(1.2 + u(random), 1.2 + u(random), 1.2 + u(random)));
    scene.bodies.push_back(placed(shape, at, 180 * u(random)));
  }
  for (int i = 0; i < 10; ++i)
    scene.segments.push_back({Vec3(u(random), u(random), u(random)) * 3.0,
                              Vec3(u(random), u(random), u(random)) * 3.0, 0});
  scene.camera.parallel = parallel;
  scene.camera.from = {180 * u(random), 80 * u(random)};
  scene.light = Direction{30, 50};
  scene.ground_z = -2;
  return scene;
}

TEST(Strokes, DoNotDependOnTheOrderOfBodies) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    Scene scene = random_scene(seed, seed % 2 == 0);
    const auto forth = Picture(scene).strokes();
    std::reverse(scene.bodies.begin(), scene.bodies.end());
    const auto back = Picture(scene).strokes();
    for (const StrokeKind kind : {StrokeKind::contour, StrokeKind::crease, StrokeKind::intersection,
                                  StrokeKind::shadow_outline, StrokeKind::segment})
      EXPECT_NEAR(length_of(of_kind(forth, kind)), length_of(of_kind(back, kind)), 1e-7)
          << to_string(kind) << seed;
  }
}

TEST(Strokes, TurnWithTheGrid) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const Picture picture(random_scene(seed, seed % 2 == 0));
    const View quarter = turned(picture.view, 90, {kPage.columns, 0}, 1);
    const auto straight = picture.strokes();
    const auto sideways =
        visible_strokes(picture.seen, picture.seen, quarter, picture.shadows, {}, 0.05);
    ASSERT_EQ(straight.size(), sideways.size());
    EXPECT_NEAR(length_of(straight), length_of(sideways), 1e-8);
  }
}

TEST(Strokes, AreTheSameEveryTime) {
  const Picture picture(random_scene(3, false));
  const auto once = picture.strokes(), again = picture.strokes();
  ASSERT_EQ(once.size(), again.size());
  for (std::size_t i = 0; i < once.size(); ++i) EXPECT_EQ(once[i].points, again[i].points);
}

/// A box with a shaft through it from top to bottom, above the ground.
TEST(Strokes, TheShadowOfAFrameHasAnOuterAndAnInnerOutline) {
  Scene scene;
  scene.camera.from = {0, 90};
  scene.camera.parallel = true;
  scene.camera.window_width = 20;
  scene.camera.look_at = Vec3(0, 0, 0);
  scene.light = Direction{0, 45};  // shadows fall along -x, as far as things are high
  scene.ground_z = 0;
  const auto box = [](const Vec3& size, const Vec3& offset) {
    Body body;
    body.shape = std::make_shared<Shape>(Box{size});
    body.placement.offset = offset;
    return body;
  };
  scene.bodies = {box({4, 4, 1}, {0, 0, 6}), box({2, 2, 3}, {0, 0, 5})};
  Solid frame;
  frame.nodes = {
      {SetOperation::subtract, 0, 3}, {SetOperation::operand, 0, 2}, {SetOperation::operand, 1, 3}};
  scene.solids.push_back(frame);
  const Picture picture(scene);
  std::vector<Vec2> corners;
  for (const double y : {-2, 2})
    for (const double x : {-2 - 7, 2 - 6}) corners.push_back(picture.at(x, y, 0));
  // Light passes the shaft where it passes both of its mouths.
  for (const double y : {-1, 1})
    for (const double x : {-1 - 6, 1 - 7}) corners.push_back(picture.at(x, y, 0));
  double length = 0;
  for (const Stroke& stroke : of_kind(picture.strokes(), StrokeKind::shadow_outline))
    for (std::size_t i = 0; i < stroke.points.size(); ++i) {
      const Vec2& p = stroke.points[i];
      EXPECT_TRUE(std::any_of(corners.begin(), corners.end(),
                              [&](const Vec2& c) { return glm::length(p - c) < 1e-9; }))
          << p.x << ", " << p.y;
      if (i > 0) length += glm::length(p - stroke.points[i - 1]);
    }
  const double cell = 100.0 / 20;
  EXPECT_NEAR(length, cell * (2 * (4 + 5) + 2 * (2 + 1)), 1e-9);
}

}  // namespace
}  // namespace overstrike
