#pragma once
// Shapes as they are said: parameters only (NN74's standard shapes). All stand in their own frame,
// Z up; those with a height stand on z = 0 with their axis through the origin, round ones and the
// torus are centred on it.
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "core/geometry/polyhedron.h"
#include "core/geometry/vec.h"

namespace overstrike {

/// Centred on the origin in x and y, standing on z = 0.
struct Box {
  Vec3 size{1.0};
};

/// `sides` of 0 is round: as many sides as the tolerance asks. A vertex lies at +x. Regular prisms
/// and frusta, pyramids and cones alike: radius at z = 0 and at z = height, circumscribed about the
/// corners; one may be 0. prism and cylinder: both equal; pyramid and cone: top 0.
struct Frustum {
  double bottom_radius = 1;
  double top_radius = 1;
  double height = 1;
  int sides = 0;
};

/// A box whose top face has shrunk to the length `top` along x (0: an edge along y), standing on z
/// = 0. `top_shift` moves the top along x from the middle. A roof is a wedge of top 0.
struct Wedge {
  Vec3 size{1.0};
  double top = 0;
  double top_shift = 0;
};

/// Any four vertices.
struct Tetrahedron {
  Vec3 vertices[4];
};

/// Semi-axes; a sphere has three equal ones. By parallels and meridians, with a vertex at each
/// pole: `sides` facets round the axis in each of `rings` bands from pole to pole. Both 0 is round,
/// as the tolerance asks. With either given it is a polyhedron of sides * (rings - 1) + 2 vertices
/// and sides
/// * rings faces; the missing one follows, sides = 2 rings. A meridian lies at +x.
struct Ellipsoid {
  Vec3 radii{1.0};
  int sides = 0;
  int rings = 0;
};

/// Around z: circle of `minor` swept along a circle of `major`; major >= minor > 0.
struct Torus {
  double major = 2;
  double minor = 1;
};

/// A plane region: outlines and holes, any orientation; simple, and with nothing in common but
/// vertices. (What set operations take may be otherwise: core/geometry/region_sets.h.)
struct Region {
  std::vector<std::vector<Vec2>> loops;
};

/// The region in x, y from z = 0 to z = height.
struct Extrusion {
  Region region;
  double height = 1;
};

/// The profile (x = radius >= 0, y = z) turned about z by `angle_deg` (0..360]; `sides` as in
/// Frustum. A closed profile polygon; less than a full turn is closed with two end faces.
struct Revolution {
  std::vector<Vec2> profile;
  double angle_deg = 360;
  int sides = 0;
  std::vector<std::vector<Vec2>> more_loops = {};  ///< of the profile: holes, further outlines
};

/// The profile, in the plane across the path with x to the right and y up, moved along the path;
/// mitred at its corners. An open path gets end faces; a closed one joins its end to its start.
struct Sweep {
  std::vector<Vec2> profile;
  std::vector<Vec3> path;
  bool closed_path = false;
};

/// Faces as given, by a user or a mesh file.
struct Mesh {
  Polyhedron polyhedron;
  std::string source;      ///< the file, for messages; empty for polyhedra written in a scene
  std::vector<int> lines;  ///< empty, or per face the line in the file
  /// How far a coordinate of the file may be from what its writer meant (half a unit of its last
  /// digit, or of a float's last place); 0 for numbers given in full. Welding of planes and
  /// vertices derives its bound from it.
  double precision = 0;
};

/// A flat polygon with holes in space: two-sided, open, casts and receives shadows.
struct FlatPolygon {
  std::vector<std::vector<Vec3>> loops;
};

using Shape = std::variant<Box, Frustum, Wedge, Tetrahedron, Ellipsoid, Torus, Extrusion,
                           Revolution, Sweep, Mesh, FlatPolygon>;
using ShapePtr = std::shared_ptr<const Shape>;

}  // namespace overstrike
