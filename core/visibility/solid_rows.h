#pragma once
// Boolean solids from level to level: what a span shows is kept until something about it may have
// changed (TK 4: scan-line coherence; kinetic data structures call it a certificate).
//
// Every edge of the operands that the level in hand meets is a node. Nodes stand in their order
// along the level; the last one of those that meet it in one place has the span to its right: the
// layers over it, what decided what is seen, and the level before which that is surely so. Edges
// move along straight lines from level to level, and so do depth differences along them and along
// the lines in which planes cross: what is sure at one level and at another is so between.
//
// A level at which nothing is due evaluates the borders of what is seen, and nothing else. One at
// which something is puts nodes in order, resolves the spans that are touched, from the layers of
// the span before, and goes on to the right until the layers are again what they were.
//
// Only what no rounding is known to change is kept, so that a level has the same bits as one that
// is resolved by itself. Where planes cross within 1e-12 of an edge of a surface that passes
// through itself, fuzzing has seen ends that differ by 3e-13 of a cell: such layers keep, on a
// level by itself, an order that hangs on the spans before.
#include <vector>

#include "core/visibility/depth_difference.h"
#include "core/visibility/face_order.h"
#include "core/visibility/level_bands.h"
#include "core/visibility/loose_edges.h"
#include "core/visibility/passing.h"
#include "core/visibility/solid_sweep.h"

namespace overstrike {

/// One solid, for one thread.
class SolidRows {
 public:
  SolidRows(const FrontTable& table, const FaceOrder& order, const LooseEdges& edges, Index solid,
            const SolidOptions& options);

  /// Whether the next level is to be asked for here. Where most of what is kept lasts for a level
  /// or two, levels are resolved faster by themselves; that is learned, and tried again now and
  /// then.
  bool is_worth_while();
  /// Appends what is seen of the solid on the level. `near`: at least its edges that meet the level
  /// (LooseEdges::near), the same span for all levels of a band.
  void on_level(double y, std::span<const LevelBands::Item> near, std::vector<SpanPiece>& pieces);

 private:
  /// A face that a span shows, and the crossing that it begins with (SpanRecord).
  struct Part {
    Index seen;
    std::array<Index, 2> crossing;
  };
  struct Node {
    Index edge;
    SlackLine line;     ///< or the border of the operand's window, where the edge is beyond that
    double clamped_to;  ///< that border, or NaN
    std::array<Index, 2> faces;
    double until;  ///< from there something about the node or its span may be otherwise
    bool dirty;    ///< is so
    bool has_span;
    // Of the span.
    double resolved_at;
    std::vector<Index> active;      ///< over its end, in any order
    std::vector<Part> parts;        ///< from left to right; none follows one of the same face
    std::vector<SpanPiece> pieces;  ///< at the level it was resolved at
  };
  /// A span with something to show: between the nodes [left, left_end) and [left_end, right_end).
  struct Shown {
    std::size_t left, left_end, right_end;
  };
  /// Where parts of a span meet, or where it ends.
  struct Border {
    const SlackLine* line;        ///< null: a crossing
    const DepthDifference* zero;  ///< of two depths
    std::array<Index, 2> crossing;
    double offset, slack;  ///< into the span, and what the place may be off by
    double x_at(double y) const { return line != nullptr ? line->x_at(y) : zero->zero_at(y); }
  };

  Node& node(std::size_t at) { return nodes_[order_line_[at]]; }
  void restart();
  void drop_ended(double y);
  void put_in_order();
  void add_started(double y, std::span<const LevelBands::Item> near);
  Index new_node(Index edge);
  bool evaluate(Node& n, double y) const;
  bool before(std::size_t at, std::size_t other);
  void resolve_dirty(double y);
  std::size_t begin_before(std::size_t at, double y);
  std::size_t resolve_from(std::size_t touched, double y);
  void resolve_span(std::size_t left, std::size_t right, double slack, double y);
  bool goes_on_as_before(std::size_t at, const std::vector<Index>& active);
  void keep_clamped(Node& n, double y) const;
  void keep_together(std::size_t first, std::size_t at, double y);
  void certify_span(std::size_t left, std::size_t right, double y);
  bool certify_part(const SpanRecord::Part& part, const Border& from, const Border& to,
                    SureLevels& sure) const;
  bool stays_before(Index face, Index other, const Border& at, double into, SureLevels& sure) const;
  void note_shown();
  void show(const Shown& shown, double y, std::vector<SpanPiece>& pieces);

  void learn();

  const FrontTable& table_;
  const FaceOrder& order_;
  const LooseEdges& edges_;
  const SolidExpression& expression_;
  SolidSweep sweep_;
  int levels_to_rest_ = 0, next_rest_ = 0;
  double credit_ = 0;                       ///< spans that were kept, less what it took
  std::size_t resolved_ = 0;                ///< spans, on the level in hand
  double y_ = HUGE_VAL, step_ = 0;          ///< the level before, and from that to the one in hand
  const LevelBands::Item* band_ = nullptr;  ///< the `near` of that
  double next_start_ = -HUGE_VAL, next_due_ = -HUGE_VAL;
  std::vector<Node> nodes_;
  std::vector<Index> free_;
  std::vector<Index> order_line_;  ///< nodes from left to right
  std::vector<double> x_;          ///< where they meet the level, while it is worked on
  std::vector<Shown> shown_;
  SpanRecord record_;
  std::vector<DepthDifference> crossings_;  ///< at which the parts of the record begin
  std::vector<Index> active_;
  std::vector<std::uint32_t> mark_;  ///< per face
  std::uint32_t turn_ = 0;
};

}  // namespace overstrike
