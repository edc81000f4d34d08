#pragma once
// Nodes with their shapes -> bodies and solids of a scene.
#include "core/scene/scene.h"
#include "scenes/readers/openscad/shapes.h"

namespace overstrike::openscad {

/// What nothing but unions stands above becomes bodies of their own; each difference and
/// intersection that is left becomes a solid.
void add_bodies(const Tree& tree, const Nodes& nodes, const std::vector<NodeShape>& shapes,
                const Reporter& reporter, Scene& scene);

/// Each background becomes a solid of its own. `nodes` as resolve_backgrounds() has them.
void add_backgrounds(const Tree& tree, const Nodes& nodes, const std::vector<NodeShape>& shapes,
                     const Reporter& reporter, Scene& scene);

/// The density factor of a colour: white is a quarter, black all of it, by luma (Rec. 709).
double density_of(const Vec3& color);

/// Pens by hue: 1 for greys, 2 red, 3 yellow, 4 green, 5 cyan and blue, 6 magenta.
int pen_of(const Vec3& color);

}  // namespace overstrike::openscad
