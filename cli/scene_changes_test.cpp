#include "cli/scene_changes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "cli/usage.h"

namespace overstrike {
namespace {

using Texts = SceneChangeTexts;

/// The option `--OPTION value`, alone or beside others.
Texts with(std::string Texts::*option, std::string_view value, Texts others = {}) {
  others.*option = std::string(value);
  return others;
}

Texts with(bool Texts::*flag, Texts others = {}) {
  others.*flag = true;
  return others;
}

Texts light(std::string_view value) { return with(&Texts::light, value); }

std::string error_of(const Texts& texts) {
  try {
    read_scene_changes(texts);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "no error";
}

Scene changed(Scene scene, const Texts& texts) {
  apply(read_scene_changes(texts), scene);
  return scene;
}

Scene scene_with_eye() {
  Scene scene;
  scene.camera.eye = Vec3(3, 4, 0);
  scene.camera.target = Vec3(0, 0, 0);
  scene.light = Direction{10, 20};
  scene.ground_z = 1;
  return scene;
}

TEST(SceneChanges, WhatIsNotSaidStays) {
  const Scene scene = changed(scene_with_eye(), {});
  EXPECT_EQ(scene.camera.eye, Vec3(3, 4, 0));
  EXPECT_EQ(scene.light->azimuth_deg, 10);
  EXPECT_EQ(scene.ground_z, 1);
  EXPECT_EQ(scene.law.k, DensityLaw{}.k);
}

TEST(SceneChanges, LightGroundAndDensityAreReplaced) {
  const Texts texts =
      with(&Texts::ground, "-1.5", with(&Texts::density, "0.5,0.9", light("-20,45")));
  const Scene scene = changed(scene_with_eye(), texts);
  EXPECT_EQ(scene.light->azimuth_deg, -20);
  EXPECT_EQ(scene.light->elevation_deg, 45);
  EXPECT_EQ(scene.ground_z, -1.5);
  EXPECT_EQ(scene.law.k, 0.5);
  EXPECT_EQ(scene.law.hmax, 0.9);
}

TEST(SceneChanges, LightAndGroundAreTakenAway) {
  const Scene scene = changed(scene_with_eye(), with(&Texts::no_light, with(&Texts::no_ground)));
  EXPECT_FALSE(scene.light);
  EXPECT_FALSE(scene.ground_z);
}

TEST(SceneChanges, AnEyeWinsOverALookAt) {
  const Scene scene = changed(Scene{}, with(&Texts::eye, "1,-2,3", with(&Texts::target, "0,0,1")));
  EXPECT_EQ(scene.camera.eye, Vec3(1, -2, 3));
  EXPECT_EQ(scene.camera.target, Vec3(0, 0, 1));
}

TEST(SceneChanges, ATargetAloneIsLookedAt) {
  const Texts texts = with(&Texts::target, "0,0,1");
  EXPECT_EQ(changed(Scene{}, texts).camera.look_at, Vec3(0, 0, 1));
  EXPECT_EQ(changed(scene_with_eye(), texts).camera.target, Vec3(0, 0, 1));
}

TEST(SceneChanges, AnAzimuthTurnsAnEyeIntoALookAt) {
  const Camera camera = changed(scene_with_eye(), with(&Texts::azimuth, "30")).camera;
  EXPECT_FALSE(camera.eye);
  EXPECT_EQ(camera.look_at, Vec3(0, 0, 0));
  EXPECT_EQ(camera.distance, 5);
  EXPECT_EQ(camera.from.azimuth_deg, 30);
}

TEST(SceneChanges, WindowsReplaceEachOther) {
  Scene scene;
  scene.camera.fov_deg = 30;
  const Camera a = changed(scene, with(&Texts::parallel, "12.5")).camera;
  EXPECT_TRUE(a.parallel && a.window_width == 12.5 && !a.fov_deg);
  scene.camera.parallel = true;
  const Camera b = changed(scene, with(&Texts::fov, "60")).camera;
  EXPECT_TRUE(!b.parallel && !b.window_width && b.fov_deg == 60);
  const Camera c = changed(scene, with(&Texts::fit)).camera;
  EXPECT_TRUE(c.parallel && !c.window_width && !c.fov_deg);
  const Camera d = changed(Scene{}, with(&Texts::parallel, "fit")).camera;
  EXPECT_TRUE(d.parallel && !d.window_width && !d.fov_deg);
}

TEST(SceneChanges, NoLightIsNoneBesideTheEyeEither) {
  Scene scene;
  scene.light_beside_eye = true;
  EXPECT_TRUE(changed(scene, {}).light_beside_eye);
  EXPECT_FALSE(changed(scene, with(&Texts::no_light)).light_beside_eye);
  EXPECT_FALSE(changed(scene, light("10,20")).light_beside_eye);
}

void expect_near(const Vec3& found, const Vec3& expected) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], 1e-12) << i;
}

// What is looked at, turns, distance: nothing turned is from above, and y is up.
TEST(SceneChanges, OpenscadsCameraOfSevenNumbers) {
  const Camera above = changed({}, with(&Texts::camera, "1,2,3,0,0,0,10")).camera;
  expect_near(*above.target, {1, 2, 3});
  expect_near(*above.eye, {1, 2, 13});
  expect_near(above.up, {0, 1, 0});
  EXPECT_EQ(above.fov_deg, 22.5);
  EXPECT_FALSE(above.parallel);
  const Camera front = changed({}, with(&Texts::camera, "0,0,0,90,0,0,4")).camera;
  expect_near(*front.eye, {0, -4, 0});
  expect_near(front.up, {0, 0, 1});
  const Camera right = changed({}, with(&Texts::camera, "0,0,0,90,0,90,4")).camera;
  expect_near(*right.eye, {4, 0, 0});
  const Camera rolled = changed({}, with(&Texts::camera, "0,0,0,90,30,0,4")).camera;
  expect_near(rolled.up, {0.5, 0, std::sqrt(0.75)});
  const Texts flat = with(&Texts::projection, "o", with(&Texts::camera, "0,0,0,55,0,25,140"));
  EXPECT_TRUE(changed({}, flat).camera.parallel);
}

TEST(SceneChanges, OpenscadsCameraOfSixNumbers) {
  const Camera camera = changed({}, with(&Texts::camera, "1,-2,3,0,0,1")).camera;
  EXPECT_EQ(camera.eye, Vec3(1, -2, 3));
  EXPECT_EQ(camera.target, Vec3(0, 0, 1));
  EXPECT_EQ(camera.up, Vec3(0, 0, 1));
  EXPECT_EQ(changed({}, with(&Texts::camera, "1,2,9,1,2,3")).camera.up, Vec3(0, 1, 0));
  EXPECT_EQ(changed({}, with(&Texts::camera, "1,2,-9,1,2,3")).camera.up, Vec3(0, -1, 0));
}

TEST(SceneChanges, OpenscadsCameraIsRefusedWhereItIsNone) {
  const std::string expected =
      "--camera: expected X,Y,Z,ROTX,ROTY,ROTZ,DISTANCE or EYEX,EYEY,EYEZ,X,Y,Z as OpenSCAD "
      "writes them, found ";
  for (const std::string text : {"1,2,3", "1,2,3,1,2,3", "0,0,0,0,0,0,0", "0,0,0,0,0,0,-1",
                                 "0,0,0,0,0,0,1,2", "0,0,0,a,0,0,1"})
    EXPECT_EQ(error_of(with(&Texts::camera, text)), expected + "'" + text + "'");
}

TEST(SceneChanges, ErrorsNameTheOptionAndWhatWasExpected) {
  EXPECT_EQ(error_of(light("nan,45")),
            "--light: expected AZ,EL in degrees, EL from -90 to 90, found 'nan,45'");
  EXPECT_EQ(error_of(light("0,91")),
            "--light: expected AZ,EL in degrees, EL from -90 to 90, found '0,91'");
  EXPECT_EQ(error_of(with(&Texts::up, "0,0,0")),
            "--up: expected X,Y,Z, a direction that is not 0,0,0, found '0,0,0'");
  EXPECT_EQ(error_of(with(&Texts::eye, "1,2,3", with(&Texts::target, "1,2,3"))),
            "--target: expected a point that is not the eye, found '1,2,3'");
  EXPECT_EQ(
      error_of(with(&Texts::fov, "180")),
      "--fov: expected DEG, the vertical angle of view, above 0 and at most 179, found '180'");
  EXPECT_EQ(error_of(with(&Texts::density, "0.8,2")),
            "--density: expected K,HMAX, both from 0 to 1, found '0.8,2'");
}

TEST(SceneChanges, WhatExcludesEachOtherIsNamed) {
  EXPECT_EQ(error_of(with(&Texts::eye, "1,2,3", with(&Texts::azimuth, "30"))),
            "--eye excludes --azimuth");
  EXPECT_EQ(error_of(with(&Texts::fov, "30", with(&Texts::fit))), "--fov excludes --fit");
  EXPECT_EQ(error_of(with(&Texts::no_light, light("0,45"))), "--light excludes --no-light");
}

}  // namespace
}  // namespace overstrike
