#include "tests/fuzz/core/tiny_scene.h"

#include <cmath>
#include <iterator>

#include "core/geometry/tessellate.h"
#include "core/geometry/trig.h"
#include "tests/fuzz/core/tiny_solids.h"

namespace overstrike::fuzz {
namespace {

constexpr unsigned kMostBodies = 4;

/// -2 .. 2; of 51 values of a byte three are off by what rounding and printing do to files.
double coordinate(ByteSource& bytes) {
  const unsigned b = bytes.byte();
  const double whole = static_cast<double>(b % 5) - 2;
  switch (b / 5) {
    case 48:
      return whole + 1e-12;
    case 49:
      return whole - 1e-12;
    case 50:
      return whole + std::fmax(std::fabs(whole), 1) * 0x1p-52;
    default:
      return whole;
  }
}

Vec3 point(ByteSource& bytes) {
  const double x = coordinate(bytes), y = coordinate(bytes), z = coordinate(bytes);
  return {x, y, z};
}

Vec3 size(ByteSource& bytes) {
  const double x = 1 + bytes.below(4), y = 1 + bytes.below(4), z = 1 + bytes.below(4);
  return {x, y, z};
}

Mesh mesh_of(ByteSource& bytes, unsigned vertices,
             std::initializer_list<std::initializer_list<Index>> faces) {
  Mesh mesh;
  for (unsigned i = 0; i < vertices; ++i) mesh.polyhedron.add_vertex(point(bytes));
  for (const auto& face : faces) mesh.polyhedron.add_face(face);
  return mesh;
}

/// Six quadrilaterals over any eight points: twisted, crossing itself, or a box.
Mesh hexahedron(ByteSource& bytes) {
  return mesh_of(
      bytes, 8,
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}

Mesh octahedron(ByteSource& bytes) {
  return mesh_of(
      bytes, 6,
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}});
}

/// Triangles and quadrilaterals over a few points, anyhow.
Mesh soup(ByteSource& bytes) {
  Mesh mesh;
  Polyhedron& p = mesh.polyhedron;
  const unsigned vertices = 3 + bytes.below(6), faces = 1 + bytes.below(8);
  for (unsigned i = 0; i < vertices; ++i) p.add_vertex(point(bytes));
  for (unsigned f = 0; f < faces; ++f) {
    std::vector<Index> loop(3 + bytes.below(2));
    for (Index& corner : loop) corner = bytes.below(vertices);
    p.add_face(std::span<const Index>(loop));
  }
  return mesh;
}

/// Level, upright or slanting, with a hole perhaps; it may cross itself.
FlatPolygon polygon(ByteSource& bytes) {
  static const Vec3 kAxes[][2] = {{{1, 0, 0}, {0, 1, 0}},
                                  {{1, 0, 0}, {0, 0, 1}},
                                  {{0, 1, 0}, {0, 0, 1}},
                                  {{1, 0, 1}, {0, 1, 0}},
                                  {{1, -1, 0}, {0, 1, -1}}};
  const auto& axes = kAxes[bytes.below(5)];
  FlatPolygon polygon;
  const unsigned loops = 1 + bytes.below(2);
  for (unsigned l = 0; l < loops; ++l) {
    polygon.loops.emplace_back(3 + bytes.below(4));
    for (Vec3& p : polygon.loops.back()) {
      const double u = coordinate(bytes), v = coordinate(bytes);
      p = axes[0] * u + axes[1] * v;
    }
  }
  return polygon;
}

Tetrahedron tetrahedron(ByteSource& bytes) {
  Tetrahedron t{};
  for (Vec3& v : t.vertices) v = point(bytes);
  return t;
}

Shape shape(ByteSource& bytes) {
  switch (bytes.below(8)) {
    case 0:
      return Box{size(bytes)};
    case 1:
      return tetrahedron(bytes);
    case 2:
      return hexahedron(bytes);
    case 3:
      return octahedron(bytes);
    case 4:
      return soup(bytes);
    case 5: {
      const unsigned sides = 3 + bytes.below(4), top = bytes.below(3), height = 1 + bytes.below(3);
      return Frustum{1.0 + bytes.below(2), static_cast<double>(top), static_cast<double>(height),
                     static_cast<int>(sides)};
    }
    case 6: {
      const Vec3 box = size(bytes);
      return Wedge{box, static_cast<double>(bytes.below(3)), 0};
    }
    default:
      return polygon(bytes);
  }
}

Body body(ByteSource& bytes) {
  constexpr double kTurns[] = {0, 0, 0, 90, 180, 45, 30};
  constexpr double kDensities[] = {1, 1, 0.5, 0.3, 0};
  Body made;
  made.shape = std::make_shared<const Shape>(shape(bytes));
  if (!validate(*made.shape).empty()) made.shape = std::make_shared<const Shape>(Box{});
  const double turn = bytes.pick(kTurns), c = cos_deg(turn), s = sin_deg(turn);
  const double mirror = bytes.below(4) == 3 ? -1 : 1;
  made.placement = {Mat3({c * mirror, s * mirror, 0}, {-s, c, 0}, {0, 0, 1}), point(bytes)};
  made.density_factor = bytes.pick(kDensities);
  made.shading = bytes.below(4) == 3 ? Shading::smooth : Shading::flat;
  return made;
}

constexpr Direction kDirections[] = {{0, 90},    {-90, 90}, {0, 0},    {-90, 0},
                                     {90, 45},   {45, 0},   {-60, 25}, {45, 35.264389682754654},
                                     {30, 60},   {0, -90},  {0, -45},  {180, 45},
                                     {-135, 30}, {20, 1}};

Camera camera(ByteSource& bytes) {
  Camera made;
  made.from = bytes.pick(kDirections);
  const unsigned kind = bytes.below(6);
  made.parallel = kind < 4;
  if (kind < 3) made.look_at = Vec3(0.0);
  if (kind == 3) made.look_at = Vec3(0.5, 0.5, 0);
  if (kind == 4) {
    const unsigned away = 1 + bytes.below(3);
    made.eye = point(bytes) * static_cast<double>(away);
    made.target = point(bytes);
  }
  if (const unsigned width = bytes.below(5)) made.window_width = 1 << width;
  if (const unsigned near = bytes.below(5); near > 2) made.near_distance = near - 2;
  return made;
}

}  // namespace

TinyScene tiny_scene(ByteSource bytes) {
  TinyScene made;
  const unsigned asked = bytes.byte();
  made.asked = {asked % 16 == 1, (asked & 2) != 0, asked % 16 == 4, asked % 8 == 7};
  Scene& scene = made.scene;
  const unsigned bodies = 1 + bytes.below(kMostBodies);
  scene.camera = camera(bytes);
  if (bytes.below(4) != 0) scene.light = bytes.pick(kDirections);
  if (bytes.below(3) != 0) scene.ground_z = coordinate(bytes);
  if (bytes.below(4) == 3) scene.law.k = 0.5, scene.law.hmax = 0.75;
  for (unsigned i = 0; i < bodies; ++i) scene.bodies.push_back(body(bytes));
  add_solids(bytes, scene);
  return made;
}

}  // namespace overstrike::fuzz
