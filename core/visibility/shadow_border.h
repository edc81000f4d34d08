#pragma once
// Borders of shadows across the light: polygons of parts of sides.
//
// A part remembers the whole side. However two faces that share a side are cut, what they have of
// it are parts of one line, with the same points at the same parts of the way: what is common to
// both cancels, and no gap is left between them.
#include <algorithm>
#include <vector>

#include "core/geometry/vec.h"
#include "core/visibility/canonical.h"

namespace overstrike {

/// From a + t0 (b - a) to a + t1 (b - a); a comes before b (by x, then y), t0 and t1 lie in 0..1.
struct SidePart {
  Vec2 a, b;
  double t0, t1;
  /// Where a caster was cut: its plane, which passes through the receiver's here. Else kNone.
  Index plane = kNone;

  Vec2 at(double t) const { return t == 0 ? a : t == 1 ? b : a + (b - a) * t; }
  Vec2 from() const { return at(t0); }
  Vec2 to() const { return at(t1); }
};

/// All of the side from p to q.
SidePart whole_side(const Vec2& p, const Vec2& q);

/// Closed: each part ends where the next one begins.
using ShadowPolygon = std::vector<SidePart>;

/// With the corners of a closed polygon.
void assign(ShadowPolygon& polygon, const std::vector<Vec2>& corners);

/// Keeps what of a closed polygon lies where a linear function is not negative: `heights` are its
/// values where the parts begin. `crossing(i)` is where it vanishes on the side of part i, from a
/// to b; it is asked where part i has a positive and a negative end. `plane` is that of the parts
/// along the cut.
template <class Crossing>
void cut(const ShadowPolygon& polygon, const std::vector<double>& heights, const Crossing& crossing,
         Index plane, ShadowPolygon& result);

/// A border that adds `winding` to the count, from right to left of a -> b; t0 < t1.
struct ShadowBorder {
  SidePart part;
  int winding;
};

/// Borders between two casters are there twice, once in each direction: they cancel.
void cancel(std::vector<ShadowBorder>& borders);

/// The count of borders round a point.
int winding_at(const Vec2& p, const std::vector<ShadowBorder>& borders);

/// Closes what has been cut open: goes on from the last part's end to the point, along a plane.
void go_on_to(const Vec2& point, Index plane, ShadowPolygon& polygon);

template <class Crossing>
void cut(const ShadowPolygon& polygon, const std::vector<double>& heights, const Crossing& crossing,
         Index plane, ShadowPolygon& result) {
  result.clear();
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double from = heights[i], to = heights[i + 1 == n ? 0 : i + 1];
    if (from <= 0 && to <= 0 && (from < 0 || to < 0)) continue;
    SidePart part = polygon[i];
    if (from < 0 || to < 0) {
      // Rounding may take it out of the part, or leave it without a number: then it is the first.
      const auto [low, high] = std::minmax(part.t0, part.t1);
      const double t = std::min(std::max(low, crossing(i)), high);
      (from > 0 ? part.t1 : part.t0) = t;
    }
    if (from <= 0 && !result.empty()) go_on_to(part.from(), plane, result);
    result.push_back(part);
  }
  if (!result.empty()) go_on_to(result.front().from(), plane, result);
}

}  // namespace overstrike
