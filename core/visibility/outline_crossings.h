#pragma once
// Where a line of the grid passes over a face, looked at from both of the line's sides.
#include "core/visibility/sight_line.h"

namespace overstrike {

/// Where the line is over the face when it is moved by nothing at all to its right (side[0]) and to
/// its left (side[1]). The two differ only where the line runs along the face's outline or touches
/// its corners: a line over the border of two faces is over one of them from either side, a line
/// over the border of a face and of nothing is over the face from one side only.
struct Passage {
  Intervals side[2];
};

/// Crossings of lines with outlines, by even and odd; keeps its working memory.
class OutlineCrossings {
 public:
  explicit OutlineCrossings(const ProjectedScene& scene) : scene_(scene) {}
  const Passage& over(Index face, const Ruler& ruler);

 private:
  struct Corner {
    Index vertex;
    double side;
  };
  double crossing(const Ruler& ruler, Corner p, Corner q) const;
  void cross_loop(const Ruler& ruler, int zero, std::vector<double>& crossings) const;

  const ProjectedScene& scene_;
  std::vector<Corner> corners_;
  std::vector<double> crossings_[2];
  Passage passage_;
};

}  // namespace overstrike
