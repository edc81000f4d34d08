#include "core/geometry/near_pairs.h"

#include <algorithm>
#include <array>
#include <limits>

#include "core/geometry/polygon.h"

namespace overstrike {
namespace {

/// So few pairs are visited rather than halved.
constexpr std::size_t kFewPairs = 64;
/// Halving must leave at most this part of the pairs, or it is not worth its copies.
constexpr double kWorthwhile = 0.75;

/// Segments to halve along, in parts of those in hand; all but the first only where nothing else
/// was worthwhile. A prime, so that they fall on all kinds where loops repeat.
constexpr std::size_t kParts = 107, kTries[] = {53, 23, 79, 41, 67, 7, 97};

using Items = std::vector<Index>;

/// Whether a thing has a part before a cut, and behind it.
struct Sides {
  bool before = false, behind = false;
  void add(double side) { before = before || side < 0, behind = behind || side > 0; }
  bool neither() const { return !before && !behind; }
};

/// Along an axis or along a segment.
struct Cut {
  const Segment2* along = nullptr;
  int axis = 0;
  double at = 0;
  double pairs = std::numeric_limits<double>::infinity();  ///< that it leaves

  double side(const Vec2& p) const {
    return along != nullptr ? turn_of(along->from, along->to, p) : p[axis] - at;
  }
};

class Halving {
 public:
  /// Of two things that meet one has a part on each side of where they do, or both have one on the
  /// same: so squares are looked at as twice as large, and a segment that only reaches a cut has no
  /// part behind it.
  Halving(std::span<const Segment2> segments, std::span<const Vec2> points, double reach,
          const VisitPair& visit)
      : segments_(segments),
        points_(points),
        same_(points.empty()),
        reach_(2 * reach),
        visit_(visit) {}

  /// No points where segments are paired among themselves.
  void run(Items segments, Items points) {
    const double pairs = product(segments.size(), same_ ? segments.size() : points.size());
    const double enough = kWorthwhile * pairs;
    const Cut cut = pairs > kFewPairs ? best_cut(segments, points, enough) : Cut{};
    if (!(cut.pairs <= enough)) return visit_all(segments, points);
    std::array<Items, 2> s, p;
    for (const Index i : segments) share(sides_of(cut, segments_[i]), i, s);
    for (const Index i : points) share(sides_of(cut, points_[i]), i, p);
    segments = {}, points = {};
    for (const int side : {0, 1}) run(std::move(s[side]), std::move(p[side]));
  }

 private:
  static double product(std::size_t a, std::size_t b) {
    return static_cast<double>(a) * static_cast<double>(b);
  }

  static Sides sides_of(const Cut& cut, const Segment2& s) {
    Sides sides;
    sides.add(cut.side(s.from)), sides.add(cut.side(s.to));
    return sides;
  }
  Sides sides_of(const Cut& cut, const Vec2& point) const {
    Sides sides;
    for (const double x : {-reach_, reach_})
      for (const double y : {-reach_, reach_}) sides.add(cut.side(point + Vec2(x, y)));
    return sides;
  }
  /// What lies in a cut crosses only what has parts on both sides.
  static void share(const Sides& sides, Index i, std::array<Items, 2>& to) {
    if (sides.before || sides.neither()) to[0].push_back(i);
    if (sides.behind) to[1].push_back(i);
  }

  Cut best_cut(const Items& segments, const Items& points, double enough) {
    Cut best;
    const auto take = [&](Cut cut) {
      cut.pairs = pairs_left(cut, segments, points);
      if (cut.pairs < best.pairs) best = cut;
    };
    for (const int axis : {0, 1}) take({nullptr, axis, median(segments, axis)});
    for (std::size_t k = 0; k < std::size(kTries) && (k == 0 || best.pairs > enough); ++k)
      take({&segments_[segments[segments.size() * kTries[k] / kParts]]});
    return best;
  }

  /// Of the ends, as many things may begin at one.
  double median(const Items& segments, int axis) {
    ends_.clear();
    for (const Index i : segments)
      ends_.push_back(segments_[i].from[axis]), ends_.push_back(segments_[i].to[axis]);
    const auto half = ends_.begin() + static_cast<std::ptrdiff_t>(segments.size());
    std::nth_element(ends_.begin(), half, ends_.end());
    return *half;
  }

  double pairs_left(const Cut& cut, const Items& segments, const Items& points) const {
    std::size_t s[2]{}, p[2]{};
    const auto count = [](const Sides& sides, std::size_t* to) {
      to[0] += sides.before || sides.neither(), to[1] += sides.behind;
    };
    for (const Index i : segments) count(sides_of(cut, segments_[i]), s);
    if (same_) return product(s[0], s[0]) + product(s[1], s[1]);
    for (const Index i : points) count(sides_of(cut, points_[i]), p);
    return product(s[0], p[0]) + product(s[1], p[1]);
  }

  void visit_all(const Items& segments, const Items& points) const {
    const Items& others = same_ ? segments : points;
    for (std::size_t i = 0; i < segments.size(); ++i)
      for (std::size_t j = same_ ? i + 1 : 0; j < others.size(); ++j)
        visit_(segments[i], others[j]);
  }

  std::span<const Segment2> segments_;
  std::span<const Vec2> points_;
  bool same_;
  double reach_;
  const VisitPair& visit_;
  std::vector<double> ends_;
};

Items numbers_to(std::size_t count) {
  Items items(count);
  for (std::size_t i = 0; i < count; ++i) items[i] = static_cast<Index>(i);
  return items;
}

}  // namespace

void crossing_pairs(std::span<const Segment2> segments, const VisitPair& visit) {
  Halving(segments, {}, 0, visit).run(numbers_to(segments.size()), {});
}

void near_pairs(std::span<const Segment2> segments, std::span<const Vec2> points, double reach,
                const VisitPair& visit) {
  if (points.empty()) return;
  Halving(segments, points, reach, visit)
      .run(numbers_to(segments.size()), numbers_to(points.size()));
}

}  // namespace overstrike
