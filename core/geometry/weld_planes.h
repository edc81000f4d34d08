#pragma once
// Which faces lie in one plane, though rounding has moved their vertices apart.
//
// A face speaks for a plane P when every one of its vertices lies as near to P as rounding
// explains. Faces are taken from the largest to the smallest; each joins the plane of a larger one
// that it speaks for, or founds its own. So there are no chains of planes that drift (a
// sphere's facets stay apart), and nothing depends on the order of the input.
//
//   1. order by area, ties by geometry
//   2. candidates: planes about as far from one reference point as the face's own plane
//   3. |n x n'| within what the vertices' errors allow, then every vertex against the plane
//   4. slivers, whose own plane says nothing, are tried against their neighbours' planes only
//
// What moved a body as a whole has not moved its faces against each other: within one body only its
// own errors count, or a small body far away would be pressed into one plane.
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "core/geometry/plane_fit.h"

namespace overstrike {

/// One or more faces that lie in one plane by construction.
struct PlaneSample {
  PlaneFit fit;  ///< of the largest of the faces
  Index first_point = 0, end_point = 0;
  Index body = 0;
};

/// How far a body's vertex may be from where it was meant: in the world, and against the rest of
/// its body.
struct VertexError {
  double in_world = 0, in_body = 0;
};

struct WeldedPlanes {
  std::vector<Index> group;           ///< per sample
  std::vector<Index> representative;  ///< per group: the sample whose plane it is
};

/// Pairs of samples that share an edge; asked for only where there are slivers.
using NeighbourPairs = std::function<std::vector<std::pair<Index, Index>>()>;

/// Groups samples of one plane, whichever way they face. `errors` are the bodies', `points` holds
/// the vertices of all samples, one after the other, or where `corners` says so their numbers in
/// it. O(n log n) but for samples whose planes pass the reference point at one distance within
/// rounding.
WeldedPlanes weld_planes(std::span<const PlaneSample> samples, std::span<const VertexError> errors,
                         std::span<const Vec3> points, const NeighbourPairs& neighbours,
                         std::span<const Index> corners = {});

}  // namespace overstrike
