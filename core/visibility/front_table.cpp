#include "core/visibility/front_table.h"

#include <algorithm>
#include <limits>

#include "core/in_order.h"
#include "core/large_pages.h"
#include "core/shading/density_law.h"
#include "core/visibility/depth_range.h"
#include "core/visibility/edge_on_faces.h"
#include "core/visibility/far_line.h"
#include "core/visibility/front_outline.h"
#include "core/visibility/ground_polygon.h"
#include "core/visibility/operand_windows.h"
#include "core/visibility/run_source.h"

namespace overstrike {

namespace {

/// Twice the area of a triangle that turns as faces do in the grid.
double area_of(const Vec2& p, const Vec2& q, const Vec2& r) {
  return (q.y - p.y) * (r.x - p.x) - (q.x - p.x) * (r.y - p.y);
}

}  // namespace

double area_of(const FrontTable& table, Index face) {
  const Canonical& c = table.canonical;
  const CanonicalFace& f = c.faces[face];
  double area = 0;
  for (Index l = f.first_loop; l < f.end_loop; ++l) {
    const std::span<const Index> loop = c.loop(l);
    const Vec2& base = table.points[loop[0]];
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
      area += area_of(base, table.points[loop[i]], table.points[loop[i + 1]]);
  }
  return area;
}

namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

class Builder {
 public:
  explicit Builder(FrontTable& table)
      : table_(table), c_(table.canonical), view_(table.view), outlines_(table) {}

  void look_at(Index number) {
    project(number);
    look_at_faces(number);
    if (!rough_ || !edge_on_) return;
    lay_edge_on_faces(table_, number);
    look_at_faces(number);
  }
  void find_outline(Index number) { outlines_.find(number); }
  void add_ground();
  void add_solids();

 private:
  void project(Index number);
  void look_at_faces(Index number);
  bool all_triangles(const CanonicalBody& body) const;
  FaceTone tone_of(const CanonicalFace& f, bool behind) const;
  bool is_smooth(const CanonicalFace& f, bool behind, double& mean) const;
  bool convex(std::span<const Index> loop) const;
  bool walkable(const CanonicalFace& f) const;

  FrontTable& table_;
  const Canonical& c_;
  const View& view_;
  // Of the present body.
  Vec2 reach_{0.0};       ///< bounds of the sizes of its coordinates
  bool rough_ = false;    ///< its points may be off by more than lines are looked at beside
  bool edge_on_ = false;  ///< it has faces that are seen edge-on
  OutlineFinder outlines_;
};

// Each of x^, y^, w^ is a sum of four products, rounded by at most 2 eps sum |terms|; the quotient
// adds an eps. Bounded for all vertices of a body at once.
void Builder::project(Index number) {
  const CanonicalBody& body = c_.bodies[number];
  FrontBody& front = table_.bodies[number] = {};
  front.low = Vec3(kInfinity), front.high = Vec3(-kInfinity);
  double least_w = kInfinity;
  Vec2 most(0.0);
  const Mat4& m = view_.matrix;
  for (Index v = body.first_vertex; v < body.end_vertex; ++v) {
    const Vec3& p = c_.vertices[v];
    front.low = glm::min(front.low, p), front.high = glm::max(front.high, p);
    const double x = m[0][0] * p.x + m[1][0] * p.y + m[2][0] * p.z + m[3][0];
    const double y = m[0][1] * p.x + m[1][1] * p.y + m[2][1] * p.z + m[3][1];
    Vec2 at(x, y);
    if (view_.perspective) {
      const double w = m[0][2] * p.x + m[1][2] * p.y + m[2][2] * p.z + m[3][2];
      least_w = std::min(least_w, std::fabs(w));
      // 0 only by rounding, of a near plane that stands at the eye: no place is better than
      // another.
      at = w != 0 ? Vec2(x / w, y / w) : Vec2(0.0);
    }
    table_.points[v] = at;
    most = glm::max(most, glm::abs(at));
  }
  reach_ = most;
  front.far = table_.use == FrontUse::picture && !(std::max(most.x, most.y) <= kFarAway);
  rough_ = false;
  if (body.first_vertex == body.end_vertex) return;
  Vec4 size = glm::abs(m[3]);
  const Vec3 reach = glm::max(glm::abs(front.low), glm::abs(front.high));
  for (int column = 0; column < 3; ++column) size += glm::abs(m[column]) * reach[column];
  const double far = std::max(most.x, most.y);
  if (!view_.perspective) least_w = 1;
  const double error = 2 * kEps * (std::max(size.x, size.y) + size.z * far) / least_w + kEps * far;
  // The ends' own errors, moved along by the slope, and the rounding of x_at itself.
  const double beside =
      table_.use == FrontUse::picture ? beside_line(table_.columns, table_.rows) : 0;
  front.line_error = {2 * error + 4 * kEps * most.x, 2 * error + 4 * kEps * most.y, beside,
                      4 * kEps * std::max(size.x, size.y) / least_w, 4 * kEps * size.z / least_w};
  rough_ = view_.perspective && beside > 0 && 2 * error > beside;
  if (front.far) front.line_error = far_line_error(table_, number);
}

bool Builder::is_smooth(const CanonicalFace& f, bool behind, double& mean) const {
  if (f.cut || !c_.bodies[f.body].smooth || c_.corner_normals.empty() || !c_.light) return false;
  if (f.end_loop - f.first_loop != 1) return false;
  const Index first = c_.first_corner(f.first_loop), end = c_.loop_ends[f.first_loop];
  const auto density = [&](Index i) {
    return lit_density(c_, c_.bodies[f.body],
                       behind ? -c_.corner_normals[i] : c_.corner_normals[i]);
  };
  const double at_first = density(first);
  bool varies = false;
  double sum = at_first;
  for (Index i = first + 1; i < end; ++i) {
    const double d = density(i);
    varies = varies || d != at_first;
    sum += d;
  }
  // Where all are equal it is that, to the last bit.
  mean = varies ? sum / (end - first) : at_first;
  return varies;
}

/// No two corners turn opposite ways.
bool Builder::convex(std::span<const Index> loop) const {
  const auto at = [&](std::size_t i) { return table_.points[loop[i % loop.size()]]; };
  bool left = false, right = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 a = at(i + 1) - at(i), b = at(i + 2) - at(i + 1);
    const double turn = a.x * b.y - a.y * b.x;
    left = left || turn < 0, right = right || turn > 0;
  }
  return !(left && right);
}

/// A loop that goes up once and down once meets every level in two sides. Of open bodies a face may
/// cross itself, and turn the other way beyond the crossing.
bool Builder::walkable(const CanonicalFace& f) const {
  if (f.end_loop - f.first_loop != 1) return false;
  const std::span<const Index> loop = c_.loop(f.first_loop);
  if (loop.size() == 3) return true;
  if (!c_.bodies[f.body].closed && !convex(loop)) return false;
  int turns = 0, direction = 0, first_direction = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const double step =
        table_.points[loop[i + 1 == loop.size() ? 0 : i + 1]].y - table_.points[loop[i]].y;
    const int now = (step > 0) - (step < 0);
    if (now == 0) continue;
    if (first_direction == 0) first_direction = now;
    turns += direction != 0 && now != direction;
    direction = now;
  }
  turns += direction != first_direction;
  return turns <= 2;
}

/// Loops have three corners or more: so many of them are three each.
bool Builder::all_triangles(const CanonicalBody& body) const {
  if (body.first_face == body.end_face) return false;
  const Index faces = body.end_face - body.first_face;
  const Index end_loop = c_.faces[body.end_face - 1].end_loop;
  return end_loop - c_.faces[body.first_face].first_loop == faces &&
         c_.loop_ends[end_loop - 1] - body.first_corner == 3 * faces;
}

FaceTone Builder::tone_of(const CanonicalFace& f, bool behind) const {
  const FaceShade shade = shade_of(c_, f, behind);
  FaceTone tone{shade.density, f.body, shade.lit ? Kind::lit : Kind::shade, false};
  if (f.cut) tone.kind = Kind::cut;
  tone.smooth = is_smooth(f, behind, tone.density);
  return tone;
}

void Builder::look_at_faces(Index number) {
  const CanonicalBody& body = c_.bodies[number];
  FrontBody& front = table_.bodies[number];
  front.triangles = all_triangles(body);
  DepthRange depths(table_.depths, reach_);
  const bool picture = table_.use == FrontUse::picture;
  const bool operand = c_.membership(number).solid != kNone;
  bool from_front = false, from_behind = false, walk = true;
  edge_on_ = front.turned = false;
  for (Index i = body.first_face; i < body.end_face; ++i) {
    const CanonicalFace& f = c_.faces[i];
    const int side = side_of_eye(c_.planes[f.plane], f.flipped, view_.eye);
    const bool behind = side < 0;
    edge_on_ = edge_on_ || side == 0;
    if (side == 0 || (behind && body.closed && !f.cut && !operand)) continue;
    const Index first = front.triangles ? body.first_corner + 3 * (i - body.first_face)
                                        : c_.first_corner(f.first_loop);
    const Index count = front.triangles ? 3 : c_.loop_ends[f.end_loop - 1] - first;
    if (!depths.add(f.plane, {c_.corners.data() + first, count}, table_.points.data())) continue;
    table_.sides[i] = behind ? -1 : 1;
    if (picture) table_.tones[i] = tone_of(f, behind);
    // A body that passes through itself may be inside out where it is cut: its cap looks to the
    // eye, but turns the other way. So do thin faces that are off their planes.
    if (f.cut || !body.on_planes || !picture) {
      const auto point = [&](Index j) { return table_.points[c_.corners[first + j]]; };
      const double area = count == 3 ? area_of(point(0), point(1), point(2)) : area_of(table_, i);
      front.turned |= behind ? area > 0 : area < 0;
    }
    front.seen = true;
    (behind ? from_behind : from_front) = true;
    walk = walk && (front.triangles || walkable(f));
  }
  front.far_z = depths.low, front.near_z = depths.high;
  front.triangles = front.triangles && !front.far;
  front.simple = body.simple, front.on_planes = body.on_planes;
  front.loose =
      front.seen && (operand || !walk || (front.turned && picture) || (from_front && from_behind));
}

/// A body of one face, after all others; in the world it is all that lies below it.
void Builder::add_ground() {
  const Index plane = static_cast<Index>(c_.planes.size());
  const std::vector<Vec2> polygon =
      ground_polygon(c_, view_, [&](GroundPlane p) { return table_.depths.depth(plane + p); });
  const Index number = table_.ground_body();
  table_.tones[table_.ground()] = {0, kNone, Kind::lit, false};
  const bool is_seen = polygon.size() > 2;
  table_.sides[table_.ground()] = is_seen;
  FrontBody& ground = table_.bodies[number] = {};
  ground.low = Vec3(-kInfinity), ground.high = Vec3(kInfinity, kInfinity, c_.ground_z.value_or(0));
  ground.near_z = kInfinity, ground.far_z = -kInfinity;
  ground.seen = is_seen;
  ground.simple = true;
  const double reach = std::max(table_.columns, table_.rows) + 1;
  const double beside = beside_line(table_.columns, table_.rows);
  ground.line_error = {6 * kEps * reach, 6 * kEps * reach, beside, 0, 0};
  if (!is_seen) return;
  outlines_.find_ground(polygon);
}

/// Bounds of all their operands that matter.
void Builder::add_solids() {
  if (c_.solids.empty()) return;
  table_.windows = operand_windows(c_, view_, {table_.bodies.data(), c_.bodies.size()});
  for (Index s = 0; s < c_.solids.size(); ++s) {
    FrontBody& solid = table_.bodies[table_.solid_body(s)] = {};
    solid.low = Vec3(kInfinity), solid.high = Vec3(-kInfinity);
    solid.near_z = -kInfinity, solid.far_z = kInfinity;
    solid.loose = true;
  }
  for (Index b = 0; b < c_.memberships.size(); ++b) {
    const FrontBody& front = table_.bodies[b];
    if (c_.memberships[b].solid == kNone || !front.seen ||
        (!table_.windows.empty() && table_.windows[b].none()))
      continue;
    FrontBody& solid = table_.bodies[table_.solid_body(c_.memberships[b].solid)];
    table_.operands.push_back(b);
    solid.seen = true;
    solid.on_planes = solid.on_planes && front.on_planes;
    solid.low = glm::min(solid.low, front.low), solid.high = glm::max(solid.high, front.high);
    solid.near_z = std::max(solid.near_z, front.near_z);
    solid.far_z = std::min(solid.far_z, front.far_z);
  }
  std::stable_sort(table_.operands.begin(), table_.operands.end(), [&](Index a, Index b) {
    return c_.memberships[a].solid < c_.memberships[b].solid;
  });
}

}  // namespace

FrontTable::FrontTable(const Canonical& canonical_input, const View& in_view, FrontUse for_use,
                       int threads)
    : canonical(canonical_input),
      view(in_view),
      use(for_use),
      columns(view.grid.columns),
      rows(view.grid.rows),
      points(canonical.vertices.size()),
      sides(canonical.faces.size() + 1),
      tones(use == FrontUse::picture ? canonical.faces.size() + 1 : 0),
      bodies(canonical.bodies.size() + 1 + canonical.solids.size()),
      further_planes(ground_planes(canonical, view)),
      depths(canonical.planes, further_planes, view) {
  // Room, not memory, until it is used.
  if (use == FrontUse::picture) small_sides.reserve(canonical.edges.size());
  prefer_large_pages(points), prefer_large_pages(tones), prefer_large_pages(bodies);
  prefer_large_pages(small_sides);
  // By what a part costs, its faces. Alone, one goes over each body once.
  constexpr std::size_t kFacesAtOnce = 4096;
  const std::size_t faces_a_body = canonical.faces.size() / (canonical.bodies.size() + 1) + 1;
  Builder builder(*this);
  if (threads != 1)
    in_parallel(canonical.bodies.size(), threads, kFacesAtOnce / faces_a_body + 1,
                [&](std::size_t first, std::size_t end) {
                  Builder part(*this);
                  for (std::size_t b = first; b < end; ++b) part.look_at(static_cast<Index>(b));
                });
  for (Index b = 0; b < canonical.bodies.size(); ++b) {
    if (threads == 1) builder.look_at(b);
    builder.find_outline(b);
    if (bodies[b].loose && canonical.membership(b).solid == kNone) loose.push_back(b);
  }
  if (use == FrontUse::picture) {
    builder.add_ground();
  } else {
    bodies[ground_body()] = {};
  }
  builder.add_solids();
}

}  // namespace overstrike
