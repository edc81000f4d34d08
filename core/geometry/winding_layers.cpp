#include "core/geometry/winding_layers.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "core/geometry/expansion.h"
#include "core/geometry/polygon.h"

namespace overstrike {
namespace {

/// Lines of sweeping, from below and on them from the left: a level edge rises, too.
bool below(const Vec2& a, const Vec2& b) { return std::tie(a.y, a.x) < std::tie(b.y, b.x); }

bool within_box(const Vec2& p, const Vec2& a, const Vec2& b) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

/// The points of the outlines and the pieces between them, which meet in ends only.
///
/// Outlines that touch or cross are divided by snap rounding (Hobby 1999): a lattice of two last
/// places of the largest coordinate is laid over them; the squares of it that hold an end or a
/// crossing are *hot*, and an edge is led through the middles of the hot squares that it passes. So
/// it moves by less than a square, and no pieces cross but in a middle. One pass does: nothing that
/// is divided is divided again, as pieces that leave a point in nearly one direction would be, at
/// the next double each time.
class Arrangement {
 public:
  Arrangement(const std::vector<Vec3>& points, const std::vector<DirectedEdge>& edges,
              const FlatAxes& axes)
      : points_(points), axes_(axes) {
    for (const Vec3& p : points_) flat_.push_back(axes_(p));
    for (const DirectedEdge& e : edges) paths_.push_back({at(e.from), at(e.to)});
    find_contacts();
    if (!contacts_.empty()) snap();
  }

  /// The middle of its square where outlines were divided.
  const Vec2& flat(Index i) const { return flat_[i]; }
  std::vector<Vec3>& points() { return points_; }
  std::vector<std::vector<Index>>& paths() { return paths_; }

 private:
  struct Edge {
    Vec2 p, q;
    std::size_t path;
    double low() const { return std::min(p.x, q.x); }
    double high() const { return std::max(p.x, q.x); }
  };
  /// Two edges that cross, or an edge and a point on it.
  struct Contact {
    std::size_t e, f;  ///< in edges_; f is the same as e when there is a point
    Index point;
  };

  /// The first point in the same place.
  Index at(Index point) {
    return first_at_.try_emplace({flat_[point].x, flat_[point].y}, point).first->second;
  }

  void find_contacts() {
    for (std::size_t path = 0; path < paths_.size(); ++path) {
      const Vec2 &p = flat_[paths_[path][0]], &q = flat_[paths_[path][1]];
      if (p != q) edges_.push_back({p, q, path});
    }
    std::stable_sort(edges_.begin(), edges_.end(),
                     [](const Edge& e, const Edge& f) { return e.low() < f.low(); });
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      std::erase_if(open, [&](std::size_t j) { return edges_[j].high() < edges_[i].low(); });
      for (const std::size_t j : open) find_contacts(j, i);
      open.push_back(i);
    }
  }

  void find_contacts(std::size_t i, std::size_t j) {
    const Edge &e = edges_[i], &f = edges_[j];
    if (std::max(e.p.y, e.q.y) < std::min(f.p.y, f.q.y)) return;
    if (std::max(f.p.y, f.q.y) < std::min(e.p.y, e.q.y)) return;
    const int ep = turn_of(f.p, f.q, e.p), eq = turn_of(f.p, f.q, e.q);
    if (ep * eq > 0) return;
    const int fp = turn_of(e.p, e.q, f.p), fq = turn_of(e.p, e.q, f.q);
    if (ep * eq < 0 && fp * fq < 0) contacts_.push_back({i, j, 0});
    if (ep == 0) touch(j, paths_[e.path].front());
    if (eq == 0) touch(j, paths_[e.path].back());
    if (fp == 0) touch(i, paths_[f.path].front());
    if (fq == 0) touch(i, paths_[f.path].back());
  }

  void touch(std::size_t i, Index point) {
    const Edge& e = edges_[i];
    if (point == paths_[e.path].front() || point == paths_[e.path].back()) return;
    if (within_box(flat_[point], e.p, e.q)) contacts_.push_back({i, i, point});
  }

  void snap() {
    double reach = 0;
    for (const Vec2& p : flat_) reach = std::max({reach, std::fabs(p.x), std::fabs(p.y)});
    // So that corners of squares, at half a side, are doubles.
    side_ = std::ldexp(1.0, std::ilogb(reach) - 51);
    first_at_.clear();
    for (Vec2& p : flat_) p = Vec2(middle_of(p.x), middle_of(p.y));
    for (std::vector<Index>& path : paths_) path = {at(path.front()), at(path.back())};
    std::vector<std::vector<Index>> passed(paths_.size());
    for (const Contact& c : contacts_) {
      const Index point = c.e == c.f ? at(c.point) : crossing(edges_[c.e], edges_[c.f]);
      passed[edges_[c.e].path].push_back(point);
      passed[edges_[c.f].path].push_back(point);
    }
    std::vector<std::pair<double, Index>> hot;
    for (const auto& [middle, point] : first_at_) hot.push_back({middle.first, point});
    for (const Edge& e : edges_) lead(e, hot, std::move(passed[e.path]));
  }

  /// A square holds its lower borders.
  double middle_of(double x) const { return std::floor(x / side_ + 0.5) * side_; }
  /// Of over / under, which is exact.
  double middle_of(const Expansion& over, const Expansion& under) const {
    double middle = middle_of(over.approximate() / under.approximate());
    const auto is_below = [&](double border) {
      return (over - Expansion(border) * under).sign() * under.sign() < 0;
    };
    while (is_below(middle - side_ / 2)) middle -= side_;
    while (!is_below(middle + side_ / 2)) middle += side_;
    return middle;
  }

  /// The point that stands for the square in which they cross.
  Index crossing(const Edge& e, const Edge& f) {
    const auto minus = [](double a, double b) { return Expansion(a) - Expansion(b); };
    const Expansion x = minus(e.q.x, e.p.x), y = minus(e.q.y, e.p.y);
    const Expansion fx = minus(f.q.x, f.p.x), fy = minus(f.q.y, f.p.y);
    const Expansion under = x * fy - y * fx;
    const Expansion part = minus(f.p.x, e.p.x) * fy - minus(f.p.y, e.p.y) * fx;
    const Vec2 middle(middle_of(Expansion(e.p.x) * under + x * part, under),
                      middle_of(Expansion(e.p.y) * under + y * part, under));
    const Index fresh = static_cast<Index>(points_.size());
    const Index first = first_at_.try_emplace({middle.x, middle.y}, fresh).first->second;
    if (first != fresh) return first;
    const Vec3 &from = points_[paths_[e.path].front()], &to = points_[paths_[e.path].back()];
    Vec3 point = from + (to - from) * (part.approximate() / under.approximate());
    point[axes_.x] = middle.x, point[axes_.y] = middle.y;
    points_.push_back(point);
    flat_.push_back(middle);
    return first;
  }

  /// Through the hot squares, which are in order of x.
  void lead(const Edge& e, const std::vector<std::pair<double, Index>>& hot,
            std::vector<Index> passed) {
    std::vector<Index>& path = paths_[e.path];
    const Index a = path.front(), b = path.back();
    for (auto it = std::lower_bound(hot.begin(), hot.end(), std::pair(e.low() - side_, Index{0}));
         it != hot.end() && it->first <= e.high() + side_; ++it)
      if (passes(e, flat_[it->second])) passed.push_back(it->second);
    std::erase_if(passed, [&](Index i) { return i == a || i == b; });
    // Of the two that an edge passes at one step of the coordinate in which it is longer, the one
    // first that is first in the other.
    const Vec2 along = e.q - e.p;
    const bool by_x = std::fabs(along.x) >= std::fabs(along.y);
    const auto key = [&](Index i) {
      const double x = along.x < 0 ? -flat_[i].x : flat_[i].x;
      const double y = along.y < 0 ? -flat_[i].y : flat_[i].y;
      return by_x ? std::pair(x, y) : std::pair(y, x);
    };
    std::sort(passed.begin(), passed.end(), [&](Index i, Index j) { return key(i) < key(j); });
    passed.erase(std::unique(passed.begin(), passed.end()), passed.end());
    path = {a};
    path.insert(path.end(), passed.begin(), passed.end());
    path.push_back(b);
  }

  /// The inside of the square about a middle. (What touches its border goes through it only where
  /// the contact is its reason.)
  bool passes(const Edge& e, const Vec2& middle) const {
    const Vec2 low = middle - side_ / 2, high = middle + side_ / 2;
    if (std::max(e.p.x, e.q.x) <= low.x || std::min(e.p.x, e.q.x) >= high.x) return false;
    if (std::max(e.p.y, e.q.y) <= low.y || std::min(e.p.y, e.q.y) >= high.y) return false;
    // Of the corners farthest to either side of the line.
    const bool rises = (e.q.x - e.p.x) * (e.q.y - e.p.y) > 0;
    const Vec2 left(rises ? low.x : high.x, high.y), right(rises ? high.x : low.x, low.y);
    return turn_of(e.p, e.q, left) * turn_of(e.p, e.q, right) < 0;
  }

  std::vector<Vec3> points_;
  std::vector<Vec2> flat_;  ///< per point
  FlatAxes axes_;
  std::map<std::pair<double, double>, Index> first_at_;
  std::vector<std::vector<Index>> paths_;
  std::vector<Edge> edges_;  ///< as given
  std::vector<Contact> contacts_;
  double side_ = 0;
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
