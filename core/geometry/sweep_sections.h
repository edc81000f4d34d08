#pragma once
// Where a swept profile stands at each point of its path.
#include "core/geometry/polygon.h"
#include "core/scene/shapes.h"

namespace overstrike {

/// The profile is carried by minimal rotation: at a corner its frame turns about the corner's own
/// axis only. At the start x points right and y up along the path's horizon (world z; for a path
/// that starts upright, world y). A section at a corner lies in the plane that halves it, so that
/// the faces between two sections are plane.
///
/// On a closed path in space the frame may come back turned. That turn is spread along the path in
/// proportion to length; `twisted` says so, and the faces between sections are not plane then.
struct SweepSections {
  Loop2 profile;                            ///< counter-clockwise, looking along the path
  std::vector<Vec3> directions;             ///< of the segments, unit
  std::vector<std::vector<Vec3>> sections;  ///< per path point, a point per profile point
  bool twisted = false;
};
SweepSections sections_of(const Sweep& sweep);

/// Unit directions of the path's segments; a closed path's last one leads back to its start.
std::vector<Vec3> path_directions(const Sweep& sweep);

/// Segments that meet at this or a larger angle's cosine, less than 2e-6 rad short of a full turn
/// back, have no halving plane worth the name: one rounding of a direction moves it by 1e-10 rad.
constexpr double kTurnsBack = -1 + 0x1p-39;

}  // namespace overstrike
