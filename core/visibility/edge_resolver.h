#pragma once
// What hides a line: the resolver along the line's own projection.
#include "core/visibility/face_index.h"
#include "core/visibility/outline_crossings.h"
#include "core/visibility/sight_line.h"
#include "core/visibility/solid_edges.h"
#include "core/visibility/solid_sight.h"

namespace overstrike {

/// A part of a line that is drawn, and what it is there.
struct VisiblePart {
  Interval over;
  StrokeKind kind;
  Index body;  ///< whose stroke it is
};

/// Resolves lines one after the other; one for each thread.
class EdgeResolver {
 public:
  EdgeResolver(const ProjectedScene& scene, const FaceIndex& index)
      : scene_(scene), crossings_(scene), query_(index), solids_(scene.canonical) {}

  /// The parts of the line (of line.within) that lie on the page and that nothing hides.
  std::vector<VisiblePart> visible(const SightLine& line);
  /// The parts that lie over the face, from whichever side they are looked at.
  Intervals inside(const SightLine& line, Index face);

 private:
  Interval on_page(const SightLine& line) const;
  Lead lead(const LineEnd& end, Index plane) const;
  void hide_behind(const SightLine& line, const Ruler& ruler, Index face);
  void hide_below_ground(const SightLine& line);
  void hide_by_solids(const Ruler& ruler, double sliver);

  const ProjectedScene& scene_;
  OutlineCrossings crossings_;
  FaceIndex::Query query_;
  Intervals hidden_[2];  ///< seen from the line's right and left side
  SolidSight solids_;
  std::vector<SolidSight::Part> shown_;  ///< by solids, on the line in hand
};

/// Lengths along a line below which two crossings cannot be told apart, in grid units.
double sliver_of(const Ruler& ruler);

}  // namespace overstrike
