#pragma once
// The canonical input of a view: what the resolver and the oracle both start from.
//
// Doubles for vertices, counted from the view's origin, faces with a plane identity, winged edges.
// A face *is* its projected outline with its stored plane's depth (rounded vertices are never quite
// coplanar). Which faces share a plane is decided here, once, and nowhere later.
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/geometry/polyhedron.h"
#include "core/geometry/winged_edges.h"
#include "core/scene/scene.h"
#include "core/scene/solid_expression.h"

namespace overstrike {

constexpr Index kNone = 0xFFFFFFFFu;

/// { p : dot(normal, p) = offset }; the normal is of unit length but for rounding.
struct Plane {
  Vec3 normal;
  double offset;
};

struct CanonicalFace {
  Index first_loop, end_loop;  ///< in Canonical::loop_ends
  Index plane;                 ///< in Canonical::planes
  Index body : 30;
  bool flipped : 1;  ///< the face's outward normal is the plane's, negated
  bool cut : 1;      ///< a cap that clipping made
};
static_assert(sizeof(CanonicalFace) == 16);

/// Winged edge: `left` is the face that has (from, to) in its loop, `right` the one that has (to,
/// from); kNone at the border of an open body. `left` != kNone.
struct WingedEdge {
  Index from, to;
  Index left, right;
  bool
      crease;  ///< a real edge of the shape; false between facets that stand for one curved surface
};

struct CanonicalBody {
  Index first_face, end_face;
  Index first_edge, end_edge;
  Index first_vertex, end_vertex;
  Index first_corner;
  Index first_twin;  ///< in Canonical::twins: one per corner; copies share them
  /// Every edge has two faces and no face crosses itself: back faces cannot be seen from outside.
  bool closed;
  bool smooth;     ///< shaded by corner normals
  bool simple;     ///< known not to pass through itself: every shape but a mesh and a sweep
  bool on_planes;  ///< its vertices lie on its faces' planes but for rounding (plane_rounding.h)
  bool curved;     ///< its facets stand for a curved surface, to the tolerance
  double density_factor;
  int pen;
  Index source;  ///< index into Scene::bodies
};

/// What a body is an operand of; kNone: it stands for itself.
struct Membership {
  Index solid = kNone;  ///< in Canonical::solids
  Index operand = 0;    ///< in its nodes
};

/// A solid with nothing taken from it: of each difference the first operand (solid_forms.h). Of a
/// background, from which all is taken, the solid as it is written.
struct UncutSolid {
  std::vector<SolidNode> nodes;
  SolidExpression expression;
};

/// A Boolean solid. Bodies that are the same in the same place are one operand.
struct CanonicalSolid {
  std::vector<SolidNode> nodes;          ///< `body` is the operand
  SolidExpression expression;            ///< the same set
  std::string name = {};                 ///< as Solid::name
  Place place = {};                      ///< as Solid::place
  double translucent = 0;                ///< as Solid::translucent
  std::optional<UncutSolid> uncut = {};  ///< where translucent > 0 (solid_forms.h)
  bool background = false;  ///< as Solid::background: `nodes` are empty, `uncut` is the whole tree
};

struct CanonicalPattern {
  std::vector<Vec3> points;
  Index body;
  int pen;
};

struct Canonical {
  std::vector<Vec3> vertices;        ///< from View::origin, as all positions here are
  std::vector<Index> corners;        ///< vertex numbers, loop after loop
  std::vector<Vec3> corner_normals;  ///< world, unit (shorter where a cut made the corner); empty
                                     ///< when no body is smooth, else one per corner
  std::vector<Index> loop_ends;      ///< in corners
  std::vector<CanonicalFace> faces;
  std::vector<Plane> planes;
  std::vector<WingedEdge> edges;  ///< a body's by their lower and then their higher vertex
  std::vector<Twin> twins;        ///< corners and faces counted from their body's first ones
  std::vector<CanonicalBody> bodies;
  std::vector<Membership> memberships;  ///< per body; empty where there are no solids
  std::vector<std::shared_ptr<const CanonicalSolid>> solids;
  std::vector<CanonicalPattern> patterns;
  std::vector<Segment> segments;
  std::optional<Vec3> light;  ///< unit vector towards the light
  std::optional<double> ground_z;
  DensityLaw law;

  Index first_corner(Index l) const { return l == 0 ? 0 : loop_ends[l - 1]; }
  std::span<const Index> loop(Index l) const {
    return {corners.data() + first_corner(l), corners.data() + loop_ends[l]};
  }
  /// The other side of the edge that begins at a corner of the body's; face kNone at a border.
  Twin twin(const CanonicalBody& body, Index corner) const {
    const Twin t = twins[body.first_twin + (corner - body.first_corner)];
    return t.face == kNone ? t : Twin{t.corner + body.first_corner, t.face + body.first_face};
  }
  Membership membership(Index body) const {
    return memberships.empty() ? Membership{} : memberships[body];
  }
  /// Outward unit normal of a face.
  Vec3 outward(const CanonicalFace& f) const {
    return f.flipped ? -planes[f.plane].normal : planes[f.plane].normal;
  }
};

struct View;

/// Tessellates to `chord_cells` grid units in the view, places, splits what is not planar, turns
/// what is inside out, welds planes and builds winged edges. Everything that was flawed is named in
/// `warnings` (with the body's place). Throws InputError where an operand of a solid is not closed.
Canonical canonicalize(const Scene& scene, const View& view, double chord_cells,
                       std::vector<Diagnostic>& warnings);

/// Density of a flat face away from shadows (NN74 (14)(15) times the body's factor, clamped to
/// 0..1), and whether light falls on it. `to_eye` is the side it is seen from (two-sided faces of
/// open bodies turn their normal to it).
struct FaceShade {
  double density;
  bool lit;
};
FaceShade shade_of(const Canonical&, const CanonicalFace&, bool seen_from_behind);

}  // namespace overstrike
