#pragma once
// Planes between convex bodies.
#include <optional>
#include <utility>
#include <vector>

#include "core/geometry/tessellate.h"
#include "core/visibility/canonical.h"

namespace overstrike::nn74 {

/// How far two bodies that touch may reach into each other, relative to their largest coordinate: a
/// placed vertex is off by at most 72 roundings of 2^-53 (canonical.cpp), along each of three axes;
/// vertices and planes of both bodies are, which makes 4 * sqrt(3) * 72 * 2^-53 < 2^-44.
constexpr double kTouch = 0x1p-44;

/// The first body lies where dot(normal, p) >= offset, the second where it is <= offset, but for
/// what touching allows. `normal` is of unit length.
struct Separation {
  Vec3 normal;
  double offset;
};

/// A plane between two convex bodies, of one canonical input or of what clipping left of it; none
/// when they interpenetrate. Candidates are the planes between their boxes, those of their faces
/// and those along an edge of each (the separating axis theorem); vertices that have a face in a
/// plane lie in it by identity, not by distance.
std::optional<Separation> separate(const Canonical& first, const CanonicalBody& a,
                                   const Canonical& second, const CanonicalBody& b);

/// True when the vertex is a corner of a face of the body that has this plane identity.
bool has_face_in(const Canonical& canonical, const CanonicalBody& body, Index plane, Index vertex);

Bounds bounds_of(const Canonical& canonical, const CanonicalBody& body);

}  // namespace overstrike::nn74
