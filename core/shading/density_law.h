#pragma once
// NN74 (14)(15): how dark a lit surface is. shade_of(), for flat faces, is declared in canonical.h.
#include "core/visibility/canonical.h"

namespace overstrike {

/// H = Hmax (1 - k cos a) times the body's factor, clamped to 0..1, for a unit normal that points
/// to the side it is seen from; cos a below 0 counts as 0 (shade, Hmax). Without a light every
/// surface is as light as one that faces it: Hmax (1 - k).
double lit_density(const Canonical& canonical, const CanonicalBody& body, const Vec3& normal);

/// Density of `body` where no light falls: Hmax times its factor, clamped to 0..1.
double shade_density(const Canonical& canonical, const CanonicalBody& body);

}  // namespace overstrike
