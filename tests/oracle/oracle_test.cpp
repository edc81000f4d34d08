// The oracle against scenes whose answer is known in closed form.
#include "tests/oracle/oracle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "core/geometry/tessellate.h"
#include "tests/oracle/exact.h"

namespace overstrike::oracle {
namespace {

constexpr double kDegrees = 3.14159265358979323846 / 180;

/// Points this near to a closed-form edge (grid units) are not asked about: the closed forms below
/// are computed in doubles.
constexpr double kClose = 1e-6;

Body body(Shape shape, Vec3 at = Vec3(0)) {
  Body b;
  b.shape = std::make_shared<const Shape>(std::move(shape));
  b.placement.offset = at;
  return b;
}

Shape square(double half, double z) {
  return FlatPolygon{{{{-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}}}};
}

/// 100 x 100 square cells, 4 world units wide unless told: 25 cells to a unit, the look-at point in
/// the middle.
class Picture {
 public:
  explicit Picture(const Scene& scene, double chord_cells = 0.05)
      : view_(make_view(scene, Grid{100, 100, 1, 1})),
        canonical_(canonicalize(scene, view_, chord_cells, warnings_)),
        oracle_(canonical_, view_) {
    EXPECT_TRUE(warnings_.empty());
  }
  Seen at(double x, double y) const { return oracle_.at(x, y); }
  Seen at(const Vec2& p) const { return oracle_.at(p.x, p.y); }
  const Oracle& oracle() const { return oracle_; }
  Vec3 outward(const Seen& s) const { return canonical_.outward(canonical_.faces[s.face]); }
  const View& view() const { return view_; }

 private:
  std::vector<Diagnostic> warnings_;
  View view_;
  Canonical canonical_;
  Oracle oracle_;
};

Scene looking(Vec3 look_at, double azimuth, double elevation) {
  Scene scene;
  scene.camera.look_at = look_at;
  scene.camera.from = {azimuth, elevation};
  scene.camera.distance = 10;
  scene.camera.parallel = true;
  scene.camera.window_width = 4;
  return scene;
}

/// From straight above, x to the right and y up: grid (50 + 25 X, 50 - 25 Y).
Scene from_above() {
  Scene scene;
  scene.camera.eye = Vec3(0, 0, 10);
  scene.camera.target = Vec3(0, 0, 0);
  scene.camera.up = Vec3(0, 1, 0);
  scene.camera.parallel = true;
  scene.camera.window_width = 4;
  return scene;
}
Vec2 world_of(const Vec2& grid) { return {(grid.x - 50) / 25, (50 - grid.y) / 25}; }

template <class Check>
void at_random_points(int count, const Check& check) {
  std::mt19937_64 bits(7);
  const auto uniform = [&bits] { return static_cast<double>(bits() >> 11) * 0x1p-53 * 100; };
  for (int i = 0; i < count; ++i) {
    const double x = uniform();
    check(Vec2(x, uniform()));
  }
}

/// Law of a rectangle: the box's face of this normal inside, paper outside.
void expect_rectangle(const Picture& picture, double half, const Vec3& normal) {
  at_random_points(500, [&](const Vec2& p) {
    const double out = std::max(std::fabs(p.x - 50), std::fabs(p.y - 50)) - half;
    if (std::fabs(out) < kClose) return;
    const Seen seen = picture.at(p);
    ASSERT_EQ(seen.paper(), out > 0) << p.x << ' ' << p.y;
    if (out >= 0) return;
    EXPECT_GT(glm::dot(picture.outward(seen), normal), 1 - 1e-12);
  });
}

TEST(Oracle, BoxFaceOnIsARectangle) {
  Scene scene = looking(Vec3(0, 0, 1), 0, 0);
  scene.bodies = {body(Box{Vec3(2)})};
  expect_rectangle(Picture(scene), 25, Vec3(1, 0, 0));
  scene.camera.parallel = false;
  expect_rectangle(Picture(scene), 25 * 10.0 / 9, Vec3(1, 0, 0));
}

TEST(Oracle, EdgesOfARectangleAreWhereTheyAre) {
  Scene scene = looking(Vec3(0, 0, 1), 0, 0);
  scene.bodies = {body(Box{Vec3(2)})};
  const Picture picture(scene);
  for (const double y : {30.3, 50.0, 71.9}) {
    EXPECT_TRUE(picture.at(25 - 1e-9, y).paper());
    EXPECT_FALSE(picture.at(25 + 1e-9, y).paper());
    EXPECT_TRUE(picture.oracle().near_edge(25, y, kEdgeRadius));
    EXPECT_FALSE(picture.oracle().near_edge(25.1, y, kEdgeRadius));
  }
}

/// The convex hull's edges have every point on their left.
bool in_hull(const std::vector<Vec2>& points, const Vec2& p, double& distance) {
  bool inside = true;
  distance = 1e9;
  for (const Vec2& a : points)
    for (const Vec2& b : points) {
      const Vec2 d = b - a;
      const double length = glm::length(d);
      if (length == 0) continue;
      const auto left = [&](const Vec2& q) {
        return (d.x * (q.y - a.y) - d.y * (q.x - a.x)) / length;
      };
      if (std::any_of(points.begin(), points.end(),
                      [&](const Vec2& q) { return left(q) < -1e-12; }))
        continue;
      inside = inside && left(p) > 0;
      distance = std::min(distance, std::fabs(left(p)));
    }
  return inside;
}

TEST(Oracle, CubeCastsTheGroundShadowOfNN74) {
  Scene scene = from_above();
  scene.light = Direction{30, 60};
  scene.ground_z = 0;
  scene.bodies = {body(Box{Vec3(1)})};
  const Picture picture(scene);
  std::vector<Vec2> shadow;
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5})
      for (const double z : {0.0, 1.0}) {
        const double reach = z / std::tan(60 * kDegrees);  // NN74 (3)
        shadow.emplace_back(x - std::cos(30 * kDegrees) * reach,
                            y - std::sin(30 * kDegrees) * reach);
      }
  int shadows = 0;
  at_random_points(1000, [&](const Vec2& g) {
    const Vec2 p = world_of(g);
    const double to_box = std::max(std::fabs(p.x), std::fabs(p.y)) - 0.5;
    double to_hull = 0;
    const bool inside = in_hull(shadow, p, to_hull);
    if (std::min(std::fabs(to_box), to_hull) < kClose) return;
    const Seen seen = picture.at(g);
    if (to_box < 0) {
      EXPECT_EQ(seen.kind, Kind::lit);
      EXPECT_NEAR(seen.density, 1 - 0.8 * std::sin(60 * kDegrees), 1e-12);  // NN74 (15)
    } else if (inside) {
      ++shadows;
      EXPECT_EQ(seen.kind, Kind::ground_shadow);
      EXPECT_EQ(seen.density, 0.85);
      EXPECT_EQ(seen.body, kNone);
    } else {
      EXPECT_TRUE(seen.paper());
    }
  });
  EXPECT_GT(shadows, 10);
}

/// A pale rug under a plate, in whose shadow the ground beside it is darker.
TEST(Oracle, ARugIsSeenInTheShadowToo) {
  Scene scene = looking(Vec3(0), 0, 30);
  scene.light = Direction{0, 90};
  scene.ground_z = 0;
  const FlatPolygon square{{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}}};
  scene.bodies = {body(square), body(Box{Vec3(4, 4, 1)}, Vec3(0, 0, 9))};
  scene.bodies[0].density_factor = 0.5;
  const Picture picture(scene);
  const Seen rug = picture.at(50, 50);
  EXPECT_EQ(rug.body, 0u);
  EXPECT_EQ(rug.kind, Kind::shadow);
  EXPECT_EQ(rug.density, 0.5);
}

TEST(Oracle, GroundIsNotSeenFromBelow) {
  Scene scene = looking(Vec3(0), 0, -30);
  scene.light = Direction{30, 60};
  scene.ground_z = 0;
  scene.bodies = {body(Box{Vec3(1)})};
  const Picture picture(scene);
  at_random_points(300, [&](const Vec2& g) { EXPECT_NE(picture.at(g).kind, Kind::ground_shadow); });
  const Seen underside = picture.at(50, 50);
  EXPECT_EQ(picture.outward(underside), Vec3(0, 0, -1));
  EXPECT_EQ(underside.kind, Kind::shade);
}

TEST(Oracle, ABodyHidesAnotherExactly) {
  for (const bool parallel : {true, false}) {
    Scene scene = looking(Vec3(0), 0, 90);
    scene.camera = from_above().camera;
    scene.camera.parallel = parallel;
    // In perspective the far square is as much larger as it is farther.
    scene.bodies = {body(square(parallel ? 1 : 1.5, -5)), body(square(1, 0))};
    const Picture picture(scene);
    int hits = 0;
    at_random_points(1000, [&](const Vec2& g) {
      const Seen seen = picture.at(g);
      if (seen.face == kNone) return;
      ++hits;
      EXPECT_EQ(seen.body, 1u);
    });
    EXPECT_NEAR(hits, 250, 60);
  }
}

TEST(Oracle, SphereIsADisc) {
  Scene scene = looking(Vec3(0), 20, 35);
  scene.bodies = {body(Ellipsoid{Vec3(1)})};
  scene.light = Direction{20, 35};
  constexpr double kChord = 0.05;
  const Picture picture(scene, kChord);
  at_random_points(400, [&](const Vec2& g) {
    const double radius = glm::length(g - Vec2(50, 50));
    // The contour's chords stay within the tolerance, and inside.
    if (radius > 25 - 2 * kChord && radius < 25) return;
    const Seen seen = picture.at(g);
    ASSERT_EQ(seen.paper(), radius >= 25) << radius;
  });
}

TEST(Oracle, SmoothShadingFollowsTheTrueNormal) {
  Scene scene = looking(Vec3(0), 20, 35);
  scene.bodies = {body(Ellipsoid{Vec3(1)})};
  scene.bodies[0].shading = Shading::smooth;
  scene.light = Direction{20, 35};
  const Picture picture(scene);
  at_random_points(200, [&](const Vec2& g) {
    const double radius = glm::length(g - Vec2(50, 50)) / 25;
    if (radius > 0.9) return;
    const double cosine = std::sqrt(1 - radius * radius);
    // Facets span 7 degrees; linear between corners is off by k (1 - cos 3.6 degrees) and the
    // chord.
    EXPECT_NEAR(picture.at(g).density, 1 - 0.8 * cosine, 0.005) << radius;
  });
}

TEST(Oracle, ShadowFallsOnAFace) {
  Scene scene = from_above();
  scene.light = Direction{0, 45};
  scene.bodies = {body(square(1.5, 0)), body(square(0.25, 1))};
  const Picture picture(scene);
  at_random_points(500, [&](const Vec2& g) {
    const Vec2 p = world_of(g);
    const double to_square = std::max(std::fabs(p.x), std::fabs(p.y)) - 0.25;
    const double to_shadow = std::max(std::fabs(p.x + 1), std::fabs(p.y)) - 0.25;  // NN74 (3)
    const double to_rim = std::max(std::fabs(p.x), std::fabs(p.y)) - 1.5;
    if (std::min({std::fabs(to_square), std::fabs(to_shadow), std::fabs(to_rim)}) < kClose) return;
    const Seen seen = picture.at(g);
    ASSERT_EQ(seen.body, to_square < 0 ? 1 : to_rim < 0 ? 0 : kNone);
    if (seen.paper()) return;
    EXPECT_EQ(seen.kind, to_shadow < 0 ? Kind::shadow : Kind::lit);
    EXPECT_NEAR(seen.density, to_shadow < 0 ? 1 : 1 - 0.8 * std::sqrt(0.5), 1e-12);
  });
}

TEST(Oracle, CrossingPlanesSplitWhereTheyCross) {
  Scene scene = from_above();
  const auto leaning = [](double slope) {
    return FlatPolygon{{{{-1, -1, -slope}, {1, -1, slope}, {1, 1, slope}, {-1, 1, -slope}}}};
  };
  scene.bodies = {body(leaning(0.5)), body(leaning(-0.25))};
  const Picture picture(scene);
  for (const double y : {30.0, 49.7, 70.1}) {
    EXPECT_EQ(picture.at(50 - 1e-9, y).body, 1u);
    EXPECT_EQ(picture.at(50 + 1e-9, y).body, 0u);
  }
}

TEST(Oracle, TheDarkerOfEqualDepthsWinsInAnyOrder) {
  for (const bool swapped : {false, true}) {
    Scene scene = from_above();
    scene.bodies = {body(square(1, 0.5)), body(square(0.5, 0.5))};
    if (swapped) std::swap(scene.bodies[0], scene.bodies[1]);
    const Index small = swapped ? 0 : 1;
    scene.bodies[small].density_factor = 2;
    EXPECT_EQ(Picture(scene).at(50, 50).body, small);
    scene.bodies[small].density_factor = 0.5;
    EXPECT_EQ(Picture(scene).at(50, 50).body, 1 - small);
    // Equal densities: the smaller first vertex, that of the larger square.
    scene.bodies[small].density_factor = 1;
    EXPECT_EQ(Picture(scene).at(50, 50).body, 1 - small);
  }
}

/// What has no tone at all was once compared with a face that there is not.
TEST(Oracle, FacesWithoutInkAreSeenToo) {
  Scene scene = from_above();
  scene.bodies = {body(square(1, 1))};
  scene.bodies[0].density_factor = 0;
  const Seen seen = Picture(scene).at(50, 50);
  EXPECT_EQ(seen.face, 0u);
  EXPECT_EQ(seen.density, 0);
}

TEST(Oracle, HolesAreOpen) {
  Scene scene = from_above();
  FlatPolygon frame{{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}},
                     {{-0.5, -0.5, 0}, {-0.5, 0.5, 0}, {0.5, 0.5, 0}, {0.5, -0.5, 0}}}};
  scene.bodies = {body(frame)};
  const Picture picture(scene);
  at_random_points(500, [&](const Vec2& g) {
    const Vec2 p = world_of(g);
    const double square_radius = std::max(std::fabs(p.x), std::fabs(p.y));
    EXPECT_EQ(picture.at(g).paper(), square_radius < 0.5 || square_radius > 1);
  });
}

Scene inside(Vec3 eye, Vec3 target) {
  Scene scene;
  scene.camera.eye = eye;
  scene.camera.target = target;
  scene.camera.fov_deg = 60;
  scene.camera.near_distance = 0.1;
  return scene;
}

TEST(Oracle, EyeInsideABodySeesItCut) {
  Scene scene = inside(Vec3(0, 0, 0.5), Vec3(1, 0, 0.5));
  scene.bodies = {body(Box{Vec3(1)}), body(Box{Vec3(1)}, Vec3(3, 0, 0))};
  scene.bodies[0].density_factor = 0.6;
  const Picture picture(scene);
  at_random_points(200, [&](const Vec2& g) {
    const Seen seen = picture.at(g);
    EXPECT_EQ(seen.kind, Kind::cut);
    EXPECT_EQ(seen.body, 0u);
    EXPECT_NEAR(seen.density, 0.5 * 0.6, 1e-15);
  });
}

TEST(Oracle, NearPlaneCutsHalfABody) {
  // The near plane x = 0.1 lies in the box; the box takes up y < 0.
  Scene scene = inside(Vec3(0, 0.5, 0.5), Vec3(1, 0.5, 0.5));
  scene.bodies = {body(Box{Vec3(1, 2, 1)}, Vec3(0.4, -0.5, 0))};
  const Picture picture(scene);
  // Right of the middle is y < 0.5.
  EXPECT_EQ(picture.at(75, 50).kind, Kind::cut);
  EXPECT_TRUE(picture.at(25, 50).paper());
}

/// Two boxes of one mesh: what is in either is inside, in both all the more.
TEST(Oracle, ACutIsWhereTheWindingNumberIsNotZero) {
  Scene scene = looking(Vec3(0, 0, 1), 0, 0);
  scene.camera.near_distance = 10;
  Mesh two;
  for (const double shift : {-0.5, 0.5}) {
    const Polyhedron box = tessellate(Box{Vec3(2)}, 1, false);
    for (Index l = 0; l < box.loop_ends.size(); ++l) {
      std::vector<Index> loop;
      for (const Index v : box.loop(l))
        loop.push_back(two.polyhedron.add_vertex(box.vertices[v] + Vec3(0, shift, 0)));
      two.polyhedron.add_face(std::span<const Index>(loop));
    }
  }
  scene.bodies = {body(two)};
  const Picture picture(scene);
  EXPECT_EQ(picture.at(20, 50).kind, Kind::cut);
  EXPECT_EQ(picture.at(50, 50).kind, Kind::cut);
  EXPECT_EQ(picture.at(80, 50).kind, Kind::cut);
}

TEST(Oracle, AFloorThatReachesBehindTheEyeIsSeenUpToItsHorizon) {
  Scene scene = inside(Vec3(0, 0, 1), Vec3(1, 0, 1));
  scene.bodies = {body(square(1e6, 0))};
  const Picture picture(scene);
  at_random_points(300, [&](const Vec2& g) {
    if (std::fabs(g.y - 50) < 0.01) return;
    EXPECT_EQ(picture.at(g).paper(), g.y < 50) << g.y;
  });
}

TEST(Exact, SignsOfDegenerateDeterminants) {
  // (a + b)(a - b) - (a a - b b) is 0 exactly, and not in doubles.
  const auto difference = [](double a, double b, double d) {
    return sign_of([=]<class T>() {
      return (T(a) + T(b)) * (T(a) - T(b)) - (T(a) * T(a) - T(b) * T(b)) + T(d);
    });
  };
  std::mt19937_64 bits(1);
  for (int i = 0; i < 1000; ++i) {
    const double a = std::ldexp(static_cast<double>(bits() >> 11), -53);
    const double b =
        std::ldexp(static_cast<double>(bits() >> 11), static_cast<int>(bits() % 90) - 140);
    EXPECT_EQ(difference(a, b, 0), 0);
    EXPECT_EQ(difference(a, b, 1e-290), 1);
    EXPECT_EQ(difference(a, b, -1e-290), -1);
  }
}

TEST(Exact, AnApproxHoldsItsTrueValue) {
  std::mt19937_64 bits(2);
  const auto number = [&bits] {
    return std::ldexp(static_cast<double>(bits() >> 11) - 0x1p52,
                      static_cast<int>(bits() % 40) - 70);
  };
  for (int i = 0; i < 2000; ++i) {
    const double a = number(), b = number(), c = number(), d = number();
    const auto formula = [=]<class T>() { return (T(a) * T(b) - T(c) * T(d)) * (T(a) + T(c)); };
    const Approx approx = formula.operator()<Approx>();
    const Exact exact = formula.operator()<Exact>();
    EXPECT_GE((exact - Exact(approx.low())).sign(), 0);
    EXPECT_LE((exact - Exact(approx.high())).sign(), 0);
  }
}

}  // namespace
}  // namespace overstrike::oracle
