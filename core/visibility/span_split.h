#pragma once
// Faces that pass through one another over a sample span (TK 4.2.2).
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "core/visibility/depth.h"

namespace overstrike {

/// The part [x0, x1) of a scan line over which `face` is seen (kNone: paper). The slacks bound the
/// errors of its ends; where bodies cross, the end is what it is.
struct SpanPiece {
  double x0, x1;
  Index face;
  float slack0, slack1;
};

/// Splits the span [x0, x1) at the exact crossings of the active faces, nearest first, and appends
/// the pieces. `slack0`, `slack1` bound the errors of the ends: what differs only within them is no
/// crossing (edges that touch a face end on it to within rounding). `Order` as ActiveList's, and
/// compare(f, g, x, y), the sign of the difference of depths, and crossing(f, g, y), where on the
/// line they are equal (NaN or infinite: nowhere).
template <class Order>
void split_at_crossings(const Order& order, std::span<const Index> active, double x0, double x1,
                        double y, double slack0, double slack1, std::vector<SpanPiece>& pieces) {
  double low = x0 + slack0, high = x1 - slack1;
  if (!(low < high)) low = high = x0 + (x1 - x0) / 2;
  Index seen = kNone;
  for (const Index f : active)
    if (seen == kNone || order.in_front(f, seen, low, y)) seen = f;
  double start = x0;
  float start_slack = static_cast<float>(slack0);
  // Each turn takes the face that comes through first; depths are linear, so none comes through
  // twice, but for one that was passed over.
  for (std::size_t turns = 0; seen != kNone && turns < 2 * active.size() && low < high; ++turns) {
    double first = high;
    Index next = kNone;
    for (const Index f : active) {
      if (f == seen || !order.in_front(f, seen, high, y)) continue;
      // Two that come through nearly together may have done so in the other order.
      const bool is_past = order.compare(f, seen, low, y) > 0;
      const double x = is_past ? low : std::clamp(order.crossing(f, seen, y), low, high);
      if (std::isnan(x)) continue;
      const bool nearer =
          next == kNone || x < first || (x == first && order.in_front(f, next, high, y));
      if (nearer) first = x, next = f;
    }
    if (next == kNone) break;
    if (first > start) pieces.push_back({start, first, seen, start_slack, 0}), start_slack = 0;
    start = std::max(start, first);
    low = std::max(low, first);
    seen = next;
  }
  if (start < x1) pieces.push_back({start, x1, seen, start_slack, static_cast<float>(slack1)});
}

}  // namespace overstrike
