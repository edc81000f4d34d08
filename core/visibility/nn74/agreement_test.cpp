// Law: NN74's method and the line resolver draw the same picture.
#include <gtest/gtest.h>

#include "core/visibility/nn74/compare.h"
#include "core/visibility/nn74/test_scenes.h"

namespace overstrike::nn74 {
namespace {

using testing::add;
using testing::expect_agreement;
using testing::town;

const Grid kGrid{97, 71, 1, 1};

constexpr unsigned kSeeds = 60;

/// Draws towns, changed, by both methods.
template <class Change>
void expect_towns_agree(const Change& change, const ScanFamily& family = {}) {
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    Scene scene = town(seed);
    change(scene);
    expect_agreement(scene, kGrid, family);
  }
}

TEST(Nn74Agreement, InPerspective) {
  expect_towns_agree([](Scene&) {});
}

TEST(Nn74Agreement, InParallelViews) {
  expect_towns_agree([](Scene& scene) { scene.camera.parallel = true; });
}

TEST(Nn74Agreement, WithLightFromEverySide) {
  for (const double azimuth : {7.0, 97.0, 187.0, 277.0})
    expect_towns_agree([&](Scene& scene) { scene.light = Direction{azimuth, 33}; });
}

TEST(Nn74Agreement, WithLightAlongTheAxes) {
  for (const Direction& light : {Direction{0, 90}, Direction{90, 45}, Direction{180, 0}})
    expect_towns_agree([&](Scene& scene) { scene.light = light; });
}

TEST(Nn74Agreement, WithLightFromBelow) {
  expect_towns_agree([](Scene& scene) { scene.light = Direction{50, -40}; });
}

TEST(Nn74Agreement, WithoutLight) {
  expect_towns_agree([](Scene& scene) { scene.light.reset(); });
}

TEST(Nn74Agreement, WithoutGround) {
  expect_towns_agree([](Scene& scene) { scene.ground_z.reset(); });
}

TEST(Nn74Agreement, FromBelow) {
  expect_towns_agree([](Scene& scene) { scene.camera.from.elevation_deg = -35; });
}

TEST(Nn74Agreement, FromStraightAbove) {
  expect_towns_agree([](Scene& scene) { scene.camera.from = {12, 90}; });
}

TEST(Nn74Agreement, FromAmongTheBodies) {
  expect_towns_agree([](Scene& scene) {
    scene.camera.eye = Vec3(2.3, 2.1, 0.55);
    scene.camera.target = Vec3(-1, 4, 0.4);
    scene.camera.fov_deg = 70;
    scene.camera.near_distance = 0.3;
  });
}

TEST(Nn74Agreement, OnTurnedLines) {
  for (const double angle : {30.0, 45.0, 90.0, 137.0})
    expect_towns_agree([](Scene&) {}, {angle, 0.7, 0.2});
}

/// Six lie on one wall, over one another, dark and light.
TEST(Nn74Agreement, OnCoplanarPolygons) {
  for (unsigned seed = 0; seed < kSeeds; ++seed) {
    SCOPED_TRACE(seed);
    testing::Dice dice(seed);
    Scene scene;
    add(scene, Box{{6, 1, 4}}, {0, .5, 0}).density_factor = dice.between(.2, 1);
    for (int i = 0; i < 6; ++i) {
      const double x = dice.between(-3, 3), z = dice.between(0, 4);
      add(scene, FlatPolygon{{{{x - 1, 0, z}, {x + 1, 0, z}, {x, 0, z + 1.5}}}}).density_factor =
          i % 2 == 0 ? 1 : dice.between(.2, 1);
    }
    scene.light = Direction{dice.between(200, 340), dice.between(10, 80)};
    scene.ground_z = 0;
    scene.camera.from = {dice.between(200, 340), dice.between(0, 60)};
    expect_agreement(scene, kGrid, {});
  }
}

/// Three beams, each over the next: no order of the whole picture exists.
TEST(Nn74Agreement, OnCyclicOverlap) {
  Scene scene;
  for (int i = 0; i < 3; ++i) {
    const double turn = 120 * i, c = cos_deg(turn), s = sin_deg(turn);
    Body& beam = add(scene, Box{{6, .5, .5}});
    const Mat3 round(Vec3(c, s, 0), Vec3(-s, c, 0), Vec3(0, 0, 1));
    const double cl = cos_deg(20), sl = sin_deg(20);
    beam.placement = {round * Mat3(Vec3(cl, 0, sl), Vec3(0, 1, 0), Vec3(-sl, 0, cl)),
                      round * Vec3(0, 1, 2)};
  }
  scene.light = Direction{20, 60};
  scene.ground_z = 0;
  scene.camera.from = {-90, 80};
  expect_agreement(scene, kGrid, {});
}

}  // namespace
}  // namespace overstrike::nn74
