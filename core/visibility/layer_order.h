#pragma once
// How the faces of a solid's operands lie along lines of sight: the eye's (face_order.h), or the
// light's over a receiver (cast_order.h).
#include "core/visibility/depth.h"

namespace overstrike {

/// Grid units: no device and no test tells a smaller displacement of an end.
constexpr double kCrossingError = 1e-9;

class LayerOrder {
 public:
  /// Not a face: the layer at which the search along a line of sight ends, where there is one. It
  /// has a depth like a face.
  static constexpr Index kEnd = 0xFFFFFFFEu;

  /// Larger is nearer. Good until the next call.
  virtual const DepthPlane& depth_of(Index face) const = 0;
  /// Sign of depth(f) - depth(g) at the point of the grid, exact: 1 when f is nearer.
  virtual int compare(Index f, Index g, double x, double y) const = 0;
  /// Where on the level the two have one depth; NaN or infinite when they are parallel along it.
  virtual double crossing(Index f, Index g, double y) const = 0;
  /// 1 when lines of sight enter the operand through the face, -1 when they leave it.
  virtual int enters(Index face) const = 0;
  /// True for a face that lies in the layer kEnd, all along. Of two such compare() says which lies
  /// nearer beside it.
  virtual bool at_end(Index) const { return false; }

 protected:
  ~LayerOrder() = default;
};

}  // namespace overstrike
