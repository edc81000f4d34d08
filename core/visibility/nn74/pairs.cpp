#include "core/visibility/nn74/pairs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/geometry/polygon.h"
#include "core/visibility/nn74/separation.h"

namespace overstrike::nn74 {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

/// f(i, j) of a side and a point.
int f(const ConvexView& view, Index side, const Vec2& p) {
  return turn_of(view.from(side), view.to(side), p);
}

/// An edge of `a` has all corners of b outside or on it.
bool splits_off(const ConvexView& v, const Contour& a, const ConvexView& w, const Contour& b) {
  return std::any_of(a.sides.begin(), a.sides.end(), [&](Index i) {
    return std::all_of(b.sides.begin(), b.sides.end(),
                       [&](Index j) { return f(v, i, w.from(j)) <= 0; });
  });
}

bool is_inside(const ConvexView& v, const Contour& inner, const ConvexView& w,
               const Contour& outer) {
  return std::all_of(outer.sides.begin(), outer.sides.end(), [&](Index i) {
    return std::all_of(inner.sides.begin(), inner.sides.end(),
                       [&](Index j) { return f(w, i, v.from(j)) >= 0; });
  });
}

/// A difference of nearness and a bound on its error.
struct Difference {
  double value, error;
};

/// Keeps the difference that stands out most above its error.
class Verdict {
 public:
  void hear(const Difference& d) {
    const double excess = std::fabs(d.value) - d.error;
    if (!(excess > excess_)) return;
    excess_ = excess;
    sign_ = d.value > 0 ? 1 : -1;
  }
  int sign() const { return sign_; }

 private:
  double excess_ = 0;
  int sign_ = 0;
};

/// Where a contour edge meets the line of another: `near` there.
struct Crossing {
  double near, error;
};

Crossing on_side(const ConvexView& v, Index side, const Vec2& a, const Vec2& b, double line_error) {
  const ViewedPoint& p = v.points[v.sides[side].from];
  const ViewedPoint& q = v.points[v.sides[side].to];
  const double fp = cross(b - a, p.at - a), fq = cross(b - a, q.at - a);
  const double t = fp / (fp - fq);
  // f is a sum of two products of differences: errors of the four places, each times the other
  // factor, and 3 kEps of its terms.
  const double length = std::fabs(b.x - a.x) + std::fabs(b.y - a.y);
  const double reach = std::fabs(p.at.x - a.x) + std::fabs(p.at.y - a.y) + std::fabs(q.at.x - a.x) +
                       std::fabs(q.at.y - a.y);
  const double place = std::max(p.at_error, q.at_error) + line_error;
  const double f_error = 2 * place * (length + reach) + 3 * kEps * length * reach;
  const double t_error = 2 * f_error / std::fabs(fp - fq);
  const double climb = q.near - p.near;
  return {p.near + climb * t, std::fabs(climb) * t_error + p.near_error + q.near_error +
                                  4 * kEps * (std::fabs(p.near) + std::fabs(q.near))};
}

/// (7)(8): the points of two contour edges that project to one crossing.
void hear_crossings(const ConvexView& v, const Contour& a, const ConvexView& w, const Contour& b,
                    Verdict& verdict) {
  for (const Index i : a.sides)
    for (const Index k : b.sides) {
      if (f(v, i, w.from(k)) * f(v, i, w.to(k)) >= 0) continue;
      if (f(w, k, v.from(i)) * f(w, k, v.to(i)) >= 0) continue;
      const double k_error =
          std::max(w.points[w.sides[k].from].at_error, w.points[w.sides[k].to].at_error);
      const double i_error =
          std::max(v.points[v.sides[i].from].at_error, v.points[v.sides[i].to].at_error);
      const Crossing p = on_side(v, i, w.from(k), w.to(k), k_error);
      const Crossing q = on_side(w, k, v.from(i), v.to(i), i_error);
      verdict.hear({p.near - q.near, p.error + q.error});
    }
}

/// (9)(10): corners of one contour that lie inside the other, against the plane of its face there.
void hear_corners(const ConvexView& v, const Contour& inner, const ConvexView& w,
                  const Contour& outer, double sign, Verdict& verdict) {
  for (const Index j : inner.sides) {
    const ViewedPoint& p = v.points[v.sides[j].from];
    for (Index face = outer.first_face; face < outer.end_face; ++face) {
      const ViewedFace& g = w.faces[face];
      if (!holds(w, g, p.at)) continue;
      const Vec3 at(p.at, 1), size = glm::abs(at);
      const double near = glm::dot(g.depth, at);
      const double error = glm::dot(g.depth_error, size) + p.near_error +
                           (std::fabs(g.depth.x) + std::fabs(g.depth.y)) * p.at_error +
                           4 * kEps * glm::dot(glm::abs(g.depth), size);
      verdict.hear({sign * (p.near - near), error});
    }
  }
}

}  // namespace

std::vector<std::pair<Index, Index>> overlapping_boxes(const std::vector<Extent>& boxes) {
  std::vector<Index> order(boxes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return boxes[a].low.x < boxes[b].low.x; });
  std::vector<std::pair<Index, Index>> pairs;
  std::vector<Index> open;
  for (const Index i : order) {
    std::erase_if(open, [&](Index j) { return boxes[j].high.x < boxes[i].low.x; });
    for (const Index j : open)
      if (boxes[i].low.x < boxes[j].high.x && boxes[j].low.x < boxes[i].high.x &&
          boxes[i].low.y < boxes[j].high.y && boxes[j].low.y < boxes[i].high.y)
        pairs.emplace_back(std::min(i, j), std::max(i, j));
    open.push_back(i);
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

Overlap overlap_of(const ConvexView& v, Index a, const ConvexView& w, Index b) {
  const Contour& p = v.bodies[a];
  const Contour& q = w.bodies[b];
  if (p.sides.empty() || q.sides.empty()) return Overlap::independent;
  if (splits_off(v, p, w, q) || splits_off(w, q, v, p)) return Overlap::independent;
  if (is_inside(w, q, v, p)) return Overlap::second_inside;
  return is_inside(v, p, w, q) ? Overlap::first_inside : Overlap::crossing;
}

int front_by_contours(const ConvexView& v, Index a, const ConvexView& w, Index b, Overlap overlap) {
  Verdict verdict;
  if (overlap == Overlap::crossing) hear_crossings(v, v.bodies[a], w, w.bodies[b], verdict);
  if (overlap == Overlap::first_inside) hear_corners(v, v.bodies[a], w, w.bodies[b], 1, verdict);
  if (overlap == Overlap::second_inside) hear_corners(w, w.bodies[b], v, v.bodies[a], -1, verdict);
  return verdict.sign();
}

int front_by_separation(const ConvexView& v, Index a, const ConvexView& w, Index b) {
  const std::optional<Separation> plane =
      separate(v.canonical, v.canonical.bodies[a], w.canonical, w.canonical.bodies[b]);
  if (!plane) return 0;
  const double side = glm::dot(plane->normal, Vec3(v.viewer)) - plane->offset * v.viewer.w;
  return (side > 0) - (side < 0);
}

int front_of(const ConvexView& v, Index a, const ConvexView& w, Index b, Overlap overlap) {
  const int front = front_by_contours(v, a, w, b, overlap);
  return front != 0 ? front : front_by_separation(v, a, w, b);
}

bool meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const auto apart = [](double p, double q, double r, double s) {
    return std::max(p, q) < std::min(r, s) || std::max(r, s) < std::min(p, q);
  };
  if (apart(a.x, b.x, c.x, d.x) || apart(a.y, b.y, c.y, d.y)) return false;
  return turn_of(a, b, c) * turn_of(a, b, d) <= 0 && turn_of(c, d, a) * turn_of(c, d, b) <= 0;
}

bool holds(const ConvexView& view, const ViewedFace& face, const Vec2& p) {
  for (Index s = face.first_side; s < face.end_side; ++s)
    if (f(view, s, p) < 0) return false;
  return true;
}

}  // namespace overstrike::nn74
