#pragma once
// The shadow of a Boolean solid on one receiver, along the eye's levels.
//
// The light sees the solid through the same resolver as the eye (solid_sweep.h): the sides of its
// operands' faces, as far as they lie over the receiver, are lines on the receiver's plane, and
// between two of them the faces have an order towards the light (cast_order.h). Where the solid is
// entered before the receiver is reached there is shadow.
#include <algorithm>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/visibility/cast_order.h"
#include "core/visibility/front_table.h"
#include "core/visibility/level_bands.h"
#include "core/visibility/passing.h"
#include "core/visibility/solid_rows.h"

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

class SolidShadow final : public SolidLines {
 public:
  /// Left of all lines the faces of `at_left` are passed. `reach`: bounds |x| where it is asked.
  SolidShadow(const SolidExpression& expression, std::vector<OperandLine> lines,
              std::vector<Index> at_left, double rows, double reach);

  /// What one thread needs; of the casting input.
  struct Scratch {
    Scratch(const Canonical& casting, Coherence kept) : tools(casting), coherence(kept) {}
    SolidTools tools;
    Coherence coherence;
    std::unordered_map<const SolidShadow*, SolidRows> rows;  ///< what is kept of each
    std::vector<Passing> passing;
    std::vector<SpanPiece> pieces;
  };
  /// Appends where the level is in shadow, from left to right. `x_of(line)` is where it meets one.
  template <class XOf>
  void on_level(double y, const CastOrder& order, const XOf& x_of, Scratch& scratch,
                std::vector<ShadowSpan>& spans) const;
  SolidLine line(Index number) const override;

 private:
  std::span<const LevelBands::Item> near(double y) const;
  bool kept_on_level(double y, const CastOrder& order, Scratch& scratch) const;
  void sweep_passing(double y, const CastOrder& order, Scratch& scratch) const;

  /// Lines that are looked through one by one.
  static constexpr std::size_t kFew = 32;
  const SolidExpression& expression_;
  std::vector<OperandLine> lines_;
  std::vector<Index> at_left_;
  GridWindow within_;  ///< lines beyond are taken for its borders
  double border_;      ///< where levels begin and end, beyond that
  /// Levels of lines that are where planes cross: those are not straight to the bit. They are
  /// nearly level, and few.
  std::vector<std::pair<double, double>> bent_;
  std::vector<LevelBands::Item> few_;
  std::optional<LevelBands> bands_;  ///< where there are many
};

/// Spans of several solids and bodies, which may overlap, as disjoint ones.
void unite(std::vector<ShadowSpan>& spans);

template <class XOf>
void SolidShadow::on_level(double y, const CastOrder& order, const XOf& x_of, Scratch& scratch,
                           std::vector<ShadowSpan>& spans) const {
  scratch.pieces.clear();
  if (!kept_on_level(y, order, scratch)) {
    scratch.passing.clear();
    for (const LevelBands::Item& item : near(y)) {
      const OperandLine& l = lines_[item.number];
      if (!item.meets(y)) continue;
      const double x = x_of(l), clamped = std::clamp(x, within_.x0, within_.x1);
      scratch.passing.push_back({clamped, x == clamped ? l.slack : 0, l.faces});
    }
    sweep_passing(y, order, scratch);
  }
  for (const SpanPiece& piece : scratch.pieces)
    spans.push_back({piece.x0, piece.x1, piece.slack0, piece.slack1});
}

}  // namespace overstrike
