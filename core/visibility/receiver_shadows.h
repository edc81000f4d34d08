#pragma once
// Shadow borders on their receivers as the eye's levels meet them.
#include <vector>

#include "core/visibility/front_table.h"
#include "core/visibility/level_bands.h"
#include "core/visibility/shadows.h"

namespace overstrike {

/// The part [x0, x1) of a level over which a receiver is in shadow; the slacks bound the ends'
/// errors.
struct ShadowSpan {
  double x0, x1;
  float slack0, slack1;
};

/// A border of a shadow: passing it from left to right adds `winding` to the count.
struct ShadowLine {
  LevelLine line;
  float slack;
  int winding;
};

class ReceiverShadows {
 public:
  ReceiverShadows(const FrontTable& table, const std::vector<Shadow>& shadows);

  bool any(Index face) const { return !of_face_.empty() && of_face_[face] != kNone; }
  /// Appends where the level is in shadow on the face's plane, from left to right; everywhere from
  /// -infinity to infinity when it is covered. `scratch` is for the crossings.
  void on_level(Index face, double y, std::vector<ShadowSpan>& spans) const;

 private:
  struct Receiver {
    bool covered = false;
    std::size_t first = 0, end = 0;  ///< in lines_, by y0
    std::size_t bands = kNoBands;    ///< in bands_, of receivers with many lines
  };
  static constexpr std::size_t kNoBands = ~std::size_t{0};
  void add_line(const ShadowEdge& edge, const View& view);

  std::vector<Index> of_face_;  ///< in receivers_; empty when there are none
  std::vector<Receiver> receivers_;
  std::vector<ShadowLine> lines_;
  std::vector<LevelBands> bands_;
};

}  // namespace overstrike
