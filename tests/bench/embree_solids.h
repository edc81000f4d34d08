#pragma once
// The ray caster to compare Boolean solids with: Intel's Embree, one ray at a time at pixel
// centres, all hits of each (a filter refuses every hit, having noted it), sorted, an in-or-out bit
// per operand along them, and a table of what every set of bits means.
#include <memory>
#include <vector>

#include "tests/bench/scenes.h"

namespace overstrike::bench {

/// Parallel views of one solid; one thread. Vertices are floats in the world, not counted from the
/// view's origin: a ray caster is handed no other.
class EmbreeSolids {
 public:
  /// Must not outlive the scene. Precondition: the first solid has at most kMostOperands.
  explicit EmbreeSolids(const Prepared&);
  ~EmbreeSolids();
  static constexpr Index kMostOperands = 16;

  /// Copies the triangles and builds the tree over them anew, robust and of high quality.
  void build();
  /// A picture of faces. Precondition: built.
  void trace();
  /// The face at every pixel of a row, kNone where there is none. Precondition: traced.
  std::vector<Index> row(int row) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace overstrike::bench
