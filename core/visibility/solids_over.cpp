#include "core/visibility/solids_over.h"

#include <algorithm>
#include <cmath>

namespace overstrike {
namespace {

double facing(const Plane& plane, const Vec3& light) {
  return std::fabs(glm::dot(plane.normal, light));
}

template <class Visit>
void each_face(const Shadow& shadow, const Visit& visit) {
  for (std::size_t e = 0; e < shadow.operands.size(); ++e)
    for (const Index face : shadow.operands[e].faces)
      if (face != kNone) visit(e, face);
}

std::vector<Index> faces_of(const Shadow& shadow) {
  std::vector<Index> faces;
  each_face(shadow, [&](std::size_t, Index face) { faces.push_back(face); });
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return faces;
}

bool share_a_corner(const Canonical& c, Index f, Index g) {
  const auto corners = [&](Index face) {
    const Index first = c.first_corner(c.faces[face].first_loop);
    return std::span(c.corners).subspan(first, c.first_corner(c.faces[face].end_loop) - first);
  };
  return std::any_of(corners(f).begin(), corners(f).end(), [&](Index v) {
    return std::find(corners(g).begin(), corners(g).end(), v) != corners(g).end();
  });
}

}  // namespace

SolidsOver::SolidsOver(const ProjectedScene& scene, const DepthMap& eye, const Canonical& casting,
                       const Plane& receiver, const Shadow& shadow)
    : casting_(casting),
      view_(scene.view),
      order_(eye, casting, receiver, faces_of(shadow)),
      unit_(order_.height_of(
          {receiver.normal, receiver.offset + glm::dot(receiver.normal, *casting.light)})),
      cells_(view_.grid.columns, view_.grid.rows, shadow.operands.size()),
      sight_(casting) {
  edges_.reserve(shadow.operands.size());
  const double along_light = facing(receiver, *casting.light);
  for (const OperandEdge& e : shadow.operands)
    edges_.push_back({end_at(e.a, along_light), end_at(e.b, along_light)});
  gather(shadow);
  put_into_cells();
}

/// Points came to the receiver along the light: that has added their rounding, divided by n . L.
LineEnd SolidsOver::end_at(const Vec3& p, double along_light) const {
  LineEnd end{p, to_grid(view_, p), kNone};
  end.grid.error *= 1 + 1 / along_light;
  return end;
}

void SolidsOver::gather(const Shadow& shadow) {
  std::vector<std::pair<Index, std::size_t>> borders;
  each_face(shadow, [&](std::size_t e, Index face) { borders.emplace_back(face, e); });
  std::sort(borders.begin(), borders.end());
  for (const auto& [face, e] : borders) {
    if (faces_.empty() || faces_.back().face != face) {
      const Plane& plane = casting_.planes[casting_.faces[face].plane];
      faces_.push_back({face, shadow.operands[e].solid, members_.size(), 0});
      faces_.back().facing = facing(plane, *casting_.light);
    }
    Over& over = faces_.back();
    members_.push_back(e);
    over.end = members_.size();
    for (const LineEnd* const end : {&edges_[e].a, &edges_[e].b}) {
      const Vec2 p = end->grid.xy();
      over.low = glm::min(over.low, p - end->grid.error);
      over.high = glm::max(over.high, p + end->grid.error);
    }
  }
}

void SolidsOver::put_into_cells() {
  start_.assign(cells_.size() + 1, 0);
  const auto each = [&](const auto& visit) {
    for (Index i = 0; i < faces_.size(); ++i)
      cells_.in_box(faces_[i].low, faces_[i].high, [&](std::size_t cell) { visit(cell, i); });
  };
  each([&](std::size_t cell, Index) { ++start_[cell + 1]; });
  for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
  items_.resize(start_.back());
  std::vector<Index> at(start_.begin(), start_.end() - 1);
  each([&](std::size_t cell, Index i) { items_[at[cell]++] = i; });
  stamps_.assign(faces_.size(), 0);
}

bool SolidsOver::meet(const Over& over, const Vec2& low, const Vec2& high) {
  return over.low.x <= high.x && over.low.y <= high.y && low.x <= over.high.x &&
         low.y <= over.high.y;
}

bool SolidsOver::first_time(Index i) {
  if (stamps_[i] == turn_) return false;
  stamps_[i] = turn_;
  return true;
}

std::vector<CastLine> SolidsOver::lines() {
  std::vector<CastLine> lines;
  for (const Edge& e : edges_) lines.push_back({e.a, e.b});
  for (Index i = 0; i < faces_.size(); ++i) {
    const Over& f = faces_[i];
    ++turn_;
    cells_.in_box(f.low, f.high, [&](std::size_t cell) {
      for (Index k = start_[cell]; k < start_[cell + 1]; ++k) {
        const Over& g = faces_[items_[k]];
        if (items_[k] > i && meet(g, f.low, f.high) && first_time(items_[k]) && may_cross(f, g))
          cross(f, g, lines);
      }
    });
  }
  return lines;
}

bool SolidsOver::may_cross(const Over& f, const Over& g) const {
  const CanonicalFace &p = casting_.faces[f.face], &q = casting_.faces[g.face];
  if (f.solid != g.solid || p.plane == q.plane) return false;
  if (p.body != q.body) return true;
  return !casting_.bodies[p.body].simple && !share_a_corner(casting_, f.face, g.face);
}

/// What is between odd and even piercings of both borders.
void SolidsOver::cross(const Over& f, const Over& g, std::vector<CastLine>& lines) {
  pierce(f, f, g, ours_);
  if (ours_.empty()) return;
  pierce(g, f, g, theirs_);
  const auto end_of = [&](const Piercing& p) {
    LineEnd end{p.at, to_grid(view_, p.at), kNone};
    end.grid.error = p.error;
    return end;
  };
  for (std::size_t i = 0, k = 0; i + 1 < ours_.size() && k + 1 < theirs_.size();) {
    const Piercing& low = ours_[i].along < theirs_[k].along ? theirs_[k] : ours_[i];
    const bool ours_ends = ours_[i + 1].along < theirs_[k + 1].along;
    const Piercing& high = ours_ends ? ours_[i + 1] : theirs_[k + 1];
    if (low.along < high.along) {
      const LineEnd a = end_of(low), b = end_of(high);
      lines.push_back({a,
                       b,
                       {casting_.faces[f.face].plane, casting_.faces[g.face].plane},
                       {lead(a, f).value, lead(b, f).value}});
    }
    (ours_ends ? i : k) += 2;
  }
}

/// Where on the borders of `border` f and g are equally high. Ends where they are count as if f
/// were higher, so that of two faces that meet in such a border one is pierced if the surface is.
void SolidsOver::pierce(const Over& border, const Over& f, const Over& g,
                        std::vector<Piercing>& result) const {
  const DepthPlane &p = order_.depth_of(f.face), &q = order_.depth_of(g.face);
  const Vec2 direction(q.b - p.b, p.a - q.a);
  result.clear();
  for (std::size_t k = border.first; k < border.end; ++k) {
    const auto& [a, b] = edges_[members_[k]];
    const double lead_a = lead_over(a, f, g), lead_b = lead_over(b, f, g);
    if ((lead_a < 0) == (lead_b < 0)) continue;
    // Linear in the grid; times w^, along the edge.
    const double at_a = lead_a * a.grid.w, at_b = lead_b * b.grid.w;
    const Vec3 at = at_a == 0   ? a.world
                    : at_b == 0 ? b.world
                                : a.world + (b.world - a.world) * (at_a / (at_a - at_b));
    result.push_back(
        {glm::dot(direction, to_grid(view_, at).xy()), at, std::max(a.grid.error, b.grid.error)});
  }
  std::sort(result.begin(), result.end(),
            [](const Piercing& a, const Piercing& b) { return a.along < b.along; });
}

/// How much higher f is than g over the point: 0 where rounding may have made the difference.
double SolidsOver::lead_over(const LineEnd& end, const Over& f, const Over& g) const {
  const Lead p = lead(end, f), q = lead(end, g);
  const double difference = p.value - q.value;
  return std::fabs(difference) <= p.error + q.error ? 0 : difference;
}

/// Rounding has moved the point across the slope of the plane, and the plane, which was made from
/// points with as much rounding, as well: twice; and the plane along the light.
Lead SolidsOver::lead(const LineEnd& end, const Over& over) const {
  const DepthPlane& d = order_.depth_of(over.face);
  const Vec3& p = end.grid.at;
  const double moved = (std::fabs(d.a) + std::fabs(d.b)) * end.grid.error;
  const double shifted = height_error(plane_of(over), end.world) / over.facing;
  const double plane_error = d.ea * std::fabs(p.x) + d.eb * std::fabs(p.y) + d.ec;
  return {d.at(p.x, p.y), 2 * moved + shifted * std::fabs(unit_.at(p.x, p.y)) + plane_error};
}

void SolidsOver::add_shadowed(const CastLine& line, double sliver,
                              std::array<Intervals, 2>& parts) {
  const Ruler ruler(line.a.grid, line.b.grid);
  const Vec2 pad(ruler.error()), from = line.a.grid.xy(), to = line.b.grid.xy();
  const Vec2 low = glm::min(from, to) - pad, high = glm::max(from, to) + pad;
  sight_.clear();
  ++turn_;
  cells_.along(from, to, ruler.error(), [&](std::size_t cell) {
    for (Index k = start_[cell]; k < start_[cell + 1]; ++k) {
      const Over& over = faces_[items_[k]];
      if (meet(over, low, high) && first_time(items_[k])) add_face(line, ruler, over);
    }
    return true;
  });
  if (!sight_.empty()) sight_.resolve(ruler, sliver, SolidSight::Ends::nowhere, shown_);
  for (const SolidSight::Part& part : shown_) parts[part.side].push_back(part.over);
  unite(parts[0]), unite(parts[1]);
  shown_.clear();
}

/// Faces of planes that cross in the line are to be equally high over it whatever rounding says.
void SolidsOver::add_face(const CastLine& line, const Ruler& ruler, const Over& over) {
  const auto& [plane, other] = line.crossed;
  const DepthPlane& d = order_.depth_of(over.face);
  FaceOver face{over.face, {}, order_.enters(over.face), {d.a, d.b}, {}};
  pass_over(ruler, over, face.passage);
  if (face.passage.side[0].empty() && face.passage.side[1].empty()) return;
  face.leads = {lead(line.a, over), lead(line.b, over)};
  const Index own = casting_.faces[over.face].plane;
  if (own == plane || own == other) {
    for (int end = 0; end < 2; ++end) face.leads[end].value = line.crossed_at[end];
  }
  sight_.add(face);
}

void SolidsOver::pass_over(const Ruler& ruler, const Over& over, Passage& passage) {
  crossings_[0].clear(), crossings_[1].clear();
  for (std::size_t k = over.first; k < over.end; ++k) {
    const GridPoint &p = edges_[members_[k]].a.grid, &q = edges_[members_[k]].b.grid;
    const double a = ruler.side(p), b = ruler.side(q);
    if ((a > 0 && b > 0) || (a < 0 && b < 0)) continue;
    for (int side = 0; side < 2; ++side) {
      const auto right = [&](double s) { return s == 0 ? side != 0 : s > 0; };
      if (right(a) != right(b)) crossings_[side].push_back(ruler.crossing(p.xy(), a, q.xy(), b));
    }
  }
  for (int side = 0; side < 2; ++side) pair_up(crossings_[side], passage.side[side]);
}

}  // namespace overstrike
