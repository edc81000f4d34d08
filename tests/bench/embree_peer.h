#pragma once
// The ray caster to compare with: Intel's Embree, rays at pixel centres in packets of 4 x 4.
#include <memory>
#include <vector>

#include "tests/bench/triangles.h"

namespace overstrike::bench {

/// Parallel views only; one thread.
class EmbreePeer {
 public:
  /// Both must outlive this. All columns and rows of view.grid are pixels. With `shifts`, the scene
  /// is as many instances of the triangles, each moved by its shift; triangle t of instance i has
  /// the number i * triangles + t.
  EmbreePeer(const Triangles& triangles, const View& view, std::vector<Vec3> shifts = {});
  ~EmbreePeer();

  /// Copies the triangles, as floats, and builds the tree over them anew.
  void build();
  /// A picture of 8-bit shades. Precondition: built.
  void trace();
  /// The triangle at every pixel of a row (kNothing: none). Precondition: built.
  std::vector<std::uint32_t> row(int row) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace overstrike::bench
