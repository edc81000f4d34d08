#pragma once
// Edges that are passed along a level from left to right, and the spans between them.
#include <algorithm>
#include <array>
#include <vector>

#include "core/geometry/polyhedron.h"

namespace overstrike {

struct Passing {
  double x;
  float slack;                 ///< bound on the error of x
  std::array<Index, 2> faces;  ///< the second may be kNone
};

inline void sort_passing(std::vector<Passing>& passing) {
  std::sort(passing.begin(), passing.end(), [](const Passing& a, const Passing& b) {
    return a.x != b.x ? a.x < b.x : a.faces < b.faces;
  });
}

/// Calls `pass(faces)` for one after the other, and `span(x0, x1, slack0, slack1)` between them.
template <class Pass, class Span>
void sweep(const std::vector<Passing>& passing, const Pass& pass, const Span& span) {
  double x = passing.front().x, slack = passing.front().slack;
  for (const Passing& p : passing) {
    // A span no wider than its ends are uncertain is of rounding's making, and may lie on the wrong
    // side of an edge in which two faces touch: nothing is asked there, and its neighbour takes it.
    if (p.x - x > slack + p.slack) {
      span(x, p.x, slack, p.slack);
      // An edge passed before may truly lie right of this one.
      slack = std::max<double>(p.slack, slack - (p.x - x));
      x = p.x;
    } else {
      slack = std::max<double>(slack, p.slack);
    }
    pass(p.faces);
  }
}

}  // namespace overstrike
