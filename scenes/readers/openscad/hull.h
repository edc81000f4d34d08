#pragma once
// Convex hulls, and sums of convex sets.
#include <optional>
#include <vector>

#include "core/scene/shapes.h"
#include "scenes/readers/openscad/part.h"

namespace overstrike::openscad {

/// The hull's triangles over those of the points that are its corners; nothing when all lie in one
/// plane. By Qhull (Barber, Dobkin, Huhdanpaa 1996).
std::optional<Polyhedron> hull(const std::vector<Vec3>& points);

/// Counter-clockwise, without points between corners; fewer than three points when all lie on one
/// line. Exact (Andrew 1979).
std::vector<Vec2> hull(std::vector<Vec2> points);

/// It is its hull, and nothing is hollow.
bool is_convex(const Part& part);
bool is_convex(const Region& region);

/// All sums of a point of one and a point of the other.
template <class Point>
std::vector<Point> sums(const std::vector<Point>& a, const std::vector<Point>& b) {
  std::vector<Point> all;
  all.reserve(a.size() * b.size());
  for (const Point& p : a)
    for (const Point& q : b) all.push_back(p + q);
  return all;
}

}  // namespace overstrike::openscad
