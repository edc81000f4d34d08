// Where faces pass through each other and through the ground: the straight line in which two planes
// meet, where it is inside both outlines.
#include <algorithm>

#include "core/visibility/candidate_lines.h"
#include "core/visibility/interpenetration.h"
#include "core/visibility/tie.h"

namespace overstrike {
namespace {

/// A point where an outline passes through a plane.
struct Piercing {
  double along;  ///< in the direction of the line in which the planes meet
  Vec3 at;
};
using Piercings = std::vector<Piercing>;

bool before(const Vec3& a, const Vec3& b) {
  if (a.x != b.x) return a.x < b.x;
  return a.y != b.y ? a.y < b.y : a.z < b.z;
}

class Crossings {
 public:
  Crossings(const ProjectedScene& scene, std::vector<SightLine>& lines)
      : scene_(scene), c_(scene.canonical), lines_(lines), curved_(curved_bodies(c_)) {}

  void cross(Index f, Index g) {
    const Index p = c_.faces[f].plane, q = c_.faces[g].plane;
    if (p == q) return;
    const Vec3 direction = glm::cross(c_.planes[p].normal, c_.planes[q].normal);
    pierce(f, q, direction, ours_);
    if (ours_.size() < 2) return;
    pierce(g, p, direction, theirs_);
    solids_ = {solid_of(f), solid_of(g)};
    meet(f, {p, q}, curved(f) || curved(g));
  }

  void cross_ground(Index f) {
    const Index p = c_.faces[f].plane, ground = scene_.ground();
    const Vec3 direction = glm::cross(c_.planes[p].normal, scene_.plane(ground).normal);
    pierce(f, ground, direction, ours_);
    solids_ = {solid_of(f), kNone};
    for (std::size_t i = 0; i + 1 < ours_.size(); i += 2)
      add(f, {p, ground}, curved(f), ours_[i].at, ours_[i + 1].at);
  }

  bool share_a_corner(Index f, Index g) const {
    for (Index l = c_.faces[f].first_loop; l < c_.faces[f].end_loop; ++l)
      for (const Index v : c_.loop(l))
        for (Index m = c_.faces[g].first_loop; m < c_.faces[g].end_loop; ++m)
          for (const Index w : c_.loop(m))
            if (v == w) return true;
    return false;
  }

 private:
  Index solid_of(Index face) const { return c_.membership(c_.faces[face].body).solid; }
  bool curved(Index face) const { return curved_[c_.faces[face].body] != 0; }

  /// Corners on the plane count as above it, so that of two faces that meet in an edge on the
  /// plane one passes through it if the surface does.
  void pierce(Index face, Index plane, const Vec3& direction, Piercings& result) {
    result.clear();
    for (Index l = c_.faces[face].first_loop; l < c_.faces[face].end_loop; ++l) {
      const std::span<const Index> loop = c_.loop(l);
      heights_.clear();
      for (const Index v : loop) heights_.push_back(scene_.height(plane, v));
      for (std::size_t i = 0, last = loop.size() - 1; i < loop.size(); last = i++)
        if ((heights_[last] < 0) != (heights_[i] < 0)) {
          const Vec3 at = piercing(loop[last], heights_[last], loop[i], heights_[i]);
          result.push_back({glm::dot(direction, at), at});
        }
    }
    std::sort(result.begin(), result.end(),
              [](const Piercing& a, const Piercing& b) { return a.along < b.along; });
  }

  /// From the ends in a canonical order: faces that share the edge share the point to the bit.
  Vec3 piercing(Index v, double hv, Index w, double hw) const {
    const Vec3 *p = &c_.vertices[v], *q = &c_.vertices[w];
    if (hv == 0) return *p;
    if (hw == 0) return *q;
    if (before(*q, *p)) std::swap(p, q), std::swap(hv, hw);
    return *p + (*q - *p) * (hv / (hv - hw));
  }

  /// What is between odd and even piercings of both outlines.
  void meet(Index face, std::array<Index, 2> planes, bool is_curved) {
    for (std::size_t i = 0, k = 0; i + 1 < ours_.size() && k + 1 < theirs_.size();) {
      const Piercing& low = ours_[i].along < theirs_[k].along ? theirs_[k] : ours_[i];
      const bool ours_ends = ours_[i + 1].along < theirs_[k + 1].along;
      const Piercing& high = ours_ends ? ours_[i + 1] : theirs_[k + 1];
      if (low.along < high.along) add(face, planes, is_curved, low.at, high.at);
      (ours_ends ? i : k) += 2;
    }
  }

  void add(Index face, std::array<Index, 2> planes, bool is_curved, const Vec3& a, const Vec3& b) {
    const Index body = c_.faces[face].body;
    lines_.push_back({{a, to_grid(scene_.view, a), kNone},
                      {b, to_grid(scene_.view, b), kNone},
                      planes,
                      StrokeKind::intersection,
                      body,
                      c_.bodies[body].pen,
                      is_curved,
                      {{0.0, 1.0}},
                      solids_});
  }

  const ProjectedScene& scene_;
  const Canonical& c_;
  std::vector<SightLine>& lines_;
  std::vector<char> curved_;
  std::vector<double> heights_;
  Piercings ours_, theirs_;
  std::array<Index, 2> solids_{kNone, kNone};  ///< of the faces in hand
};

}  // namespace

void add_intersections(const ProjectedScene& scene, const FaceIndex& index,
                       std::vector<SightLine>& lines) {
  const Canonical& c = scene.canonical;
  const std::vector<char> may_cross = bodies_that_may_cross(c);
  if (std::none_of(may_cross.begin(), may_cross.end(), [](char m) { return m != 0; })) return;
  Crossings crossings(scene, lines);
  FaceIndex::Query query(index);
  const std::vector<FaceBox>& boxes = index.boxes();
  for (Index i = 0; i < boxes.size(); ++i) {
    const Index f = boxes[i].face, body = c.faces[f].body;
    if (may_cross[body] == 0) continue;
    if (scene.has_ground()) crossings.cross_ground(f);
    query.meeting(boxes[i], [&](Index other) {
      const Index g = boxes[other].face, other_body = c.faces[g].body;
      if (other <= i || may_cross[other_body] == 0) return;
      if (other_body == body && (c.bodies[body].simple || crossings.share_a_corner(f, g))) return;
      // The line is a stroke of the body that would win a tie, whatever the order given.
      const bool in_order = wins_tie(c, f, g);
      crossings.cross(in_order ? f : g, in_order ? g : f);
    });
  }
}

}  // namespace overstrike
