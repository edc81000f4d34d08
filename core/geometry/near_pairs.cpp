#include "core/geometry/near_pairs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace overstrike {
namespace {

/// So few pairs are visited rather than halved.
constexpr std::size_t kFewPairs = 64;
/// Halving must leave at most this part of the pairs, or it is not worth its copies.
constexpr double kWorthwhile = 0.75;
/// Bound of the error of a projection n.x x + n.y y in doubles: two products and a sum, each within
/// 2^-53, and as much again for its ends' widening.
constexpr double kProjection = 8 * 0x1p-53;

struct Interval {
  double low, high;
  double middle() const { return low / 2 + high / 2; }
};

/// Holds the projections of all points within `reach` of a segment.
Interval across(const Vec2& normal, const Segment2& s, double reach) {
  const auto at = [&](const Vec2& p) { return normal.x * p.x + normal.y * p.y; };
  const auto size = [&](const Vec2& p) {
    return std::fabs(normal.x * p.x) + std::fabs(normal.y * p.y);
  };
  const double from = at(s.from), to = at(s.to);
  const double wide = reach * (std::fabs(normal.x) + std::fabs(normal.y));
  const double slack = wide + kProjection * (std::max(size(s.from), size(s.to)) + wide);
  return {std::min(from, to) - slack, std::max(from, to) + slack};
}

using Items = std::vector<Index>;

class Halving {
 public:
  Halving(std::span<const Segment2> a, std::span<const Segment2> b, double reach, bool same,
          const std::function<void(Index, Index)>& visit)
      : a_(a), b_(b), reach_(reach), same_(same), visit_(visit) {}

  /// `b` is empty where segments are paired among themselves.
  void run(Items a, Items b) {
    const double pairs = product(a.size(), same_ ? a.size() : b.size());
    const Cut cut = pairs > kFewPairs ? best_cut(a, b) : Cut{};
    if (!(cut.pairs <= kWorthwhile * pairs)) return visit_all(a, b);
    Items low, low_b, high, high_b;
    share(cut, a_, a, low, high);
    if (!same_) share(cut, b_, b, low_b, high_b);
    a = {}, b = {};
    run(std::move(low), std::move(low_b));
    run(std::move(high), std::move(high_b));
  }

 private:
  struct Cut {
    Vec2 normal{0};
    double at = 0;
    double pairs = std::numeric_limits<double>::infinity();  ///< that it leaves
  };

  static double product(std::size_t a, std::size_t b) {
    return static_cast<double>(a) * static_cast<double>(b);
  }

  Cut best_cut(const Items& a, const Items& b) {
    const Segment2& middle = a_[a[a.size() / 2]];
    const Vec2 along = middle.to - middle.from;
    const double size = std::max(std::fabs(along.x), std::fabs(along.y));
    Cut best;
    for (const Vec2& normal : {Vec2(1, 0), Vec2(0, 1), Vec2(-along.y, along.x) / size}) {
      if (!std::isfinite(normal.x)) continue;
      const Cut cut = median_cut(normal, a, b);
      if (cut.pairs < best.pairs) best = cut;
    }
    return best;
  }

  Cut median_cut(const Vec2& normal, const Items& a, const Items& b) {
    const auto project = [&](std::span<const Segment2> of, const Items& items,
                             std::vector<Interval>& out) {
      out.clear();
      for (const Index i : items) out.push_back(across(normal, of[i], reach_));
    };
    project(a_, a, of_a_);
    if (!same_) project(b_, b, of_b_);
    middles_.clear();
    for (const Interval& i : of_a_) middles_.push_back(i.middle());
    const auto half = middles_.begin() + static_cast<std::ptrdiff_t>(middles_.size() / 2);
    std::nth_element(middles_.begin(), half, middles_.end());
    const double at = *half;
    const auto count = [&](const std::vector<Interval>& of) {
      std::array<std::size_t, 2> sides{};
      for (const Interval& i : of) sides[0] += i.low <= at, sides[1] += i.high >= at;
      return sides;
    };
    const auto in_a = count(of_a_), in_b = same_ ? in_a : count(of_b_);
    return {normal, at, product(in_a[0], in_b[0]) + product(in_a[1], in_b[1])};
  }

  void share(const Cut& cut, std::span<const Segment2> of, const Items& items, Items& low,
             Items& high) const {
    for (const Index i : items) {
      const Interval interval = across(cut.normal, of[i], reach_);
      if (interval.low <= cut.at) low.push_back(i);
      if (interval.high >= cut.at) high.push_back(i);
    }
  }

  void visit_all(const Items& a, const Items& b) const {
    const Items& others = same_ ? a : b;
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t j = same_ ? i + 1 : 0; j < others.size(); ++j) visit_(a[i], others[j]);
  }

  std::span<const Segment2> a_, b_;
  double reach_;
  bool same_;
  const std::function<void(Index, Index)>& visit_;
  std::vector<Interval> of_a_, of_b_;
  std::vector<double> middles_;
};

Items numbers_to(std::size_t count) {
  Items items(count);
  for (std::size_t i = 0; i < count; ++i) items[i] = static_cast<Index>(i);
  return items;
}

}  // namespace

void near_pairs(std::span<const Segment2> a, std::span<const Segment2> b, double reach,
                const std::function<void(Index, Index)>& visit) {
  if (a.empty() || b.empty()) return;
  Halving(a, b, reach, false, visit).run(numbers_to(a.size()), numbers_to(b.size()));
}

void near_pairs(std::span<const Segment2> segments,
                const std::function<void(Index, Index)>& visit) {
  if (segments.empty()) return;
  Halving(segments, segments, 0, true, visit).run(numbers_to(segments.size()), {});
}

}  // namespace overstrike
