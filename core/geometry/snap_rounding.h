#pragma once
// Segments divided where they meet, so that rounding the crossings creates no new ones: snap
// rounding (J. D. Hobby, Practical segment intersection with finite precision output, 1999).
//
// A lattice of squares is laid over the plane. Those that hold an end or a crossing are *hot*; each
// is a *site*. A segment is led through the middles of the hot squares that it passes, in order.
//
// Laws: paths have no point in common but sites. Each lies within half a side of its segment, in x
// and in y. They depend on the segments alone, not on their order or direction. Crossings and what
// passes a square are decided exactly, for coordinates of magnitude 0 or 1e-70 to 1e70.
#include <span>
#include <vector>

#include "core/geometry/near_pairs.h"

namespace overstrike {

struct SnapRounded {
  /// Of a square: a power of two, four last places of the largest coordinate, so that borders and
  /// middles are doubles. Squares hold their lower borders.
  double side = 0;
  /// Per site, in order of x, then y: the middle of its square.
  std::vector<Vec2> middles;
  /// Per site the point that its square was heated by: an end, to the bit, where it holds one, the
  /// first in order of x, y; else the first crossing, within a few last places, and with the very x
  /// or y of a segment that has one.
  std::vector<Vec2> points;
  /// Of segment s: sites path_ends[s - 1] .. path_ends[s]; one site when it lies in one square.
  std::vector<Index> path_sites;
  std::vector<std::size_t> path_ends;

  std::span<const Index> path(std::size_t segment) const {
    const std::size_t first = segment == 0 ? 0 : path_ends[segment - 1];
    return {path_sites.data() + first, path_sites.data() + path_ends[segment]};
  }
};

SnapRounded snap_round(std::span<const Segment2> segments);

/// A segment passes the square about `middle` that holds its lower borders.
bool passes(const Segment2& segment, const Vec2& middle, double side);

}  // namespace overstrike
