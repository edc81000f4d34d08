#pragma once
// Pieces of what is seen along a level, from the places where another face begins to be.
#include <array>
#include <vector>

#include "core/visibility/depth_difference.h"
#include "core/visibility/layer_order.h"
#include "core/visibility/span_split.h"

namespace overstrike {

/// Makes pieces, which it appends. Neighbours of one face become one.
class PieceMaker {
 public:
  explicit PieceMaker(std::vector<SpanPiece>& pieces) : pieces_(pieces) {}
  /// The face that is seen from the last turn on.
  Index face() const { return open_.face; }
  /// From x on another face is seen, or none: `slack1` bounds the error of x as an end, `slack0` as
  /// a beginning.
  void turn(double x, float slack1, float slack0, Index face) {
    open_.x1 = x, open_.slack1 = slack1;
    if (open_.face != kNone) append(open_);
    open_ = {x, x, face, slack0, 0};
  }
  /// Precondition: nothing is seen from the last turn on.
  void append(const SpanPiece& piece) {
    SpanPiece* const last = pieces_.empty() ? nullptr : &pieces_.back();
    if (last != nullptr && last->x1 == piece.x0 && last->face == piece.face) {
      last->x1 = piece.x1, last->slack1 = piece.slack1;
    } else {
      pieces_.push_back(piece);
    }
  }

 private:
  std::vector<SpanPiece>& pieces_;
  SpanPiece open_{0, 0, kNone, 0, 0};
};

/// Borders of what is seen, for levels between which they are the same lines and crossings.
class KeptBorders {
 public:
  void clear() { borders_.clear(), lines_.clear(); }
  /// The face right of the last border.
  Index face() const { return borders_.empty() ? kNone : borders_.back().face; }
  /// A border with this face to its right: where two faces cross, ...
  void add_crossing(const std::array<Index, 2>& faces, Index face) {
    borders_.push_back({faces, 0, 0, face});
  }
  /// ... or lines that meet each level in one place, added one by one after it, of which the first
  /// by place and then by faces counts.
  void add(Index face) {
    const auto first = static_cast<Index>(lines_.size());
    borders_.push_back({{kNone, kNone}, first, first, face});
  }
  void add_line(const SlackLine& line, const std::array<Index, 2>& faces) {
    lines_.push_back({line, faces});
    borders_.back().end = static_cast<Index>(lines_.size());
  }
  void show(double y, const LayerOrder& order, std::vector<SpanPiece>& pieces) const;

 private:
  struct Border {
    std::array<Index, 2> crossing;  ///< kNone: lines
    Index first, end;               ///< of lines_
    Index face;
  };
  struct Line {
    SlackLine line;
    std::array<Index, 2> faces;
  };
  void turn_at_lines(const Border& border, double y, PieceMaker& pieces) const;

  std::vector<Border> borders_;
  std::vector<Line> lines_;
};

}  // namespace overstrike
