#pragma once
// From pieces of a region's border to its loops.
#include <span>
#include <vector>

#include "core/geometry/snap_rounding.h"
#include "core/scene/shapes.h"

namespace overstrike {

/// A piece of border from site to site, the region on its left.
struct Border {
  Index from, to;
  std::span<const Index> sources;  ///< the segments that it is a part of, in order
};

/// The region that the borders enclose, as region_sets.h promises it. Precondition: they leave each
/// site as often as they reach it.
Region outlines_of(const std::vector<Border>& borders, const SnapRounded& arrangement);

}  // namespace overstrike
