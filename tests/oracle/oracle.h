#pragma once
// The oracle: what is seen at one point of the grid, by brute force and exact arithmetic, over the
// canonical input. Slow and right: it shares no code with the resolver that it judges, only the
// plain structs of the input.
//
// The law, which holds for resolver and oracle alike:
//
//  1. A face is its projected outline (even-odd over all its loops, vertices projected exactly by
//     the view's matrix) with its stored plane's depth: the depth at grid point (x, y) is z^/w^ of
//     the point of the plane that projects there. Larger is nearer. Only what has w^ > 0 is there.
//     Where an outline reaches behind the eye it is taken in the face's own plane, which is the
//     same thing where both are defined.
//  2. A face is seen from its front when dot(outward normal, eye) - offset * eye.w > 0, from behind
//     when < 0, and not at all (edge-on) when 0. Closed bodies are not seen from behind; open ones
//     are two-sided: their normal is turned to the eye.
//  3. With a near plane only points with dot(n, p) >= offset are there, and of the backs of closed
//     bodies those with dot(n, p) > offset: a body that ends in the near plane is not cut by it.
//     Where a line of sight starts on it inside a closed body (its winding number along the line is
//     not 0) the near plane is seen there as that body's cut face,
//     density cut_factor * hmax * the body's factor, clamped to 0..1; inside several bodies: the
//     darkest, then the body of the smallest number.
//  4. The ground is the plane Z = ground_z, seen from above only. It hides what lies below it. Lit
//     ground is bare paper.
//  5. The nearest point wins. Among equal depths (faces of one plane) the face of the greater
//     density factor wins, which is the darker one wherever both are flat; then a flat body's
//     before a smooth one's, then the lexicographically smaller plane (normal x, y, z, offset),
//     then the smaller sorted list of vertices. A face that lies in the ground is seen before it,
//     whatever their densities.
//  Solids: a point is in an operand when its winding number along the line of sight is not 0, and
//  in the solid when the tree says so. A solid is seen where it is entered first; faces of one
//  plane are passed together. What is seen is a face that is passed there, whose operand is entered
//  or left the way it faces (parts of a mesh that are inside out are entered by faces that look
//  away) and matters: with some of the changes made that are made there, the point is outside, and
//  inside with its own besides. Among those law 5 decides.
//  6. With light L (towards it), a face with dot(seen-side normal, L) <= 0 is shade. Otherwise the
//     hit point Q on its stored plane is in shadow when the ray Q + t L, t > 0, meets a face of
//     another plane: the outline is taken along L, t = (offset - n.Q) / (n.L) from the stored
//     plane. Faces with n.L = 0 do not cast; of closed bodies those with outward normal.L > 0 cast.
//     A solid casts where the way from the light to Q enters it; faces of Q's plane do not count.
//     The ground casts no shadow, and casters are not clipped by the near plane. Light that does
//     not come from above the ground (L.z <= 0) leaves the ground bare.
//  7. Density: NN74 (15), hmax (1 - k max(0, n.L)); without light hmax (1 - k); in shadow hmax;
//  each
//     times the body's factor and clamped to 0..1. So shade is hmax on flat faces. Faces of smooth
//     bodies (those without holes) have the law's density, shade or not, for their corners' normals
//     at the corners, linear in the world over the triangles (c0, c_i, c_i+1) of the loop. Ground
//     shadow: hmax * ground_shadow_factor.
#include <memory>

#include "core/picture.h"
#include "core/visibility/canonical.h"
#include "core/visibility/view.h"

namespace overstrike::oracle {

/// What is seen at a point. Bare paper: density 0, no face, no body, kind lit. A cut face and a
/// ground shadow have no face; a ground shadow has no body either.
struct Seen {
  Index face = kNone;
  Index body = kNone;
  Kind kind = Kind::lit;
  double density = 0;
  double away_from_shadow = 0, in_shadow = 0;  ///< of a face: what density it has when it is (not)

  bool paper() const { return face == kNone && kind == Kind::lit; }
  /// The same thing is seen (whatever its density; of bodies that are cut at one place any).
  bool same(const Seen& o) const {
    return kind == o.kind && face == o.face && (body == o.body || kind == Kind::cut);
  }
};

class Oracle {
 public:
  /// Both must outlive the oracle.
  Oracle(const Canonical& canonical, const View& view);
  ~Oracle();

  Seen at(double x, double y) const;
  /// True when something else is seen at one of eight points round (x, y) at `radius` grid units: a
  /// true edge may be that near.
  bool near_edge(double x, double y, double radius) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Points nearer than this to a true edge may differ (grid units).
constexpr double kEdgeRadius = 1e-7;

}  // namespace overstrike::oracle
