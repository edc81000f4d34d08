#include "scenes/readers/yaml/shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "core/geometry/polygon.h"
#include "scenes/readers/yaml/fields.h"
#include "scenes/readers/yaml/polyhedron.h"
#include "scenes/readers/yaml/regions.h"
#include "scenes/readers/yaml/shape_laws.h"

namespace overstrike::yaml {
namespace {

constexpr int kMostSides = 4096;  // as tessellate() has it

int optional_sides(const Fields& f) {
  return f.has("sides") ? f.whole_number_or("sides", 3, 3, kMostSides) : 0;
}

int needed_sides(const Fields& f) {
  const Node* sides = f.need("sides");
  return sides ? whole_number(f.reporter(), *sides, "sides", 3, kMostSides) : 3;
}

Vec3 needed_vec3(const Fields& f, std::string_view key, const Range& range) {
  const Node* value = f.need(key);
  return value ? vec3(f.reporter(), *value, key, range) : Vec3(1);
}

/// Three lengths, or one for all three.
Vec3 size(const Fields& f) {
  const Node* value = f.need("size");
  if (value && value->kind == NodeKind::scalar)
    return Vec3(number(f.reporter(), *value, "size", kPositive));
  return value ? vec3(f.reporter(), *value, "size", kPositive) : Vec3(1);
}

std::vector<Vec2> needed_points2(const Fields& f, std::string_view key) {
  const Node* value = f.need(key);
  return value ? points2(f.reporter(), *value, key, 3) : std::vector<Vec2>{};
}

Shape box(const Fields& f) { return Box{size(f)}; }

Shape prism(const Fields& f) {
  const double radius = f.number("radius", kPositive);
  return Frustum{radius, radius, f.number("height", kPositive), needed_sides(f)};
}

Shape cylinder(const Fields& f) {
  const double radius = f.number("radius", kPositive);
  return Frustum{radius, radius, f.number("height", kPositive), optional_sides(f)};
}

Shape pyramid(const Fields& f) {
  return Frustum{f.number("radius", kPositive), 0, f.number("height", kPositive), needed_sides(f)};
}

Shape cone(const Fields& f) {
  return Frustum{f.number("radius", kPositive), 0, f.number("height", kPositive),
                 optional_sides(f)};
}

Shape frustum(const Fields& f) {
  const Frustum shape{f.number("bottom", kNotNegative), f.number("top", kNotNegative),
                      f.number("height", kPositive), optional_sides(f)};
  if (shape.bottom_radius == 0 && shape.top_radius == 0)
    f.reporter().error(f.mark(), "bottom and top of a frustum must not both be 0");
  return shape;
}

Shape wedge(const Fields& f) {
  return Wedge{size(f), f.number_or("top", 0, kNotNegative), f.number_or("shift", 0)};
}

Shape tetrahedron(const Fields& f) {
  Tetrahedron shape{};
  const Node* value = f.need("vertices");
  if (!value) return shape;
  const auto points = points3(f.reporter(), *value, "vertices", 4);
  if (points.size() > 4)
    f.reporter().error(value->mark,
                       "a tetrahedron has 4 vertices, found " + std::to_string(points.size()));
  if (points.size() == 4)
    for (int i = 0; i < 4; ++i) shape.vertices[i] = points[static_cast<std::size_t>(i)];
  return shape;
}

Shape globe(const Fields& f, const Vec3& radii) {
  Ellipsoid shape{radii};
  shape.sides = f.whole_number_or("sides", 0, 3, kMostSides);
  shape.rings = f.whole_number_or("rings", 0, 2, kMostSides / 2);
  return shape;
}

Shape sphere(const Fields& f) { return globe(f, Vec3(f.number("radius", kPositive))); }

Shape ellipsoid(const Fields& f) { return globe(f, needed_vec3(f, "radii", kPositive)); }

Shape torus(const Fields& f) {
  const Torus shape{f.number("major", kPositive), f.number("minor", kPositive)};
  if (f.has("major") && f.has("minor") && shape.minor > shape.major)
    f.reporter().error(f.mark("minor"), "minor must not be larger than major");
  return shape;
}

/// The value of `region`, or null when the shape is said by its other keys.
const Node* region_node(const Fields& f, Keys others) {
  const Node* region = f.find("region");
  for (const std::string_view key : others)
    if (region && f.has(key))
      f.reporter().error(f.mark(key), in_quotes(key) + " and 'region' exclude each other");
  return region;
}

constexpr std::string_view kOutlineKeys[] = {"outline", "holes"}, kProfileKeys[] = {"profile"};

Shape extrusion(const Fields& f) {
  const double height = f.number("height", kPositive);
  if (const Node* region = region_node(f, kOutlineKeys))
    return Extrusion{read_region(f.reporter(), *region), height};
  Extrusion shape{{{needed_points2(f, "outline")}}, height};
  if (const Node* holes = f.find("holes"))
    for (const Node* hole : list(f.reporter(), *holes, "holes", "outlines [[x, y], ...]"))
      shape.region.loops.push_back(points2(f.reporter(), *hole, "a hole", 3));
  return shape;
}

/// Every loop of the region is one of the profile.
void read_profile(Revolution& shape, Reporter& reporter, const Node& node) {
  Region region = read_region(reporter, node);
  for (std::vector<Vec2>& loop : region.loops) {
    for (const Vec2& point : loop)
      if (point.x < 0) {
        reporter.error(node.mark, fmt::format("a region that is turned must not reach beyond the "
                                              "axis, found radius {}",
                                              point.x));
        return;
      }
    std::vector<Vec2>& to = shape.profile.empty() ? shape.profile : shape.more_loops.emplace_back();
    to = std::move(loop);
  }
}

Shape revolution(const Fields& f) {
  Revolution shape{{}, f.number_or("angle", 360, {1e-3, 360, false, {}}), optional_sides(f)};
  if (const Node* region = region_node(f, kProfileKeys)) {
    read_profile(shape, f.reporter(), *region);
    return shape;
  }
  shape.profile = needed_points2(f, "profile");
  const Node* profile = f.find("profile");
  for (std::size_t i = 0; i < shape.profile.size(); ++i)
    if (shape.profile[i].x < 0)
      f.reporter().error(profile->items[i]->mark,
                         "the radius of a profile's point must not be negative, found " +
                             profile->items[i]->items[0]->text);
  return shape;
}

Shape sweep(const Fields& f) {
  Sweep shape{{}, {}, f.boolean_or("closed", false)};
  if (const Node* region = region_node(f, kProfileKeys)) {
    Region found = read_region(f.reporter(), *region);
    if (found.loops.size() > 1)
      f.reporter().error(region->mark,
                         fmt::format("a region that is swept must be one outline without holes, "
                                     "found {} outlines and holes",
                                     found.loops.size()));
    else if (!found.loops.empty())
      shape.profile = std::move(found.loops.front());
  } else {
    shape.profile = needed_points2(f, "profile");
  }
  if (const Node* path = f.need("path"))
    shape.path = points3(f.reporter(), *path, "path", shape.closed_path ? 3 : 2);
  return shape;
}

Shape polygon(const Fields& f) {
  FlatPolygon shape;
  if (const Node* outline = f.need("outline"))
    shape.loops.push_back(points3(f.reporter(), *outline, "outline", 3));
  if (const Node* holes = f.find("holes"))
    for (const Node* hole : list(f.reporter(), *holes, "holes", "outlines [[x, y, z], ...]"))
      shape.loops.push_back(points3(f.reporter(), *hole, "a hole", 3));
  return shape;
}

struct ShapeReader {
  const MapKind& kind;
  Shape (*read)(const Fields&);
};

const ShapeReader kReaders[] = {
    {kBoxMap, box},
    {kPrismMap, prism},
    {kCylinderMap, cylinder},
    {kPyramidMap, pyramid},
    {kConeMap, cone},
    {kFrustumMap, frustum},
    {kWedgeMap, wedge},
    {kTetrahedronMap, tetrahedron},
    {kSphereMap, sphere},
    {kEllipsoidMap, ellipsoid},
    {kTorusMap, torus},
    {kExtrusionMap, extrusion},
    {kRevolutionMap, revolution},
    {kSweepMap, sweep},
    {kPolyhedronMap, read_polyhedron},
    {kPolygonMap, polygon},
};

}  // namespace

bool is_shape(std::string_view key) {
  if (key == kMeshMap.name) return true;
  for (const ShapeReader& reader : kReaders)
    if (reader.kind.name == key) return true;
  return false;
}

ShapePtr read_shape(Reporter& reporter, std::string_view key, const Node& value,
                    MeshFiles& meshes) {
  const std::size_t errors_before = reporter.errors();
  if (key == kMeshMap.name) {
    const Fields f(reporter, value, kMeshMap);
    const Node* file = f.need("file");
    return file ? meshes.read(reporter, *file) : nullptr;
  }
  for (const ShapeReader& reader : kReaders) {
    if (reader.kind.name != key) continue;
    const Fields f(reporter, value, reader.kind);
    auto shape = std::make_shared<const Shape>(reader.read(f));
    if (reporter.errors() == errors_before) check_laws(f, *shape);
    return reporter.errors() == errors_before ? shape : nullptr;
  }
  return nullptr;
}

std::vector<ShapePtr> read_shapes(Reporter& reporter, std::string_view key, const Node& value,
                                  MeshFiles& meshes) {
  if (key != kPolygonMap.name || value.kind != NodeKind::map)
    return {read_shape(reporter, key, value, meshes)};
  const std::size_t errors_before = reporter.errors();
  const Fields f(reporter, value, kPolygonMap);
  const Node* node = region_node(f, kOutlineKeys);
  if (!node) return {read_shape(reporter, key, value, meshes)};
  const OrderedRegion region = in_order(read_region(reporter, *node).loops);
  if (reporter.errors() > errors_before) return {nullptr};
  std::vector<ShapePtr> shapes;
  for (const Piece& piece : region.pieces) {
    FlatPolygon sheet;
    const auto add = [&](std::size_t loop) {
      sheet.loops.emplace_back();
      for (const Vec2& p : region.loops[loop]) sheet.loops.back().push_back({p, 0});
    };
    add(piece.outline);
    for (const std::size_t hole : piece.holes) add(hole);
    shapes.push_back(std::make_shared<const Shape>(std::move(sheet)));
  }
  return shapes;
}

}  // namespace overstrike::yaml
