#pragma once
// Boolean solids along a line that may be drawn, as the eye or the light sees them: where they hide
// it or leave it in shadow, and where their surface runs through it.
//
// The solid is resolved along the line's own projection (solid_sweep.h), looked at from either
// side; for the eye the line itself is the layer at which the search ends. Where the solid is
// entered before it, the line is hidden on that side. Where it is entered in a plane that the line
// lies in, its surface ends in the line there, or goes on through it. What the light's faces lie
// over lies behind all of them: where the solid is entered at all, there is shadow.
#include <vector>

#include "core/visibility/outline_crossings.h"
#include "core/visibility/passing.h"
#include "core/visibility/solid_sweep.h"

namespace overstrike {

/// How much nearer a plane is than the line at one of its ends.
struct Lead {
  double value;  ///< 0 where they meet by topology, or but for rounding
  double error;
};

/// A face of an operand that a line may pass over.
struct FaceOver {
  Index face;
  std::array<Lead, 2> leads;  ///< of its plane, at the line's ends
  int enters;                 ///< as in LayerOrder
  Vec2 slope;                 ///< how its plane comes nearer over the grid
  Passage passage;
};

/// One a thread.
class SolidSight {
 public:
  /// Of `canonical` are the faces.
  explicit SolidSight(const Canonical& canonical);

  void clear() { faces_.clear(); }
  bool empty() const { return faces_.empty(); }
  void add(const FaceOver& face);

  /// What a solid shows over a part of the line, looked at from its right (0) or left (1) side.
  struct Part {
    Index solid;
    int side;
    Interval over;
    Index face;
    bool hides;  ///< the face lies before the line; else the line lies in its plane
  };
  enum class Ends { in_line, nowhere };
  /// Sets the parts of all solids whose faces were added, by solid and side, along the line, where
  /// the search ends or behind which it does; `sliver` is a length below which crossings cannot be
  /// told apart, as a part of the line's.
  void resolve(const Ruler& ruler, double sliver, Ends ends, std::vector<Part>& parts);

 private:
  struct Face {
    Index solid;
    FaceOver over;
  };
  class Order;
  void resolve(std::span<const Face> faces, int side, const Order& order, double sliver, Ends ends,
               std::vector<Part>& parts);

  const Canonical& canonical_;
  SolidSweep sweep_;
  std::vector<Face> faces_;
  std::vector<Passing> passing_;
  std::vector<SpanPiece> pieces_;
};

}  // namespace overstrike
