#pragma once
// The Boolean solids that benchmarks and their tests measure, defined to the last digit.
#include "core/scene/scene.h"

namespace overstrike::bench {

/// TK 4.8 to 4.11: scene B, its central prism taken from `cut` of the eight others. With none it
/// belongs to the union. With a half height of 1 the nine prisms' caps lie in two planes, and what
/// is left of the eight is an open ring: scene H1; with 1.2 scene H0.
Scene nine_prisms(int sides, int cut, double half_height = 1.2);

/// How a scene is turned and moved, its camera with it: by 0.7 rad about (1, 2, 3), and by `far`
/// along each axis. `placed`: bodies are; `baked`: their vertices, as a file of another program has
/// them.
enum class Turned { no, placed, baked };
Scene moved(Scene scene, Turned turned, double far);

/// A plate of 50 x 50 x 20, from which n differences of a slab and a block are taken. Written as
/// sums of products they are (n + 1) 2^n terms. Seen along (-1, 1, -1), or from below.
Scene nested_differences(int n, bool below);

/// A block less n slots, one after the other: ((block - slot) - slot) - ... is n deep on the left.
Scene left_deep(int n);
/// Boxes in boxes with their tops in one plane: box - (box - (box - ...)) is n deep on the right,
/// and shows rings.
Scene right_deep(int n);

/// Holes of 16 sides through a plate, a lattice of them.
Scene holes(int n);

/// A balanced tree of `leaves` operands, a lattice of cups united two by two: each a box less a
/// smaller one that is flush with its top.
Scene cups(int leaves);

}  // namespace overstrike::bench
