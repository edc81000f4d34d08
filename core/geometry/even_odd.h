#pragma once
// What lies inside outlines that may cross themselves, by even and odd.
#include <array>
#include <vector>

#include "core/geometry/vec.h"

namespace overstrike {

/// Counter-clockwise where y points up, from the upper left.
using Trapezoid = std::array<Vec2, 4>;

struct EvenOdd {
  /// Each point lies within the outlines once or not at all, all the same way round: winding
  /// numbers say what even and odd do.
  bool simple = true;
  std::vector<Trapezoid> parts;  ///< of the inside
};

/// Cuts the outlines at the heights of their corners and crossings. Crossings are rounded; of
/// degree n squared.
EvenOdd even_odd(const std::vector<std::vector<Vec2>>& loops);

}  // namespace overstrike
