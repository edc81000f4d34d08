#pragma once
// Visible edges for plotters: the line resolver along each edge's own projection.
#include <vector>

#include "core/drawing.h"
#include "core/visibility/canonical.h"
#include "core/visibility/shadows.h"
#include "core/visibility/view.h"

namespace overstrike {

/// The visible parts of contours, creases, intersections of interpenetrating bodies, shadow
/// outlines, outlines of cuts, patterns and segments, clipped to the grid, chained into polylines
/// and simplified within `tolerance` (grid units). `casting` is what cast the shadows.
std::vector<Stroke> visible_strokes(const Canonical& casting, const Canonical& seen,
                                    const View& view, const std::vector<Shadow>& shadows,
                                    const StrokeOptions& options, double tolerance);

}  // namespace overstrike
