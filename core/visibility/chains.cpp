#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "core/geometry/polyline.h"
#include "core/visibility/pieces.h"

namespace overstrike {
namespace {

/// Ends nearer to each other than this part of the tolerance are one place: crossings that were
/// found from either of two lines differ by their rounding, and no device shows as little.
constexpr double kSamePlace = 1.0 / 1024;

auto group_of(const LinePiece& p) { return std::tie(p.body, p.kind, p.pen); }

bool before(const Vec2& a, const Vec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

/// One of the two ends of each piece: end 2 i is a, 2 i + 1 is b.
class Joints {
 public:
  /// Numbers places so that ends in one place have one number.
  Joints(const std::vector<LinePiece>& pieces, double same_place) {
    std::vector<Index> order(2 * pieces.size());
    std::iota(order.begin(), order.end(), 0);
    const auto at = [&](Index end) { return end & 1 ? pieces[end / 2].b : pieces[end / 2].a; };
    const auto smaller = [&](Index e, Index f) {
      const LinePiece &p = pieces[e / 2], &q = pieces[f / 2];
      if (group_of(p) != group_of(q)) return group_of(p) < group_of(q);
      return at(e) != at(f) ? before(at(e), at(f)) : e < f;
    };
    std::sort(order.begin(), order.end(), smaller);
    place_.assign(order.size(), kNowhere);
    for (std::size_t i = 0; i < order.size(); ++i) {
      const Index e = order[i];
      if (place_[e] == kNowhere) place_[e] = e;
      for (std::size_t k = i + 1; k < order.size(); ++k) {
        const Index f = order[k];
        if (group_of(pieces[e / 2]) != group_of(pieces[f / 2]) || at(f).x - at(e).x > same_place)
          break;
        if (place_[f] == kNowhere && std::fabs(at(f).y - at(e).y) <= same_place)
          place_[f] = place_[e];
      }
    }
    count_.assign(order.size(), 0);
    sum_.assign(order.size(), 0);
    for (Index e = 0; e < place_.size(); ++e) ++count_[place_[e]], sum_[place_[e]] += e;
  }

  /// The end that continues from end e, or kNowhere: only where just two meet.
  Index partner(Index e) const {
    return count_[place_[e]] == 2 ? static_cast<Index>(sum_[place_[e]] - e) : kNowhere;
  }
  static constexpr Index kNowhere = 0xFFFFFFFFu;

 private:
  std::vector<Index> place_, count_;
  std::vector<std::uint64_t> sum_;
};

/// A closed chain starts at its smallest point, towards the smaller neighbour; an open one at its
/// smaller end.
void set_in_order(std::vector<Vec2>& points) {
  if (points.front() != points.back()) {
    if (before(points.back(), points.front())) std::reverse(points.begin(), points.end());
    return;
  }
  points.pop_back();
  std::rotate(points.begin(), std::min_element(points.begin(), points.end(), before), points.end());
  if (points.size() > 1 && before(points.back(), points[1]))
    std::reverse(points.begin() + 1, points.end());
  points.push_back(points.front());
}

class Chainer {
 public:
  Chainer(const std::vector<LinePiece>& pieces, double tolerance)
      : pieces_(pieces),
        tolerance_(tolerance),
        joints_(pieces, tolerance * kSamePlace),
        used_(pieces.size(), 0) {}

  std::vector<Stroke> run() {
    for (Index i = 0; i < pieces_.size(); ++i)
      if (used_[i] == 0) strokes_.push_back(chain(i));
    std::sort(strokes_.begin(), strokes_.end(), smaller);
    return std::move(strokes_);
  }

 private:
  static bool smaller(const Stroke& s, const Stroke& t) {
    const auto key = [](const Stroke& x) { return std::tie(x.body, x.kind, x.pen); };
    if (key(s) != key(t)) return key(s) < key(t);
    return std::lexicographical_compare(s.points.begin(), s.points.end(), t.points.begin(),
                                        t.points.end(), before);
  }

  Vec2 at(Index end) const { return end & 1 ? pieces_[end / 2].b : pieces_[end / 2].a; }

  /// The end of a piece from which the chain of `piece` starts: walked back to, or any end of a
  /// closed one.
  Index start_of(Index piece) const {
    Index end = 2 * piece;
    for (;;) {
      const Index before_it = joints_.partner(end);
      if (before_it == Joints::kNowhere) return end;
      end = before_it ^ 1;
      if (end / 2 == piece) return 2 * piece;
    }
  }

  Stroke chain(Index piece) {
    const LinePiece& first = pieces_[piece];
    std::vector<Vec2> points;
    bool curved = true;
    double error = 0;
    const Index start = start_of(piece);
    Index end = start;
    while (end != Joints::kNowhere && used_[end / 2] == 0) {
      used_[end / 2] = 1;
      curved &= pieces_[end / 2].curved;
      error = std::max(error, pieces_[end / 2].error);
      if (points.empty() || points.back() != at(end)) points.push_back(at(end));
      points.push_back(at(end ^ 1));
      end = joints_.partner(end ^ 1);
    }
    if (end == start && points.back() != points.front()) points.push_back(points.front());
    set_in_order(points);
    return {simplified(points, curved ? tolerance_ : error), first.kind, first.body, first.pen,
            false};
  }

  const std::vector<LinePiece>& pieces_;
  double tolerance_;
  Joints joints_;
  std::vector<char> used_;
  std::vector<Stroke> strokes_;
};

}  // namespace

std::vector<Stroke> chained(const std::vector<LinePiece>& pieces, double tolerance) {
  return Chainer(pieces, tolerance).run();
}

}  // namespace overstrike
