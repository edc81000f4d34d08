// What tessellation promises of curved surfaces: chords, normals, bounds.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "core/geometry/circle.h"
#include "core/geometry/polyhedron_laws.h"
#include "core/geometry/tessellate.h"

namespace overstrike {
namespace {

/// Distance of a point inside an ellipsoid from its surface: along the nearest normal (D. Eberly,
/// Distance from a point to an ellipse, an ellipsoid), by bisection.
double depth_in_ellipsoid(const Vec3& r, const Vec3& p) {
  const auto excess = [&](double t) {
    const Vec3 q = r * p / (r * r + t);
    return glm::dot(q, q) - 1;
  };
  const double least = std::min({r.x, r.y, r.z});
  double low = -least * least * (1 - 1e-12), high = 0;
  for (int i = 0; i < 200; ++i) {
    const double middle = (low + high) / 2;
    (excess(middle) > 0 ? low : high) = middle;
  }
  return glm::length(r * r * p / (r * r + high) - p);
}

double across(const Vec3& p) { return std::hypot(p.x, p.y); }

struct Curved {
  const char* name;
  Shape shape;
  std::function<double(const Vec3&)> depth;  ///< of a facet's point below the true surface
};

std::vector<Curved> curved_shapes() {
  const auto in_torus = [](const Vec3& p) { return 1 - std::hypot(across(p) - 3, p.z); };
  return {
      {"cylinder", Frustum{2, 2, 5, 0}, [](const Vec3& p) { return 2 - across(p); }},
      {"cone", Frustum{3, 0, 3, 0},
       [](const Vec3& p) { return (3 - p.z - across(p)) / std::sqrt(2.0); }},
      {"sphere", Ellipsoid{Vec3{2}}, [](const Vec3& p) { return 2 - glm::length(p); }},
      {"lens", Ellipsoid{{3, 3, 1}},
       [](const Vec3& p) {
         return depth_in_ellipsoid({3, 3, 1}, p);
       }},
      {"rod", Ellipsoid{{1, 1, 6}},
       [](const Vec3& p) {
         return depth_in_ellipsoid({1, 1, 6}, p);
       }},
      {"pebble", Ellipsoid{{4, 2, 1}},
       [](const Vec3& p) {
         return depth_in_ellipsoid({4, 2, 1}, p);
       }},
      {"torus", Torus{3, 1}, [in_torus](const Vec3& p) { return std::fabs(in_torus(p)); }},
      {"quarter tube", Revolution{{{2, 0}, {3, 0}, {3, 1}, {2, 1}}, 90, 0},
       [](const Vec3& p) {
         const bool inner = across(p) < 2.5;
         return std::fabs((inner ? 2 : 3) - across(p));
       }},
  };
}

/// Facets of the caps and ends are no part of the curved surface.
bool is_curved_face(const Polyhedron& p, Index face) {
  const auto loop = p.loop(p.first_loop(face));
  const Vec3& normal = p.corner_normals[p.first_index(p.first_loop(face))];
  if (loop.size() > 4 || p.face_ends[face] - p.first_loop(face) > 1) return false;
  if (normal.x == 0 && std::fabs(normal.y) == 1) return false;  // the start of a part turn
  const Vec3& last = p.corner_normals[p.loop_ends[p.first_loop(face)] - 1];
  return loop.size() == 3 || p.corner_normals[p.first_index(p.first_loop(face)) + 1] != last ||
         normal != last;
}

TEST(RoundShapes, FacetsKeepTheChord) {
  std::mt19937_64 random(19);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const Curved& c : curved_shapes()) {
    for (double chord : {0.3, 0.05, 0.01}) {
      const Polyhedron p = tessellate(c.shape, chord, true);
      double furthest = 0;
      for (Index face = 0; face < p.face_count(); ++face) {
        if (!is_curved_face(p, face)) continue;
        const auto loop = p.loop(p.first_loop(face));
        for (int i = 0; i < 30; ++i) {
          Vec3 point{0};
          double sum = 0;
          for (Index corner : loop) {
            const double weight = i == 0 ? 1 : unit(random);
            point += weight * p.vertices[corner];
            sum += weight;
          }
          furthest = std::max(furthest, c.depth(point / sum));
        }
      }
      EXPECT_LE(furthest, chord * (1 + 1e-9)) << c.name;
      // Not finer than asked, but for whole numbers of sides.
      if (chord < 0.1) {
        EXPECT_GT(furthest, chord / 3) << c.name;
      }
    }
  }
}

TEST(RoundShapes, VerticesLieOnTheSurface) {
  for (const Curved& c : curved_shapes()) {
    const Polyhedron p = tessellate(c.shape, 0.05, false);
    for (const Vec3& v : p.vertices) EXPECT_NEAR(c.depth(v), 0, 2e-12) << c.name;
  }
}

TEST(RoundShapes, NormalsAreUnitAndOutward) {
  for (const Curved& c : curved_shapes()) {
    const Polyhedron p = tessellate(c.shape, 0.05, true);
    ASSERT_EQ(p.corner_normals.size(), p.indices.size()) << c.name;
    for (Index face = 0; face < p.face_count(); ++face) {
      const Vec3 flat = glm::normalize(face_area(p, face));
      for (Index i = p.first_index(p.first_loop(face)); i < p.loop_ends[p.face_ends[face] - 1];
           ++i) {
        EXPECT_NEAR(glm::length(p.corner_normals[i]), 1, 4e-16) << c.name;
        EXPECT_GT(glm::dot(flat, p.corner_normals[i]), 0.5) << c.name;
      }
    }
    EXPECT_TRUE(tessellate(c.shape, 0.05, false).corner_normals.empty());
  }
}

TEST(RoundShapes, NormalsAreThoseOfTheTrueSurface) {
  const Polyhedron sphere = tessellate(Ellipsoid{Vec3{2}}, 0.05, true);
  for (std::size_t i = 0; i < sphere.indices.size(); ++i)
    EXPECT_LT(glm::length(sphere.corner_normals[i] - sphere.vertices[sphere.indices[i]] / 2.0),
              1e-15);
  const Polyhedron pebble = tessellate(Ellipsoid{{4, 2, 1}}, 0.05, true);
  for (std::size_t i = 0; i < pebble.indices.size(); ++i) {
    const Vec3 gradient = pebble.vertices[pebble.indices[i]] / Vec3{16, 4, 1};
    EXPECT_LT(glm::length(pebble.corner_normals[i] - glm::normalize(gradient)), 1e-14);
  }
  const Polyhedron cylinder = tessellate(Frustum{2, 2, 5, 0}, 0.05, true);
  std::size_t caps = 0;
  for (std::size_t i = 0; i < cylinder.indices.size(); ++i) {
    const Vec3 v = cylinder.vertices[cylinder.indices[i]], n = cylinder.corner_normals[i];
    const bool cap = n.z != 0;
    caps += cap;
    EXPECT_LT(glm::length(n - (cap ? Vec3{0, 0, v.z == 0 ? -1 : 1} : Vec3{v.x / 2, v.y / 2, 0})),
              1e-15);
  }
  EXPECT_EQ(caps * 3, cylinder.indices.size());  // each side: two corners of caps, four of its own
}

TEST(RoundShapes, PointsOfTheCircleMirrorExactly) {
  for (int n = 3; n < 200; ++n) {
    for (int k = 0; k <= n; ++k) {
      const Vec2 p = turn(k, n), mirrored = turn(n - k, n);
      EXPECT_EQ(p.x, mirrored.x);
      EXPECT_EQ(p.y, -mirrored.y);
      if (n % 2 == 0) {
        EXPECT_EQ(turn(k + n / 2, n), -p);
      }
      if (n % 4 == 0) {
        EXPECT_EQ(turn(k + n / 4, n), Vec2(-p.y, p.x));
      }
    }
  }
  EXPECT_EQ(turn(1, 4), Vec2(0, 1));
  EXPECT_EQ(turn(1, 12).y, 0.5);
}

/// A horn torus has its middle as one vertex, or a narrow hole where no vertex of the tube lies
/// innermost.
TEST(RoundShapes, HornTorusIsClosed) {
  for (double chord : {0.5, 0.2, 0.1, 0.05, 0.02}) {
    const Polyhedron p = tessellate(Torus{1, 1}, chord, false);
    EXPECT_EQ(unpaired_edges(p), 0);
    EXPECT_EQ(equal_vertices(p), 0);
    EXPECT_GT(volume(p), 0);
  }
}

Affine random_placement(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-2, 2);
  Affine placement;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) placement.linear[c][r] = unit(random);
  placement.offset = {unit(random), unit(random), unit(random)};
  return placement;
}

void expect_tight_bounds(const char* name, const Shape& shape) {
  std::mt19937_64 random(23);
  for (int i = 0; i < 10; ++i) {
    const Affine placement = random_placement(random);
    const Bounds b = bounds(shape, placement);
    Bounds facets;
    for (const Vec3& v : tessellate(shape, 1e-3, false).vertices) facets.add(placement(v));
    for (int axis = 0; axis < 3; ++axis) {
      const double size = b.high[axis] - b.low[axis];
      EXPECT_LE(b.low[axis], facets.low[axis] + 1e-13 * size) << name;
      EXPECT_GE(b.high[axis], facets.high[axis] - 1e-13 * size) << name;
      EXPECT_LT(size, 1.01 * (facets.high[axis] - facets.low[axis])) << name;
    }
  }
}

TEST(Bounds, HoldCurvedShapesTightly) {
  for (const Curved& c : curved_shapes()) expect_tight_bounds(c.name, c.shape);
  for (double angle : {30.0, 90.0, 135.0, 180.0, 200.0, 270.0, 359.0})
    expect_tight_bounds("part", Revolution{{{0, 0}, {3, 1}, {1, 2}}, angle, 0});
}

TEST(Bounds, OfFlatFacedShapesAreThoseOfTheirVertices) {
  const Affine move{glm::dmat3(2), {1, 2, 3}};
  const Bounds box = bounds(Box{{2, 4, 6}}, move);
  EXPECT_EQ(box.low, Vec3(-1, -2, 3));
  EXPECT_EQ(box.high, Vec3(3, 6, 15));
  const Bounds prism = bounds(Frustum{1, 1, 1, 3}, {});
  EXPECT_NEAR(prism.low.x, -0.5, 1e-15);
  EXPECT_EQ(prism.high.x, 1);
  const Mesh mesh{tessellate(Box{}, 1, false), "", {}, 0};
  EXPECT_EQ(bounds(mesh, {}).high, Vec3(0.5, 0.5, 1));
}

}  // namespace
}  // namespace overstrike
