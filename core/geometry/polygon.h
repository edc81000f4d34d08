#pragma once
// Plane polygons: exact side tests, faults of loops, and regions in order.
//
// A loop is a closed polygon without its first point again at its end. The side tests are exact for
// coordinates of magnitude 0 or 1e-100 to 1e100 (products neither overflow nor lose their errors).
#include <optional>
#include <vector>

#include "core/geometry/polyhedron.h"

namespace overstrike {

using Loop2 = std::vector<Vec2>;

/// 1 when a, b, c turn counter-clockwise, -1 clockwise, 0 when they lie on one straight line:
/// exactly, by an error bound and, where that fails, by expansions (Shewchuk 1997).
int turn_of(const Vec2& a, const Vec2& b, const Vec2& c);

/// The loop without points equal to the one before.
Loop2 without_repeats(const Loop2& loop);

/// Exact for simple loops.
bool is_counter_clockwise(const Loop2& loop);

/// By even and odd crossings; exact. Points on the loop may be either.
bool contains(const Loop2& loop, const Vec2& point);

/// Where two edges of the loops (of one or of two) meet that should not: any contact other than
/// that of neighbours in their common point, and neighbours that fold back on each other. `first`
/// <= `second` are the loops' numbers.
struct Contact {
  std::size_t first, second;
  Vec2 near;
};
std::optional<Contact> find_contact(const std::vector<Loop2>& loops);

/// One connected piece of a region: numbers of its outline and of its holes.
struct Piece {
  std::size_t outline;
  std::vector<std::size_t> holes;
};

/// Outlines counter-clockwise and holes clockwise, pieces in the order of their outlines. What lies
/// within an odd number of loops is inside. Precondition: no contacts but common vertices of loops.
struct OrderedRegion {
  std::vector<Loop2> loops;
  std::vector<Piece> pieces;
};
OrderedRegion in_order(const std::vector<Loop2>& loops);

/// Per loop and edge (from each point to the next) a number for the straight line it lies on: equal
/// for neighbours on one line and for any edges of equal x or of equal y. Numbers count from 0.
std::vector<std::vector<Index>> line_numbers(const std::vector<Loop2>& loops);

/// Twice the area times the unit normal of a loop in space (Newell), counter-clockwise seen from
/// the normal's side.
Vec3 vector_area(const std::vector<Vec3>& loop);

}  // namespace overstrike
