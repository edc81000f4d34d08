#include "core/geometry/snap_rounding.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/geometry/expansion.h"
#include "core/geometry/polygon.h"

namespace overstrike {
namespace {

bool before(const Vec2& a, const Vec2& b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); }

/// Why a square is hot.
struct Heat {
  Vec2 middle;
  bool crossing;
  Vec2 point;
};

bool before(const Heat& a, const Heat& b) {
  if (a.middle != b.middle) return before(a.middle, b.middle);
  return a.crossing != b.crossing ? b.crossing : before(a.point, b.point);
}

/// Their insides have one point in common.
bool cross(const Segment2& e, const Segment2& f) {
  const auto apart = [](double a, double b, double c, double d) {
    return std::max(a, b) < std::min(c, d) || std::max(c, d) < std::min(a, b);
  };
  if (apart(e.from.x, e.to.x, f.from.x, f.to.x) || apart(e.from.y, e.to.y, f.from.y, f.to.y))
    return false;
  return turn_of(f.from, f.to, e.from) * turn_of(f.from, f.to, e.to) < 0 &&
         turn_of(e.from, e.to, f.from) * turn_of(e.from, e.to, f.to) < 0;
}

/// The lattice, coordinate by coordinate.
class Squares {
 public:
  explicit Squares(double side) : side_(side) {}

  double middle_of(double x) const { return std::floor(x / side_ + 0.5) * side_; }
  Vec2 middle_of(const Vec2& p) const { return {middle_of(p.x), middle_of(p.y)}; }

  /// Of over / under, which is about `near`: exactly.
  double middle_of(const Expansion& over, const Expansion& under, double near) const {
    double middle = middle_of(near);
    const auto is_below = [&](double border) {
      return (over - Expansion(border) * under).sign() * under.sign() < 0;
    };
    while (is_below(middle - side_ / 2)) middle -= side_;
    while (!is_below(middle + side_ / 2)) middle += side_;
    return middle;
  }
  double within(double middle, double x) const {
    return std::clamp(x, middle - side_ / 2, middle + side_ / 2);
  }

 private:
  double side_;
};

/// Where two segments cross. Precondition: e.from before e.to, f.from before f.to, and e first in
/// order, so that the result is the same whatever they were given as.
Heat crossing_of(const Segment2& e, const Segment2& f, const Squares& squares) {
  const auto minus = [](double a, double b) { return Expansion(a) - Expansion(b); };
  const Expansion x = minus(e.to.x, e.from.x), y = minus(e.to.y, e.from.y);
  const Expansion fx = minus(f.to.x, f.from.x), fy = minus(f.to.y, f.from.y);
  const Expansion under = x * fy - y * fx;
  const Expansion part = minus(f.from.x, e.from.x) * fy - minus(f.from.y, e.from.y) * fx;
  const Expansion over_x = Expansion(e.from.x) * under + x * part;
  const Expansion over_y = Expansion(e.from.y) * under + y * part;
  Heat heat{Vec2(0), true, Vec2(0)};
  const double divisor = under.approximate();
  const auto set = [&](double e0, double e1, double f0, double f1, const Expansion& over,
                       double& point, double& middle) {
    point = e0 == e1 ? e0 : f0 == f1 ? f0 : over.approximate() / divisor;
    middle = squares.middle_of(over, under, point);
    point = squares.within(middle, point);
  };
  set(e.from.x, e.to.x, f.from.x, f.to.x, over_x, heat.point.x, heat.middle.x);
  set(e.from.y, e.to.y, f.from.y, f.to.y, over_y, heat.point.y, heat.middle.y);
  return heat;
}

class Rounder {
 public:
  explicit Rounder(std::span<const Segment2> segments)
      : segments_(segments), squares_(result_.side = side_for(segments)) {}

  SnapRounded run() {
    for (const Segment2& s : segments_)
      for (const Vec2& p : {s.from, s.to}) heats_.push_back({squares_.middle_of(p), false, p});
    add_crossings();
    keep_sites();
    lead();
    return std::move(result_);
  }

 private:
  static double side_for(std::span<const Segment2> segments) {
    double reach = 0;
    for (const Segment2& s : segments)
      for (const Vec2& p : {s.from, s.to})
        reach = std::max({reach, std::fabs(p.x), std::fabs(p.y)});
    // Middles reach to twice the power of two below the largest coordinate, and their borders half
    // a side beyond: there a last place is 2^-51 of that power.
    return reach == 0 ? 1 : std::ldexp(1.0, std::ilogb(reach) - 50);
  }

  void add_crossings() {
    near_pairs(segments_, [&](Index i, Index j) {
      if (!cross(segments_[i], segments_[j])) return;
      Segment2 e = segments_[i], f = segments_[j];
      for (Segment2* s : {&e, &f})
        if (before(s->to, s->from)) std::swap(s->from, s->to);
      if (e.from == f.from ? before(f.to, e.to) : before(f.from, e.from)) std::swap(e, f);
      heats_.push_back(crossing_of(e, f, squares_));
    });
  }

  void keep_sites() {
    std::sort(heats_.begin(), heats_.end(),
              [](const Heat& a, const Heat& b) { return before(a, b); });
    for (const Heat& h : heats_) {
      if (!result_.middles.empty() && result_.middles.back() == h.middle) continue;
      result_.middles.push_back(h.middle);
      result_.points.push_back(h.point);
    }
  }

  void lead() {
    std::vector<Segment2> sites;
    for (const Vec2& m : result_.middles) sites.push_back({m, m});
    std::vector<std::pair<Index, Index>> passed;
    near_pairs(segments_, sites, result_.side / 2, [&](Index s, Index site) {
      if (passes(segments_[s], result_.middles[site], result_.side)) passed.emplace_back(s, site);
    });
    std::sort(passed.begin(), passed.end());
    passed.erase(std::unique(passed.begin(), passed.end()), passed.end());
    for (std::size_t s = 0, at = 0; s < segments_.size(); ++s) {
      const std::size_t first = result_.path_sites.size();
      for (; at < passed.size() && passed[at].first == s; ++at)
        result_.path_sites.push_back(passed[at].second);
      sort_along(segments_[s], first);
      result_.path_ends.push_back(result_.path_sites.size());
    }
  }

  /// Of the two squares that a segment passes at one step of the coordinate in which it is longer,
  /// the one first that is first in the other.
  void sort_along(const Segment2& s, std::size_t first) {
    const Vec2 along = s.to - s.from;
    const bool by_x = std::fabs(along.x) >= std::fabs(along.y);
    const auto key = [&](Index i) {
      const Vec2& m = result_.middles[i];
      const double x = along.x < 0 ? -m.x : m.x, y = along.y < 0 ? -m.y : m.y;
      return by_x ? std::pair(x, y) : std::pair(y, x);
    };
    std::sort(result_.path_sites.begin() + static_cast<std::ptrdiff_t>(first),
              result_.path_sites.end(), [&](Index i, Index j) { return key(i) < key(j); });
  }

  std::span<const Segment2> segments_;
  SnapRounded result_;
  Squares squares_;
  std::vector<Heat> heats_;
};

}  // namespace

bool passes(const Segment2& s, const Vec2& middle, double side) {
  const Vec2 low = middle - side / 2, high = middle + side / 2;
  if (std::max(s.from.x, s.to.x) < low.x || std::min(s.from.x, s.to.x) >= high.x) return false;
  if (std::max(s.from.y, s.to.y) < low.y || std::min(s.from.y, s.to.y) >= high.y) return false;
  // Of the corners farthest to either side of the line only the lower left one is in the square.
  const bool rises =
      (s.to.x > s.from.x) == (s.to.y > s.from.y) && s.to.x != s.from.x && s.to.y != s.from.y;
  if (rises)
    return turn_of(s.from, s.to, {low.x, high.y}) * turn_of(s.from, s.to, {high.x, low.y}) < 0;
  const int corner = turn_of(s.from, s.to, low);
  return corner == 0 || corner * turn_of(s.from, s.to, high) < 0;
}

SnapRounded snap_round(std::span<const Segment2> segments) { return Rounder(segments).run(); }

}  // namespace overstrike
