#include "core/visibility/eye_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/shading/density_law.h"
#include "core/visibility/ground_polygon.h"
#include "core/visibility/interpenetration.h"
#include "core/visibility/tie.h"

namespace overstrike {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();

struct Projected {
  Vec3 at;       ///< x, y, depth
  double w;      ///< w^: 1 in a parallel view
  double error;  ///< bound on the error of x and of y
};

/// Each of x^, y^, w^ is a sum of four products, rounded by at most 2 eps sum |terms|; the quotient
/// adds an eps.
Projected project(const View& view, const Vec3& p) {
  const Vec4 h = view.matrix * Vec4(p, 1.0);
  Vec4 size(0);
  for (int column = 0; column < 4; ++column)
    size += glm::abs(view.matrix[column] * (column < 3 ? p[column] : 1.0));
  const double x = h.x / h.z, y = h.y / h.z;
  const double most = std::max(std::fabs(x), std::fabs(y));
  const double error =
      2 * kEps * (std::max(size.x, size.y) + size.z * most) / std::fabs(h.z) + kEps * most;
  return {Vec3(x, y, h.w / h.z), h.z, error};
}

/// Fills an EyeTable.
class Builder {
 public:
  Builder(EyeTable& table, const View& view) : table_(table), c_(table.canonical), view_(view) {}

  void project_vertices() {
    points_.reserve(c_.vertices.size());
    for (const Vec3& p : c_.vertices) points_.push_back(project(view_, p));
  }
  void add_faces();
  void add_edges();
  void add_ground();
  void add_shadows(const std::vector<Shadow>& shadows);

 private:
  /// The first EyeFace of each canonical face (kNone: not seen) and the number of them.
  struct Seen {
    Index first = kNone;
    Index count = 0;
  };
  /// `densities` become those of the corners, none when they do not count.
  bool is_smooth(const CanonicalFace& f, bool from_behind, std::vector<double>& densities) const;
  void add_flat(Index face, bool from_behind);
  void add_smooth(Index face, bool from_behind, const std::vector<double>& densities);
  EyeFace face_base(Index face, bool from_behind) const;
  Index piece_at(Index face, Index from, Index to) const;
  void add_edge(const Projected& a, const Projected& b, Index f, Index g, Index slot, int winding);

  EyeTable& table_;
  const Canonical& c_;
  const View& view_;
  std::vector<Projected> points_;
  std::vector<Seen> seen_;
};

EyeFace Builder::face_base(Index face, bool from_behind) const {
  const CanonicalFace& f = c_.faces[face];
  const FaceShade shade = shade_of(c_, f, from_behind);
  EyeFace e{};
  e.plane = f.plane;
  e.surface = face;
  e.body = f.body;
  e.kind = f.cut ? Kind::cut : (shade.lit ? Kind::lit : Kind::shade);
  e.density = shade.density;
  e.in_shadow = std::clamp(c_.law.hmax * c_.bodies[f.body].density_factor, 0.0, 1.0);
  return e;
}

bool Builder::is_smooth(const CanonicalFace& f, bool from_behind,
                        std::vector<double>& densities) const {
  densities.clear();
  if (f.cut || !c_.bodies[f.body].smooth || c_.corner_normals.empty() || !c_.light) return false;
  if (f.end_loop - f.first_loop != 1) return false;
  const Index first = f.first_loop == 0 ? 0 : c_.loop_ends[f.first_loop - 1];
  for (Index i = first; i < c_.loop_ends[f.first_loop]; ++i)
    densities.push_back(lit_density(c_, c_.bodies[f.body],
                                    from_behind ? -c_.corner_normals[i] : c_.corner_normals[i]));
  return std::any_of(densities.begin(), densities.end(),
                     [&](double d) { return d != densities[0]; });
}

void Builder::add_flat(Index face, bool from_behind) {
  seen_[face] = {static_cast<Index>(table_.faces.size()), 1};
  table_.faces.push_back(face_base(face, from_behind));
}

/// Density times 1/w^ and 1/w^ itself are linear over the grid on a triangle: solve for the three
/// corners.
void set_gradient(EyeFace& e, const std::array<Projected, 3>& p,
                  const std::array<double, 3>& density) {
  const Mat3 corners(Vec3(p[0].at.x, p[1].at.x, p[2].at.x), Vec3(p[0].at.y, p[1].at.y, p[2].at.y),
                     Vec3(1.0));
  const double determinant = glm::determinant(corners);
  e.density = (density[0] + density[1] + density[2]) / 3;
  if (determinant == 0) return;
  const Mat3 solve = glm::inverse(corners);
  Vec3 q, w;
  for (int i = 0; i < 3; ++i) q[i] = density[i] / p[i].w, w[i] = 1 / p[i].w;
  e.q = solve * q;
  e.w = solve * w;
  e.least = std::min({density[0], density[1], density[2]});
  e.most = std::max({density[0], density[1], density[2]});
  e.smooth = true;
}

void Builder::add_smooth(Index face, bool from_behind, const std::vector<double>& densities) {
  const std::span<const Index> loop = c_.loop(c_.faces[face].first_loop);
  const Index n = static_cast<Index>(loop.size());
  seen_[face] = {static_cast<Index>(table_.faces.size()), n - 2};
  for (Index i = 1; i + 1 < n; ++i) {
    EyeFace e = face_base(face, from_behind);
    set_gradient(e, {points_[loop[0]], points_[loop[i]], points_[loop[i + 1]]},
                 {densities[0], densities[i], densities[i + 1]});
    table_.faces.push_back(e);
  }
  for (Index i = 2; i + 1 < n; ++i) {
    const Index before = seen_[face].first + i - 2;
    add_edge(points_[loop[0]], points_[loop[i]], before, before + 1, kNone, 0);
  }
}

void Builder::add_faces() {
  seen_.resize(c_.faces.size());
  std::vector<double> densities;
  for (Index face = 0; face < c_.faces.size(); ++face) {
    const CanonicalFace& f = c_.faces[face];
    const int side = side_of_eye(c_.planes[f.plane], f.flipped, view_.eye);
    if (side == 0 || !table_.depths.has_depth(f.plane)) continue;
    const bool from_behind = side < 0;
    if (from_behind && c_.bodies[f.body].closed && !f.cut) continue;
    if (is_smooth(f, from_behind, densities)) {
      add_smooth(face, from_behind, densities);
    } else {
      add_flat(face, from_behind);
      // Corners that are all as dark may be darker than the flat face: a symmetrical ridge.
      if (!densities.empty()) table_.faces.back().density = densities[0];
    }
  }
  const std::vector<char> crossing = bodies_that_may_cross(c_);
  for (EyeFace& f : table_.faces) f.may_cross = crossing[f.body] != 0;
}

/// The triangle of a smooth face's fan that has the edge.
Index Builder::piece_at(Index face, Index from, Index to) const {
  if (face == kNone || seen_[face].first == kNone) return kNone;
  if (seen_[face].count == 1) return seen_[face].first;
  const std::span<const Index> loop = c_.loop(c_.faces[face].first_loop);
  const Index n = static_cast<Index>(loop.size());
  for (Index i = 0; i < n; ++i) {
    if (loop[i] != from || loop[(i + 1) % n] != to) continue;
    const Index triangle = i == 0 ? 0 : (i == n - 1 ? n - 3 : i - 1);
    return seen_[face].first + triangle;
  }
  return seen_[face].first;
}

void Builder::add_edges() {
  for (const WingedEdge& e : c_.edges) {
    const Index left = piece_at(e.left, e.from, e.to), right = piece_at(e.right, e.to, e.from);
    if (left == kNone && right == kNone) continue;
    add_edge(points_[e.from], points_[e.to], left, right, kNone, 0);
  }
}

void Builder::add_edge(const Projected& a, const Projected& b, Index f, Index g, Index slot,
                       int winding) {
  // A corner that rounding has put into the eye's own plane, of a near plane that stands there.
  if (!std::isfinite(a.at.x + a.at.y + b.at.x + b.at.y)) return;
  if (std::max(a.at.y, b.at.y) < 0 || std::min(a.at.y, b.at.y) > table_.rows ||
      std::min(a.at.x, b.at.x) > table_.columns)
    return;
  if (a.at.y == b.at.y) {
    table_.flat_edges.push_back({std::min(a.at.x, b.at.x), std::max(a.at.x, b.at.x), a.at.y});
    return;
  }
  const bool down = a.at.y < b.at.y;
  const Projected& top = down ? a : b;
  const Projected& bottom = down ? b : a;
  ScanEdge e;
  e.x0 = top.at.x, e.y0 = top.at.y, e.x1 = bottom.at.x, e.y1 = bottom.at.y;
  e.slope = (e.x1 - e.x0) / (e.y1 - e.y0);
  const double most = std::max(std::fabs(e.x0), std::fabs(e.x1));
  const double tall = std::max(std::fabs(e.y0), std::fabs(e.y1));
  // The ends' own errors, moved along by the slope, and the rounding of x_at itself.
  e.x_error = (a.error + b.error) * (1 + std::fabs(e.slope)) +
              4 * kEps * (most + tall * std::fabs(e.slope));
  e.faces[0] = f, e.faces[1] = g;
  if (e.faces[0] == kNone) std::swap(e.faces[0], e.faces[1]);
  e.shadow_slot = slot;
  e.winding = down ? winding : -winding;
  table_.edges.push_back(e);
}

void Builder::add_ground() {
  const Index plane = static_cast<Index>(c_.planes.size());
  const std::vector<Vec2> polygon =
      ground_polygon(c_, view_, [&](GroundPlane p) -> std::optional<DepthPlane> {
        if (!table_.depths.has_depth(plane + p)) return std::nullopt;
        return table_.depths[plane + p];
      });
  if (polygon.empty()) return;
  table_.ground = static_cast<Index>(table_.faces.size());
  EyeFace ground{};
  ground.plane = plane;
  ground.surface = static_cast<Index>(c_.faces.size());
  ground.body = kNone;
  ground.kind = Kind::lit;
  ground.in_shadow = std::clamp(c_.law.hmax * c_.law.ground_shadow_factor, 0.0, 1.0);
  table_.faces.push_back(ground);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[(i + 1) % polygon.size()];
    const auto point = [](const Vec2& p) {
      return Projected{Vec3(p, 0), 1, kEps * (std::fabs(p.x) + std::fabs(p.y))};
    };
    add_edge(point(a), point(b), table_.ground, kNone, kNone, 0);
  }
}

void Builder::add_shadows(const std::vector<Shadow>& shadows) {
  table_.shadow_slot.assign(c_.faces.size() + 1, kNone);
  for (const Shadow& shadow : shadows) {
    const bool is_ground = shadow.receiver == c_.faces.size();
    if (is_ground ? table_.ground == kNone : seen_[shadow.receiver].first == kNone) continue;
    const Index slot = static_cast<Index>(table_.covered.size());
    table_.shadow_slot[shadow.receiver] = slot;
    table_.covered.push_back(shadow.covered);
    for (const ShadowEdge& e : shadow.edges)
      add_edge(project(view_, e.a), project(view_, e.b), kNone, kNone, slot, e.winding);
  }
}

/// The canonical input's planes and those that bound the ground.
std::vector<Plane> with_ground(const Canonical& c, const View& view) {
  std::vector<Plane> planes = c.planes;
  for (const Plane& plane : ground_planes(c, view)) planes.push_back(plane);
  return planes;
}

}  // namespace

EyeTable::EyeTable(const Canonical& canonical_input, const View& view,
                   const std::vector<Shadow>& shadows)
    : canonical(canonical_input),
      columns(view.grid.columns),
      rows(view.grid.rows),
      planes(with_ground(canonical_input, view)),
      depths(planes, view) {
  Builder builder(*this, view);
  builder.project_vertices();
  builder.add_faces();
  builder.add_edges();
  builder.add_ground();
  builder.add_shadows(shadows);
}

bool EyeTable::wins_tie(Index f, Index g) const {
  if (f == ground || g == ground) return g == ground;
  const Index a = faces[f].surface, b = faces[g].surface;
  return a != b ? overstrike::wins_tie(canonical, a, b) : f < g;
}

}  // namespace overstrike
