#include "tests/bench/solid_scenes.h"

#include <cmath>
#include <utility>

#include "tests/bench/scenes.h"

namespace overstrike::bench {
namespace {

/// Writes one solid, node after node.
class Writer {
 public:
  /// The nodes that `members` writes stand below it.
  template <class Members>
  void node(SetOperation operation, const Members& members) {
    const std::size_t at = solid_.nodes.size();
    solid_.nodes.push_back({operation, 0, 0});
    members();
    solid_.nodes[at].end = static_cast<std::uint32_t>(solid_.nodes.size());
  }
  void leaf(Body body) {
    const auto at = static_cast<std::uint32_t>(solid_.nodes.size());
    solid_.nodes.push_back(
        {SetOperation::operand, static_cast<std::uint32_t>(scene.bodies.size()), at + 1});
    scene.bodies.push_back(std::move(body));
  }
  Scene take() {
    scene.solids.push_back(std::move(solid_));
    return std::move(scene);
  }

  Scene scene;

 private:
  Solid solid_;
};

Body box(const Vec3& low, const Vec3& size) {
  Body body;
  body.shape = std::make_shared<Shape>(Box{size});
  body.placement.offset = low + Vec3(size.x / 2, size.y / 2, 0);
  return body;
}

void look_along(Camera& camera, const Vec3& from, const Vec3& middle) {
  camera.eye = middle + from;
  camera.target = middle;
  camera.parallel = true;
}

void look_from_above(Camera& camera) {
  camera.parallel = true;
  camera.from = {-50, 50};
}

/// About unit(1, 2, 3), by Rodrigues' formula.
Mat3 turn() {
  const Vec3 axis = Vec3(1, 2, 3) / std::sqrt(14.0);
  const double c = std::cos(0.7), s = std::sin(0.7);
  Mat3 m(0.0);
  for (int i = 0; i < 3; ++i) {
    Vec3 e(0.0);
    e[i] = 1;
    m[i] = c * e + s * glm::cross(axis, e) + (1 - c) * axis[i] * axis;
  }
  return m;
}

void bake(Body& body) {
  auto shape = std::make_shared<Shape>(*body.shape);
  for (Vec3& p : std::get<Mesh>(*shape).polyhedron.vertices) p = body.placement(p);
  body.shape = std::move(shape);
  body.placement = {};
}

}  // namespace

Scene nine_prisms(int sides, int cut, double half_height) {
  const Scene loose = scene_b(sides, half_height);
  Writer out;
  out.scene.camera = loose.camera;
  out.node(SetOperation::unite, [&] {
    for (int i = 0; i < 8; ++i) {
      const Body& prism = loose.bodies[static_cast<std::size_t>(i)];
      if (i >= cut) {
        out.leaf(prism);
        continue;
      }
      out.node(SetOperation::subtract, [&] { out.leaf(prism), out.leaf(loose.bodies[8]); });
    }
    if (cut == 0) out.leaf(loose.bodies[8]);
  });
  return out.take();
}

Scene moved(Scene scene, Turned turned, double far) {
  const Affine move{turned == Turned::no ? Mat3(1.0) : turn(), Vec3(far)};
  for (Body& body : scene.bodies) {
    body.placement = {move.linear * body.placement.linear, move(body.placement.offset)};
    if (turned == Turned::baked) bake(body);
  }
  Camera& camera = scene.camera;
  camera.eye = move(*camera.eye);
  camera.target = move(*camera.target);
  camera.up = move.linear * camera.up;
  return scene;
}

Scene nested_differences(int n, bool below) {
  Writer out;
  const Body slab = box({0, 0, 0}, {200, 200, 10});
  Body block = box({0, 0, 0}, {20, 20, 10});
  out.node(SetOperation::subtract, [&] {
    out.leaf(box({0, 0, 0}, {50, 50, 20}));
    for (int i = 0; i < n; ++i)
      out.node(SetOperation::subtract, [&] {
        out.leaf(slab);
        block.placement.offset = Vec3(i + 10, 10, 0);
        out.leaf(block);
      });
  });
  look_along(out.scene.camera, Vec3(50, -50, below ? -50 : 50), Vec3(25, 25, 10));
  return out.take();
}

Scene left_deep(int n) {
  Writer out;
  const auto write = [&](const auto& self, int i) -> void {
    if (i == 0) return out.leaf(box({0, 0, 0}, {1.0 * n, 10, 10}));
    out.node(SetOperation::subtract, [&] {
      self(self, i - 1);
      out.leaf(box({i - 0.75, 0, 5}, {0.5, 10, 5}));
    });
  };
  write(write, n);
  look_from_above(out.scene.camera);
  return out.take();
}

Scene right_deep(int n) {
  Writer out;
  const auto write = [&](const auto& self, int i) -> void {
    const double width = 2.0 * (n + 1 - i), depth = 0.5 * (n + 1 - i);
    const Body one = box({-width / 2, -width / 2, -depth}, {width, width, depth});
    if (i == n) return out.leaf(one);
    out.node(SetOperation::subtract, [&] {
      out.leaf(one);
      self(self, i + 1);
    });
  };
  write(write, 0);
  look_from_above(out.scene.camera);
  return out.take();
}

Scene holes(int n) {
  Writer out;
  const int columns = static_cast<int>(std::ceil(std::sqrt(n)));
  out.node(SetOperation::subtract, [&] {
    out.leaf(box({0, 0, 0}, {1.0 * columns, 1.0 * columns, 1}));
    Body hole;
    hole.shape = std::make_shared<Shape>(Frustum{0.35, 0.35, 1, 16});
    for (int i = 0; i < n; ++i) {
      hole.placement.offset = Vec3(i % columns + 0.5, i / columns + 0.5, 0);
      out.leaf(hole);
    }
  });
  look_from_above(out.scene.camera);
  return out.take();
}

Scene cups(int leaves) {
  Writer out;
  const int count = leaves / 2, columns = static_cast<int>(std::ceil(std::sqrt(count)));
  const ShapePtr outer = box({0, 0, 0}, Vec3(0.8)).shape;
  const ShapePtr inner = box({0, 0, 0}, Vec3(0.5)).shape;
  const auto write = [&](const auto& self, int first, int end) -> void {
    if (end - first > 1) {
      const int middle = first + (end - first) / 2;
      return out.node(SetOperation::unite,
                      [&] { self(self, first, middle), self(self, middle, end); });
    }
    Body one, other;
    one.shape = outer, other.shape = inner;
    one.placement.offset = Vec3(first % columns, first / columns, 0);
    other.placement.offset = one.placement.offset + Vec3(0, 0, 0.3);
    out.node(SetOperation::subtract, [&] { out.leaf(one), out.leaf(other); });
  };
  write(write, 0, count);
  look_from_above(out.scene.camera);
  return out.take();
}

}  // namespace overstrike::bench
