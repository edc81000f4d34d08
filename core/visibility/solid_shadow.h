#pragma once
// The shadow of a Boolean solid on one receiver, along the eye's levels.
//
// The light sees the solid through the same resolver as the eye (solid_sweep.h): the sides of its
// operands' faces, as far as they lie over the receiver, are lines on the receiver's plane, and
// between two of them the faces have an order towards the light (cast_order.h). Where the solid is
// entered before the receiver is reached there is shadow.
#include <optional>
#include <span>
#include <vector>

#include "core/visibility/cast_order.h"
#include "core/visibility/front_table.h"
#include "core/visibility/level_bands.h"
#include "core/visibility/passing.h"
#include "core/visibility/solid_sweep.h"

namespace overstrike {

/// The part [x0, x1) of a level over which a receiver is in shadow; the slacks bound the ends'
/// errors.
struct ShadowSpan {
  double x0, x1;
  float slack0, slack1;
};

/// Where a level meets an operand's edge on the receiver.
struct OperandLine {
  LevelLine line;
  float slack;
  Index plane;  ///< as in ShadowLine
  std::array<Index, 2> faces;
};

class SolidShadow {
 public:
  /// Left of all lines the faces of `at_left` are passed. `reach`: bounds |x| where it is asked.
  SolidShadow(const SolidExpression& expression, std::vector<OperandLine> lines,
              std::vector<Index> at_left, double rows, double reach);

  /// What one thread needs; of the casting input.
  struct Scratch {
    explicit Scratch(const Canonical& casting) : solid(casting) {}
    SolidSweep solid;
    std::vector<Passing> passing;
    std::vector<SpanPiece> pieces;
  };
  /// Appends where the level is in shadow, from left to right. `x_of(line)` is where it meets one.
  template <class XOf>
  void on_level(double y, const CastOrder& order, const XOf& x_of, Scratch& scratch,
                std::vector<ShadowSpan>& spans) const;

 private:
  void sweep_passing(double y, const CastOrder& order, Scratch& scratch,
                     std::vector<ShadowSpan>& spans) const;

  /// Lines that are looked through one by one.
  static constexpr std::size_t kFew = 32;
  const SolidExpression& expression_;
  std::vector<OperandLine> lines_;
  std::vector<Index> at_left_;
  double reach_;
  std::optional<LevelBands> bands_;
};

/// Spans of several solids and bodies, which may overlap, as disjoint ones.
void unite(std::vector<ShadowSpan>& spans);

template <class XOf>
void SolidShadow::on_level(double y, const CastOrder& order, const XOf& x_of, Scratch& scratch,
                           std::vector<ShadowSpan>& spans) const {
  scratch.passing.clear();
  const auto meet = [&](const OperandLine& l) {
    if (l.line.y0 <= y && y < l.line.y1) scratch.passing.push_back({x_of(l), l.slack, l.faces});
  };
  if (bands_) {
    for (const LevelBands::Item& item : (*bands_)[bands_->band(y)])
      if (item.meets(y)) meet(lines_[item.number]);
  } else {
    for (const OperandLine& line : lines_) meet(line);
  }
  sweep_passing(y, order, scratch, spans);
}

}  // namespace overstrike
