#pragma once
// A polyhedron cut by a plane, closed again by a cap.
#include <vector>

#include "core/geometry/polyhedron.h"

namespace overstrike {

/// What a face of a cap is a part of; and one whose loops run clockwise, seen from the removed
/// side.
constexpr Index kCap = 0xFFFFFFFFu, kTurnedCap = 0xFFFFFFFEu;
constexpr bool is_cap(Index face_source) { return face_source >= kTurnedCap; }

struct CutPolyhedron {
  Polyhedron polyhedron;
  std::vector<Index> face_source;  ///< per face: the face it is a part of, or is_cap()
  /// Per vertex: the ends of the edge it was cut from, low < high; both the old vertex when it was
  /// one, both kCap where outlines of the cap cross.
  struct Origin {
    Index low, high;
  };
  std::vector<Origin> origin;
};

/// What stands where dot(normal, p) >= offset; `normal` is of unit length. Faces may be non-convex
/// with holes; the loops that come out enclose the right points by the even-odd rule. A cut edge
/// gets one new vertex, computed from its lower to its higher end, for both its faces, and exact to
/// a few roundings of its own, however far the edge reaches; its normal lies between theirs on a
/// straight line, not of unit length, so that what is linear in normals stays linear. With `cap`,
/// the cut is closed where its winding number is not 0 (cap.h): by one face whose outward side is
/// -normal and that holds all loops of the cut; by several, one on the other, where a polyhedron
/// lies within itself more than once; and faces in the plane that have the solid on the removed
/// side are gone.
CutPolyhedron cut_polyhedron(const Polyhedron& polyhedron, const Vec3& normal, double offset,
                             bool cap);
/// With heights of the vertices over the plane that are known better than from the vertices.
CutPolyhedron cut_polyhedron(const Polyhedron& polyhedron, const std::vector<double>& heights,
                             const Vec3& normal, double offset, bool cap);

}  // namespace overstrike
