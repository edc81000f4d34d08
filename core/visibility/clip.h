#pragma once
// Near clipping: what the eye could not see because it stands inside.
#include "core/visibility/canonical.h"

namespace overstrike {

/// True when something lies on the negative side of the plane, so that clip() changes something.
/// What lies nearly in the plane is where its faces' planes are (clip_heights.h).
bool needs_clip(const Canonical& canonical, const Plane& keep);

/// What lies where dot(normal, p) >= offset. Bodies wholly there are copied, bodies wholly beyond
/// are dropped; the others have their faces, edges, patterns and corner normals cut. A cut through
/// a closed body is closed by one face with `cut` set, in the clip plane, outward to the side that
/// is gone; so the body stays closed. Vertices of the cut count as in the clip plane.
/// Smooth faces keep the tones that the eye sees.
Canonical clip(const Canonical& canonical, const Plane& keep, const Vec4& eye);

}  // namespace overstrike
