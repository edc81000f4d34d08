#include "core/visibility/far_line.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "core/geometry/expansion.h"
#include "core/visibility/ground_polygon.h"
#include "core/visibility/projected_scene.h"
#include "core/visibility/run_source.h"

namespace overstrike {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();

double reach_of(const Vec2& p) { return std::max(std::fabs(p.x), std::fabs(p.y)); }

/// x^, y^, w^.
using ExactPoint = std::array<Expansion, 3>;

ExactPoint image(const View& view, const Vec3& p) {
  ExactPoint at;
  for (int row = 0; row < 3; ++row) {
    at[row] = view.matrix[3][row];
    for (int i = 0; i < 3; ++i)
      at[row] = at[row] + Expansion(view.matrix[i][row]) * Expansion(p[i]);
  }
  return at;
}

/// Where the straight line through two points meets the level, to a few ulp.
double meeting(const ExactPoint& a, const ExactPoint& b, double y) {
  const Expansion below_a = a[1] - Expansion(y) * a[2], below_b = b[1] - Expansion(y) * b[2];
  const Expansion x = below_b * a[0] - below_a * b[0], w = below_b * a[2] - below_a * b[2];
  return x.approximate() / w.approximate();
}

bool in_near_plane(const FrontTable& table, Index vertex) {
  const Plane& near = *table.view.near_plane;
  const Vec3& p = table.canonical.vertices[vertex];
  return std::fabs(glm::dot(near.normal, p) - near.offset) <= height_error(near, p);
}

using Planes = std::array<Index, 2>;

/// Those in whose crossing a side lies, where the near plane has cut it: between a face and a cap,
/// or, of an open body, where a face ends in the near plane.
std::optional<Planes> cut_in(const FrontTable& table, const std::array<Index, 2>& ends,
                             const std::array<Index, 2>& faces) {
  const auto cut = [&](Index face) { return face != kNone && table.canonical.faces[face].cut; };
  if (faces[0] != kNone && faces[1] != kNone) {
    if (cut(faces[0]) == cut(faces[1])) return {};
    return Planes{table.plane_of(std::min(faces[0], faces[1])),
                  table.plane_of(std::max(faces[0], faces[1]))};
  }
  const Index face = faces[0] != kNone ? faces[0] : faces[1];
  if (!table.view.near_plane || cut(face)) return {};
  if (!in_near_plane(table, ends[0]) || !in_near_plane(table, ends[1])) return {};
  return Planes{table.plane_of(face), table.plane_of(table.ground()) + kNearPlane};
}

/// Of x and of y of a vertex, which is where it is: as in FrontTable, where bodies are asked as a
/// whole.
double point_error(const View& view, const Vec3& p, const Vec2& at) {
  const double w = (view.matrix * Vec4(p, 1.0)).z;
  Vec4 size = glm::abs(view.matrix[3]);
  for (int i = 0; i < 3; ++i) size += glm::abs(view.matrix[i] * p[i]);
  return 2 * kEps * (std::max(size.x, size.y) + size.z * reach_of(at)) / std::fabs(w) +
         kEps * reach_of(at);
}

/// To the picture's levels and one more at either end, for what looks a hair beside its line.
LevelLine trimmed(const LevelLine& line, double rows) {
  const double y0 = std::max(line.y0, -1.0), y1 = std::min(line.y1, rows + 1);
  LevelLine result = line;
  result.x0 = line.x_at(y0), result.y0 = y0, result.y1 = y1;
  return result;
}

/// Through a place on its first level and one on its last; as it is when it is level but for
/// rounding, and meets them nowhere.
template <class MeetingAt>
LevelLine through(const LevelLine& line, const MeetingAt& x_at) {
  if (!(line.y0 < line.y1)) return line;
  const double x0 = x_at(line.y0), x1 = x_at(line.y1);
  return std::isfinite(x0) && std::isfinite(x1) ? LevelLine({x0, line.y0}, {x1, line.y1}) : line;
}

}  // namespace

LevelLine far_line(const View& view, const Vec3& top, const Vec3& bottom, const LevelLine& rough) {
  const LevelLine line = trimmed(rough, view.grid.rows);
  if (!(line.y0 < line.y1)) return line;
  const ExactPoint a = image(view, top), b = image(view, bottom);
  return through(line, [&](double y) { return meeting(a, b, y); });
}

LevelLine far_line(const FrontTable& table, const std::array<Index, 2>& ends,
                   const std::array<Index, 2>& faces) {
  Index top = ends[0], bottom = ends[1];
  if (table.points[top].y > table.points[bottom].y) std::swap(top, bottom);
  const Vec2 &p = table.points[top], &q = table.points[bottom];
  const LevelLine line = trimmed({p, q}, table.rows);
  if (const std::optional<Planes> planes = cut_in(table, {top, bottom}, faces)) {
    const ExactPlane a = table.depths.exact((*planes)[0]), b = table.depths.exact((*planes)[1]);
    return through(line, [&](double y) { return crossing_exactly(a, b, y); });
  }
  if (!is_far_away(p) && !is_far_away(q)) return line;
  const std::vector<Vec3>& at = table.canonical.vertices;
  return far_line(table.view, at[top], at[bottom], {p, q});
}

// Near ends as in FrontTable, each for itself. What is found exactly is rounded by a few ulp, at
// most 8 kEps of x0 and x1, and evaluated with as little; where it is in the picture these are no
// more than the picture's width and its height times the slope.
LineError far_line_error(const FrontTable& table, Index number) {
  const CanonicalBody& body = table.canonical.bodies[number];
  double error = 0;
  Vec2 most(table.columns + 1, table.rows + 1);
  for (Index v = body.first_vertex; v < body.end_vertex; ++v) {
    const Vec2& at = table.points[v];
    if (is_far_away(at)) continue;
    most = glm::max(most, glm::abs(at));
    error = std::max(error, point_error(table.view, table.canonical.vertices[v], at));
  }
  return {2 * error + 16 * kEps * most.x, 2 * error + 16 * kEps * most.y,
          beside_line(table.columns, table.rows)};
}

}  // namespace overstrike
