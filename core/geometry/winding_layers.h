#pragma once
// How often closed outlines go round the points of a plane, as regions with borders of their own.
//
// The winding number w of outlines that may cross, touch or lie on one another is a sum of layers:
// one for each k > 0, where w >= k, and one for each k < 0, where w <= k. Each layer is a plain
// region, by even and odd, and every piece of the outlines borders as many layers as w changes by
// across it: a surface that ends in the outlines is closed by its layers. w is not 0 just where a
// layer is.
//
// Laws: no two pieces have a point in common but ends. Sides, orders and crossings are decided
// exactly (turn_of) on doubles; a crossing is rounded and then a point like others, so that
// outlines bend there by the last place of a coordinate.
#include <vector>

#include "core/geometry/polyhedron.h"

namespace overstrike {

struct DirectedEdge {
  Index from, to;
};

/// The coordinates to look at, so that counter-clockwise is what is so seen from `outward`: those
/// across its largest component.
struct FlatAxes {
  int x, y;
  explicit FlatAxes(const Vec3& outward);
  Vec2 operator()(const Vec3& p) const { return {p[x], p[y]}; }
};

struct WindingLayers {
  std::vector<Vec3> points;  ///< the given ones, then crossings
  /// Per given edge: the points that it passes, with its ends. Of points in one place the first
  /// stands for all.
  std::vector<std::vector<Index>> paths;
  struct Layer {
    int winding;                            ///< k
    std::vector<std::vector<Index>> loops;  ///< counter-clockwise round the layer when k > 0
  };
  std::vector<Layer> layers;  ///< k = 1, 2, ..., then -1, -2, ...
};

/// Edges that leave each point as often as they reach it.
WindingLayers winding_layers(const std::vector<Vec3>& points,
                             const std::vector<DirectedEdge>& edges, const FlatAxes& axes);

}  // namespace overstrike
