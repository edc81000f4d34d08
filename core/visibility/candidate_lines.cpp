#include "core/visibility/candidate_lines.h"

#include <algorithm>
#include <optional>

namespace overstrike {
namespace {

/// Of an operand's edge more is known where its solid is resolved (solid_edges.h).
std::optional<StrokeKind> kind_of(const ProjectedScene& scene, const WingedEdge& e) {
  const Canonical& c = scene.canonical;
  const bool left = scene.seen(e.left), right = scene.seen(e.right);
  if (!left && !right) return std::nullopt;
  if (c.faces[e.left].cut || (e.right != kNone && c.faces[e.right].cut))
    return StrokeKind::cut_outline;
  if (c.membership(c.faces[e.left].body).solid != kNone) return StrokeKind::crease;
  if (left != right || scene.side(e.left) != scene.side(e.right)) return StrokeKind::contour;
  if (e.crease) return StrokeKind::crease;
  return std::nullopt;
}

LineEnd end_at(const ProjectedScene& scene, const Vec3& p) {
  return {p, to_grid(scene.view, p), kNone};
}

LineEnd end_at(const ProjectedScene& scene, Index vertex) {
  return {scene.canonical.vertices[vertex], scene.points[vertex], vertex};
}

/// The planes of a body's faces that a pattern may lie on, once each, with one of their faces: one
/// that is seen if there is one.
std::vector<std::pair<Index, Index>> planes_of(const ProjectedScene& scene,
                                               const CanonicalBody& body) {
  std::vector<std::pair<Index, Index>> planes;
  for (Index f = body.first_face; f < body.end_face; ++f)
    planes.emplace_back(scene.canonical.faces[f].plane, f);
  std::stable_sort(planes.begin(), planes.end(), [&](const auto& a, const auto& b) {
    return a.first != b.first ? a.first < b.first : scene.seen(a.second) > scene.seen(b.second);
  });
  const auto same = [](const auto& a, const auto& b) { return a.first == b.first; };
  planes.erase(std::unique(planes.begin(), planes.end(), same), planes.end());
  return planes;
}

struct PatternPlane {
  Index plane = kNone, face = kNone;
};

/// The nearest plane that both ends lie on, within `tolerance` grid units' length in the world.
PatternPlane plane_under(const ProjectedScene& scene,
                         const std::vector<std::pair<Index, Index>>& planes, const LineEnd& a,
                         const LineEnd& b, double tolerance) {
  const double length = tolerance * scene.view.world_per_cell;
  double best = 1;
  PatternPlane found;
  for (const auto& [plane, face] : planes) {
    const auto distance = [&, on = plane](const LineEnd& end) {
      const double allowed = length * end.grid.w + height_error(scene.plane(on), end.world);
      return std::fabs(scene.height(on, end.world)) / allowed;
    };
    const double off = std::max(distance(a), distance(b));
    if (off < best) best = off, found = {plane, face};
  }
  return found;
}

}  // namespace

bool wanted(StrokeKind kind, const StrokeOptions& options) {
  switch (kind) {
    case StrokeKind::contour:
    case StrokeKind::cut_outline:
      return options.contours;
    case StrokeKind::crease:
      return options.creases;
    case StrokeKind::intersection:
      return options.intersections;
    case StrokeKind::shadow_outline:
      return options.shadow_outlines;
    case StrokeKind::pattern:
      return options.patterns;
    case StrokeKind::segment:
      break;
  }
  return options.segments;
}

std::vector<char> curved_bodies(const Canonical& c) {
  std::vector<char> curved(c.bodies.size(), 0);
  for (const WingedEdge& e : c.edges)
    if (!e.crease && e.right != kNone && c.faces[e.left].plane != c.faces[e.right].plane)
      curved[c.faces[e.left].body] = 1;
  return curved;
}

void add_edges(const ProjectedScene& scene, const StrokeOptions& options,
               std::vector<SightLine>& lines) {
  const Canonical& c = scene.canonical;
  const std::vector<char> curved = curved_bodies(c);
  for (const WingedEdge& e : c.edges) {
    const std::optional<StrokeKind> kind = kind_of(scene, e);
    const Index solid = c.membership(c.faces[e.left].body).solid;
    if (!kind || (solid == kNone && !wanted(*kind, options))) continue;
    SightLine line{end_at(scene, e.from), end_at(scene, e.to), kNoPlanes, *kind,
                   c.faces[e.left].body};
    line.planes = {c.faces[e.left].plane, e.right == kNone ? kNone : c.faces[e.right].plane};
    line.pen = c.bodies[line.body].pen;
    line.curved = curved[line.body] != 0;
    line.solids = {solid, solid};
    line.smooth = solid != kNone && !e.crease;
    lines.push_back(std::move(line));
  }
}

void add_patterns(const ProjectedScene& scene, double tolerance, std::vector<SightLine>& lines) {
  const Canonical& c = scene.canonical;
  std::vector<std::pair<Index, Index>> planes;
  Index planes_body = kNone;
  for (const CanonicalPattern& pattern : c.patterns) {
    if (planes_body != pattern.body)
      planes = planes_of(scene, c.bodies[pattern.body]), planes_body = pattern.body;
    for (std::size_t i = 0; i + 1 < pattern.points.size(); ++i) {
      SightLine line{end_at(scene, pattern.points[i]), end_at(scene, pattern.points[i + 1]),
                     kNoPlanes, StrokeKind::pattern, pattern.body};
      const PatternPlane on = plane_under(scene, planes, line.a, line.b, tolerance);
      if (on.face != kNone && !scene.seen(on.face)) continue;
      line.planes[0] = on.plane;
      line.pen = pattern.pen;
      if (on.plane != kNone) line.solids[0] = scene.canonical.membership(pattern.body).solid;
      lines.push_back(std::move(line));
    }
  }
}

void add_segments(const ProjectedScene& scene, std::vector<SightLine>& lines) {
  for (const Segment& s : scene.canonical.segments) {
    SightLine line{end_at(scene, s.from), end_at(scene, s.to), kNoPlanes, StrokeKind::segment,
                   kNoSurface};
    line.pen = s.pen;
    lines.push_back(std::move(line));
  }
}

}  // namespace overstrike
