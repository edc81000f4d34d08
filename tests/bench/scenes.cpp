#include "tests/bench/scenes.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "core/drawing.h"
#include "tests/bench/timing.h"
#include "tests/oracle/random.h"

namespace overstrike::bench {
namespace {

using Triangle = std::array<Index, 3>;

struct Icosphere {
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
};

/// Vertices (0, +-1, +-phi) and their cyclic turns, on the unit sphere.
Icosphere icosahedron() {
  const double phi = std::numbers::phi, length = std::sqrt(1 + phi * phi);
  Icosphere s;
  for (int axis = 0; axis < 3; ++axis)
    for (const double one : {-1.0, 1.0})
      for (const double golden : {-phi, phi}) {
        Vec3 p(0.0);
        p[(axis + 1) % 3] = one / length, p[(axis + 2) % 3] = golden / length;
        s.vertices.push_back(p);
      }
  const double edge = 2 / length;
  const auto joined = [&](Index a, Index b) {
    return std::fabs(glm::distance(s.vertices[a], s.vertices[b]) - edge) < edge / 8;
  };
  for (Index a = 0; a < 12; ++a)
    for (Index b = a + 1; b < 12; ++b)
      for (Index c = b + 1; c < 12; ++c) {
        if (!joined(a, b) || !joined(b, c) || !joined(a, c)) continue;
        const Vec3 &p = s.vertices[a], &q = s.vertices[b], &r = s.vertices[c];
        const bool outward = glm::dot(glm::cross(q - p, r - p), p) > 0;
        s.triangles.push_back(outward ? Triangle{a, b, c} : Triangle{a, c, b});
      }
  return s;
}

Icosphere subdivided(const Icosphere& coarse) {
  Icosphere fine{coarse.vertices, {}};
  std::map<std::pair<Index, Index>, Index> middles;
  const auto middle = [&](Index a, Index b) {
    const auto [at, is_new] = middles.try_emplace(std::minmax(a, b), Index(fine.vertices.size()));
    if (is_new) {
      const Vec3 sum = coarse.vertices[a] + coarse.vertices[b];
      fine.vertices.push_back(sum / std::sqrt(glm::dot(sum, sum)));
    }
    return at->second;
  };
  for (const auto& [a, b, c] : coarse.triangles) {
    const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (const Triangle& t :
         {Triangle{a, ab, ca}, Triangle{ab, b, bc}, Triangle{ca, bc, c}, Triangle{ab, bc, ca}})
      fine.triangles.push_back(t);
  }
  return fine;
}

Affine placed(double scale, const Vec3& offset) { return {Mat3(scale), offset}; }

void add(Scene& scene, const ShapePtr& shape, const Affine& placement) {
  Body body;
  body.shape = shape;
  body.placement = placement;
  scene.bodies.push_back(std::move(body));
}

Camera parallel_camera(const Vec3& back, const Vec3& up, double width) {
  Camera camera;
  camera.parallel = true;
  camera.target = Vec3(0.0);
  camera.eye = back * 10.0;
  camera.up = up;
  camera.window_width = width;
  return camera;
}

/// A regular prism round the z axis; vertex v at angle `turn` + 2 pi v / k.
ShapePtr prism(int sides, double radius, double turn, double z0, double z1) {
  Mesh mesh;
  std::vector<Index> bottom, top;
  for (int v = 0; v < sides; ++v) {
    const double angle = turn + 2 * std::numbers::pi * v / sides;
    const Vec2 p(radius * std::cos(angle), radius * std::sin(angle));
    bottom.push_back(mesh.polyhedron.add_vertex(Vec3(p, z0)));
    top.push_back(mesh.polyhedron.add_vertex(Vec3(p, z1)));
  }
  mesh.polyhedron.add_face(top);
  mesh.polyhedron.add_face(std::vector<Index>(bottom.rbegin(), bottom.rend()));
  for (int v = 0; v < sides; ++v) {
    const int w = (v + 1) % sides;
    mesh.polyhedron.add_face({bottom[v], bottom[w], top[w], top[v]});
  }
  return std::make_shared<const Shape>(std::move(mesh));
}

}  // namespace

ShapePtr icosphere(int level) {
  Icosphere s = icosahedron();
  for (int i = 0; i < level; ++i) s = subdivided(s);
  Mesh mesh;
  mesh.polyhedron.vertices = s.vertices;
  for (const auto& [a, b, c] : s.triangles) mesh.polyhedron.add_face({a, b, c});
  return std::make_shared<const Shape>(std::move(mesh));
}

Scene scene_c(int level) {
  Scene scene;
  scene.camera = parallel_camera(Vec3(0, 0, 1), Vec3(0, 1, 0), 2.5);
  const ShapePtr sphere = icosphere(level);
  oracle::Random random(777);
  for (int i = 0; i < 80; ++i) add(scene, sphere, placed(0.2, random.within(Vec3(-1), Vec3(1))));
  return scene;
}

Scene lit_scene_c(int level) {
  Scene scene = scene_c(level);
  scene.light = Direction{45, std::atan(std::sqrt(0.5)) * 180 / std::numbers::pi};
  scene.ground_z = -1.25;
  return scene;
}

Scene scene_b(int sides, double half_height) {
  Scene scene;
  scene.camera = parallel_camera(Vec3(0.6, -1, 0.8), Vec3(0, 0, 1), 4.4);
  for (int i = 0; i < 8; ++i) {
    const double angle = std::numbers::pi * i / 4;
    add(scene, prism(sides, 0.45, 0.1 * i, -half_height, half_height),
        placed(1, Vec3(std::cos(angle), std::sin(angle), 0)));
  }
  add(scene, prism(sides, 1, 0, -1, 1), Affine{});
  return scene;
}

Scene many_boxes(Boxes where) {
  constexpr double kSide = 0.02;
  constexpr int kCount = 100'000, kLattice = 47;
  constexpr double kCell = 2.0 / kLattice;
  Scene scene;
  scene.camera.parallel = true;
  scene.camera.look_at = Vec3(0.0);
  scene.camera.window_width = 3.6;
  const ShapePtr box = std::make_shared<const Shape>(Box{Vec3(kSide)});
  oracle::Random random(4242);
  for (int i = 0; i < kCount; ++i) {
    Vec3 at = random.within(Vec3(-1), Vec3(1));
    if (where == Boxes::apart) {
      const Vec3 cell(i % kLattice, i / kLattice % kLattice, i / (kLattice * kLattice));
      at = Vec3(-1.0) + cell * kCell + (at + 1.0) * 0.5 * (kCell - kSide);
    }
    add(scene, box, placed(1, at));
  }
  return scene;
}

Grid square_grid(int size) {
  const double cells = size;
  return {cells, cells, 1, 1};
}

Prepared prepare(const Scene& scene, const Grid& grid) {
  std::vector<Diagnostic> warnings;
  Prepared result;
  result.view = make_view(scene, grid);
  // A median, as of what is drawn, where that takes no time.
  constexpr std::size_t kMostTimes = 9;
  constexpr double kShort = 10;
  std::vector<double> ms;
  do {
    const Stopwatch watch;
    result.canonical = std::make_shared<const Canonical>(
        canonicalize(scene, result.view, DrawOptions{}.tolerance, warnings));
    ms.push_back(watch.cpu_ms());
  } while (ms.back() < kShort && ms.size() < kMostTimes);
  result.canonicalize_ms = median(ms);
  return result;
}

}  // namespace overstrike::bench
