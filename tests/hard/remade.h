#pragma once
// The same scene said in another way.
#include <functional>

#include "core/scene/scene.h"

namespace overstrike::hard {

using Remake = std::function<Polyhedron(const Polyhedron&)>;

/// Every solid of flat faces, and every mesh, becomes a mesh of what `remake` makes of its faces.
/// Smooth bodies and sheets stay as they are.
Scene with_meshes(const Scene& scene, const Remake& remake);

/// Faces in another order. Always the same one.
Polyhedron shuffled(const Polyhedron& p);

/// Faces and vertices in another order, loops begun elsewhere.
Polyhedron renumbered(const Polyhedron& p);

/// Every edge halved, every convex face cut to triangles round its middle.
Polyhedron subdivided(const Polyhedron& p);

/// Every box cut in two across its x.
Scene in_halves(const Scene& scene);

/// The scene, its camera and its light in a mirror across x = 0.
Scene mirrored(const Scene& scene);

}  // namespace overstrike::hard
