#pragma once
// Phase I: the light is the first view (NN74). What it sees leaves shadow boundaries as lines on
// the receivers' planes.
//
// A point Q of a face that the light faces is in shadow when another face that faces the light lies
// over it, seen from the light, and that face's stored plane passes over Q, on the light's side of
// its plane. The casters over a receiver leave closed polygons there, which are counted where they
// overlap; any count but zero is shadow. A face never shadows its own plane, which is a matter of
// plane identities; of all others planes decide, not how far vertices are from them.
//
// Steps, for one receiver:
//  1. Bodies whose bounds across the light meet the receiver's are looked at, one by one.
//  2. A body whose front towards the light can be walked (front_table.h) leaves its outline, and
//     nothing on itself, unless its faces' vertices are off their planes. Where it lies wholly
//     above the receiver its outline alone decides: all of the receiver inside is covered, and no
//     other body need be asked; outside is nothing; else the sides of the outline that pass by are
//     left as a polygon.
//  3. Where it lies beside the receiver in height, or cannot be walked, its faces over the receiver
//     are cut to the light's side of its plane and left one by one; borders that two of them share
//     cancel.
//     Faces of a solid's operands are cut and left in the same way, each with its own border: what
//     of the solid is there is decided where the receiver is seen (solid_shadow.h).
//  4. A receiver that no border passes over is in shadow all over or not at all.
#include <array>
#include <memory>
#include <vector>

#include "core/visibility/canonical.h"
#include "core/visibility/view.h"

namespace overstrike {

/// A piece of a shadow's boundary on its receiver; crossing it changes the count by `winding` (from
/// right to left of a -> b as the light sees it).
struct ShadowEdge {
  Vec3 a, b;
  int winding;
  Index plane = kNone;  ///< of a caster, where it passes through the receiver's along this piece
};

/// On its receiver, a piece of a side of an operand's face that lies over it. Passing it, the face
/// begins or ends (`faces`: or both do, where two share the side).
struct OperandEdge {
  Vec3 a, b;
  Index solid;                 ///< of the casting input
  std::array<Index, 2> faces;  ///< of the casting input; the second may be kNone
  Index plane = kNone;         ///< as in ShadowEdge
};

/// What the light leaves on one receiver. Without edges, `covered` says whether all of it is in
/// shadow.
struct Shadow {
  Index receiver;  ///< a face of `seen`, or seen.faces.size() for the ground
  bool covered = false;
  std::vector<ShadowEdge> edges;
  /// By solid. Whether one casts shadow at a point of the receiver is what its operands say along
  /// the light there (solid_shadow.h).
  std::vector<OperandEdge> operands;
};

/// Casts shadows, on any number of threads.
class ShadowCaster {
 public:
  /// `whole` casts; `seen` (the same, or what near clipping left of it) receives. Both must outlive
  /// this. Without a light nothing is cast.
  ShadowCaster(const Canonical& whole, const Canonical& seen, const View& view, int threads);
  ~ShadowCaster();

  /// What one thread needs.
  class Scratch {
   public:
    Scratch();
    ~Scratch();
    Scratch(Scratch&&) noexcept;

   private:
    friend class ShadowCaster;
    struct Impl;
    std::unique_ptr<Impl> impl_;
  };
  /// False when the receiver is none: a face that the light and the eye do not see from the same
  /// side, a cut.
  bool receives(Index receiver) const;
  /// The shadow on a receiver, which may be empty.
  Shadow on(Index receiver, Scratch& scratch) const;
  /// What casts. Precondition: there is a light.
  const Canonical& casting() const;
  /// All shadows, by receiver; receivers without shadow are left out.
  std::vector<Shadow> all() const;

 private:
  struct Impl;
  std::unique_ptr<const Impl> impl_;
};

std::vector<Shadow> cast_shadows(const Canonical& whole, const Canonical& seen, const View& view);

}  // namespace overstrike
