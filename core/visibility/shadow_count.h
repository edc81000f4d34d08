#pragma once
// Where along a line on a receiver the boundaries that plain bodies left there say shadow.
//
// Edges that share corners make closed boundaries. One that lies beside the piece of the line in
// question adds nothing to the count there. The straight line is looked at from both of its sides:
// the edges of the boundaries change the count of casters; far away it is zero.
#include <array>
#include <vector>

#include "core/visibility/shadows.h"
#include "core/visibility/sight_line.h"

namespace overstrike {

class ShadowCount {
 public:
  ShadowCount(const ProjectedScene& scene, const Shadow& shadow);

  /// Sets the parts of a line from a to b that lie in shadow on its right (0) and left (1) side.
  void shadowed(const GridPoint& a, const GridPoint& b, std::array<Intervals, 2>& parts);

 private:
  struct Edge {
    GridPoint a, b;
    int winding;
  };
  /// A closed boundary: edges_[members_[first .. end)], and where they lie.
  struct Boundary {
    Vec2 low{1e300}, high{-1e300};
    std::size_t first, end;

    void add(const GridPoint& p) {
      low = glm::min(low, p.xy() - p.error), high = glm::max(high, p.xy() + p.error);
    }
  };
  /// The count changes here, on one side of the line.
  struct Change {
    double at;
    int by;
  };
  Vec2 corner(Index end) const { return (end & 1 ? edges_[end / 2].b : edges_[end / 2].a).xy(); }
  void gather();
  void pass(const Ruler& ruler, const Edge& edge);
  void between_changes(int side, Intervals& parts);

  std::vector<Edge> edges_;
  std::vector<Index> members_;
  std::vector<Boundary> boundaries_;
  std::vector<Change> changes_[2];
};

}  // namespace overstrike
