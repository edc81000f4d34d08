#include "core/visibility/cell_scanner.h"

#include <algorithm>
#include <cmath>

namespace overstrike {
namespace {

/// Keeps the part of a convex polygon where f >= 0.
template <class Function>
std::vector<Vec2> cut(const std::vector<Vec2>& polygon, const Function& f) {
  std::vector<Vec2> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    const double fa = f(a), fb = f(b);
    if (fa >= 0) result.push_back(a);
    if ((fa < 0 && fb > 0) || (fa > 0 && fb < 0)) result.push_back(a + (b - a) * (fa / (fa - fb)));
  }
  return result;
}

Vec2 middle_of(const std::vector<Vec2>& polygon) {
  Vec2 sum(0);
  for (const Vec2& p : polygon) sum += p;
  return sum / static_cast<double>(polygon.size());
}

}  // namespace

CellScanner::CellScanner(const EyeTable& table)
    : table_(table), active_(table), cells_(static_cast<int>(std::ceil(table.columns))) {}

double CellScanner::x_at(const Clip& clip, double y) const {
  if (y == clip.ya) return clip.xa;
  if (y == clip.yb) return clip.xb;
  return table_.edges[clip.edge].x_at(y + top_);
}

void CellScanner::gather(const std::vector<Index>& edges, const std::vector<Index>& flat_edges) {
  clips_.clear();
  for (const Index e : edges) {
    const ScanEdge& edge = table_.edges[e];
    if (edge.y1 <= top_ || edge.y0 >= top_ + 1) continue;
    Clip c;
    c.edge = e;
    const double a = std::max(edge.y0, top_), b = std::min(edge.y1, top_ + 1);
    c.ya = a - top_, c.yb = b - top_;
    c.xa = edge.x_at(a), c.xb = edge.x_at(b);
    c.low = std::min(c.xa, c.xb), c.high = std::max(c.xa, c.xb);
    if (c.low < table_.columns) clips_.push_back(c);
  }
  for (const Index e : flat_edges) {
    const FlatEdge& flat = table_.flat_edges[e];
    if (flat.y > top_ && flat.y < top_ + 1)
      clips_.push_back({flat.x0, flat.y - top_, flat.x1, flat.y - top_, flat.x0, flat.x1, kNone});
  }
  std::sort(clips_.begin(), clips_.end(), [](const Clip& a, const Clip& b) {
    return a.low != b.low ? a.low < b.low : (a.high != b.high ? a.high < b.high : a.edge < b.edge);
  });
}

std::span<const float> CellScanner::resolve(std::int64_t row, const std::vector<Index>& edges,
                                            const std::vector<Index>& flat_edges) {
  top_ = static_cast<double>(row);
  gather(edges, flat_edges);
  cells_.clear();
  double x = 0;
  for (std::size_t first = 0; first < clips_.size();) {
    double high = clips_[first].high;
    std::size_t last = first + 1;
    while (last < clips_.size() && clips_[last].low <= high)
      high = std::max(high, clips_[last++].high);
    const double low = clips_[first].low;
    rectangle(x, std::min(low, table_.columns));
    cluster(first, last, std::max(low, x), high);
    x = std::max(x, high);
    first = last;
  }
  rectangle(x, table_.columns);
  active_.clear();
  return cells_.finish();
}

void CellScanner::cluster(std::size_t first, std::size_t last, double low, double high) {
  if (high <= 0 || low >= table_.columns) {
    // Out of sight: only what it leaves active matters, the same at every height.
    high = low;
  }
  if (last - first == 1 && clips_[first].edge != kNone && clips_[first].ya == 0 &&
      clips_[first].yb == 1) {
    heights_ = {0, 1};
  } else {
    find_heights(first, last);
  }
  for (std::size_t i = 0; i + 1 < heights_.size(); ++i) {
    slab(first, last, heights_[i], heights_[i + 1], low, high);
    if (i + 2 < heights_.size())  // back to the state left of the cluster
      for (const Side& side : sides_) active_.pass_back(table_.edges[side.edge]);
  }
  if (high > low) cells_.settle(low, high);
}

void CellScanner::find_heights(std::size_t first, std::size_t last) {
  heights_ = {0, 1};
  for (std::size_t i = first; i < last; ++i) {
    const Clip& a = clips_[i];
    heights_.push_back(a.ya), heights_.push_back(a.yb);
    if (a.edge == kNone) continue;
    for (std::size_t j = i + 1; j < last && clips_[j].low <= a.high; ++j) {
      const Clip& b = clips_[j];
      const double y0 = std::max(a.ya, b.ya), y1 = std::min(a.yb, b.yb);
      if (b.edge == kNone || !(y0 < y1)) continue;
      const double d0 = x_at(a, y0) - x_at(b, y0), d1 = x_at(a, y1) - x_at(b, y1);
      if ((d0 < 0 && d1 > 0) || (d0 > 0 && d1 < 0))
        heights_.push_back(y0 + (y1 - y0) * (d0 / (d0 - d1)));
    }
  }
  std::sort(heights_.begin(), heights_.end());
  heights_.erase(std::unique(heights_.begin(), heights_.end()), heights_.end());
}

void CellScanner::slab(std::size_t first, std::size_t last, double ya, double yb, double low,
                       double high) {
  sides_.clear();
  for (std::size_t i = first; i < last; ++i) {
    const Clip& c = clips_[i];
    if (c.edge == kNone || c.ya > ya || c.yb < yb) continue;
    const double xa = x_at(c, ya), xb = x_at(c, yb);
    sides_.push_back({xa, xb, (xa + xb) / 2, c.edge});
  }
  std::sort(sides_.begin(), sides_.end(), [](const Side& a, const Side& b) {
    return a.middle != b.middle ? a.middle < b.middle : a.edge < b.edge;
  });
  Side left{low, low, low, kNone};
  for (const Side& side : sides_) {
    if (side.middle > left.middle && high > low) {
      trapezoid(left, side, ya, yb);
      left = side;
    }
    active_.pass(table_.edges[side.edge]);
  }
  if (high > left.middle) trapezoid(left, {high, high, high, kNone}, ya, yb);
}

void CellScanner::rectangle(double x0, double x1) {
  if (!(x0 < x1) || active_.faces().empty()) return;
  const std::vector<Vec2> corners{{x0, 0}, {x1, 0}, {x1, 1}, {x0, 1}};
  const Index face =
      active_.crossing() ? sole_owner(corners) : active_.seen_at((x0 + x1) / 2, top_ + 0.5);
  if (face == kNone && active_.crossing()) {
    share(corners);
    cells_.settle(x0, x1);
    return;
  }
  if (face == kNone) return;
  const bool shadowed = active_.shadowed(face);
  const EyeFace& f = table_.faces[face];
  if (f.smooth && !shadowed) {
    cells_.add_smooth(corners, f, top_);
  } else if (face != table_.ground || shadowed) {
    cells_.add_rectangle(x0, x1, shadowed ? f.in_shadow : f.density);
  }
}

void CellScanner::trapezoid(const Side& left, const Side& right, double ya, double yb) {
  if (active_.faces().empty() || right.middle <= 0 || left.middle >= table_.columns) return;
  const double xa = std::max(left.xa, right.xa), xb = std::max(left.xb, right.xb);
  const std::vector<Vec2> corners{{left.xa, ya}, {xa, ya}, {xb, yb}, {left.xb, yb}};
  const Index face = active_.crossing()
                         ? sole_owner(corners)
                         : active_.seen_at((left.middle + right.middle) / 2, top_ + (ya + yb) / 2);
  if (face != kNone) {
    part(corners, face);
  } else if (active_.crossing()) {
    share(corners);
  }
}

void CellScanner::part(const std::vector<Vec2>& polygon, Index face) {
  const bool shadowed = active_.shadowed(face);
  if (face == table_.ground && !shadowed) return;
  const EyeFace& f = table_.faces[face];
  if (f.smooth && !shadowed) {
    cells_.add_smooth(polygon, f, top_);
    return;
  }
  const double density = shadowed ? f.in_shadow : f.density;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    // Clockwise as y points down: edges going up are left borders.
    if (a.y > b.y) cells_.add_border(b.x, b.y, a.x, a.y, density);
    if (a.y < b.y) cells_.add_border(a.x, a.y, b.x, b.y, -density);
  }
}

/// The face that is nearest at every corner, or kNone when that is not one face. Edges that touch a
/// face end on it but for rounding: a face may be behind at a corner by as much as depth changes
/// within the corner's own uncertainty.
Index CellScanner::sole_owner(const std::vector<Vec2>& polygon) {
  const Vec2 middle = middle_of(polygon);
  const Index owner = active_.nearest(middle.x, middle.y + top_);
  if (owner == kNone) return kNone;
  // Grid units, far above the rounding of a corner's place and far below what an area shows.
  constexpr double kCornerError = 0x1p-36;
  const DepthPlane& p = table_.depths[table_.faces[owner].plane];
  for (const Index face : active_.faces()) {
    if (face == owner || table_.faces[face].plane == table_.faces[owner].plane) continue;
    if (!table_.faces[face].may_cross && !table_.faces[owner].may_cross) continue;
    if (face == table_.ground && !table_.faces[owner].may_cross) continue;
    const DepthPlane& q = table_.depths[table_.faces[face].plane];
    const double slack = kCornerError * (std::fabs(p.a - q.a) + std::fabs(p.b - q.b));
    for (const Vec2& corner : polygon)
      if (p.at(corner.x, corner.y + top_) - q.at(corner.x, corner.y + top_) < -slack) return kNone;
  }
  return owner;
}

/// Step 3: the nearest face's part is where it is nearer than every other.
void CellScanner::share(const std::vector<Vec2>& polygon) {
  const std::vector<Index>& faces = active_.faces();
  for (const Index face : faces) {
    std::vector<Vec2> mine = polygon;
    const DepthPlane& p = table_.depths[table_.faces[face].plane];
    for (const Index other : faces) {
      if (other == face || mine.size() < 3) continue;
      const bool by_rule = (face == table_.ground && !table_.faces[other].may_cross) ||
                           (other == table_.ground && !table_.faces[face].may_cross);
      if (by_rule || table_.faces[face].plane == table_.faces[other].plane) {
        const Vec2 middle = middle_of(mine);
        if (!table_.in_front(face, other, middle.x, middle.y + top_)) mine.clear();
        continue;
      }
      const DepthPlane& q = table_.depths[table_.faces[other].plane];
      mine =
          cut(mine, [&](const Vec2& c) { return p.at(c.x, c.y + top_) - q.at(c.x, c.y + top_); });
    }
    if (mine.size() >= 3) part(mine, face);
  }
}

}  // namespace overstrike
