#include "tests/oracle/crossings.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace overstrike::oracle {
namespace {

/// This search runs in doubles and only has to tell which crossing it is: generous, in grid units.
constexpr double kSearch = 1e-6, kWidestSearch = 1e-3;
/// How far past its ends an edge still counts, relative to its length: for run ends at vertices.
constexpr double kPastEnd = 1e-6;

/// Whether p is within `reach` of the segment between two homogeneous grid points; of the whole
/// straight line where one of them is behind the eye.
bool is_near(const Vec2& p, const Vec3& a, const Vec3& b, double reach) {
  const Vec3 l = glm::cross(a, b);
  const double across = std::fabs(glm::dot(l, Vec3(p, 1)));
  if (!(across <= reach * std::hypot(l.x, l.y))) return false;
  if (a.z <= 0 || b.z <= 0) return a.z > 0 || b.z > 0;
  const Vec2 from = Vec2(a) / a.z, to = Vec2(b) / b.z, d = to - from;
  const double along = glm::dot(p - from, d), length = glm::length(d);
  return along >= -reach * length && along <= (length + reach) * length;
}

}  // namespace

struct Crossings::Search {
  const Line& line;
  std::vector<Place> found;

  void add(double at, double condition) {
    if (std::isfinite(at) && std::isfinite(condition))
      found.push_back({at, std::max(1.0, condition)});
  }
  /// How far a homogeneous grid point (x^, y^, w^) lies across the line, times w^.
  double across(const Vec3& p) const {
    const Vec2 n(-line.direction.y, line.direction.x);
    return n.x * p.x + n.y * p.y - glm::dot(n, line.origin) * p.z;
  }
  double along(const Vec3& p) const {
    return glm::dot(line.direction, Vec2(p.x, p.y) / p.z - line.origin);
  }
  /// The image of a straight edge, given by its ends' homogeneous grid points.
  void add_edge(const Vec3& a, const Vec3& b, double factor) {
    const double fa = across(a), fb = across(b);
    const double slack = kPastEnd * std::fabs(fb - fa);
    if (fa == fb || std::min(fa, fb) > slack || std::max(fa, fb) < -slack) return;
    const Vec3 crossing = (fb * a - fa * b) / (fb - fa);
    if (crossing.z <= 0) return;
    const Vec3 l = glm::cross(a, b);
    const double length = std::hypot(l.x, l.y);
    add(along(crossing), factor * length / std::fabs(glm::dot(Vec2(l.x, l.y), line.direction)));
  }
  /// Two planes in grid coordinates, as covectors over (x, y, w, z).
  void add_depths(const Crossings& scene, const Plane& plane_a, const Plane& plane_b) {
    const Vec4 a = scene.image(plane_a), b = scene.image(plane_b);
    if (a.w == 0 || b.w == 0) return;
    const Vec2 slope_a(-a.x / a.w, -a.y / a.w), slope_b(-b.x / b.w, -b.y / b.w);
    const Vec2 difference = slope_a - slope_b;
    const double along_line = glm::dot(difference, line.direction);
    if (along_line == 0) return;
    const double start = -a.z / a.w + b.z / b.w + glm::dot(difference, line.origin);
    const double steepest = glm::length(slope_a) + glm::length(slope_b);
    const double at = -start / along_line;
    const double error = scene.depth_error(plane_a, line.at(at), scene.offset_error_) +
                         scene.depth_error(plane_b, line.at(at), scene.offset_error_);
    add(at, (steepest + error / kEndError) / std::fabs(along_line));
  }
};

Crossings::Crossings(const Canonical& canonical, const View& view)
    : in_(canonical), view_(view), planes_to_grid_(glm::transpose(glm::inverse(view.matrix))) {
  double size = 0;
  for (const Vec3& p : in_.vertices) size = std::max(size, glm::length(p));
  offset_error_ = kOffsetRounding * size;
}

Vec3 Crossings::image(const Vec3& p) const { return Vec3(view_.matrix * Vec4(p, 1)); }

/// Rows of the matrix are x^, y^, w^, z^, and so are the components.
Vec4 Crossings::image(const Plane& plane) const {
  return planes_to_grid_ * Vec4(plane.normal, -plane.offset);
}

void Crossings::edges(Search& search) const {
  for (const WingedEdge& e : in_.edges)
    search.add_edge(image(in_.vertices[e.from]), image(in_.vertices[e.to]), 1);
}

/// Every edge's shadow on the receiver's plane.
void Crossings::shadow_edges(Search& search, const Plane& receiver) const {
  const Vec3 light = *in_.light;
  const double facing = glm::dot(receiver.normal, light);
  if (facing == 0) return;
  const auto shadow = [&](Index v) {
    const Vec3& p = in_.vertices[v];
    return image(p + light * ((receiver.offset - glm::dot(receiver.normal, p)) / facing));
  };
  for (const WingedEdge& e : in_.edges)
    search.add_edge(shadow(e.from), shadow(e.to), 1 / std::fabs(facing));
  // Where faces of solids pass through each other: the plane along the light through their
  // crossing.
  if (in_.solids.empty()) return;
  for (std::size_t i = 0; i < in_.planes.size(); ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const Plane &p = in_.planes[i], &q = in_.planes[k];
      const double along_p = glm::dot(p.normal, light), along_q = glm::dot(q.normal, light);
      const Vec3 normal = p.normal * along_q - q.normal * along_p;
      const double length = glm::length(normal);
      if (length > 0)
        search.add_depths(*this, receiver,
                          {normal / length, (p.offset * along_q - q.offset * along_p) / length});
    }
}

/// Where any plane of the scene passes through this one.
void Crossings::depths(Search& search, const Plane& with) const {
  for (const Plane& p : in_.planes) search.add_depths(*this, with, p);
  if (in_.ground_z) search.add_depths(*this, with, Plane{Vec3(0, 0, 1), *in_.ground_z});
}

/// Paper and shadow on the ground lie in one plane, and so do faces of one plane identity.
bool Crossings::same_plane(const Seen& one, const Seen& other) const {
  if (one.face == kNone || other.face == kNone) return one.face == other.face;
  return in_.faces[one.face].plane == in_.faces[other.face].plane;
}

Plane Crossings::plane_of(const Seen& seen) const {
  if (seen.face != kNone) return in_.planes[in_.faces[seen.face].plane];
  return {Vec3(0, 0, 1), in_.ground_z.value_or(0)};
}

/// What may change on the planes of `left` and `right`, but for other planes that pass through.
void Crossings::outlines(Search& search, const Seen& left, const Seen& right) const {
  edges(search);
  for (const Seen& seen : {left, right})
    if (in_.light && (seen.face != kNone || in_.ground_z)) shadow_edges(search, plane_of(seen));
  if (view_.near_plane) depths(search, *view_.near_plane);
}

void Crossings::everything(Search& search, const Seen& left, const Seen& right) const {
  outlines(search, left, right);
  for (const Seen& seen : {left, right})
    if (seen.face != kNone || in_.ground_z) depths(search, plane_of(seen));
}

std::vector<double> Crossings::conditions(const Line& line, double s, const Seen& left,
                                          const Seen& right) const {
  Search search{line, {}};
  everything(search, left, right);
  std::vector<double> near;
  for (const Place& p : search.found)
    if (std::fabs(p.s - s) <= std::min(kSearch * p.condition, kWidestSearch))
      near.push_back(p.condition);
  std::sort(near.begin(), near.end());
  return near;
}

/// How much the plane's depth at p is off when its offset is off by `error`.
double Crossings::depth_error(const Plane& plane, const Vec2& p, double error) const {
  const Vec4 here = image(plane), moved = image(Plane{plane.normal, plane.offset + error});
  const auto depth = [&p](const Vec4& f) { return glm::dot(Vec3(f), Vec3(p, 1)) / -f.w; };
  return std::fabs(depth(moved) - depth(here));
}

bool Crossings::near_depth(const Vec2& p, const Plane& a, const Plane& b, double error) const {
  const Vec4 f = image(a), g = image(b);
  if (f.w == 0 || g.w == 0) return false;
  const Vec3 depth_f = Vec3(f) / -f.w, depth_g = Vec3(g) / -g.w;
  const double steepest = glm::length(Vec2(depth_f)) + glm::length(Vec2(depth_g));
  return std::fabs(glm::dot(depth_f - depth_g, Vec3(p, 1))) <=
         error * steepest + depth_error(a, p, offset_error_) + depth_error(b, p, offset_error_);
}

/// How far the face's vertices are from its plane: that far has welding moved the one from the
/// others.
double Crossings::welded_by(const CanonicalFace& face) const {
  const Plane& plane = in_.planes[face.plane];
  double most = 0;
  for (Index l = face.first_loop; l < face.end_loop; ++l)
    for (const Index v : in_.loop(l))
      most = std::max(most, std::fabs(glm::dot(plane.normal, in_.vertices[v]) - plane.offset));
  return most;
}

/// The body begins or ends in the near plane: whether there is anything of it to be cut hangs on
/// whether its vertices are asked or its planes.
bool Crossings::near_cut(const Vec2& p, Index body) const {
  const CanonicalBody& b = in_.bodies[body];
  const Vec4 near = image(*view_.near_plane);
  for (Index f = b.first_face; f < b.end_face; ++f) {
    const CanonicalFace& face = in_.faces[f];
    const Vec4 depth = image(in_.planes[face.plane]);
    const double apart = glm::dot(Vec3(depth) / -depth.w - Vec3(near) / -near.w, Vec3(p, 1));
    const double error = welded_by(face) + offset_error_;
    if (std::fabs(apart) <= 2 * depth_error(in_.planes[face.plane], p, error)) return true;
  }
  return false;
}

bool Crossings::near_shadow(const Vec2& p, const Plane& receiver, double error) const {
  const double facing = glm::dot(receiver.normal, *in_.light);
  if (facing == 0) return false;
  const auto shadow = [&](Index v) {
    const Vec3& q = in_.vertices[v];
    return image(q + *in_.light * ((receiver.offset - glm::dot(receiver.normal, q)) / facing));
  };
  const double reach = error / std::fabs(facing);
  return std::any_of(in_.edges.begin(), in_.edges.end(), [&](const WingedEdge& e) {
    return is_near(p, shadow(e.from), shadow(e.to), reach);
  });
}

bool Crossings::may_be_off(const Vec2& p, const Seen& one, const Seen& other, double error) const {
  if (!same_plane(one, other) && near_depth(p, plane_of(one), plane_of(other), error)) return true;
  for (const Seen& seen : {one, other}) {
    if (view_.near_plane && near_depth(p, plane_of(seen), *view_.near_plane, error)) return true;
    if (seen.kind == Kind::cut && near_cut(p, seen.body)) return true;
    const bool receives = in_.light && (seen.face != kNone || in_.ground_z);
    if (receives && near_shadow(p, plane_of(seen), error)) return true;
  }
  return false;
}

bool Crossings::on_border(const Vec2& p, const Seen& seen, double error) const {
  if (seen.face == kNone) return false;
  const CanonicalBody& body = in_.bodies[seen.body];
  for (Index i = body.first_edge; i < body.end_edge; ++i) {
    const WingedEdge& e = in_.edges[i];
    if ((e.left == seen.face || e.right == seen.face) &&
        is_near(p, image(in_.vertices[e.from]), image(in_.vertices[e.to]), error))
      return true;
  }
  return false;
}

bool Crossings::on_both_borders(const Vec2& p, const Seen& one, const Seen& other,
                                double error) const {
  return on_border(p, one, error) && on_border(p, other, error);
}

std::vector<Crossings::Place> Crossings::places(const Line& line, const Seen& seen) const {
  Search search{line, {}};
  everything(search, seen, seen);
  std::sort(search.found.begin(), search.found.end(),
            [](const Place& a, const Place& b) { return a.s < b.s; });
  return std::move(search.found);
}

}  // namespace overstrike::oracle
