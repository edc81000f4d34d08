#include "scenes/readers/openscad/shape_pool.h"

#include <bit>
#include <cstdint>

namespace overstrike::openscad {
namespace {

/// Boxes, frusta and meshes are what OpenSCAD's shapes become.
struct Digest {
  std::uint64_t sum = 0xCBF29CE484222325;  // FNV-1a, word by word
  void add(std::uint64_t word) { sum = (sum ^ word) * 0x100000001B3; }
  void add(double x) { add(std::bit_cast<std::uint64_t>(x)); }
  void add(const Vec3& p) { add(p.x), add(p.y), add(p.z); }
  void operator()(const Box& box) { add(box.size); }
  void operator()(const Frustum& f) {
    add(f.bottom_radius), add(f.top_radius), add(f.height);
    add(static_cast<std::uint64_t>(f.sides));
  }
  void operator()(const Mesh& mesh) {
    for (const Vec3& p : mesh.polyhedron.vertices) add(p);
    for (const Index i : mesh.polyhedron.indices) add(std::uint64_t{i});
  }
  template <class Other>
  void operator()(const Other&) {}
};

bool equal(const Box& a, const Box& b) { return a.size == b.size; }
bool equal(const Frustum& a, const Frustum& b) {
  return a.bottom_radius == b.bottom_radius && a.top_radius == b.top_radius &&
         a.height == b.height && a.sides == b.sides;
}
bool equal(const Mesh& a, const Mesh& b) {
  const Polyhedron &p = a.polyhedron, &q = b.polyhedron;
  return a.precision == b.precision && a.source == b.source && p.vertices == q.vertices &&
         p.indices == q.indices && p.loop_ends == q.loop_ends && p.face_ends == q.face_ends &&
         p.corner_normals == q.corner_normals;
}
template <class A, class B>
bool equal(const A&, const B&) {
  return false;
}

}  // namespace

ShapePtr ShapePool::shared(ShapePtr shape) {
  Digest digest;
  std::visit(digest, *shape);
  const auto [first, end] = known_.equal_range(digest.sum);
  for (auto i = first; i != end; ++i)
    if (std::visit([](const auto& a, const auto& b) { return equal(a, b); }, *i->second, *shape))
      return i->second;
  known_.emplace(digest.sum, shape);
  return shape;
}

}  // namespace overstrike::openscad
