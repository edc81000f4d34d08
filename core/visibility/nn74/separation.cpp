#include "core/visibility/nn74/separation.h"

#include <algorithm>
#include <cmath>

namespace overstrike::nn74 {
namespace {

double largest(const Bounds& box) {
  const Vec3 size = glm::max(glm::abs(box.low), glm::abs(box.high));
  return std::max({size.x, size.y, size.z});
}

struct Solid {
  const Canonical& canonical;
  const CanonicalBody& body;
};

/// Where a body lies along a direction, counted from a point.
struct Range {
  double low = 1e300, high = -1e300;
};

/// Gives up, and returns false, when the body lies farther than `most` on both sides of the origin.
bool one_sided(const Solid& s, const Vec3& n, double origin, double most, Range& r) {
  r = {};
  for (Index v = s.body.first_vertex; v < s.body.end_vertex; ++v) {
    const double h = glm::dot(n, s.canonical.vertices[v]) - origin;
    r.low = std::min(r.low, h), r.high = std::max(r.high, h);
    if (r.low < -most && r.high > most) return false;
  }
  return true;
}

/// The plane with the widest gap so far.
class Search {
 public:
  Search(const Solid& a, const Solid& b, double touch) : a_(a), b_(b), touch_(touch) {}

  void boxes(const Bounds& a, const Bounds& b) {
    for (int i = 0; i < 3; ++i) {
      Vec3 axis(0);
      axis[i] = 1;
      offer(axis, a.low[i], b.high[i], 0);
      offer(-axis, -a.high[i], -b.low[i], 0);
    }
  }
  void faces() {
    of(a_, b_, -1);
    of(b_, a_, 1);
  }
  void edges();

  std::optional<Separation> result() const { return found_; }

 private:
  /// a lies at `a_low` and above along the axis, b at `b_high` and below.
  void offer(const Vec3& axis, double a_low, double b_high, double touch) {
    const double gap = a_low - b_high;
    if (gap < -touch || (found_ && gap <= gap_)) return;
    gap_ = gap;
    found_ = Separation{axis, b_high + gap / 2};
  }
  void of(const Solid& owner, const Solid& other, double sign);
  void edge_pair(const Vec3& origin, const Vec3& axis);

  const Solid& a_;
  const Solid& b_;
  double touch_, gap_ = 0;
  std::optional<Separation> found_;
};

/// A face's plane has its own body behind it.
void Search::of(const Solid& owner, const Solid& other, double sign) {
  for (Index f = owner.body.first_face; f < owner.body.end_face; ++f) {
    const CanonicalFace& face = owner.canonical.faces[f];
    const Plane& plane = owner.canonical.planes[face.plane];
    for (const double side : owner.body.closed ? std::vector<double>{face.flipped ? -1.0 : 1.0}
                                               : std::vector<double>{1.0, -1.0}) {
      double lowest = 1e300;
      for (Index v = other.body.first_vertex; v < other.body.end_vertex; ++v) {
        const double h =
            side * (glm::dot(plane.normal, other.canonical.vertices[v]) - plane.offset);
        if (h >= lowest) continue;
        lowest = h < 0 && has_face_in(other.canonical, other.body, face.plane, v)
                     ? std::min(lowest, 0.0)
                     : h;
        if (lowest < -touch_) break;
      }
      // The other at `lowest` above the plane, the owner at 0 and below.
      const double at = side * plane.offset;
      const Vec3 normal = plane.normal * side;
      if (sign > 0)
        offer(normal, at + lowest, at, touch_);
      else
        offer(-normal, -at, -(at + lowest), touch_);
    }
  }
}

void Search::edge_pair(const Vec3& origin, const Vec3& axis) {
  const double at = glm::dot(axis, origin);
  Range a, b;
  if (!one_sided(a_, axis, at, touch_, a) || !one_sided(b_, axis, at, 1e300, b)) return;
  offer(axis, at + a.low, at + b.high, touch_);
  offer(-axis, -(at + a.high), -(at + b.low), touch_);
}

void Search::edges() {
  // Edges nearer to parallel than this sine span no plane that 53 bits could tell from a face's.
  constexpr double kParallel = 0x1p-40;
  for (Index i = a_.body.first_edge; i < a_.body.end_edge; ++i) {
    const WingedEdge& e = a_.canonical.edges[i];
    const Vec3 from = a_.canonical.vertices[e.from], along = a_.canonical.vertices[e.to] - from;
    for (Index j = b_.body.first_edge; j < b_.body.end_edge; ++j) {
      const WingedEdge& g = b_.canonical.edges[j];
      const Vec3 other = b_.canonical.vertices[g.to] - b_.canonical.vertices[g.from];
      const Vec3 axis = glm::cross(along, other);
      const double square = glm::dot(axis, axis);
      const double sizes = glm::dot(along, along) * glm::dot(other, other);
      if (square > kParallel * kParallel * sizes) edge_pair(from, axis / std::sqrt(square));
    }
  }
}

}  // namespace

bool has_face_in(const Canonical& c, const CanonicalBody& body, Index plane, Index vertex) {
  for (Index f = body.first_face; f < body.end_face; ++f) {
    if (c.faces[f].plane != plane) continue;
    for (Index l = c.faces[f].first_loop; l < c.faces[f].end_loop; ++l)
      for (const Index v : c.loop(l))
        if (v == vertex) return true;
  }
  return false;
}

Bounds bounds_of(const Canonical& c, const CanonicalBody& body) {
  Bounds box;
  for (Index v = body.first_vertex; v < body.end_vertex; ++v) box.add(c.vertices[v]);
  return box;
}

std::optional<Separation> separate(const Canonical& first, const CanonicalBody& a,
                                   const Canonical& second, const CanonicalBody& b) {
  const Bounds p = bounds_of(first, a), q = bounds_of(second, b);
  const Solid solid_a{first, a}, solid_b{second, b};
  Search search(solid_a, solid_b, kTouch * std::max(largest(p), largest(q)));
  search.boxes(p, q);
  if (!search.result()) search.faces();
  if (!search.result()) search.edges();
  return search.result();
}

}  // namespace overstrike::nn74
