#pragma once
// From a shape as it was said to faces.
#include <string>
#include <unordered_map>
#include <vector>

#include "core/geometry/polyhedron.h"
#include "core/scene/shapes.h"

namespace overstrike {

/// The shape as faces in its own frame. Curved shapes get the fewest facets that keep every chord
/// within `chord` (units of the own frame) of the true surface: at least 3 sides, at most 4096
/// round a circle. Vertices lie on the true surface. Flat-faced shapes ignore `chord`. With
/// `normals`, corner normals of the true surface are given for curved shapes, and for those with
/// `sides` of their own the normals of the surface that they would have without (creases such as a
/// cylinder's rim keep two normals). Precondition: validate() is empty. Deterministic to the bit.
///
/// Solids are closed: every directed edge has one opposite, and no two vertices have equal
/// coordinates. Caps, and level parts of a turned profile, are one face, with holes where they have
/// some. Faces are plane but for rounding; sweeps along closed paths that leave a plane get
/// triangles where the path turns their profile. plane_groups is given where faces of one solid lie
/// in one plane by construction.
Polyhedron tessellate(const Shape& shape, double chord, bool normals);

/// The chord at which a curved shape keeps within 4096 sides round a circle and 2^20 facets (some
/// 700 MB when drawn): `chord` itself, or else a coarser one, which does not depend on it.
double drawable_chord(const Shape& shape, double chord);

/// Why the shape cannot be drawn ("radius must be positive, found -1"), or empty.
std::string validate(const Shape& shape);

/// The shape's name as scenes write it ("box", "torus", ...).
std::string_view shape_name(const Shape& shape);

/// True for shapes whose facets stand for a curved surface: their facet edges are no creases.
bool is_curved(const Shape& shape);

/// Axis-aligned bounds after the placement: exact for flat-faced shapes, at most 1 % larger for
/// curved ones.
struct Bounds {
  Vec3 low{1e300}, high{-1e300};
  bool empty() const { return low.x > high.x; }
  void add(const Vec3& p) { low = glm::min(low, p), high = glm::max(high, p); }
};
Bounds bounds(const Shape& shape, const Affine& placement);

/// The same of many bodies: flat-faced shapes find their vertices once, however many copies they
/// have. The shapes must outlive this.
class BoundsOfCopies {
 public:
  Bounds operator()(const Shape& shape, const Affine& placement);

 private:
  std::unordered_map<const Shape*, std::vector<Vec3>> vertices_;
};

}  // namespace overstrike
