#pragma once
// Convex scenes for the tests beside this file: bodies apart by construction, each in its own place
// of a grid, standing on the ground and on each other, side by side, hanging and leaning.
#include "core/picture.h"
#include "core/visibility/test_scenes.h"

namespace overstrike::nn74::testing {

using overstrike::testing::add;

/// Numbers from a seed, the same with every library.
class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(random_()) / 4294967296.0);
  }
  unsigned below(unsigned n) { return static_cast<unsigned>(random_()) % n; }

 private:
  std::mt19937 random_;
};

inline void tilt(Body& body, double degrees) {
  const double c = cos_deg(degrees), s = sin_deg(degrees);
  body.placement.linear =
      body.placement.linear * Mat3(Vec3(1, 0, 0), Vec3(0, c, s), Vec3(0, -s, c));
}

/// A tower of boxes, each on the other's top, some as wide.
inline void add_tower(Scene& scene, Dice& dice, Vec3 at, double turn) {
  Vec3 size(dice.between(.6, 1.4), dice.between(.6, 1.4), 0);
  const unsigned storeys = 1 + dice.below(3);
  for (unsigned i = 0; i < storeys; ++i) {
    size.z = dice.between(.2, .8);
    add(scene, Box{size}, at, turn);
    at.z += size.z;
    if (dice.below(2) == 0) size = Vec3(size.x * dice.between(.4, 1), size.y * .75, 0);
  }
}

/// Two boxes with a wall in common, and a poster on the first's outer wall.
inline void add_pair(Scene& scene, Dice& dice, const Vec3& at) {
  const double depth = dice.between(.4, 1.2);
  add(scene, Box{{.5, depth, dice.between(.3, 1)}}, at - Vec3(.25, 0, 0));
  add(scene, Box{{.5, depth, dice.between(.3, 1)}}, at + Vec3(.25, 0, 0));
  const double y = at.y - depth / 2;
  add(scene, FlatPolygon{{{{at.x - .4, y, .05}, {at.x - .1, y, .05}, {at.x - .25, y, .25}}}});
}

inline void add_screen(Scene& scene, Dice& dice, const Vec3& at) {
  std::vector<Vec3> loop;
  const unsigned sides = 3 + dice.below(4);
  for (unsigned i = 0; i < sides; ++i) {
    const double angle = 360.0 * i / sides;
    loop.emplace_back(.8 * cos_deg(angle), .8 * sin_deg(angle), 0);
  }
  tilt(add(scene, FlatPolygon{{loop}}, at + Vec3(0, 0, 1), dice.between(0, 360)),
       dice.between(0, 180));
}

inline void add_one(Scene& scene, Dice& dice, const Vec3& at) {
  const double turn = dice.between(0, 360);
  switch (dice.below(7)) {
    case 0:
      return add_tower(scene, dice, at, turn);
    case 1:
      return add_pair(scene, dice, at);
    case 2:
      return add_screen(scene, dice, at);
    case 3:
      add(scene, Frustum{.8, dice.between(0, .8), dice.between(.3, 2), 3 + (int)dice.below(9)}, at,
          turn);
      return;
    case 4:
      add(scene, Ellipsoid{{.8, .6, dice.between(.3, .9)}, 8, 5}, at + Vec3(0, 0, 1), turn);
      return;
    case 5:
      tilt(add(scene, Box{{.7, .5, .9}}, at + Vec3(0, 0, 1), turn), dice.between(0, 360));
      return;
    default:
      add(scene, Tetrahedron{{{.8, 0, 0}, {-.4, .7, 0}, {-.4, -.7, 0}, {0, .1, 1.4}}}, at, turn);
  }
}

inline Scene town(unsigned seed, int side = 3) {
  Dice dice(seed);
  Scene scene;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) add_one(scene, dice, Vec3(2.2 * i, 2.2 * j, 0));
  scene.light = Direction{dice.between(0, 360), dice.between(10, 80)};
  scene.ground_z = 0;
  scene.camera.from = {dice.between(0, 360), dice.between(5, 70)};
  return scene;
}

}  // namespace overstrike::nn74::testing
