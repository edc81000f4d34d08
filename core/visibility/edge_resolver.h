#pragma once
// What hides a line: the resolver along the line's own projection.
#include "core/visibility/face_index.h"
#include "core/visibility/outline_crossings.h"
#include "core/visibility/sight_line.h"

namespace overstrike {

/// Resolves lines one after the other; one for each thread.
class EdgeResolver {
 public:
  EdgeResolver(const ProjectedScene& scene, const FaceIndex& index)
      : scene_(scene), crossings_(scene), query_(index) {}

  /// The parts of the line (of line.within) that lie on the page and that nothing hides.
  Intervals visible(const SightLine& line);
  /// The parts that lie over the face, from whichever side they are looked at.
  Intervals inside(const SightLine& line, Index face);

 private:
  Interval on_page(const SightLine& line) const;
  double lead(const LineEnd& end, Index plane) const;
  void hide_behind(const SightLine& line, const Ruler& ruler, Index face);
  void hide_below_ground(const SightLine& line);

  const ProjectedScene& scene_;
  OutlineCrossings crossings_;
  FaceIndex::Query query_;
  Intervals hidden_[2];  ///< seen from the line's right and left side
};

/// Lengths along a line below which two crossings cannot be told apart, in grid units.
double sliver_of(const Ruler& ruler);

}  // namespace overstrike
