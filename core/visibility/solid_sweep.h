#pragma once
// What is seen of a Boolean solid along one level (TK, ch. 3 and 4).
//
// The faces of all operands that lie over the present span are kept in their order of depth.
// Passing an edge replaces a face by its neighbour, or brings two in or takes two out (TK 4, the
// three patterns); within a span only neighbours in depth can exchange their places, at their exact
// crossing (TK 4.2.2). Along depth each operand has a winding number, and the expression of the
// solid follows it: the first place inside is where the solid is seen.
#include <array>
#include <optional>
#include <vector>

#include "core/visibility/face_order.h"
#include "core/scene/solid_expression.h"
#include "core/visibility/span_split.h"

namespace overstrike {

/// Goes over one level after the other. One a thread.
class SolidSweep {
 public:
  SolidSweep(const FrontTable& table, const FaceOrder& order) : table_(table), order_(order) {}

  /// Goes to the left of all edges of a solid's operands on the level.
  void begin(const SolidExpression& expression, double y);
  /// Passes an edge between two faces (the second may be kNone) from left to right.
  void pass(const std::array<Index, 2>& faces);
  /// Appends what is seen from where edges were passed last to where the next one is. The face of
  /// `over` is not looked at. Where nothing is seen, there is no piece.
  void span(const SpanPiece& over, std::vector<SpanPiece>& pieces);

 private:
  /// An active face, and its depth on the level: slope x + constant, larger is nearer.
  struct Layer {
    Index face;
    Index plane, operand;
    int enters;  ///< 1: the operand is entered there along the line of sight, -1: left
    double slope, constant, slope_error, constant_error;
    bool fresh;  ///< it took the place of another in the span in hand
    // It stays before that face up to there; kept by next_crossing().
    Index before = kNone;
    double before_until = 0;
  };
  /// A crossing of two neighbours in depth.
  struct Crossing {
    double x;
    std::size_t first;  ///< of the two layers
  };
  Layer layer_of(Index face) const;
  void settle(double low, double high);
  void replace(std::size_t at, Index face);
  void toggle(Index face);
  void insert(Index face);
  void move_into_order(std::size_t at);
  int compare(const Layer& a, const Layer& b) const;
  int compare_at(const Layer& a, const Layer& b, double x, bool& sharp) const;
  std::optional<Crossing> next_crossing(double from);
  double before_until(const Layer& near, const Layer& far) const;
  void changed_at(std::size_t at);
  bool ties(std::size_t at) const;
  Index seen();
  Index find_seen();
  Index choose(std::size_t first, std::size_t end);
  bool needed(Index operand, std::span<const Index> changed);

  const FrontTable& table_;
  const FaceOrder& order_;
  const SolidExpression* expression_ = nullptr;
  std::optional<SolidExpression::State> state_;
  double y_ = 0, low_ = 0, high_ = 0;  ///< within the span in hand
  std::vector<Layer> layers_;          ///< from near to far
  std::vector<std::array<Index, 2>> passed_;
  std::vector<Index> entering_;
  // What is seen, as long as nothing changes among the first `decided_` layers, which decide it.
  bool known_ = false;
  Index seen_ = kNone;
  std::size_t decided_ = 0;
  std::vector<int> winding_;  ///< per operand; 0 between two questions
  std::vector<Index> entered_, changed_, operands_, candidates_, others_;
  std::vector<char> made_;  ///< per one of others_: whether its change is made
};

}  // namespace overstrike
