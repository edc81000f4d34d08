#pragma once
// Set operations on plane regions (TK chapter 2, on whole regions instead of along a line).
//
// The borders of all operands are divided where they meet, once (snap_rounding.h). A sweep finds
// what lies just below each piece; the expression is evaluated on both sides of it, and never
// expanded. Pieces with the set on one side only are the set's border.
//
// Laws of the result:
// - Loops are simple. Two of them have nothing in common but vertices of both. Outlines are
//   counter-clockwise, holes clockwise. No part of it is without width: what has none is left out
//   (regularised sets). Each loop begins with its first point in order of x, then y, and loops are
//   in the order of their points.
// - No vertex lies on the straight line between its neighbours unless two loops meet in it. So what
//   is found is a property of the set, as far as no crossing had to be rounded: it depends neither
//   on the order of operands nor on how the expression is written or where loops begin.
// - A vertex of an operand stays to the bit. A crossing is within a few last places of where it is,
//   and rounding creates no new ones: what comes within three squares of something else (of four
//   last places of the largest coordinate each) is set on the lattice of their middles.
// Sides and crossings are decided exactly. n log n steps in edges and crossings, but for long edges
// across crowds of others (near_pairs.h).
#include <span>

#include "core/scene/set_operation.h"
#include "core/scene/shapes.h"

namespace overstrike {

/// `operation` of all operands: union, intersection, or the first without all others. Loops of an
/// operand may touch, lie on one another and cross: what lies within an odd number is inside. Of no
/// operands the result is empty.
Region combine(SetOperation operation, std::span<const Region> operands);

/// A tree of operations. The `body` of a leaf is the number of its operand.
Region resolve(std::span<const SolidNode> nodes, std::span<const Region> operands);

}  // namespace overstrike
