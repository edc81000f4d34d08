#include "core/visibility/view.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/geometry/direction.h"
#include "core/geometry/tessellate.h"
#include "core/visibility/camera_frame.h"

namespace overstrike {
namespace {

ShapePtr box(const Vec3& size) { return std::make_shared<const Shape>(Box{size}); }

Scene boxes(int count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> u(-3, 3);
  Scene scene;
  for (int i = 0; i < count; ++i) {
    Body body;
    body.shape = box(Vec3(1, 2, 3) * (0.2 + 0.1 * i));
    body.placement.offset = {u(random), u(random), u(random)};
    scene.bodies.push_back(body);
  }
  return scene;
}

/// Where a point of the world is seen.
Vec3 grid_point(const View& view, const Vec3& p) { return view.project(p - view.origin); }

/// What the bodies' vertices cover in the grid.
struct Extent {
  Vec2 low{1e300}, high{-1e300};
  void add(const Vec3& p) { low = glm::min(low, Vec2(p)), high = glm::max(high, Vec2(p)); }
};
Extent extent_of(const Scene& scene, const View& view, double chord = 0.001) {
  Extent extent;
  for (const Body& body : scene.bodies)
    for (const Vec3& p : tessellate(*body.shape, chord, false).vertices)
      extent.add(grid_point(view, body.placement(p)));
  return extent;
}

TEST(UnitVector, IsExactAtQuarterTurns) {
  EXPECT_EQ(unit_vector({0, 0}), Vec3(1, 0, 0));
  EXPECT_EQ(unit_vector({90, 0}), Vec3(0, 1, 0));
  EXPECT_EQ(unit_vector({-90, 0}), Vec3(0, -1, 0));
  EXPECT_EQ(unit_vector({37, 90}), Vec3(0, 0, 1));
  EXPECT_EQ(unit_vector({0, 30}).z, 0.5);
}

/// The light beside the eye goes with the camera, and three faces of a box that it sees are lit,
/// each in a tone of its own.
TEST(LightOf, FollowsTheEyeWhereTheSceneHasNone) {
  Scene scene = boxes(3, 1);
  const auto light = [&] { return light_of(scene, camera_frame(scene.camera, stage_of(scene))); };
  EXPECT_EQ(light(), std::nullopt);
  scene.light_beside_eye = true;
  for (const double azimuth : {-65.0, 25.0, 115.0}) {
    scene.camera.from = {azimuth, 35};
    const Vec3 right = unit_vector({azimuth + 65, 0}), front = unit_vector({azimuth - 25, 0});
    const Vec3 found = light().value();
    EXPECT_NEAR(glm::length(found), 1, 1e-15);
    EXPECT_GT(glm::dot(found, front), 0.15);
    EXPECT_GT(glm::dot(found, right), glm::dot(found, front) + 0.15);
    EXPECT_GT(found.z, glm::dot(found, right) + 0.15);
  }
  scene.light = Direction{10, 20};
  EXPECT_EQ(light(), unit_vector({10, 20}));
}

/// Also where what the camera looks at lies half way between two places that origins have.
TEST(View, CountsFromNearWhatTheCameraLooksAtHoweverFarAway) {
  constexpr double kSize = 8, kStep = 0x1p-20 * (2 * kSize);
  for (const double far : {0.0, 1.0, 0x1p20, 0x1p30, -0x1p30}) {
    for (const double beside : {0.0, kStep / 2, 1.5 * kStep}) {
      Scene scene;
      Body body;
      body.shape = box(Vec3(kSize));
      body.placement.offset = Vec3(far);
      scene.bodies.push_back(body);
      scene.camera.look_at = Vec3(far + beside, far, far - beside);
      const Vec3 from = *scene.camera.look_at - make_view(scene, Grid{}).origin;
      EXPECT_LE(glm::length(from), kStep) << far << " " << beside;
    }
  }
}

TEST(View, IsNishitaAndNakamaesProjection) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int i = 0; i < 200; ++i) {
    Scene scene;
    const double azimuth = 180 * u(random), elevation = 80 * u(random), distance = 5 + u(random);
    const Vec3 centre(u(random), u(random), u(random));
    scene.camera.look_at = centre;
    scene.camera.distance = distance;
    scene.camera.from = {azimuth, elevation};
    scene.camera.window_width = 4;
    const Grid grid{100, 60, 2, 3};
    const View view = make_view(scene, grid);
    const Vec3 p = centre + Vec3(u(random), u(random), u(random));
    const Vec3 q = p - centre;
    const double t = azimuth * M_PI / 180, f = elevation * M_PI / 180;
    const double x = -std::sin(t) * q.x + std::cos(t) * q.y;
    const double y =
        -std::cos(t) * std::sin(f) * q.x - std::sin(t) * std::sin(f) * q.y + std::cos(f) * q.z;
    const double z =
        std::cos(t) * std::cos(f) * q.x + std::sin(t) * std::cos(f) * q.y + std::sin(f) * q.z;
    const double shrink = distance / (distance - z);
    const Vec3 seen = grid_point(view, p);
    EXPECT_NEAR(seen.x, 50 + x * shrink * 25, 1e-12);
    EXPECT_NEAR(seen.y, 30 - y * shrink * 25 * 2 / 3, 1e-12);
    EXPECT_NEAR(view.eye.x + view.origin.x, centre.x + distance * std::cos(t) * std::cos(f), 1e-14);
    EXPECT_EQ(view.world_per_cell, 4.0 / 100);
  }
}

TEST(View, AxisAlignedViewsAreExact) {
  Scene scene;
  scene.camera.look_at = Vec3(1, 2, 3);
  scene.camera.distance = 8;
  scene.camera.from = {-90, 0};
  scene.camera.parallel = true;
  scene.camera.window_width = 16;
  const View front = make_view(scene, {16, 16, 1, 1});
  EXPECT_EQ(grid_point(front, {1, 2, 3}), Vec3(8, 8, 0));
  EXPECT_EQ(grid_point(front, {2, 1, 5}).x, 9);
  EXPECT_EQ(grid_point(front, {2, 1, 5}).y, 6);
  EXPECT_EQ(front.eye, Vec4(0, -1, 0, 0));
  EXPECT_FALSE(front.near_plane);
  scene.camera.from = {-90, 90};
  const View top = make_view(scene, {16, 16, 1, 1});
  EXPECT_EQ(Vec2(grid_point(top, {2, 1, 5})), Vec2(9, 9));
  EXPECT_GT(grid_point(top, {0, 0, 5}).z, grid_point(top, {0, 0, 4}).z);
}

TEST(View, DepthGrowsTowardsTheEye) {
  for (const bool parallel : {false, true}) {
    Scene scene = boxes(3, 2);
    scene.camera.parallel = parallel;
    const View view = make_view(scene, {});
    const Vec3 towards = unit_vector(scene.camera.from);
    double last = -1e300;
    for (double t = -5; t < 5; t += 0.5) {
      const double z = grid_point(view, towards * t).z;
      EXPECT_GT(z, last);
      last = z;
    }
  }
}

TEST(View, AFitFillsTheTighterAxisAndIsCentred) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    Scene scene = boxes(1 + static_cast<int>(seed) % 7, seed);
    scene.camera.parallel = seed % 2 == 0;
    scene.camera.from = {seed * 37.0, seed * 11.0 - 80};
    const Grid grid{135, seed % 3 == 0 ? 180.0 : 40.0, 2.54, 3.175};
    const Extent seen = extent_of(scene, make_view(scene, grid, 0.02));
    const Vec2 size = (seen.high - seen.low) / Vec2(grid.columns, grid.rows);
    EXPECT_NEAR(std::fmax(size.x, size.y), 0.96, 1e-12);
    EXPECT_NEAR(seen.low.x + seen.high.x, grid.columns, 1e-9);
    EXPECT_NEAR(seen.low.y + seen.high.y, grid.rows, 1e-9);
  }
}

TEST(View, AFitSeesPatternsSegmentsAndRoundShapes) {
  Scene scene;
  Body ball;
  ball.shape = std::make_shared<const Shape>(Ellipsoid{});
  scene.bodies.push_back(ball);
  scene.camera.parallel = true;
  scene.camera.from = {-90, 0};
  const Grid grid{200, 100, 1, 1};
  EXPECT_NEAR(make_view(scene, grid, 0).world_per_cell, 0.02, 1e-5);
  scene.segments.push_back({{0, 0, 0}, {0, 0, 3}, 0});
  EXPECT_NEAR(make_view(scene, grid, 0).world_per_cell, 0.04, 1e-5);
  scene.bodies[0].patterns.push_back({{{0, 0, -5}, {0, 0, 0}}, 0});
  EXPECT_NEAR(make_view(scene, grid, 0).world_per_cell, 0.08, 1e-5);
}

TEST(View, HighLightFitsTheShadowsTooAndLowLightDoesNot) {
  Scene scene;
  Body tower;
  tower.shape = box({1, 1, 4});
  scene.bodies.push_back(tower);
  scene.camera.from = {-90, 30};
  scene.ground_z = 0;
  const Grid grid{100, 100, 1, 1};
  const auto shadow_end = [&](double elevation) {
    scene.light = Direction{180, elevation};
    const View view = make_view(scene, grid);
    const double reach = 4 / std::tan(elevation * M_PI / 180);
    return grid_point(view, {0.5 + reach, -0.5, 0}).x;
  };
  EXPECT_NEAR(shadow_end(30), 98, 1e-9);
  EXPECT_NEAR(shadow_end(20), 98, 1e-9);
  EXPECT_GT(shadow_end(19), 100);
}

TEST(View, AFitLeavesOutWhatTheGroundHides) {
  const Grid grid{100, 100, 1, 1};
  for (const bool parallel : {false, true}) {
    Scene sunk, cut, under;
    for (Scene* scene : {&sunk, &cut, &under}) {
      scene->camera.parallel = parallel;
      scene->camera.look_at = Vec3(0, 0, 0);
      scene->camera.distance = 20;
      scene->ground_z = 0;
    }
    Body half, whole, deep;
    whole.shape = box({1, 2, 3});
    whole.placement.offset = {0, 0, -1};
    half.shape = box({1, 2, 2});
    deep.shape = box({9, 9, 1});
    deep.placement.offset = {0, 0, -5};
    deep.patterns.push_back({{{5, 5, 0}, {-5, 5, 0}}, 0});
    cut.bodies = {half};
    sunk.bodies = {whole, deep};
    sunk.segments.push_back({{0, 0, 1}, {0, 0, -9}, 0});
    const View a = make_view(cut, grid), b = make_view(sunk, grid);
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(0.5, 1, 2), Vec3(0.5, -1, 0)})
      EXPECT_LT(glm::distance(Vec2(grid_point(a, p)), Vec2(grid_point(b, p))), 1e-9);
    // From below nothing hides it, and a scene all under the ground is fitted whole.
    sunk.camera.from.elevation_deg = -30;
    EXPECT_GT(make_view(sunk, grid).world_per_cell, 1.5 * b.world_per_cell);
    under.bodies = {deep};
    EXPECT_GT(make_view(under, grid).world_per_cell, 1.5 * b.world_per_cell);
  }
}

TEST(View, AFitOfATipThatComesOutOfTheGroundHasALimit) {
  const Grid grid{100, 100, 1, 1};
  Mesh pyramid;
  for (const Vec3 p : {Vec3(-1, -1, -2), Vec3(1, -1, -2), Vec3(0, 1, -2), Vec3(0, 0, 0)})
    pyramid.polyhedron.add_vertex(p);
  for (const auto& face : {std::array<Index, 3>{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}})
    pyramid.polyhedron.add_face({face[0], face[1], face[2]});
  Scene scene;
  scene.bodies.emplace_back();
  scene.bodies[0].shape = std::make_shared<const Shape>(pyramid);
  scene.ground_z = 0;
  scene.camera.look_at = Vec3(0, 0, 0);
  scene.camera.distance = 20;
  for (const bool parallel : {false, true}) {
    scene.camera.parallel = parallel;
    double before = 1;
    for (double height = 1; height > 1e-18; height /= 8) {
      scene.bodies[0].placement.offset = Vec3(0, 0, height);
      const View view = make_view(scene, grid);
      // The tip is in the picture, and nothing is as fine as rounding.
      const Vec3 tip = grid_point(view, Vec3(0, 0, height));
      EXPECT_TRUE(tip.x >= 0 && tip.x <= 100 && tip.y >= 0 && tip.y <= 100) << height;
      EXPECT_GT(view.world_per_cell, 2 * 0x1p-53 / 1e-9) << height;
      if (height > 1e-3) {  // as near as fits
        EXPECT_LT(view.world_per_cell, before);
      }
      before = view.world_per_cell;
    }
  }
}

TEST(View, AnEyeInsideTheSceneSeesSixtyDegrees) {
  Scene scene = boxes(20, 4);
  scene.camera.eye = Vec3(0, 0, 0);
  scene.camera.target = Vec3(0, 1, 0);
  const View view = make_view(scene, {100, 100, 1, 1});
  EXPECT_NEAR(grid_point(view, {0, 1, std::tan(30 * M_PI / 180)}).y, 0, 1e-12);
  ASSERT_TRUE(view.near_plane);
  EXPECT_EQ(view.near_plane->normal, Vec3(0, 1, 0));
  EXPECT_NEAR(view.near_plane->offset + view.origin.y, 0.001, 1e-15);
}

/// The law: all lines of sight pass the eye, however far the target: x^, y^ and w^ vanish there,
/// but for the rounding of their four products (8 units of 2^-53 of each, and twice that for the
/// axes').
TEST(View, LinesOfSightPassTheEye) {
  Scene scene = boxes(20, 4);
  for (const double far : {10.0, 1e4, 1e8, 1e12}) {
    scene.camera.eye = Vec3(0.3, 0.2, 0.1);
    scene.camera.target = scene.camera.eye;  // the direction and the distance say where to look
    scene.camera.distance = far;
    scene.camera.fov_deg = 50;
    const View view = make_view(scene, {100, 100, 1, 1});
    const Vec4 at = view.matrix * view.eye;
    Vec4 terms(0);
    for (int c = 0; c < 3; ++c) terms += glm::abs(view.matrix[c] * view.eye[c]);
    for (int row = 0; row < 3; ++row) EXPECT_LE(std::fabs(at[row]), 24 * 0x1p-53 * terms[row]);
  }
}

TEST(View, FieldOfViewIsVertical) {
  Scene scene;
  scene.camera.eye = Vec3(10, 0, 0);
  scene.camera.target = Vec3(0, 0, 0);
  scene.camera.fov_deg = 90;
  const View view = make_view(scene, {200, 50, 1, 2});
  EXPECT_NEAR(grid_point(view, {0, 0, 10}).y, 0, 1e-12);
  EXPECT_NEAR(grid_point(view, {0, 10, 0}).x, 150, 1e-12);
}

TEST(View, OddCamerasStillSeeSomething) {
  Scene scene;
  for (const bool parallel : {false, true}) {
    scene.camera.parallel = parallel;
    const View empty = make_view(scene, {});
    EXPECT_TRUE(std::isfinite(grid_point(empty, {0, 0, 0}).x));
  }
  scene = boxes(2, 1);
  scene.camera.eye = scene.camera.target = Vec3(9, 9, 9);
  EXPECT_TRUE(std::isfinite(grid_point(make_view(scene, {}), {0, 0, 0}).x));
  scene.camera.target = Vec3(9, 9, 0);
  const View down = make_view(scene, {});
  EXPECT_GT(grid_point(down, {10, 9, 0}).x, grid_point(down, {9, 9, 0}).x);
  EXPECT_LT(grid_point(down, {9, 10, 0}).y, grid_point(down, {9, 9, 0}).y);
  Scene point;
  point.segments.push_back({{1, 1, 1}, {1, 1, 1}, 0});
  EXPECT_NEAR(grid_point(make_view(point, {}), {1, 1, 1}).x, 135 / 2.0, 1e-9);
}

TEST(View, TurnedIsARotationOfTheGrid) {
  Scene scene = boxes(3, 9);
  const View view = make_view(scene, {});
  const View other = turned(view, 30, {10, 20}, 4);
  const Vec3 p(0.3, -0.2, 0.9);
  const Vec2 d = Vec2(grid_point(view, p)) - Vec2(10, 20);
  const double c = std::sqrt(3) / 2, s = 0.5;
  EXPECT_NEAR(grid_point(other, p).x, 4 * (c * d.x + s * d.y), 1e-10);
  EXPECT_NEAR(grid_point(other, p).y, 4 * (c * d.y - s * d.x), 1e-10);
  EXPECT_EQ(grid_point(other, p).z, grid_point(view, p).z);
  EXPECT_EQ(other.world_per_cell, view.world_per_cell / 4);
}

}  // namespace
}  // namespace overstrike
