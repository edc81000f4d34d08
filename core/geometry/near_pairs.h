#pragma once
// Which of many segments may meet: by halving, without looking at all pairs.
#include <functional>
#include <span>
#include <vector>

#include "core/geometry/polyhedron.h"

namespace overstrike {

struct Segment2 {
  Vec2 from, to;
};

/// Called with numbers of two things. Pairs may come more than once.
using VisitPair = std::function<void(Index, Index)>;

/// Visits pairs i < j of segments, among them all that have a point in common other than an end of
/// both.
///
/// The things in hand are halved at a coordinate in x, in y, or along one of them, whichever
/// separates best; so crowds are taken apart wherever they are, long parallels along their
/// direction, and fans along one of their rays. Of n that lie apart n log n steps; all pairs of
/// those that cross one another.
void crossing_pairs(std::span<const Segment2> segments, const VisitPair& visit);

/// Visits pairs (segment, point), among them all in which the segment passes or touches the square
/// about the point, of half the side `reach`.
void near_pairs(std::span<const Segment2> segments, std::span<const Vec2> points, double reach,
                const VisitPair& visit);

}  // namespace overstrike
