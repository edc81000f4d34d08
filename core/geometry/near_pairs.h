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

/// Calls `visit` for pairs (i of `a`, j of `b`), among them every pair of which the squares of
/// `reach` about some point of each overlap or touch. Pairs may come more than once.
///
/// The things in hand are halved at the median across x, across y, or across one of them, whichever
/// separates best; so crowds are taken apart wherever they are, and long parallels across their
/// direction. Of n that lie apart n log n steps; of those through one point all pairs.
void near_pairs(std::span<const Segment2> a, std::span<const Segment2> b, double reach,
                const std::function<void(Index, Index)>& visit);

/// The same among the segments themselves, i < j.
void near_pairs(std::span<const Segment2> segments, const std::function<void(Index, Index)>& visit);

}  // namespace overstrike
