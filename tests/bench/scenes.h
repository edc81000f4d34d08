#pragma once
// The scenes that benchmarks measure, defined to the last digit, and what every method starts from.
#include <memory>

#include "core/scene/scene.h"
#include "core/visibility/canonical.h"
#include "core/visibility/view.h"

namespace overstrike::bench {

/// Scene C: 80 icospheres of radius 0.2, 20 * 4^level triangles each (level 0: 1600 in all, level
/// 3: 102 400), centres by Random(777) in [-1, 1)^3; many pass through one another. Seen along -z
/// in a parallel view of [-1.25, 1.25]^2.
Scene scene_c(int level);
/// The same lit from (1, 1, 1), above a ground at z = -1.25.
Scene lit_scene_c(int level);

/// Scene B: the union of nine right prisms with k sides, eight in a ring about a ninth, each
/// passing through its neighbours. Prism i < 8: centre (cos(pi i / 4), sin(pi i / 4)), radius 0.45,
/// z in [-h, h], h 1.2 unless told otherwise, turned by 0.1 i; prism 8: centre 0, radius 1, z in
/// [-1, 1]. Seen along (-0.6, 1, -0.8) in a parallel view of [-2.2, 2.2]^2.
Scene scene_b(int sides, double half_height = 1.2);

enum class Boxes { apart, anywhere };
/// 100 000 copies of one cube of side 0.02, that is about 3 of 512 columns, by Random(4242) in
/// [-1, 1)^3: `apart`, one each in the first cells of a lattice of 47^3, anywhere in its cell, so
/// that none passes through another; `anywhere`: more than half pass through some. Seen from the
/// default direction in a parallel view 3.6 wide. Under a point lie about ten boxes.
Scene many_boxes(Boxes);

/// The unit sphere as 20 * 4^level triangles: the icosahedron (0, +-1, +-phi), halved.
ShapePtr icosphere(int level);

/// A scene on a square grid, canonical.
struct Prepared {
  std::shared_ptr<const Canonical> canonical;
  View view;
  double canonicalize_ms;  ///< of CPU time
};
Prepared prepare(const Scene&, const Grid&);
Grid square_grid(int size);

}  // namespace overstrike::bench
