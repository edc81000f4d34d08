#include "core/visibility/shadow_border.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace overstrike {
namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

bool before(const Vec2& a, const Vec2& b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); }

auto side_of(const ShadowBorder& border) {
  const SidePart& p = border.part;
  return std::tie(p.a.x, p.a.y, p.b.x, p.b.y);
}

/// What borders of one side add up to, part by part.
void sum_up(const ShadowBorder* first, const ShadowBorder* end, std::vector<ShadowBorder>& sums) {
  std::vector<std::pair<double, int>> changes;
  for (const ShadowBorder* b = first; b != end; ++b) {
    changes.emplace_back(b->part.t0, b->winding);
    changes.emplace_back(b->part.t1, -b->winding);
  }
  std::sort(changes.begin(), changes.end());
  SidePart part = first->part;
  part.plane = kNone;
  int winding = 0;
  for (std::size_t i = 0; i < changes.size();) {
    const double t = changes[i].first;
    int by = 0;
    for (; i < changes.size() && changes[i].first == t; ++i) by += changes[i].second;
    if (by == 0) continue;
    part.t1 = t;
    if (winding != 0) sums.push_back({part, winding});
    winding += by;
    part.t0 = t;
  }
}

bool same_part(const ShadowBorder& p, const ShadowBorder& q) {
  return p.part.t0 == q.part.t0 && p.part.t1 == q.part.t1;
}

}  // namespace

SidePart whole_side(const Vec2& p, const Vec2& q) {
  return before(q, p) ? SidePart{q, p, 1, 0} : SidePart{p, q, 0, 1};
}

void assign(ShadowPolygon& polygon, const std::vector<Vec2>& corners) {
  polygon.clear();
  for (std::size_t i = 0; i < corners.size(); ++i)
    polygon.push_back(whole_side(corners[i], corners[i + 1 == corners.size() ? 0 : i + 1]));
}

void go_on_to(const Vec2& point, Index plane, ShadowPolygon& polygon) {
  const Vec2 end = polygon.back().to();
  if (end == point) return;
  polygon.push_back(whole_side(end, point));
  polygon.back().plane = plane;
}

void cancel(std::vector<ShadowBorder>& borders) {
  std::sort(borders.begin(), borders.end(),
            [](const auto& p, const auto& q) { return side_of(p) < side_of(q); });
  std::vector<ShadowBorder> sums;
  std::size_t out = 0;
  for (std::size_t i = 0; i < borders.size();) {
    ShadowBorder sum = borders[i];
    bool same = true;
    std::size_t j = i + 1;
    for (; j < borders.size() && side_of(borders[j]) == side_of(sum); ++j) {
      same = same && same_part(borders[j], borders[i]);
      sum.winding += borders[j].winding;
      if (borders[j].part.plane != sum.part.plane) sum.part.plane = kNone;
    }
    if (!same) {
      sum_up(&borders[i], borders.data() + j, sums);
    } else if (sum.winding != 0) {
      borders[out++] = sum;
    }
    i = j;
  }
  borders.resize(out);
  borders.insert(borders.end(), sums.begin(), sums.end());
}

int winding_at(const Vec2& p, const std::vector<ShadowBorder>& borders) {
  int winding = 0;
  for (const ShadowBorder& border : borders) {
    const Vec2 a = border.part.from(), b = border.part.to();
    if ((a.y <= p.y) == (b.y <= p.y)) continue;
    const bool left = cross(b - a, p - a) > 0;
    if (b.y > a.y && left) winding += border.winding;
    if (b.y < a.y && !left) winding -= border.winding;
  }
  return winding;
}

}  // namespace overstrike
