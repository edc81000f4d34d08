#pragma once
// Triangles for a face that is not planar.
#include <array>
#include <span>
#include <vector>

#include "core/geometry/polyhedron.h"

namespace overstrike {

/// Triangles over the corners of one loop (numbers into `loop`), counter-clockwise as the loop is
/// about `normal`: ears are cut at the shortest diagonal first, so that a quadrilateral gets its
/// shorter one. The result does not depend on where the loop starts. O(n^2).
std::vector<std::array<Index, 3>> triangles_of(std::span<const Vec3> loop, const Vec3& normal);

/// One loop of an outline and its holes, joined by the shortest bridges that cross nothing. Corners
/// are named by their place in the loops put one after another. O(n^3) in the worst case.
std::vector<Index> bridged(std::span<const std::vector<Vec3>> loops, const Vec3& normal);

/// True when the loop, seen along `normal`, turns left at every corner and goes round once; false
/// also where rounding could hide that.
bool is_convex(std::span<const Vec3> loop, const Vec3& normal);

/// True when two sides of the loops, seen along `normal`, cross. Sides that touch do not count.
bool crosses_itself(std::span<const std::vector<Vec3>> loops, const Vec3& normal);

}  // namespace overstrike
