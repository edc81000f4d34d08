#include "scenes/readers/openscad/project.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/cut_polyhedron.h"
#include "core/geometry/polyline.h"
#include "core/geometry/region_sets.h"
#include "core/geometry/tessellate.h"

namespace overstrike::openscad {
namespace {

Polyhedron placed_faces(const Part& part) {
  Polyhedron faces = tessellate(*part.shape, 1, false);
  for (Vec3& p : faces.vertices) p = part.place(p);
  return faces;
}

/// A face from above: its loops, by even and odd.
Region flattened(const Polyhedron& p, Index face) {
  Region region;
  for (Index l = p.first_loop(face); l < p.face_ends[face]; ++l) {
    std::vector<Vec2>& loop = region.loops.emplace_back();
    for (const Index v : p.loop(l)) loop.emplace_back(p.vertices[v]);
  }
  return region;
}

/// What of the faces lies in z = 0.
Region slice(const Polyhedron& faces) {
  const CutPolyhedron cut = cut_polyhedron(faces, Vec3(0, 0, 1), 0, true);
  std::vector<Region> caps;
  for (Index f = 0; f < cut.polyhedron.face_count(); ++f)
    if (is_cap(cut.face_source[f])) caps.push_back(flattened(cut.polyhedron, f));
  return combine(SetOperation::unite, caps);
}

/// Of the size of a solid: corners of its shadow are rounded so, fine beside the six digits of a
/// file and coarse beside the hair below a face, which doubles tell from the face 2^18 times over.
/// Where the parts' vertices may be farther from where they were meant, it is so far that what
/// should lie in one plane leaves no skin.
constexpr int kCornerBits = 26, kHairBits = 34;
/// In such roundings and hairs: two corners beside a line are off by one each way at most, and the
/// line too.
constexpr double kStraight = 4;
/// A face steeper than this lies over less than the sixth digit.
constexpr double kSteepest = 0x1p-22;
/// Faces cut by planes: four seconds, and where sections have many corners up to a minute.
constexpr std::size_t kMostCuts = std::size_t{1} << 24;

/// z = slope . (x, y) + height.
struct SlopedPlane {
  double slope_x, slope_y, height;
  auto operator<=>(const SlopedPlane&) const = default;
};

/// Of the face, where it is not upright.
std::optional<SlopedPlane> plane_of(const Polyhedron& p, Index face) {
  const std::span<const Index> loop = p.loop(p.first_loop(face));
  Vec3 normal(0.0), middle(0.0);
  const Vec3& origin = p.vertices[loop[0]];
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3 a = p.vertices[loop[i]] - origin;
    normal += glm::cross(a, p.vertices[loop[(i + 1) % loop.size()]] - origin);
    middle += a / static_cast<double>(loop.size());
  }
  if (!(std::fabs(normal.z) > kSteepest * glm::length(normal))) return {};
  middle += origin;
  const double x = -normal.x / normal.z, y = -normal.y / normal.z;
  return SlopedPlane{x, y, middle.z - x * middle.x - y * middle.y};
}

/// As the faces lie to a plane so far below: that is z = 0 then, and nothing moves in x and y.
Polyhedron over(const SlopedPlane& plane, double below, Polyhedron faces) {
  const double down =
      below * std::sqrt(1 + plane.slope_x * plane.slope_x + plane.slope_y * plane.slope_y);
  for (Vec3& p : faces.vertices)
    p.z -= plane.slope_x * p.x + plane.slope_y * p.y + plane.height - down;
  return faces;
}

double largest_extent(std::span<const Polyhedron> operands) {
  Vec3 low(HUGE_VAL), high(-HUGE_VAL);
  for (const Polyhedron& operand : operands)
    for (const Vec3& p : operand.vertices) low = glm::min(low, p), high = glm::max(high, p);
  const Vec3 size = high - low;
  return std::max({size.x, size.y, size.z});
}

/// By halves, so that what lies within others is gone early.
Region united(std::vector<Region> regions) {
  while (regions.size() > 1) {
    std::vector<Region> next;
    for (std::size_t i = 0; i < regions.size(); i += 2)
      next.push_back(
          combine(SetOperation::unite,
                  std::span(regions).subspan(i, std::min<std::size_t>(2, regions.size() - i))));
    regions = std::move(next);
  }
  return regions.empty() ? Region{} : std::move(regions[0]);
}

void round(Region& region, double side) {
  for (auto& loop : region.loops)
    for (Vec2& p : loop) p = glm::round(p / side) * side;
}

/// What sections in different planes have in common was rounded in each: where it is straight, so
/// it becomes, and what is left between becomes nothing.
Region straightened(const Region& region, double tolerance) {
  Region straight;
  for (std::vector<Vec2> loop : region.loops) {
    loop.push_back(loop.front());
    loop = simplified(loop, tolerance);
    loop.pop_back();
    if (loop.size() >= 3) straight.loops.push_back(std::move(loop));
  }
  return combine(SetOperation::unite, {&straight, 1});
}

Region shadow(const Polyhedron& faces) {
  std::vector<Region> all;
  for (Index f = 0; f < faces.face_count(); ++f) all.push_back(flattened(faces, f));
  return combine(SetOperation::unite, all);
}

std::optional<Flat> shadow(std::span<const SolidNode> tree, std::span<const Polyhedron> operands,
                           double precision) {
  std::vector<SlopedPlane> planes;
  std::size_t faces = 0;
  for (const Polyhedron& p : operands) {
    faces += p.face_count();
    for (Index f = 0; f < p.face_count(); ++f)
      if (const std::optional<SlopedPlane> plane = plane_of(p, f)) planes.push_back(*plane);
  }
  std::sort(planes.begin(), planes.end());
  planes.erase(std::unique(planes.begin(), planes.end()), planes.end());
  if (planes.empty()) return Flat{};
  if (planes.size() * faces > kMostCuts) return {};
  const int size = std::ilogb(largest_extent(operands));
  const double side = std::ldexp(1.0, size - kCornerBits);
  const double hair = 2 * precision + std::ldexp(1.0, size - kHairBits);
  std::vector<Region> sections;
  for (const SlopedPlane& plane : planes) {
    std::vector<Region> slices;
    for (const Polyhedron& operand : operands) slices.push_back(slice(over(plane, hair, operand)));
    Region section = resolve(tree, slices);
    round(section, side);
    if (!section.loops.empty()) sections.push_back(std::move(section));
  }
  const double straight = kStraight * (side + hair);
  return Flat{straightened(united(std::move(sections)), straight),
              precision + hair + side + straight};
}

bool takes_away(const SolidNode& node) {
  return node.operation == SetOperation::subtract || node.operation == SetOperation::intersect;
}

}  // namespace

std::optional<Flat> projected(std::span<const SolidNode> tree, std::span<const Part> parts,
                              bool cut) {
  std::vector<Polyhedron> operands;
  double precision = 0;
  for (const Part& part : parts) {
    operands.push_back(placed_faces(part));
    precision = std::fmax(precision, part.precision);
  }
  if (!cut && std::any_of(tree.begin(), tree.end(), takes_away))
    return shadow(tree, operands, precision);
  std::vector<Region> regions;
  for (const Polyhedron& faces : operands) regions.push_back(cut ? slice(faces) : shadow(faces));
  return Flat{resolve(tree, regions), precision};
}

}  // namespace overstrike::openscad
