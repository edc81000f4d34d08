#pragma once
// Phase I: the light is the first view (NN74). What it sees leaves shadow boundaries as lines on
// the receivers' planes.
//
// A point Q of a face that the light faces is in shadow when another face that faces the light lies
// over it, seen from the light, on the light's side of its plane. Each such face, cut to the
// light's side of the receiver's plane, leaves a closed polygon there; where several overlap they
// are counted, and any count but zero is shadow. Borders that two casters share cancel, so that a
// body leaves its contour as seen from the light and nothing else. A face never shadows its own
// plane: vertices of the receiver's plane identity are on it by topology, not by distance.
#include <vector>

#include "core/visibility/canonical.h"
#include "core/visibility/view.h"

namespace overstrike {

/// A piece of a shadow's boundary on its receiver; crossing it changes the count by `winding` (from
/// right to left of a -> b as the light sees it).
struct ShadowEdge {
  Vec3 a, b;
  int winding;
};

/// What the light leaves on one receiver. Without edges, `covered` says whether all of it is in
/// shadow.
struct Shadow {
  Index receiver;  ///< a face of `seen`, or seen.faces.size() for the ground
  bool covered = false;
  std::vector<ShadowEdge> edges;
};

/// `whole` casts; `seen` (the same, or what near clipping left of it) receives. Receivers are the
/// faces that both the light and the eye see from the same side, and the ground. Sorted by
/// receiver; receivers without shadow are left out.
std::vector<Shadow> cast_shadows(const Canonical& whole, const Canonical& seen, const View& view);

}  // namespace overstrike
