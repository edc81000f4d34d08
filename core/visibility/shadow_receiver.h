#pragma once
// What shadows fall on: a face that the eye and the light see from the same side, or the ground.
#include <cmath>
#include <optional>
#include <vector>

#include "core/visibility/caster_index.h"
#include "core/visibility/light_frame.h"
#include "core/visibility/view.h"

namespace overstrike {

/// The plane of a receiver as the light sees it. A receiver is what the eye sees of it: where its
/// vertices are off its plane, its corners are where the eye sees them on it.
struct ShadowReceiver {
  Index face;      ///< of the canonical input; its number of faces for the ground
  Index body;      ///< kNone for the ground
  Index plane_id;  ///< kNone for the ground
  Plane plane;
  bool off_plane;      ///< its vertices lie farther off it than rounding alone takes them
  double along_light;  ///< dot(plane.normal, L), not 0; its sign is the lit side's
  LightRegion region;  ///< across the light
  double low_z = -HUGE_VAL, high_z = -HUGE_VAL;  ///< bounds of its heights towards the light
};

/// nullopt when the face receives no shadow: the eye and the light do not see it from the same
/// side, or it is a cut.
std::optional<ShadowReceiver> face_receiver(const Canonical& seen, const View& view,
                                            const LightFrame& frame, Index face);
std::optional<ShadowReceiver> ground_receiver(const Canonical& seen, const View& view,
                                              const LightFrame& frame);

/// The outline of a face across the light, counter-clockwise; nothing where it is not strictly
/// convex.
void convex_outline_of(const ShadowReceiver& r, const Canonical& seen, const View& view,
                       const LightFrame& frame, std::vector<Vec2>& outline);

/// The receiver's point under one across the light.
Vec3 lifted(const ShadowReceiver& r, const LightFrame& frame, const Vec2& p);

}  // namespace overstrike
