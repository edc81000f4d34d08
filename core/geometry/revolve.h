#pragma once
// One way to make every round shape: a profile turned about z.
#include <optional>
#include <vector>

#include "core/geometry/polyhedron.h"

namespace overstrike {

/// A piece of a profile in the half plane x = radius >= 0, y = z, the solid on its left. With
/// normals (unit or not, pointing out of the solid) the faces carry them, turned with the profile.
struct ProfileEdge {
  Index from, to;  ///< in ProfileChain::points
  Vec2 normal_from{0}, normal_to{0};
  /// Edges of one line lie on one straight line by construction; their facets share planes.
  Index line = 0;
  /// Level and plane: becomes one face (a disc or a ring) and not a fan of facets.
  bool flat = false;
};

/// One or more loops, or open with both ends on the axis. Points with x == 0 become single
/// vertices; edges on the axis are left out.
struct ProfileChain {
  std::vector<Vec2> points;
  std::vector<ProfileEdge> edges;
  /// What closes less than a full turn: faces of loops of points, outlines counter-clockwise and
  /// first. None: one of all points.
  std::vector<std::vector<std::vector<Index>>> ends;
};

/// `facets` over `angle_deg` (0..360]; less than a full turn gets end faces, and the chain must be
/// closed then. `normals` asks for corner normals.
Polyhedron revolve(const ProfileChain& chain, int facets, double angle_deg, bool normals);

}  // namespace overstrike
