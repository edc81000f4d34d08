#include "tests/oracle/random_scenes.h"

#include <array>
#include <cmath>
#include <utility>

#include "tests/oracle/random.h"

namespace overstrike::oracle {
namespace {

// Numbers are drawn in a fixed order: within braces, never among the arguments of one call.

Body body(Shape shape, const Affine& placement = {}) {
  Body b;
  b.shape = std::make_shared<const Shape>(std::move(shape));
  b.placement = placement;
  return b;
}

Shape convex_shape(Random& r) {
  switch (r.below(6)) {
    case 0:
      return Box{r.within(Vec3(0.4), Vec3(1.8))};
    case 1:
      return Frustum{r.in(0.4, 1), r.chance(0.3) ? 0 : r.in(0.3, 1), r.in(0.5, 2), 3 + r.below(8)};
    case 2:
      return Wedge{r.within(Vec3(0.5), Vec3(1.5)), r.in(0, 0.4), r.in(-0.1, 0.1)};
    case 3: {
      const Vec3 a(-0.9, -0.8, -0.6), b(1, -0.7, -0.5), c(r.in(-0.5, 0.5), 1.1, -0.6);
      return Tetrahedron{{a, b, c, Vec3(0, r.in(-0.3, 0.3), 1)}};
    }
    case 4:
      return Ellipsoid{r.within(Vec3(0.5), Vec3(1.1))};
    default:
      return Frustum{r.in(0.4, 0.8), r.in(0.4, 0.8), r.in(0.5, 1.5), 0};
  }
}

/// A simple polygon: its corners turn once round the origin.
std::vector<Vec2> star(Random& r, int corners, double inner, double outer) {
  std::vector<Vec2> loop;
  for (int i = 0; i < corners; ++i) {
    // Round the square |x| + |y| = 1, which needs no cosine.
    const double s = 4.0 * i / corners;
    const double f = s - std::floor(s);
    const std::array<Vec2, 4> quarter{Vec2(1 - f, f), Vec2(-f, 1 - f), Vec2(f - 1, -f),
                                      Vec2(f, f - 1)};
    loop.push_back(quarter[static_cast<std::size_t>(s)] * r.in(inner, outer));
  }
  return loop;
}

std::vector<Vec2> ell(Random& r) {
  const double a = r.in(0.3, 0.6), w = r.in(0.8, 1.4), h = r.in(0.8, 1.4);
  return {{0, 0}, {w, 0}, {w, a}, {a, a}, {a, h}, {0, h}};
}

Shape non_convex_shape(Random& r) {
  switch (r.below(6)) {
    case 0:
      return Extrusion{{{star(r, 6 + r.below(6), 0.9, 1.4), star(r, 4, 0.3, 0.6)}}, r.in(0.4, 1.2)};
    case 1:
      return Extrusion{{{ell(r)}}, r.in(0.3, 1.2)};
    case 2:
      return Torus{r.in(0.8, 1.1), r.in(0.2, 0.4)};
    case 3:
      return Revolution{{{0.4, 0}, {1, 0.1}, {0.6, 0.5}, {0.9, 1}, {0.3, 0.9}},
                        r.chance(0.5) ? 360 : r.in(60, 300),
                        5 + r.below(6)};
    case 4:
      return Sweep{{{-0.2, -0.2}, {0.2, -0.2}, {0.2, 0.2}, {-0.2, 0.2}},
                   {{-1, -0.8, 0}, {0.8, -0.8, 0}, {0.8, 0.9, 0.3}, {0.2, 0.9, 1.2}},
                   false};
    default:
      return Extrusion{{{star(r, 8, 0.5, 1.4)}}, r.in(0.3, 1.5)};
  }
}

using Bodies = std::vector<Body>;

/// Three by three places far enough apart that nothing meets.
Bodies apart(Random& r, Shape (*shape)(Random&)) {
  Bodies made;
  for (int i = 0; i < 9; ++i) {
    if (r.chance(0.3)) continue;
    const Vec3 place(3.6 * (i % 3) - 3.6, 3.6 * (i / 3) - 3.6, r.in(0, 1));
    Shape one = shape(r);
    made.push_back(body(std::move(one), {r.chance(0.7) ? turn(r) : Mat3(1), place}));
  }
  if (made.empty()) made.push_back(body(shape(r)));
  return made;
}

Bodies interpenetrating(Random& r) {
  Bodies made;
  for (int i = 4 + r.below(5); i > 0; --i) {
    const Vec3 place = r.within(Vec3(-1.2, -1.2, 0), Vec3(1.2, 1.2, 1.5));
    Shape shape = r.chance(0.7) ? convex_shape(r) : non_convex_shape(r);
    made.push_back(body(std::move(shape), {turn(r), place}));
  }
  return made;
}

/// Three bars, each over the next; and a fourth through them now and then.
Bodies cyclic(Random& r) {
  const double length = r.in(2.5, 4), tilt = r.in(0.12, 0.2);
  Bodies made;
  for (int i = 0; i < 3; ++i) {
    const double c = i == 0 ? 1 : -0.5, s = i == 0 ? 0 : (i == 1 ? 1 : -1) * std::sqrt(0.75);
    const Mat3 about_z(c, s, 0, -s, c, 0, 0, 0, 1);
    const double n = 1 / std::sqrt(1 + tilt * tilt);
    const Mat3 lean(n, 0, tilt * n, 0, 1, 0, -tilt * n, 0, n);
    const Vec3 place = about_z * Vec3(0, -0.5 - r.in(0, 0.2), 1);
    made.push_back(body(Box{Vec3(length, 0.3, 0.1)}, {about_z * lean, place}));
  }
  if (r.chance(0.4)) made.push_back(body(Box{Vec3(0.2, 0.2, 3)}, {turn(r), Vec3(0, 0, 1)}));
  return made;
}

/// Boxes that share faces, parts of faces, edges and corners; all on eighths, so that what touches
/// does so exactly; or turned together, so that it touches but for rounding.
Bodies touching(Random& r) {
  const Affine together{r.chance(0.35) ? turn_about_z(r) : Mat3(1), Vec3(0)};
  const auto eighths = [&r](int low, int high) { return (low + r.below(high - low + 1)) / 8.0; };
  Bodies made;
  double x = -2;
  for (int column = 0; column < 4; ++column) {
    const double width = eighths(4, 9);
    double z = 0;
    for (int floor = 1 + r.below(3); floor > 0; --floor) {
      const Vec3 size{floor == 1 ? width : width - 0.25, eighths(4, 12), eighths(3, 8)};
      const Vec3 place(x + width / 2, eighths(-4, 4), z);
      made.push_back(body(Box{size}, together * Affine{Mat3(1), place}));
      z += size.z;
    }
    x += width;
  }
  return made;
}

FlatPolygon polygon(const std::vector<std::vector<Vec2>>& loops) {
  FlatPolygon made;
  for (const auto& loop : loops) {
    made.loops.emplace_back();
    for (const Vec2& p : loop) made.loops.back().emplace_back(p, 0.0);
  }
  return made;
}

Bodies flat(Random& r) {
  Bodies made;
  for (int i = 4 + r.below(4); i > 0; --i) {
    const Affine place{turn(r), r.within(Vec3(-1.5, -1.5, 0.5), Vec3(1.5, 1.5, 2.5))};
    std::vector<std::vector<Vec2>> loops{star(r, 3 + r.below(6), 0.8, 1.5)};
    if (r.chance(0.4)) loops.push_back(star(r, 4, 0.2, 0.35));
    made.push_back(body(polygon(loops), place));
  }
  // On one plane: two that overlap, over a box's top.
  made.push_back(body(Box{Vec3(2, 2, 0.5)}, {Mat3(1), Vec3(1, 0, 0)}));
  for (int i = 0; i < 2; ++i)
    made.push_back(body(polygon({star(r, 5, 0.7, 1.6)}), {Mat3(1), Vec3(i, 0.25, 0.5)}));
  return made;
}

Bodies mixed(Random& r) {
  Bodies made = touching(r);
  for (Body& b : interpenetrating(r)) made.push_back(std::move(b));
  const Mat3 turned = turn(r);
  made.push_back(body(polygon({star(r, 7, 0.6, 2)}), {turned, Vec3(0, 0, 1.5)}));
  return made;
}

Bodies bodies_of(Family family, Random& r) {
  switch (family) {
    case Family::convex:
      return apart(r, convex_shape);
    case Family::non_convex:
      return apart(r, non_convex_shape);
    case Family::interpenetrating:
      return interpenetrating(r);
    case Family::cyclic:
      return cyclic(r);
    case Family::touching:
      return touching(r);
    case Family::flat:
      return flat(r);
    case Family::mixed:
      break;
  }
  return mixed(r);
}

}  // namespace

Scene random_scene(int n) {
  Random r(0x4E4E3734u + static_cast<std::uint64_t>(n));
  Scene scene;
  scene.bodies = bodies_of(static_cast<Family>(n % kFamilies), r);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    Body& b = scene.bodies[i];
    b.name = "body " + std::to_string(i);
    if (r.chance(0.5)) b.density_factor = r.in(0.5, 1.3);
    if (r.chance(0.3)) b.shading = Shading::smooth;
  }
  if (r.chance(0.8)) scene.light = Direction{r.in(-180, 180), r.in(15, 80)};
  if (r.chance(0.6))
    scene.ground_z = static_cast<Family>(n % kFamilies) == Family::touching ? 0 : r.in(-2, 0.2);
  scene.source = "random scene " + std::to_string(n);
  return seen_from(std::move(scene), n, 0);
}

Scene seen_from(Scene scene, int n, int view) {
  Random r(static_cast<std::uint64_t>(n * kViews + view) * 0x2545F491u);
  Camera camera;
  if (view == 0) {
    camera.from = {r.in(-180, 180), r.in(15, 60)};
  } else if (view == 1) {
    camera.from = {r.in(-180, 180), r.in(-50, 85)};
    camera.parallel = true;
  } else {
    const bool among = n % 2 == 0;
    camera.eye = among ? r.within(Vec3(-1, -1, 0.3), Vec3(1, 1, 1.5))
                       : r.within(Vec3(-7, -7, 3), Vec3(-4, -4, 6));
    camera.target = r.within(Vec3(-0.5, 2, 0), Vec3(0.5, 3, 1));
    if (!among) camera.target = r.within(Vec3(-0.5, -0.5, 0), Vec3(0.5, 0.5, 1));
    camera.fov_deg = r.in(40, 90);
    camera.near_distance = r.in(0.05, 0.4);
  }
  scene.camera = camera;
  return scene;
}

std::string describe(int n, int view) {
  constexpr std::array kNames{"convex", "non-convex", "interpenetrating", "cyclic", "touching",
                              "flat",   "mixed"};
  return "random scene " + std::to_string(n) + " (" +
         kNames[static_cast<std::size_t>(n % kFamilies)] + "), view " + std::to_string(view);
}

}  // namespace overstrike::oracle
