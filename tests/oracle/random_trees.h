#pragma once
// Random Boolean trees. Operands stand on a small lattice, so that faces, edges and vertices
// coincide on purpose.
#include <memory>
#include <utility>

#include "core/geometry/tessellate.h"
#include "core/scene/scene.h"
#include "tests/oracle/random.h"

namespace overstrike::oracle {

class TreeMaker {
 public:
  /// convex: bodies stand upright. all: half of them are not convex, as extrusions or as meshes,
  /// and all are turned by quarters.
  enum class Shapes { convex, all };
  explicit TreeMaker(std::uint64_t seed, Shapes shapes = Shapes::convex)
      : random_(seed), shapes_(shapes) {}

  Scene make() {
    Scene scene;
    Solid solid;
    add(scene, solid, 4);
    scene.solids.push_back(std::move(solid));
    scene.camera.parallel = below(2) == 0;
    scene.camera.from = {static_cast<double>(below(72)) * 5 + 1,
                         static_cast<double>(below(17)) * 10 - 80};
    if (below(3) == 0) look_from_within(scene.camera);
    return scene;
  }

  /// Of smooth bodies that stand and lie: facets' edges lie in the planes of others' bases.
  Scene make_round() {
    round_ = true;
    return make();
  }

  /// The same as make(), often in light, on a ground, and beside a body that stands for itself.
  Scene make_lit() {
    Scene scene = make();
    if (below(3) != 0) light(scene);
    return scene;
  }

 private:
  /// From above, now and then along faces; often with a ground, and a body that stands for itself.
  void light(Scene& scene) {
    scene.light = Direction{static_cast<double>(below(24)) * 15 + (below(4) == 0 ? 0 : 4),
                            static_cast<double>(below(6)) * 15 + (below(4) == 0 ? 0 : 7)};
    if (below(2) == 0) scene.ground_z = lattice() - 2;
    if (below(2) == 0) scene.bodies.push_back(body());
  }
  /// Near clipping, often within the solid.
  void look_from_within(Camera& camera) {
    camera.eye = Vec3(lattice() + 0.5, lattice() + 0.3, lattice() + 0.7);
    camera.target = Vec3(2.1, 2.3, 1.9);
    camera.fov_deg = 60;
    camera.near_distance = 0.25;
    camera.parallel = false;
  }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_.next() % n); }
  double lattice() { return static_cast<double>(below(4)); }

  void add(Scene& scene, Solid& solid, int depth) {
    const std::size_t at = solid.nodes.size();
    if (depth == 0 || (depth < 4 && below(3) == 0)) {
      solid.nodes.push_back({SetOperation::operand, static_cast<Index>(scene.bodies.size()),
                             static_cast<Index>(at + 1)});
      scene.bodies.push_back(body());
      return;
    }
    solid.nodes.push_back({static_cast<SetOperation>(1 + below(3)), 0, 0});
    for (std::size_t i = 1 + below(3); i > 0; --i) add(scene, solid, depth - 1);
    solid.nodes[at].end = static_cast<Index>(solid.nodes.size());
  }

  Body round_body() {
    Body body;
    const double height = 1 + static_cast<double>(below(3));
    const int sides = 8 + 4 * static_cast<int>(below(2));
    switch (below(3)) {
      case 0:
        body.shape = std::make_shared<Shape>(Frustum{1, 1, height, sides});
        break;
      case 1:
        body.shape = std::make_shared<Shape>(Frustum{2, 0, height, sides});
        break;
      default:
        body.shape = std::make_shared<Shape>(Ellipsoid{Vec3(1.5), sides, sides / 2});
        break;
    }
    body.shading = Shading::smooth;
    if (below(2) == 0) body.placement.linear = Mat3(Vec3(1, 0, 0), Vec3(0, 0, 1), Vec3(0, -1, 0));
    body.placement.offset = {lattice(), lattice(), lattice()};
    return body;
  }

  Body body() {
    if (round_) return round_body();
    Body body;
    const double height = 1 + static_cast<double>(below(3));
    switch (below(4)) {
      case 0:
        body.shape = std::make_shared<Shape>(Frustum{1, 1, height, 4});
        break;
      case 1:
        body.shape = std::make_shared<Shape>(Frustum{2, 1, height, 5});
        break;
      case 2:
        body.shape = std::make_shared<Shape>(Wedge{{2, 2, height}, 0, 0});
        break;
      default:
        body.shape = std::make_shared<Shape>(Box{{2, 1 + lattice(), height}});
        break;
    }
    body.placement.offset = {lattice(), lattice(), lattice()};
    body.density_factor = 0.25 * static_cast<double>(1 + below(4));
    if (shapes_ == Shapes::all) change(body, height);
    return body;
  }

  void change(Body& body, double height) {
    const std::size_t kind = below(4);
    if (kind < 2) {
      Extrusion hollow{{{kind == 0 ? kAngle : kChannel}}, height};
      body.shape = std::make_shared<Shape>(hollow);
      if (below(2) == 0) {
        Mesh mesh;
        mesh.polyhedron = tessellate(*body.shape, 0, false);
        mesh.polyhedron.plane_groups.clear();
        body.shape = std::make_shared<Shape>(std::move(mesh));
      }
    }
    for (std::size_t turns = below(4); turns > 0; --turns) {
      const Mat3 m = body.placement.linear;
      body.placement.linear = below(2) == 0 ? Mat3(m[1], -m[0], m[2]) : Mat3(m[0], m[2], -m[1]);
    }
  }

  static inline const std::vector<Vec2> kAngle{{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}};
  static inline const std::vector<Vec2> kChannel{{0, 0}, {3, 0}, {3, 3}, {2, 3},
                                                 {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  Random random_;
  Shapes shapes_;
  bool round_ = false;
};

}  // namespace overstrike::oracle
