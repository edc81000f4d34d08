#include "scenes/readers/yaml/shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>

#include "core/geometry/polygon.h"
#include "core/geometry/tessellate.h"
#include "scenes/readers/mesh.h"
#include "scenes/readers/yaml/fields.h"
#include "scenes/readers/yaml/regions.h"

namespace overstrike::yaml {
namespace {

constexpr int kMostSides = 4096;  // as tessellate() has it

constexpr int kMostVertices = 1'000'000'000;  // numbers beyond are no slips by one

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

/// The loop's vertex numbers, checked against the number of vertices.
std::vector<Index> face_loop(Reporter& reporter, const Node& node, std::size_t vertices) {
  std::vector<Index> loop;
  for (const Node* item : list(reporter, node, "a face", "vertex numbers", 3)) {
    const std::size_t errors_before = reporter.errors();
    const int index =
        whole_number(reporter, *item, "a vertex number", -kMostVertices, kMostVertices);
    if (reporter.errors() > errors_before) continue;
    if (vertices > 0 && (index < 0 || static_cast<std::size_t>(index) >= vertices))
      reporter.error(item->mark, "vertex " + std::to_string(index) + " does not exist: there are " +
                                     std::to_string(vertices) + ", numbered from 0");
    loop.push_back(static_cast<Index>(index));
  }
  return loop;
}

Shape polyhedron(const Fields& f) {
  Mesh shape;
  Reporter& reporter = f.reporter();
  if (const Node* vertices = f.need("vertices"))
    shape.polyhedron.vertices = points3(reporter, *vertices, "vertices", 3);
  const std::size_t count = shape.polyhedron.vertices.size();
  const Node* faces = f.need("faces");
  if (!faces) return shape;
  for (const Node* face : list(reporter, *faces, "faces", "faces [a, b, c, ...]", 1)) {
    const Fields face_fields(reporter, *face, kFaceMap);
    shape.lines.push_back(face->mark.line);
    if (const Node* outline = face_fields.need("outline"))
      shape.polyhedron.add_loop(face_loop(reporter, *outline, count));
    if (const Node* holes = face_fields.find("holes"))
      for (const Node* hole : list(reporter, *holes, "holes", "outlines [a, b, c, ...]"))
        shape.polyhedron.add_loop(face_loop(reporter, *hole, count));
    shape.polyhedron.end_face();
  }
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
    {kPolyhedronMap, polyhedron},
    {kPolygonMap, polygon},
};

/// Where core's complaint about "loop N" of a region belongs: the outline or a hole.
const Node* complained_loop(const Fields& f, const std::string& complaint) {
  constexpr std::string_view kLoop = "loop ";
  const Node* outline = f.find("outline");
  if (!outline || !complaint.starts_with(kLoop)) return outline;
  const int loop = std::atoi(complaint.c_str() + kLoop.size());
  const Node* holes = f.find("holes");
  if (loop < 2 || !holes || holes->items.size() < static_cast<std::size_t>(loop - 1))
    return outline;
  return holes->items[static_cast<std::size_t>(loop - 2)];
}

/// Core numbers a region's loops; scenes have an outline and holes.
std::string in_scene_words(std::string complaint) {
  constexpr std::string_view kLoop = "loop ";
  for (std::size_t at = complaint.find(kLoop); at != std::string::npos;
       at = complaint.find(kLoop, at + 1)) {
    const std::size_t digits = at + kLoop.size();
    const std::size_t end =
        std::min(complaint.size(), complaint.find_first_not_of("0123456789", digits));
    const int loop = std::atoi(complaint.c_str() + digits);
    if (end == digits) continue;
    complaint.replace(at, end - at, loop == 1 ? "the outline" : fmt::format("hole {}", loop - 1));
  }
  return complaint;
}

/// A law of shapes that the keys alone don't tell, at the key that the complaint names first.
void check_laws(const Fields& f, const Shape& shape) {
  const std::string complaint = validate(shape);
  if (complaint.empty()) return;
  std::string_view named;
  std::size_t first = std::string::npos;
  for (const std::string_view key : f.kind().keys)
    if (const std::size_t at = complaint.find(key); at < first && f.has(key))
      first = at, named = key;
  if (named.empty() && f.has("region")) return f.reporter().error(f.mark("region"), complaint);
  const Node* loop = complained_loop(f, complaint);
  f.reporter().error(named.empty() && loop ? loop->mark : f.mark(named), in_scene_words(complaint));
}

}  // namespace

ShapePtr MeshFiles::read(Reporter& reporter, const Node& name) {
  namespace fs = std::filesystem;
  if (name.kind != NodeKind::scalar || name.text.empty()) {
    reporter.error(name.mark, "file must be the name of a mesh file, found " + describe(name));
    return nullptr;
  }
  const auto known = read_.find(name.text);
  if (known != read_.end()) return known->second;
  ShapePtr& shape = read_[name.text];
  const fs::path path = folder_ / name.text;
  std::error_code ignored;
  if (!fs::exists(path, ignored)) {
    reporter.error(name.mark,
                   "no mesh file " + in_quotes(name.text) + "; looked for " + path.string());
    return nullptr;
  }
  if (fs::is_directory(path, ignored)) {
    reporter.error(name.mark,
                   "mesh file " + in_quotes(name.text) + " is a directory: " + path.string());
    return nullptr;
  }
  try {
    std::vector<Diagnostic> warnings;
    shape = std::make_shared<const Shape>(read_mesh(path, warnings));
    reporter.append(warnings);
  } catch (const InputError& e) {
    reporter.append(e.diagnostics());
  }
  return shape;
}

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
