#pragma once
// The ground's part of a picture.
#include <functional>
#include <optional>
#include <vector>

#include "core/visibility/canonical.h"
#include "core/visibility/depth.h"
#include "core/visibility/view.h"

namespace overstrike {

/// The planes that bound the ground in a picture, numbered after a canonical input's own.
enum GroundPlane : Index { kGroundItself, kAtInfinity, kNearPlane };
/// The ground, the plane at infinity (the horizon) and the near plane where there is one.
std::vector<Plane> ground_planes(const Canonical& canonical, const View& view);

/// The polygon of the grid over which the ground is seen if nothing hides it: below the horizon,
/// and no nearer than the near plane, both straight lines there. Reaches a cell beyond the grid.
/// Empty when there is no ground or the eye is not above it. `depth` gives the depths of
/// ground_planes(), nullopt for one that passes through the eye.
std::vector<Vec2> ground_polygon(
    const Canonical& canonical, const View& view,
    const std::function<std::optional<DepthPlane>(GroundPlane)>& depth);

}  // namespace overstrike
