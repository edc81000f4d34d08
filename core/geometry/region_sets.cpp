#include "core/geometry/region_sets.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <vector>

#include "core/geometry/polygon.h"
#include "core/geometry/region_outlines.h"
#include "core/geometry/snap_rounding.h"
#include "core/scene/solid_expression.h"

namespace overstrike {
namespace {

constexpr Index kNone = 0xFFFFFFFFu;

struct OperandEdges {
  std::vector<Segment2> segments;
  std::vector<Index> operands;  ///< per segment
};

OperandEdges edges_of(std::span<const Region> operands) {
  OperandEdges edges;
  for (std::size_t o = 0; o < operands.size(); ++o)
    for (const Loop2& loop : operands[o].loops)
      for (std::size_t i = 0; i < loop.size(); ++i) {
        // A negative zero and zero are one coordinate.
        const Vec2 from = loop[i] + 0.0, to = loop[i + 1 == loop.size() ? 0 : i + 1] + 0.0;
        if (from == to) continue;
        edges.segments.push_back({from, to});
        edges.operands.push_back(static_cast<Index>(o));
      }
  return edges;
}

/// A piece between two sites, low < high, which is to the right, or upwards.
struct Piece2 {
  Index low, high;
  Index first_operand, end_operand;  ///< in Pieces::operands: those whose border it is
  Index first_source, end_source;    ///< in Pieces::sources
};

struct Pieces {
  std::vector<Piece2> list;  ///< in order of low, then high
  std::vector<Index> operands, sources;

  std::span<const Index> operands_of(const Piece2& p) const {
    return {operands.data() + p.first_operand, operands.data() + p.end_operand};
  }
  std::span<const Index> sources_of(const Piece2& p) const {
    return {sources.data() + p.first_source, sources.data() + p.end_source};
  }
};

/// One for all parts of edges that lie on one another. Of one operand an even number is no border.
Pieces pieces_of(const OperandEdges& edges, const SnapRounded& arrangement) {
  struct Part {
    Index low, high, operand, source;
  };
  std::vector<Part> parts;
  for (std::size_t s = 0; s < edges.segments.size(); ++s) {
    const std::span<const Index> path = arrangement.path(s);
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      const auto [low, high] = std::minmax(path[i], path[i + 1]);
      parts.push_back({low, high, edges.operands[s], static_cast<Index>(s)});
    }
  }
  std::sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) {
    return std::tie(a.low, a.high, a.operand, a.source) <
           std::tie(b.low, b.high, b.operand, b.source);
  });
  Pieces pieces;
  const auto at = [](const std::vector<Index>& v) { return static_cast<Index>(v.size()); };
  for (std::size_t i = 0; i < parts.size();) {
    Piece2 piece{parts[i].low, parts[i].high, at(pieces.operands), 0, at(pieces.sources), 0};
    const auto same = [&](const Part& p) { return p.low == piece.low && p.high == piece.high; };
    while (i < parts.size() && same(parts[i])) {
      const Index operand = parts[i].operand;
      bool odd = false;
      for (; i < parts.size() && same(parts[i]) && parts[i].operand == operand; ++i) {
        odd = !odd;
        pieces.sources.push_back(parts[i].source);
      }
      if (odd) pieces.operands.push_back(operand);
    }
    piece.end_operand = at(pieces.operands), piece.end_source = at(pieces.sources);
    if (piece.first_operand != piece.end_operand) pieces.list.push_back(piece);
  }
  return pieces;
}

/// Finds what lies just below each piece, by a sweep to the right over the sites.
class Sweep2 {
 public:
  Sweep2(const Pieces& pieces, const SnapRounded& arrangement)
      : pieces_(pieces.list), at_(arrangement.middles), active_(Below{*this}) {}

  /// Per piece the one below, or kNone.
  std::vector<Index> run() {
    std::vector<Index> ending(pieces_.size());
    for (Index i = 0; i < pieces_.size(); ++i) ending[i] = i;
    std::sort(ending.begin(), ending.end(), [&](Index a, Index b) {
      return std::tie(pieces_[a].high, a) < std::tie(pieces_[b].high, b);
    });
    places_.resize(pieces_.size());
    std::vector<Index> below(pieces_.size(), kNone), starting;
    std::size_t ended = 0;
    for (Index i = 0; i < pieces_.size();) {
      const Index site = pieces_[i].low;
      for (; ended < ending.size() && pieces_[ending[ended]].high <= site; ++ended)
        active_.erase(places_[ending[ended]]);
      starting.clear();
      for (; i < pieces_.size() && pieces_[i].low == site; ++i) starting.push_back(i);
      std::sort(starting.begin(), starting.end(), Below{*this});
      for (const Index piece : starting) {
        places_[piece] = active_.insert(piece).first;
        if (places_[piece] != active_.begin()) below[piece] = *std::prev(places_[piece]);
      }
    }
    return below;
  }

 private:
  /// The order upwards of pieces that the line of sweeping meets. It leans to the left by a hair.
  struct Below {
    const Sweep2& sweep;
    bool operator()(Index a, Index b) const {
      const Piece2 &p = sweep.pieces_[a], &q = sweep.pieces_[b];
      if (a == b) return false;
      if (p.low < q.low) return sweep.side(p, q.low) > 0;
      if (q.low < p.low) return sweep.side(q, p.low) < 0;
      return sweep.side(p, q.high) > 0;
    }
  };

  int side(const Piece2& piece, Index site) const {
    return turn_of(at_[piece.low], at_[piece.high], at_[site]);
  }

  const std::vector<Piece2>& pieces_;
  const std::vector<Vec2>& at_;
  std::set<Index, Below> active_;
  std::vector<std::set<Index, Below>::iterator> places_;
};

/// Evaluates the expression on both sides of every piece, going from each to those above it.
class Evaluation {
 public:
  Evaluation(const Pieces& pieces, const std::vector<Index>& below,
             const SolidExpression& expression)
      : pieces_(pieces), state_(expression), order_(pieces.list.size()) {
    first_above_.assign(below.size() + 2, 0);
    for (const Index b : below) ++first_above_[slot(b) + 1];
    for (std::size_t i = 1; i < first_above_.size(); ++i) first_above_[i] += first_above_[i - 1];
    std::vector<Index> place = first_above_;
    for (Index i = 0; i < below.size(); ++i) order_[place[slot(below[i])]++] = i;
  }

  std::vector<Border> run() {
    struct Open {
      Index piece, next, end;
    };
    std::vector<Open> open;
    const auto go_above = [&](Index piece) {
      open.push_back({piece, first_above_[slot(piece)], first_above_[slot(piece) + 1]});
    };
    go_above(kNone);
    while (!open.empty()) {
      Open& top = open.back();
      if (top.next < top.end) {
        const Index piece = order_[top.next++];
        pass(piece, true);
        go_above(piece);
      } else {
        if (top.piece != kNone) pass(top.piece, false);
        open.pop_back();
      }
    }
    return std::move(borders_);
  }

 private:
  /// Where a piece's own list is; the first is for what has none below.
  static std::size_t slot(Index piece) { return piece == kNone ? 0 : piece + std::size_t{1}; }

  void pass(Index piece, bool upwards) {
    const Piece2& p = pieces_.list[piece];
    const bool below = state_.inside();
    for (const Index operand : pieces_.operands_of(p)) state_.flip(operand);
    const bool above = state_.inside();
    if (!upwards || below == above) return;
    borders_.push_back(above ? Border{p.low, p.high, pieces_.sources_of(p)}
                             : Border{p.high, p.low, pieces_.sources_of(p)});
  }

  const Pieces& pieces_;
  SolidExpression::State state_;
  std::vector<Index> first_above_, order_;  ///< pieces by the one below them
  std::vector<Border> borders_;
};

}  // namespace

Region resolve(std::span<const SolidNode> nodes, std::span<const Region> operands) {
  const OperandEdges edges = edges_of(operands);
  const SnapRounded arrangement = snap_round(edges.segments);
  const Pieces pieces = pieces_of(edges, arrangement);
  const std::vector<Index> below = Sweep2(pieces, arrangement).run();
  const SolidExpression expression(nodes, static_cast<Index>(operands.size()));
  return outlines_of(Evaluation(pieces, below, expression).run(), arrangement);
}

Region combine(SetOperation operation, std::span<const Region> operands) {
  const Index count = static_cast<Index>(operands.size());
  std::vector<SolidNode> nodes{{operation, 0, count + 1}};
  for (Index i = 0; i < count; ++i) nodes.push_back({SetOperation::operand, i, i + 2});
  return resolve(nodes, operands);
}

}  // namespace overstrike
