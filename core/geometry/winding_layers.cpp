#include "core/geometry/winding_layers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "core/geometry/polygon.h"

namespace overstrike {
namespace {

/// Lines of sweeping, from below and on them from the left: a level edge rises, too.
bool below(const Vec2& a, const Vec2& b) { return std::tie(a.y, a.x) < std::tie(b.y, b.x); }

bool within_box(const Vec2& p, const Vec2& a, const Vec2& b) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

/// The points of the outlines and the pieces between them, divided until pieces meet in ends only.
class Arrangement {
 public:
  Arrangement(const std::vector<Vec3>& points, const std::vector<DirectedEdge>& edges,
              const FlatAxes& axes)
      : points_(points), axes_(axes) {
    for (const DirectedEdge& e : edges) paths_.push_back({at(e.from), at(e.to)});
    // Pieces that leave a point in nearly one direction may be divided at the next double in each
    // round: what is left then crosses within the last places, and its windings are found all the
    // same.
    constexpr int kMostRounds = 8;
    for (int round = 0; round < kMostRounds && divide(); ++round) continue;
  }

  Vec2 flat(Index i) const { return axes_(points_[i]); }
  std::vector<Vec3>& points() { return points_; }
  std::vector<std::vector<Index>>& paths() { return paths_; }

 private:
  /// A piece of a path, between its points `step` and step + 1.
  struct Piece {
    Index a, b;
    Vec2 p, q;
    std::size_t path, step;
    double low() const { return std::min(p.x, q.x); }
    double high() const { return std::max(p.x, q.x); }
  };
  /// `point` divides the piece; in order of pieces, then along them.
  struct Division {
    std::size_t path, step;
    double along;
    Index point;
    bool operator<(const Division& o) const {
      return std::tie(path, step, along, point) < std::tie(o.path, o.step, o.along, o.point);
    }
  };

  Index at(Index point) {
    const Vec2 p = flat(point);
    return first_at_.try_emplace({p.x, p.y}, point).first->second;
  }

  std::vector<Piece> pieces() const {
    std::vector<Piece> made;
    for (std::size_t path = 0; path < paths_.size(); ++path)
      for (std::size_t i = 0; i + 1 < paths_[path].size(); ++i) {
        const Index a = paths_[path][i], b = paths_[path][i + 1];
        if (a != b) made.push_back({a, b, flat(a), flat(b), path, i});
      }
    std::stable_sort(made.begin(), made.end(),
                     [](const Piece& e, const Piece& f) { return e.low() < f.low(); });
    return made;
  }

  /// One round; false when nothing was divided. Paths stay monotone in x and in y, between
  /// the ends of their edges, and there are only so many doubles: rounds come to an end. (As a rule
  /// after the first or the second.)
  bool divide() {
    const std::vector<Piece> all = pieces();
    std::vector<Division> divisions;
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < all.size(); ++i) {
      std::erase_if(open, [&](std::size_t j) { return all[j].high() < all[i].low(); });
      for (const std::size_t j : open) find_contacts(all[j], all[i], divisions);
      open.push_back(i);
    }
    std::sort(divisions.begin(), divisions.end());
    // From the back, so that the steps in front keep their numbers.
    bool divided = false;
    std::size_t end = divisions.size();
    while (end > 0) {
      std::size_t begin = end - 1;
      const auto same = [&](const Division& d) {
        return d.path == divisions[end - 1].path && d.step == divisions[end - 1].step;
      };
      while (begin > 0 && same(divisions[begin - 1])) --begin;
      divided |= insert(std::span(divisions).subspan(begin, end - begin));
      end = begin;
    }
    return divided;
  }

  /// Rounding may put two points of a piece into an order that is not that of both coordinates: the
  /// second one is left for the next round.
  bool insert(std::span<const Division> divisions) {
    std::vector<Index>& path = paths_[divisions[0].path];
    const std::size_t step = divisions[0].step;
    std::vector<Index> between;
    Vec2 last = flat(path[step]);
    const Vec2 end = flat(path[step + 1]);
    for (const Division& d : divisions) {
      const Vec2 p = flat(d.point);
      if (p == last || !within_box(p, last, end)) continue;
      between.push_back(d.point);
      last = p;
    }
    path.insert(path.begin() + static_cast<std::ptrdiff_t>(step) + 1, between.begin(),
                between.end());
    return !between.empty();
  }

  void find_contacts(const Piece& e, const Piece& f, std::vector<Division>& out) {
    if (std::max(e.p.y, e.q.y) < std::min(f.p.y, f.q.y)) return;
    if (std::max(f.p.y, f.q.y) < std::min(e.p.y, e.q.y)) return;
    const int ep = turn_of(f.p, f.q, e.p), eq = turn_of(f.p, f.q, e.q);
    if (ep * eq > 0) return;
    const int fp = turn_of(e.p, e.q, f.p), fq = turn_of(e.p, e.q, f.q);
    if (ep * eq < 0 && fp * fq < 0) {
      const Index point = crossing(e, f);
      divide_at(e, point, out), divide_at(f, point, out);
      return;
    }
    if (ep == 0) divide_at(f, e.a, out);
    if (eq == 0) divide_at(f, e.b, out);
    if (fp == 0) divide_at(e, f.a, out);
    if (fq == 0) divide_at(e, f.b, out);
  }

  void divide_at(const Piece& e, Index point, std::vector<Division>& out) const {
    const Vec2 p = flat(point);
    if (point == e.a || point == e.b || !within_box(p, e.p, e.q)) return;
    out.push_back({e.path, e.step, std::fabs(p.x - e.p.x) + std::fabs(p.y - e.p.y), point});
  }

  /// Where they cross, rounded, and not outside of what both reach.
  Index crossing(const Piece& e, const Piece& f) {
    const Vec2 along = e.q - e.p, other = f.q - f.p, between = f.p - e.p;
    const double part =
        (between.x * other.y - between.y * other.x) / (along.x * other.y - along.y * other.x);
    Vec3 point = points_[e.a] + (points_[e.b] - points_[e.a]) * part;
    for (const int axis : {axes_.x, axes_.y}) {
      const auto [e_low, e_high] = std::minmax(points_[e.a][axis], points_[e.b][axis]);
      const auto [f_low, f_high] = std::minmax(points_[f.a][axis], points_[f.b][axis]);
      point[axis] = std::clamp(point[axis], std::max(e_low, f_low), std::min(e_high, f_high));
    }
    const Index fresh = static_cast<Index>(points_.size());
    points_.push_back(point);
    const Index first = at(fresh);
    if (first != fresh) points_.pop_back();
    return first;
  }

  std::vector<Vec3> points_;
  FlatAxes axes_;
  std::map<std::pair<double, double>, Index> first_at_;
  std::vector<std::vector<Index>> paths_;
};

/// A piece of border, that w is higher on the left of by `step` > 0.
struct Border {
  Index from, to;
  int step;
  int right;  ///< w on its right
};

/// What is left where pieces lie on one another.
std::vector<Border> borders_of(const std::vector<std::vector<Index>>& paths) {
  std::map<std::pair<Index, Index>, int> net;
  for (const std::vector<Index>& path : paths)
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
      const Index a = path[i], b = path[i + 1];
      if (a != b) net[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  std::vector<Border> borders;
  for (const auto& [ends, step] : net) {
    if (step > 0) borders.push_back({ends.first, ends.second, step, 0});
    if (step < 0) borders.push_back({ends.second, ends.first, -step, 0});
  }
  std::sort(borders.begin(), borders.end(), [](const Border& a, const Border& b) {
    return std::tie(a.from, a.to) < std::tie(b.from, b.to);
  });
  return borders;
}

/// Finds w beside every border.
class Windings {
 public:
  Windings(const Arrangement& at, std::vector<Border>& borders) : at_(at), borders_(borders) {}

  void find() {
    std::map<Index, int> reached;
    for (const Border& b : borders_) ++reached[b.to];
    std::vector<bool> known(borders_.size(), false);
    for (std::size_t i = 0; i < borders_.size(); ++i) {
      if (known[i]) continue;
      const int right = beside(borders_[i]);
      // It stays the same along a chain, until borders branch.
      for (std::size_t k = i; k < borders_.size() && !known[k]; k = next(k, reached)) {
        known[k] = true;
        borders_[k].right = right;
      }
    }
  }

 private:
  /// The only border that goes on where k ends, or the number of borders.
  std::size_t next(std::size_t k, const std::map<Index, int>& reached) const {
    const Index v = borders_[k].to;
    const auto [first, last] =
        std::equal_range(borders_.begin(), borders_.end(), Border{v, 0, 0, 0},
                         [](const Border& a, const Border& b) { return a.from < b.from; });
    const bool only = last - first == 1 && reached.at(v) == 1 && first->step == borders_[k].step;
    return only ? static_cast<std::size_t>(first - borders_.begin()) : borders_.size();
  }

  /// w on the right of a border: from far away on the left of its lower end across all that lies
  /// between, just above that end.
  int beside(const Border& border) const {
    const auto [low, high, up] = risen(border);
    int winding = 0;
    for (const Border& other : borders_) {
      const auto [other_low, other_high, other_up] = risen(other);
      if (below(low, other_low) || !below(low, other_high)) continue;
      const bool left = other_low == low ? turn_of(low, high, other_high) > 0
                                         : turn_of(other_low, other_high, low) < 0;
      if (left) winding -= other_up ? other.step : -other.step;
    }
    return up ? winding - border.step : winding;
  }

  struct Risen {
    Vec2 low, high;
    bool up;
  };
  Risen risen(const Border& b) const {
    const Vec2 p = at_.flat(b.from), q = at_.flat(b.to);
    if (below(p, q)) return {p, q, true};
    return {q, p, false};
  }

  const Arrangement& at_;
  std::vector<Border>& borders_;
};

/// Links borders that leave each point as often as they reach it. Any links will do: by even and
/// odd they enclose the same. `borders` are in the order of their first points.
std::vector<std::vector<Index>> linked(const std::vector<DirectedEdge>& borders) {
  std::vector<std::vector<Index>> loops;
  std::vector<bool> used(borders.size(), false);
  const auto next_from = [&](Index v) {
    auto it = std::lower_bound(borders.begin(), borders.end(), v,
                               [](const DirectedEdge& e, Index w) { return e.from < w; });
    while (it != borders.end() && it->from == v && used[it - borders.begin()]) ++it;
    return it != borders.end() && it->from == v ? static_cast<std::size_t>(it - borders.begin())
                                                : borders.size();
  };
  for (std::size_t i = 0; i < borders.size(); ++i) {
    std::vector<Index> loop;
    for (std::size_t k = i; k < borders.size() && !used[k]; k = next_from(borders[k].to)) {
      used[k] = true;
      loop.push_back(borders[k].from);
    }
    if (loop.size() > 2) loops.push_back(std::move(loop));
  }
  return loops;
}

/// The layer k, of borders with w >= k (or <= k) on one side only.
WindingLayers::Layer layer_of(const std::vector<Border>& borders, int k) {
  std::vector<DirectedEdge> own;
  for (const Border& b : borders) {
    const int left = b.right + b.step;
    if (k > 0 ? b.right < k && k <= left : b.right <= k && k < left) own.push_back({b.from, b.to});
  }
  return {k, linked(own)};
}

}  // namespace

FlatAxes::FlatAxes(const Vec3& outward) {
  const Vec3 size = glm::abs(outward);
  const int axis = size.z >= size.x && size.z >= size.y ? 2 : size.y >= size.x ? 1 : 0;
  x = (axis + 1) % 3, y = (axis + 2) % 3;
  if (outward[axis] < 0) std::swap(x, y);
}

WindingLayers winding_layers(const std::vector<Vec3>& points,
                             const std::vector<DirectedEdge>& edges, const FlatAxes& axes) {
  Arrangement arrangement(points, edges, axes);
  std::vector<Border> borders = borders_of(arrangement.paths());
  Windings(arrangement, borders).find();
  int lowest = 0, highest = 0;
  for (const Border& b : borders) {
    lowest = std::min(lowest, b.right);
    highest = std::max(highest, b.right + b.step);
  }
  WindingLayers result;
  for (int k = 1; k <= highest; ++k) result.layers.push_back(layer_of(borders, k));
  for (int k = -1; k >= lowest; --k) result.layers.push_back(layer_of(borders, k));
  std::erase_if(result.layers, [](const auto& layer) { return layer.loops.empty(); });
  result.points = std::move(arrangement.points());
  result.paths = std::move(arrangement.paths());
  return result;
}

}  // namespace overstrike
