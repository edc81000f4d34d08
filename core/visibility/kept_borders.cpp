#include "core/visibility/kept_borders.h"

#include <algorithm>

namespace overstrike {

void KeptBorders::show(double y, const LayerOrder& order, std::vector<SpanPiece>& pieces) const {
  PieceMaker shown(pieces);
  for (const Border& border : borders_) {
    const auto& [near, far] = border.crossing;
    if (near != kNone) {
      shown.turn(order.crossing(near, far, y), 0, 0, border.face);
    } else {
      turn_at_lines(border, y, shown);
    }
  }
}

void KeptBorders::turn_at_lines(const Border& border, double y, PieceMaker& pieces) const {
  const Line* first = &lines_[border.first];
  double least = first->line.x_at(y);
  float slack = first->line.slack;
  for (Index i = border.first + 1; i < border.end; ++i) {
    const Line& other = lines_[i];
    const double x = other.line.x_at(y);
    if (x < least || (x == least && other.faces < first->faces)) first = &other, least = x;
    slack = std::max(slack, other.line.slack);
  }
  pieces.turn(least, first->line.slack, slack, border.face);
}

}  // namespace overstrike
