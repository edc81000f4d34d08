#include "core/visibility/kept_stretch.h"

#include <algorithm>

namespace overstrike {
namespace {

SlackLine line_of(const FrontSide& s) { return {s.x0, s.y0, s.y1, s.slope, s.slack}; }

/// The difference of two depths over the grid, linear but for rounding of at most `error` within
/// the columns and levels.
struct Difference {
  double a, b, c, error;

  Difference(const DepthPlane& p, const DepthPlane& q, double columns, double levels)
      : a(p.a - q.a),
        b(p.b - q.b),
        c(p.c - q.c),
        error((p.ea + q.ea) * columns + (p.eb + q.eb) * levels + (p.ec + q.ec)) {}
  double at(double x, double y) const { return a * x + b * y + c; }
  /// The levels' own comparison must come out the same: what it computes is off by `error` here and
  /// there, and takes `error` for doubt; its place by the slack of the line at either level.
  double margin(double slack) const { return 3 * error + 2 * std::fabs(a) * slack; }
};

}  // namespace

/// True when value(y), linear but for rounding that the margin covers, is at least the margin from
/// y_ to until_, after until_ was brought nearer where need be.
template <class Value>
bool StretchKeeper::certify(double margin, const Value& value) {
  const double now = value(y_);
  if (!(now >= margin)) return false;
  constexpr int kMostTurns = 4;
  for (int turn = 0; turn < kMostTurns; ++turn) {
    const double then = value(until_);
    if (then >= margin) return true;
    // A little before the level where the margin is reached.
    constexpr double kLittle = 0x1p-10;
    until_ = y_ + (until_ - y_) * ((now - margin) / (now - then) - kLittle);
    if (!(until_ >= least_)) return false;
  }
  return false;
}

/// Each x_at is off by less than its slack, here and there.
bool StretchKeeper::apart(const SlackLine& a, const SlackLine& b) {
  return certify(3 * (a.slack + b.slack), [&](double y) { return b.x_at(y) - a.x_at(y); });
}

double StretchKeeper::keep(double y, double least, const SlackLine& left, const SlackLine& right,
                           std::span<const std::span<const FrontSide>> fronts,
                           std::vector<KeptPiece>& pieces) {
  y_ = y, least_ = least;
  first_piece_ = pieces.size();
  bool sure = begin(left, right, fronts);
  for (SlackLine from = left; sure;) {
    const Passing* first = nullptr;
    for (const Passing& p : passing_)
      if (p.next() != nullptr && (first == nullptr || p.next()->x_at(y_) < first->next()->x_at(y_)))
        first = &p;
    const bool inside = first != nullptr && first->next()->x_at(y_) < right.x_at(y_);
    const SlackLine to = inside ? line_of(*first->next()) : right;
    sure = apart(from, to) && span(from, to, pieces);
    if (!inside) {
      // Sides beyond stay there.
      for (const Passing& p : passing_)
        sure = sure && (p.next() == nullptr || apart(right, line_of(*p.next())));
      break;
    }
    ++passing_[static_cast<std::size_t>(first - passing_.data())].at;
    from = to;
  }
  if (sure && until_ >= least_) return until_;
  pieces.resize(first_piece_);
  return -HUGE_VAL;
}

/// Finds the sides at which the stretch begins, and until when the sides in it and those next to it
/// are there. Fronts do not change between sides that stay.
bool StretchKeeper::begin(const SlackLine& left, const SlackLine& right,
                          std::span<const std::span<const FrontSide>> fronts) {
  passing_.clear();
  until_ = std::min(left.y1, right.y1);
  const double x0 = left.x_at(y_), x1 = right.x_at(y_);
  for (const std::span<const FrontSide> sides : fronts) {
    Passing p{sides, 0};
    while (p.next() != nullptr && p.next()->x_at(y_) <= x0) ++p.at;
    passing_.push_back(p);
    until_ = std::min(until_, sides[p.at].y1);
    do until_ = std::min(until_, sides[++p.at].y1);
    while (p.at + 1 < sides.size() && sides[p.at].x_at(y_) < x1);
  }
  return until_ >= least_ && std::all_of(passing_.begin(), passing_.end(),
                                         [&](const Passing& p) { return stays_before(left, p); });
}

/// Sides before the one in hand are left of it but for their slack.
bool StretchKeeper::stays_before(const SlackLine& left, const Passing& passing) {
  if (passing.at == 0) return true;
  SlackLine last = line_of(passing.sides[passing.at]);
  for (std::size_t i = 0; i < passing.at; ++i)
    last.slack = std::max(last.slack, passing.sides[i].slack);
  return apart(last, left);
}

Index StretchKeeper::nearest(const SlackLine& line, double offset) const {
  const double x = line.x_at(y_) + offset;
  Index best = passing_[0].face();
  for (const Passing& p : std::span(passing_).subspan(1))
    if (order_.in_front(p.face(), best, x, y_)) best = p.face();
  return best;
}

/// On the line, moved by the offset, doubles tell that `face` lies before `other`, though the place
/// be off by the slack.
bool StretchKeeper::surely_before(Index face, Index other, const SlackLine& line, double offset,
                                  double slack) {
  const Difference d(order_.depth_of(face), order_.depth_of(other), columns_, levels());
  return certify(d.margin(slack), [&](double y) { return d.at(line.x_at(y) + offset, y); });
}

/// `face`, which is now seen before `other` there, stays so.
bool StretchKeeper::before(Index face, Index other, const SlackLine& line, double offset) {
  if (order_.plane_of(face) == order_.plane_of(other)) return true;
  const double until = until_;
  if (surely_before(face, other, line, offset, line.slack)) return true;
  // Where the line is an edge in which the faces touch, what is exact half as far from it is so
  // everywhere farther, the rounding of x_at being less than a quarter of the slack.
  until_ = until;
  return order_.compare(face, other, line.x_at(y_) + offset / 2, y_) > 0 &&
         order_.compare(face, other, line.x_at(until_) + offset / 2, until_) > 0;
}

bool StretchKeeper::before_all(Index face, const SlackLine& line, double offset) {
  return std::all_of(passing_.begin(), passing_.end(), [&](const Passing& p) {
    return p.face() == face || before(face, p.face(), line, offset);
  });
}

/// The same where the depth of `face` is that of `other`.
bool StretchKeeper::before_all_at_crossing(Index face, Index other, double slack) {
  const Difference crossing(order_.depth_of(face), order_.depth_of(other), columns_, levels());
  for (const Passing& p : passing_) {
    const Index plane = order_.plane_of(p.face());
    if (plane == order_.plane_of(face) || plane == order_.plane_of(other)) continue;
    const Difference d(order_.depth_of(face), order_.depth_of(p.face()), columns_, levels());
    const auto value = [&](double y) {
      return d.at(-(crossing.b * y + crossing.c) / crossing.a, y);
    };
    if (!certify(d.margin(slack + crossing.error / std::fabs(crossing.a)), value)) return false;
  }
  return true;
}

/// Sides of what is hidden are no borders.
void StretchKeeper::show(Index face, const SlackLine& end, Index next,
                         std::vector<KeptPiece>& pieces) const {
  if (pieces.size() > first_piece_ && pieces.back().face == face) pieces.pop_back();
  pieces.push_back({end, face, next});
}

/// One piece or two.
bool StretchKeeper::span(const SlackLine& from, const SlackLine& to,
                         std::vector<KeptPiece>& pieces) {
  if (passing_.size() == 1) {
    show(passing_[0].face(), to, kNone, pieces);
    return true;
  }
  const Index first = nearest(from, from.slack), last = nearest(to, -to.slack);
  if (first == last) {
    show(first, to, kNone, pieces);
    return before_all(first, from, from.slack) && before_all(first, to, -to.slack);
  }
  show(first, {}, last, pieces);
  show(last, to, kNone, pieces);
  // FaceOrder::crossing may be off by so much. Of two crossings the nearer must come out first,
  // and none before the ends.
  return surely_before(first, last, from, from.slack, from.slack + kCrossingError) &&
         surely_before(last, first, to, -to.slack, to.slack + kCrossingError) &&
         before_all(first, from, from.slack) && before_all(last, to, -to.slack) &&
         before_all_at_crossing(first, last, 2 * kCrossingError);
}

}  // namespace overstrike
