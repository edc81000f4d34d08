#pragma once
// Which scenes NN74's method draws: flat-shaded convex bodies and convex flat polygons that neither
// interpenetrate nor pass through the ground.
#include "core/scene/scene.h"
#include "core/visibility/canonical.h"
#include "core/visibility/view.h"

namespace overstrike::nn74 {

/// Throws InputError that names every body that is not convex or not flat-shaded, or that passes
/// through a ground that the eye sees; when there is none, the first two bodies that
/// interpenetrate.
void check_conditions(const Scene& scene, const Canonical& canonical, const View& view);

}  // namespace overstrike::nn74
