#pragma once
// Two contours (NN74's appendix): which overlap, and which body is in front.
#include <optional>
#include <utility>
#include <vector>

#include "core/visibility/nn74/convex_view.h"

namespace overstrike::nn74 {

/// Pairs i < j of boxes that overlap by more than a touch, in increasing order. A sweep over x.
std::vector<std::pair<Index, Index>> overlapping_boxes(const std::vector<Extent>& boxes);

enum class Overlap { independent, crossing, second_inside, first_inside };

/// By the two sign matrices f(i, j), exactly: independent when a contour edge of one has all
/// corners of the other outside, inside when all corners of one lie inside all edges of the other.
Overlap overlap_of(const ConvexView& first, Index a, const ConvexView& second, Index b);

/// 1 when body a of `first` is nearer to the viewer than body b of `second` where their contours
/// overlap, -1 when it is farther, 0 when they touch so that neither hides the other. Both views
/// are of one viewer. Precondition: they overlap and do not interpenetrate.
int front_of(const ConvexView& first, Index a, const ConvexView& second, Index b, Overlap overlap);

/// front_of() where the contours themselves tell more than rounding: 0 when they do not.
int front_by_contours(const ConvexView& first, Index a, const ConvexView& second, Index b,
                      Overlap overlap);
/// front_of() by the side of a plane between the bodies that the viewer is on.
int front_by_separation(const ConvexView& first, Index a, const ConvexView& second, Index b);

/// Closed segments that have a common point; exact.
bool meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);
/// Inside the front face or on its border; exact.
bool holds(const ConvexView& view, const ViewedFace& face, const Vec2& p);

}  // namespace overstrike::nn74
