#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "core/visibility/cell_grid.h"
#include "core/visibility/intervals.h"
#include "core/visibility/pieces.h"

namespace overstrike {
namespace {

/// Both lines of a pair are moved by their errors, at either end.
constexpr double kErrorsOfPair = 4;

int rank_of(StrokeKind kind) {
  switch (kind) {
    case StrokeKind::contour:
      return 0;
    case StrokeKind::cut_outline:
      return 1;
    case StrokeKind::crease:
      return 2;
    case StrokeKind::intersection:
      return 3;
    case StrokeKind::shadow_outline:
      return 4;
    case StrokeKind::pattern:
      return 5;
    case StrokeKind::segment:
      break;
  }
  return 6;
}

double length_of(const LinePiece& p) { return std::sqrt(glm::dot(p.b - p.a, p.b - p.a)); }

/// Distance of p from the straight line through a piece.
double off_line(const LinePiece& line, double length, const Vec2& p) {
  const Vec2 along = line.b - line.a, v = p - line.a;
  return std::fabs(along.x * v.y - along.y * v.x) / length;
}

class Merger {
 public:
  Merger(std::vector<LinePiece> pieces, const Grid& grid)
      : pieces_(std::move(pieces)),
        cells_(grid.columns, grid.rows, pieces_.size()),
        kept_in_(cells_.size()),
        stamp_(1, 0) {}

  std::vector<LinePiece> run() {
    std::vector<Index> order(pieces_.size());
    std::iota(order.begin(), order.end(), 0);
    for (const LinePiece& p : pieces_) lengths_.push_back(length_of(p));
    std::sort(order.begin(), order.end(), [&](Index p, Index q) { return key(p) < key(q); });
    stamp_.assign(pieces_.size(), kNever);
    for (const Index p : order) add(p);
    return std::move(kept_);
  }

 private:
  static constexpr Index kNever = 0xFFFFFFFFu;

  /// The smaller goes before.
  std::array<double, 8> key(Index p) const {
    const LinePiece& piece = pieces_[p];
    const auto [low, high] =
        std::minmax({std::pair(piece.a.x, piece.a.y), std::pair(piece.b.x, piece.b.y)});
    return {static_cast<double>(rank_of(piece.kind)),
            -lengths_[p],
            static_cast<double>(piece.rank),
            low.first,
            low.second,
            high.first,
            high.second,
            static_cast<double>(piece.pen)};
  }

  double reach(const LinePiece& p, const LinePiece& q) const {
    return kErrorsOfPair * (p.error + q.error);
  }

  /// Keeps what of the piece no kept one covers.
  void add(Index p) {
    const LinePiece& piece = pieces_[p];
    if (!(lengths_[p] > reach(piece, piece))) return;
    Intervals covered;
    cells_.along(piece.a, piece.b, reach(piece, piece), [&](std::size_t cell) {
      for (const Index q : kept_in_[cell])
        if (stamp_[q] != p) {
          stamp_[q] = p;
          cover(p, q, covered);
        }
      return true;
    });
    unite(covered);
    const double sliver = reach(piece, piece) / lengths_[p];
    bool any = false;
    for (const Interval& part : without({0, 1}, covered, sliver)) {
      LinePiece left = piece;
      if (part.first > 0) left.a = piece.a + (piece.b - piece.a) * part.first;
      if (part.second < 1) left.b = piece.a + (piece.b - piece.a) * part.second;
      kept_.push_back(left);
      any = true;
    }
    if (!any) return;
    cells_.along(piece.a, piece.b, reach(piece, piece), [&](std::size_t cell) {
      kept_in_[cell].push_back(p);
      return true;
    });
  }

  /// The part of p that lies on q: the shorter one's ends are measured against the longer one.
  void cover(Index p, Index q, Intervals& covered) const {
    const LinePiece &a = pieces_[p], &b = pieces_[q];
    const bool longer = lengths_[p] > lengths_[q];
    const LinePiece &line = longer ? a : b, &other = longer ? b : a;
    const double length = std::max(lengths_[p], lengths_[q]), near = reach(a, b);
    if (off_line(line, length, other.a) > near || off_line(line, length, other.b) > near) return;
    const Vec2 along = a.b - a.a;
    const double square = glm::dot(along, along);
    const double s = glm::dot(along, b.a - a.a) / square, t = glm::dot(along, b.b - a.a) / square;
    covered.emplace_back(std::max(0.0, std::min(s, t)), std::min(1.0, std::max(s, t)));
  }

  std::vector<LinePiece> pieces_;
  CellGrid cells_;
  std::vector<std::vector<Index>> kept_in_;
  std::vector<double> lengths_;
  std::vector<Index> stamp_;
  std::vector<LinePiece> kept_;
};

}  // namespace

std::vector<LinePiece> merged(std::vector<LinePiece> pieces, const Grid& grid) {
  return Merger(std::move(pieces), grid).run();
}

}  // namespace overstrike
