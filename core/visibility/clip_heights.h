#pragma once
// How high vertices count over a clip plane.
//
// A face is where its stored plane is, and vertices are off their planes by rounding. Where a face
// lies nearly in the clip plane that decides about all of it: a body that ends there by its planes
// must not end before it by its vertices.
#include <vector>

#include "core/visibility/canonical.h"

namespace overstrike {

/// Sets the heights of the body's vertices over the plane, along its normal. Of a vertex that is no
/// farther from it than the planes' rounding it is the height of the stored plane of its flattest
/// face, of the exact sign.
void clip_heights(const Canonical& canonical, const CanonicalBody& body, const Plane& keep,
                  std::vector<double>& heights);

/// A vertex whose coordinates' sizes add up to at most `reach` has the sign of its own coordinates
/// where it is farther than this from the plane.
double clip_rounding(const Plane& keep, double reach);

}  // namespace overstrike
