#pragma once
// How far stored planes are off the vertices that they stand for.
#include "core/visibility/canonical.h"

namespace overstrike {

/// What a plane may be off its vertices, in parts of the sizes that their coordinates and its
/// offset add up to: vertices are rounded three times over (shaped, placed, counted from the
/// origin), and the offset is a rounded sum of rounded products, a normal's and a vertex's. Where
/// it is farther off, the file's own rounding has bent the face, or welding has moved it.
constexpr double kPlaneRounding = 16 * 0x1p-53;

/// Sets CanonicalBody::on_planes of all bodies.
void note_bodies_on_planes(Canonical& canonical);

}  // namespace overstrike
