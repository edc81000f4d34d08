#include "core/visibility/cell_scanner.h"

#include <algorithm>
#include <cmath>

#include "core/visibility/line_averager.h"

namespace overstrike {
namespace {

/// Keeps the part of a convex polygon where f >= 0.
template <class Function>
void cut(std::span<const Vec2> polygon, const Function& f, std::vector<Vec2>& result) {
  result.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    const double fa = f(a), fb = f(b);
    if (fa >= 0) result.push_back(a);
    if ((fa < 0 && fb > 0) || (fa > 0 && fb < 0)) result.push_back(a + (b - a) * (fa / (fa - fb)));
  }
}

Vec2 middle_of(std::span<const Vec2> polygon) {
  Vec2 sum(0);
  for (const Vec2& p : polygon) sum += p;
  return sum / static_cast<double>(polygon.size());
}

/// Grid units, far above the rounding of a corner's place and far below what an area shows.
constexpr double kCornerError = 0x1p-36;

/// Edges to a column, seen and hidden, from which on cutting a row exactly costs more than its
/// lines do: measured on 80 spheres, where hidden facets cross hidden facets, and on a knot of
/// 21600 facets.
double edges_to_a_column(const EyeTable& table) {
  constexpr double kCurved = 6, kFlatFaced = 30;
  const auto& bodies = table.canonical.bodies;
  const bool curved =
      std::any_of(bodies.begin(), bodies.end(), [](const auto& b) { return b.curved; });
  return curved ? kCurved : kFlatFaced;
}

}  // namespace

CellScanner::CellScanner(const EyeTable& table, double tolerance,
                         std::function<std::unique_ptr<RunScanner>()> lines)
    : table_(table),
      active_(table),
      cells_(static_cast<int>(std::ceil(table.columns))),
      make_lines_(std::move(lines)),
      tolerance_(tolerance),
      most_edges_(table.columns * edges_to_a_column(table)) {}

bool CellScanner::crowded() const { return static_cast<double>(clips_.size()) > most_edges_; }

/// A clip is the straight line between its ends, whatever digits its edge has: a shadow's border on
/// a face that light grazes comes from 1e16 cells away, in steps of a cell, and would cross others
/// elsewhere than it is found to.
double CellScanner::x_at(const Clip& clip, double y) {
  return y == clip.yb ? clip.xb : clip.xa + (y - clip.ya) * clip.slope;
}

/// The part of an edge between two heights of the row; horizontal edges are added by gather().
void CellScanner::add_clip(Index e, double ya, double yb) {
  const ScanEdge& edge = table_.edges[e];
  Clip c;
  c.edge = e;
  const double a = std::max(edge.y0, top_ + ya), b = std::min(edge.y1, top_ + yb);
  c.ya = std::max(edge.y0 - top_, ya), c.yb = std::min(edge.y1 - top_, yb);
  if (!(c.ya < c.yb)) return;
  c.xa = edge.x_at(a), c.xb = edge.x_at(b);
  c.low = std::min(c.xa, c.xb), c.high = std::max(c.xa, c.xb);
  c.slope = (c.xb - c.xa) / (c.yb - c.ya);
  clips_.push_back(c);
}

void CellScanner::gather(const std::vector<Index>& edges, const std::vector<Index>& flat_edges) {
  clips_.clear();
  for (const Index e : edges) {
    const ScanEdge& edge = table_.edges[e];
    if (edge.y1 > top_ && edge.y0 < top_ + 1) add_clip(e, 0, 1);
  }
  for (const Index e : flat_edges) {
    const FlatEdge& flat = table_.flat_edges[e];
    const double y = flat.y - top_;
    if (y > 0 && y < 1) clips_.push_back({flat.x0, y, flat.x1, y, flat.x0, flat.x1, 0, kNone});
  }
}

std::span<const float> CellScanner::resolve(std::int64_t row, const std::vector<Index>& edges,
                                            const std::vector<Index>& flat_edges) {
  top_ = static_cast<double>(row);
  gather(edges, flat_edges);
  cells_.clear();
  if (crowded()) {
    if (lines_ == nullptr) lines_ = make_lines_();
    average_lines(top_, tolerance_, cells_, runs_,
                  [&](double y, std::vector<DensityRun>& runs) { lines_->resolve(y, runs); });
    return cells_.finish();
  }
  double low = 0, high = table_.columns;
  for (const Clip& c : clips_) low = std::min(low, c.low), high = std::max(high, c.high);
  resolve_band({0, 1}, 0, low, high);
  active_.clear();
  return cells_.finish();
}

/// Everything between x = low and x = high, left to right, over the height of the band.
void CellScanner::resolve_band(const Band& band, std::size_t first, double low, double high) {
  std::sort(clips_.begin() + static_cast<std::ptrdiff_t>(first), clips_.end(),
            [](const Clip& a, const Clip& b) {
              return a.low != b.low ? a.low < b.low
                                    : (a.high != b.high ? a.high < b.high : a.edge < b.edge);
            });
  const std::size_t end = clips_.size();
  double x = low;
  for (std::size_t i = first; i < end;) {
    double right = clips_[i].high;
    std::size_t last = i + 1;
    while (last < end && clips_[last].low <= right) right = std::max(right, clips_[last++].high);
    rectangle(band, x, std::min(clips_[i].low, high));
    const double left = std::max(clips_[i].low, x);
    cluster(band, i, last, left, std::min(right, high));
    if (band.halvings == 0) cells_.settle(left, right);
    x = std::max(x, right);
    i = last;
  }
  rectangle(band, x, high);
}

void CellScanner::cluster(const Band& band, std::size_t first, std::size_t last, double low,
                          double high) {
  // A few edges are quicker cut into slabs than gathered again; and many that meet in a point never
  // come apart.
  constexpr std::size_t kFew = 6;
  constexpr int kMostHalvings = 12, kMostInVain = 3;
  if (high <= 0 || low >= table_.columns) {
    // Out of sight: only what it leaves active matters, the same at every height.
    for (std::size_t i = first; i < last; ++i)
      if (clips_[i].edge != kNone && clips_[i].yb == band.yb)
        active_.pass(table_.edges[clips_[i].edge]);
    return;
  }
  const Clip& only = clips_[first];
  if (last - first == 1 && only.edge != kNone && only.ya == band.ya && only.yb == band.yb) {
    heights_ = {band.ya, band.yb};
  } else if (last - first > kFew && band.halvings < kMostHalvings && band.in_vain < kMostInVain) {
    halves(band, first, last, low, high);
    return;
  } else {
    find_heights(band, first, last);
  }
  const std::vector<double> heights = heights_;
  for (std::size_t i = 0; i + 1 < heights.size(); ++i) {
    slab(first, last, heights[i], heights[i + 1], low, high);
    if (i + 2 < heights.size())  // back to the state left of the cluster
      for (const Side& side : sides_) active_.pass_back(table_.edges[side.edge]);
  }
}

void CellScanner::halves(const Band& band, std::size_t first, std::size_t last, double low,
                         double high) {
  const double middle = band.ya + (band.yb - band.ya) / 2;
  const std::size_t end = clips_.size();
  // Edges that lie all but on one another stay together.
  const int in_vain = last - first < band.edges ? 0 : band.in_vain + 1;
  for (const Band& half : {Band{band.ya, middle, band.halvings + 1, in_vain, last - first},
                           Band{middle, band.yb, band.halvings + 1, in_vain, last - first}}) {
    for (std::size_t i = first; i < last; ++i) {
      const Clip c = clips_[i];
      if (c.edge != kNone) {
        add_clip(c.edge, half.ya, half.yb);
      } else if (c.ya > half.ya && c.ya < half.yb) {
        clips_.push_back(c);
      }
    }
    resolve_band(half, end, low, high);
    clips_.resize(end);
    if (half.ya != band.ya) break;
    // Back to the state left of the cluster: what passes the middle has been passed once.
    for (std::size_t i = first; i < last; ++i) {
      const Clip& c = clips_[i];
      if (c.edge != kNone && c.ya < middle && c.yb >= middle)
        active_.pass_back(table_.edges[c.edge]);
    }
  }
}

void CellScanner::find_heights(const Band& band, std::size_t first, std::size_t last) {
  heights_ = {band.ya, band.yb};
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

void CellScanner::rectangle(const Band& band, double x0, double x1) {
  x1 = std::min(x1, table_.columns);
  if (!(x0 < x1) || active_.faces().empty()) return;
  if (band.halvings > 0) {
    trapezoid({x0, x0, x0, kNone}, {x1, x1, x1, kNone}, band.ya, band.yb);
    return;
  }
  const Vec2 corners[4] = {{x0, 0}, {x1, 0}, {x1, 1}, {x0, 1}};
  const bool crossing = active_.crossing();
  const Index face = crossing ? sole_owner(corners) : active_.seen_at((x0 + x1) / 2, top_ + 0.5);
  if (x1 - x0 <= kCornerError) active_.forget();
  if (face == kNone && crossing) {
    share(corners);
    cells_.settle(x0, x1);
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
  if (active_.faces().empty() || std::max(right.xa, right.xb) <= 0 ||
      std::min(left.xa, left.xb) >= table_.columns)
    return;
  const double xa = std::max(left.xa, right.xa), xb = std::max(left.xb, right.xb);
  const Vec2 corners[4] = {{left.xa, ya}, {xa, ya}, {xb, yb}, {left.xb, yb}};
  std::span<const Vec2> polygon = corners;
  if (std::max(xa, xb) > table_.columns) {
    // Edges beyond the last column are not there: nothing is known of what they would turn off.
    cut(
        polygon, [&](const Vec2& p) { return table_.columns - p.x; }, inside_);
    polygon = inside_;
    if (polygon.size() < 3) return;
  }
  const Vec2 middle = middle_of(polygon);
  const Index face =
      active_.crossing() ? sole_owner(polygon) : active_.seen_at(middle.x, top_ + middle.y);
  // Two edges that should be one: such a sliver may lie on the wrong side of a line in which faces
  // touch, and what is seen in it says nothing about the next span.
  if (right.middle - left.middle <= kCornerError) active_.forget();
  if (face != kNone) {
    part(polygon, face);
  } else if (active_.crossing()) {
    share(polygon);
  }
}

void CellScanner::part(std::span<const Vec2> polygon, Index face) {
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
Index CellScanner::sole_owner(std::span<const Vec2> polygon) {
  const Vec2 middle = middle_of(polygon);
  const Index owner = active_.nearest(middle.x, middle.y + top_);
  if (owner == kNone) return kNone;
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
void CellScanner::share(std::span<const Vec2> polygon) {
  const std::vector<Index>& faces = active_.faces();
  for (const Index face : faces) {
    mine_.assign(polygon.begin(), polygon.end());
    const DepthPlane& p = table_.depths[table_.faces[face].plane];
    for (const Index other : faces) {
      if (other == face || mine_.size() < 3) continue;
      const bool by_rule = (face == table_.ground && !table_.faces[other].may_cross) ||
                           (other == table_.ground && !table_.faces[face].may_cross);
      const DepthPlane& q = table_.depths[table_.faces[other].plane];
      // A face in the ground's plane, or so near to it that doubles cannot tell them apart.
      const bool together = std::all_of(mine_.begin(), mine_.end(), [&](const Vec2& c) {
        return compare_roughly(p, q, c.x, c.y + top_) == 0;
      });
      if (by_rule || together) {
        const Vec2 middle = middle_of(mine_);
        if (!table_.in_front(face, other, middle.x, middle.y + top_)) mine_.clear();
        continue;
      }
      const auto nearer = [&](const Vec2& c) {
        return p.at(c.x, c.y + top_) - q.at(c.x, c.y + top_);
      };
      cut(mine_, nearer, kept_);
      mine_.swap(kept_);
    }
    if (mine_.size() >= 3) part(mine_, face);
  }
}

}  // namespace overstrike
