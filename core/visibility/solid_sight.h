#pragma once
// Boolean solids along a line that may be drawn: where they hide it, and where their surface runs
// through it.
//
// The solid is resolved along the line's own projection (solid_sweep.h), looked at from either
// side; the line itself is the layer at which the search ends. Where the solid is entered before
// it, the line is hidden on that side. Where it is entered in a plane that the line lies in, its
// surface ends in the line there, or goes on through it.
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

/// One a thread.
class SolidSight {
 public:
  explicit SolidSight(const ProjectedScene& scene);

  void clear() { faces_.clear(); }
  bool empty() const { return faces_.empty(); }
  /// A face of an operand that the line may pass over, and its plane's leads at the line's ends.
  void add(Index face, const std::array<Lead, 2>& leads, const Passage& passage);

  /// What a solid shows over a part of the line, looked at from its right (0) or left (1) side.
  struct Part {
    Index solid;
    int side;
    Interval over;
    Index face;
    bool hides;  ///< the face lies before the line; else the line lies in its plane
  };
  /// Sets the parts of all solids whose faces were added, by solid and side, along the line;
  /// `sliver` is a length below which crossings cannot be told apart, as a part of the line's.
  void resolve(const Ruler& ruler, double sliver, std::vector<Part>& parts);

 private:
  struct Face {
    Index solid, face;
    std::array<Lead, 2> leads;
    Passage passage;
  };
  class Order;
  void resolve(std::span<const Face> faces, int side, const Order& order, double sliver,
               std::vector<Part>& parts);

  const ProjectedScene& scene_;
  SolidSweep sweep_;
  std::vector<Face> faces_;
  std::vector<Passing> passing_;
  std::vector<SpanPiece> pieces_;
};

}  // namespace overstrike
