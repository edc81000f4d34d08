#pragma once
// How faces lie to one another over a receiver, along the light, as the eye sees the receiver's
// points: which of two is met first by light that would come to the point.
//
// A point of the grid at (x, y) stands for Q, where the eye sees the receiver's plane there. With a
// plane in the grid's homogeneous coordinates, pi' = pi adj(M) (depth.h), r' the receiver's and g'
// the face's, Q is (r'_z x, r'_z y, r'_z, -r' . (x, y, 1)) up to a factor, and the face's height
// over it along the light L
//   t = -s (c . (x, y, 1)) / (n . L),  c = r'_z g' - g'_z r',  s the sign of det M r'_z,
// up to a positive factor, which is the same for all faces: linear over the grid, as depth is, so
// that it is compared and crossed as depths are.
#include <vector>

#include "core/visibility/layer_order.h"

namespace overstrike {

/// Safe to share between threads.
class CastOrder final : public LayerOrder {
 public:
  /// `faces` (of `casting`, ascending) face the light from in front or from behind. All must
  /// outlive this.
  CastOrder(const DepthMap& eye, const Canonical& casting, const Plane& receiver,
            std::vector<Index> faces);

  const DepthPlane& depth_of(Index face) const override { return depths_[number_of(face)]; }
  int compare(Index f, Index g, double x, double y) const override;
  double crossing(Index f, Index g, double y) const override;
  int enters(Index face) const override;
  /// The height of a plane that faces the light.
  DepthPlane height_of(const Plane& plane) const;

 private:
  std::size_t number_of(Index face) const;
  const Plane& plane_of(Index face) const { return casting_.planes[casting_.faces[face].plane]; }
  ExactPlane exact_height_of(const Plane& plane) const;

  const DepthMap& eye_;
  const Canonical& casting_;
  const Plane receiver_;
  DepthMap::RoundedPlane receiver_in_grid_;
  int sign_;
  std::vector<Index> faces_;
  std::vector<DepthPlane> depths_;  ///< heights over the receiver
};

}  // namespace overstrike
