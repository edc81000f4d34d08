#include "scenes/readers/openscad/primitives.h"

#include <algorithm>
#include <numeric>

#include "core/geometry/trig.h"

namespace overstrike::openscad {
namespace {

/// As many facets as core draws of one curved shape.
constexpr double kMostFacets = 0x1p20;

std::vector<Part> one_part(Shape shape, const Vec3& offset, double precision) {
  return {{std::make_shared<const Shape>(std::move(shape)), {Mat3(1.0), offset}, precision}};
}

bool is_size(double x) { return x > 0 && std::isfinite(x); }

}  // namespace

std::vector<Part> cube(const Arguments& a) {
  const Vec3 size = a.sizes("size", 3, 1);
  if (!is_size(size.x) || !is_size(size.y) || !is_size(size.z)) return {};
  const Vec3 offset =
      a.boolean("center", false) ? Vec3(0, 0, -size.z / 2) : Vec3(size.x / 2, size.y / 2, 0);
  return one_part(Box{size}, offset, a.precision("size"));
}

std::vector<Part> sphere(const Arguments& a) {
  const double radius = a.number("r", 1);
  if (!is_size(radius)) return {};
  const int sides = a.fragments(radius);
  const int rings = (sides + 1) / 2;
  if (static_cast<double>(sides) * rings > kMostFacets) {
    a.error("a sphere of " + std::to_string(sides) + " facets round has too many of them",
            "mind $fn, $fa and $fs");
    return {};
  }
  Mesh mesh;
  Polyhedron& p = mesh.polyhedron;
  for (int ring = 0; ring < rings; ++ring) {
    const double polar = 180 * (ring + 0.5) / rings;
    for (int k = 0; k < sides; ++k) {
      const double turn = 360.0 * k / sides;
      p.add_vertex({radius * sin_deg(polar) * cos_deg(turn),
                    radius * sin_deg(polar) * sin_deg(turn), radius * cos_deg(polar)});
    }
  }
  std::vector<Index> cap(static_cast<std::size_t>(sides));
  std::iota(cap.begin(), cap.end(), Index{0});
  p.add_face(cap);
  const Index n = static_cast<Index>(sides), last = static_cast<Index>(rings - 1) * n;
  for (Index start = 0; start < last; start += n)
    for (Index k = 0; k < n; ++k) {
      const Index next = (k + 1) % n;
      p.add_face({start + k, start + n + k, start + n + next, start + next});
    }
  std::iota(cap.begin(), cap.end(), last);
  std::reverse(cap.begin(), cap.end());
  p.add_face(cap);
  return one_part(std::move(mesh), Vec3(0.0), a.precision("r"));
}

std::vector<Part> cylinder(const Arguments& a) {
  const double height = a.number("h", 1), bottom = a.number("r1", 1), top = a.number("r2", 1);
  const double widest = std::fmax(bottom, top);
  if (!is_size(height) || !is_size(widest) || !(bottom >= 0) || !(top >= 0)) return {};
  const double low = a.boolean("center", false) ? -height / 2 : 0;
  return one_part(Frustum{bottom, top, height, a.fragments(widest)}, Vec3(0, 0, low),
                  std::fmax(a.precision("h"), std::fmax(a.precision("r1"), a.precision("r2"))));
}

std::vector<Part> polyhedron(const Arguments& a) {
  Mesh mesh;
  mesh.polyhedron.vertices = a.points3("points");
  mesh.precision = a.precision("points");
  const std::string_view faces = a.has("triangles") ? "triangles" : "faces";
  for (std::vector<Index>& face : a.index_lists(faces, mesh.polyhedron.vertices.size())) {
    if (face.size() < 3) continue;
    std::reverse(face.begin(), face.end());
    mesh.polyhedron.add_face(face);
  }
  if (mesh.polyhedron.face_count() == 0) return {};
  return one_part(std::move(mesh), Vec3(0.0), 0);
}

Flat square(const Arguments& a) {
  const Vec3 size = a.sizes("size", 2, 1);
  if (!is_size(size.x) || !is_size(size.y)) return {};
  const Vec2 low = a.boolean("center", false) ? Vec2(-size.x / 2, -size.y / 2) : Vec2(0.0);
  const Vec2 high = low + Vec2(size);
  return {{{{low, {high.x, low.y}, high, {low.x, high.y}}}}, a.precision("size")};
}

Flat circle(const Arguments& a) {
  const double radius = a.number("r", 1);
  if (!is_size(radius)) return {};
  const int sides = a.fragments(radius);
  Flat flat{{{{}}}, a.precision("r")};
  for (int k = 0; k < sides; ++k) {
    const double turn = 360.0 * k / sides;
    flat.region.loops[0].emplace_back(radius * cos_deg(turn), radius * sin_deg(turn));
  }
  return flat;
}

Flat polygon(const Arguments& a) {
  const std::vector<Vec2> points = a.points2("points");
  Flat flat{{}, a.precision("points")};
  const auto add = [&](std::vector<Vec2> loop) {
    if (loop.size() >= 3) flat.region.loops.push_back(std::move(loop));
  };
  if (!a.has("paths")) {
    add(points);
    return flat;
  }
  for (const std::vector<Index>& path : a.index_lists("paths", points.size())) {
    std::vector<Vec2> loop;
    for (const Index i : path) loop.push_back(points[i]);
    add(std::move(loop));
  }
  return flat;
}

}  // namespace overstrike::openscad
