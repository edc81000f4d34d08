// Extrusions, revolutions and sweeps of random profiles, and their hard cases.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/geometry/polyhedron_laws.h"
#include "core/geometry/tessellate.h"

namespace overstrike {
namespace {

constexpr double kPi = 3.14159265358979323846;

/// A simple polygon about (x, 0): random radii at even angles, either way round.
std::vector<Vec2> random_star(std::mt19937_64& random, double x, double least, double most) {
  std::uniform_real_distribution<double> radius(least, most);
  const int count = 5 + static_cast<int>(random() % 20);
  std::vector<Vec2> star;
  for (int k = 0; k < count; ++k) {
    const double r = radius(random), a = 2 * kPi * k / count;
    star.push_back({x + r * std::cos(a), r * std::sin(a)});
  }
  if (random() % 2 == 0) std::reverse(star.begin(), star.end());
  return star;
}

double area(const std::vector<Vec2>& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
    sum += a.x * b.y - a.y * b.x;
  }
  return std::fabs(sum) / 2;
}

/// Area times the distance of its centroid from x = 0.
double moment(const std::vector<Vec2>& loop) {
  double sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
    sum += (a.x + b.x) * (a.x * b.y - a.y * b.x);
  }
  return std::fabs(sum) / 6;
}

void expect_solid(const Polyhedron& p, double true_volume, int euler) {
  EXPECT_EQ(unpaired_edges(p), 0);
  EXPECT_EQ(equal_vertices(p), 0);
  EXPECT_EQ(euler_characteristic(p), euler);
  EXPECT_NEAR(volume(p), true_volume, 1e-12 * true_volume);
  EXPECT_LT(worst_unevenness(p), 16);
  EXPECT_LT(worst_group_unevenness(p), 32);
}

TEST(SweptShapes, RandomExtrusions) {
  std::mt19937_64 random(29);
  for (int i = 0; i < 200; ++i) {
    const auto outline = random_star(random, 0, 3, 5), hole = random_star(random, 0, 1, 2);
    const auto island = random_star(random, 0, 0.2, 0.5), apart = random_star(random, 20, 1, 5);
    const Extrusion shape{{{island, outline, apart, hole}}, 2.5};
    ASSERT_EQ(validate(shape), "");
    const double base = area(outline) - area(hole) + area(island) + area(apart);
    expect_solid(tessellate(shape, 1, false), 2.5 * base, 4);
    ASSERT_FALSE(HasFailure()) << i;
  }
}

/// Pappus, with n chords for the circle: area times the path of the centroid, of which n sin(2
/// pi/n) stands for 2 pi.
TEST(SweptShapes, RandomRevolutions) {
  std::mt19937_64 random(31);
  for (int i = 0; i < 200; ++i) {
    const int n = 3 + static_cast<int>(random() % 30);
    const auto profile = random_star(random, 6, 1, 5);
    const Revolution ring{profile, 360, n};
    ASSERT_EQ(validate(ring), "");
    expect_solid(tessellate(ring, 1, false), moment(profile) * n * std::sin(2 * kPi / n), 0);
    const double angle = 1 + static_cast<double>(random() % 358);
    const Revolution part{profile, angle, n};
    expect_solid(tessellate(part, 1, false), moment(profile) * n * std::sin(angle * kPi / 180 / n),
                 2);
    ASSERT_FALSE(HasFailure()) << i;
  }
}

TEST(SweptShapes, LevelEdgesOfARevolutionAreOneFace) {
  const Revolution cake{{{0, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}}, 360, 12};
  const Polyhedron p = tessellate(cake, 1, false);
  EXPECT_EQ(p.face_count(), 3u * 12 + 4);
  ASSERT_EQ(p.plane_groups.size(), p.face_count());
  // The outer ledge and the floor of the hollow lie in one plane.
  std::vector<Index> at_one;
  for (Index f = 0; f < p.face_count(); ++f)
    if (std::fabs(glm::normalize(face_area(p, f)).z) == 1 &&
        p.vertices[p.indices[p.first_index(p.first_loop(f))]].z == 1)
      at_one.push_back(p.plane_groups[f]);
  ASSERT_EQ(at_one.size(), 2u);
  EXPECT_EQ(at_one[0], at_one[1]);
}

TEST(SweptShapes, FacetsOfOneStraightPieceShareAPlane) {
  const Polyhedron p =
      tessellate(Extrusion{{{{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}}}, 1}, 1, false);
  ASSERT_EQ(p.face_count(), 7u);
  EXPECT_EQ(p.plane_groups[2], p.plane_groups[3]);
  EXPECT_NE(p.plane_groups[3], p.plane_groups[4]);
  EXPECT_TRUE(
      tessellate(Extrusion{{{{{0, 0}, {1, 0}, {0, 2}}}}, 1}, 1, false).plane_groups.empty());
}

/// The axis may be touched in a point, along an edge, or twice.
TEST(SweptShapes, RevolutionsThatTouchTheAxis) {
  const std::vector<Vec2> crescent{{0, 0}, {2, 1}, {0, 2}, {1, 1}};
  const std::vector<Vec2> spindle{{0, 0}, {1, 1}, {0, 3}};
  for (double angle : {360.0, 180.0, 75.0}) {
    const Polyhedron hollow = tessellate(Revolution{crescent, angle, 8}, 1, false);
    const Polyhedron solid = tessellate(Revolution{spindle, angle, 8}, 1, false);
    EXPECT_EQ(unpaired_edges(hollow), 0) << angle;
    EXPECT_EQ(equal_vertices(hollow), 0) << angle;
    EXPECT_EQ(unpaired_edges(solid), 0) << angle;
    EXPECT_EQ(euler_characteristic(solid), 2) << angle;
    EXPECT_GT(volume(hollow), 0);
  }
}

/// Any open path: the centroid of the profile runs along it, so mitres change no volume.
TEST(SweptShapes, RandomSweeps) {
  std::mt19937_64 random(37);
  std::uniform_real_distribution<double> unit(-1, 1);
  const std::vector<Vec2> cross_section{{-0.2, -0.1}, {0.2, -0.1}, {0.2, 0.1}, {-0.2, 0.1}};
  int drawn = 0;
  for (int i = 0; i < 200; ++i) {
    Sweep sweep{cross_section, {{0, 0, 0}}, false};
    double length = 0;
    for (int k = 0; k < 6; ++k) {
      const Vec3 step = 2.0 * Vec3{unit(random), unit(random), unit(random)};
      sweep.path.push_back(sweep.path.back() + step);
      length += glm::length(step);
    }
    if (!validate(sweep).empty()) continue;
    ++drawn;
    expect_solid(tessellate(sweep, 1, false), 0.08 * length, 2);
    ASSERT_FALSE(HasFailure()) << i;
  }
  EXPECT_GT(drawn, 100);
}

/// Round a corner of a cube the frame comes back turned by the solid angle it has gone round: the
/// turn is spread, and the sides are triangles.
TEST(SweptShapes, ClosedPathInSpaceJoinsUp) {
  const std::vector<Vec2> square{{-0.2, -0.2}, {0.2, -0.2}, {0.2, 0.2}, {-0.2, 0.2}};
  const std::vector<Vec3> path{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {4, 4, 4}, {0, 4, 4}, {0, 4, 1}};
  const Sweep sweep{square, path, true};
  ASSERT_EQ(validate(sweep), "");
  const Polyhedron p = tessellate(sweep, 1, false);
  EXPECT_EQ(unpaired_edges(p), 0);
  EXPECT_EQ(euler_characteristic(p), 0);
  EXPECT_EQ(p.face_count(), 6u * 4 * 2);
  EXPECT_LT(worst_unevenness(p), 16);
  double length = 0;
  for (std::size_t i = 0; i < path.size(); ++i)
    length += glm::length(path[(i + 1) % path.size()] - path[i]);
  EXPECT_NEAR(volume(p), 0.16 * length, 0.03 * 0.16 * length);
}

TEST(SweptShapes, PlaneClosedPathKeepsPlaneSides) {
  const std::vector<Vec2> square{{-0.2, -0.2}, {0.2, -0.2}, {0.2, 0.2}, {-0.2, 0.2}};
  std::mt19937_64 random(41);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int i = 0; i < 50; ++i) {
    const Vec3 u = glm::normalize(Vec3{unit(random), unit(random), unit(random)});
    const Vec3 v = glm::normalize(glm::cross(u, Vec3{unit(random), unit(random), 1}));
    Sweep sweep{square, {}, true};
    for (int k = 0; k < 20; ++k)
      sweep.path.push_back(5.0 * (u * std::cos(kPi * k / 10) + v * std::sin(kPi * k / 10)));
    ASSERT_EQ(validate(sweep), "");
    const Polyhedron p = tessellate(sweep, 1, false);
    EXPECT_EQ(p.face_count(), 80u);
    expect_solid(p, 0.16 * 20 * 10 * std::sin(kPi / 20), 0);
  }
}

/// Where a sweep starts upright, x of the profile is to the right and y up as seen along the path.
TEST(SweptShapes, ProfileStandsAcrossThePath) {
  const std::vector<Vec2> corner{{0, 0}, {2, 0}, {0, 1}};
  const Polyhedron along_x = tessellate(Sweep{corner, {{0, 0, 0}, {5, 0, 0}}, false}, 1, false);
  EXPECT_EQ(along_x.vertices[1], Vec3(0, -2, 0));
  EXPECT_EQ(along_x.vertices[2], Vec3(0, 0, 1));
  const Polyhedron down = tessellate(Sweep{corner, {{0, 0, 5}, {0, 0, 0}}, false}, 1, false);
  EXPECT_EQ(down.vertices[1], Vec3(2, 0, 5));
  EXPECT_EQ(down.vertices[2], Vec3(0, 1, 5));
}

}  // namespace
}  // namespace overstrike
