#include "devices/plotter/clip.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace overstrike {
namespace {

/// Narrows [t0, t1] to where from + t * step lies in [low, high]; false when nothing is left.
bool narrow(double from, double step, double low, double high, double& t0, double& t1) {
  if (step == 0) return from >= low && from <= high;
  const double enter = ((step > 0 ? low : high) - from) / step;
  const double leave = ((step > 0 ? high : low) - from) / step;
  t0 = std::max(t0, enter);
  t1 = std::min(t1, leave);
  return t0 <= t1;
}

/// Rounding of a + t * (b - a) may stray over the border; the border is where a cut end lies.
Vec2 held(Vec2 p, const Rectangle& inside) { return glm::clamp(p, inside.low, inside.high); }

Vec2 point_at(Vec2 a, Vec2 b, double t, const Rectangle& inside) {
  const auto on_border = [&](double from, double step, double low, double high) {
    if (step != 0 && (low - from) / step == t) return low;
    if (step != 0 && (high - from) / step == t) return high;
    return from + t * step;
  };
  return held({on_border(a.x, b.x - a.x, inside.low.x, inside.high.x),
               on_border(a.y, b.y - a.y, inside.low.y, inside.high.y)},
              inside);
}

}  // namespace

std::optional<std::pair<Vec2, Vec2>> clip_segment(Vec2 a, Vec2 b, const Rectangle& inside) {
  if (!std::isfinite(std::abs(a.x) + std::abs(a.y) + std::abs(b.x) + std::abs(b.y)))
    return std::nullopt;
  double t0 = 0, t1 = 1;
  if (!narrow(a.x, b.x - a.x, inside.low.x, inside.high.x, t0, t1)) return std::nullopt;
  if (!narrow(a.y, b.y - a.y, inside.low.y, inside.high.y, t0, t1)) return std::nullopt;
  return std::pair{t0 == 0 ? a : point_at(a, b, t0, inside),
                   t1 == 1 ? b : point_at(a, b, t1, inside)};
}

std::size_t clip_polyline(std::span<const Vec2> points, const Rectangle& inside,
                          const std::function<void(std::span<const Vec2>)>& sink) {
  if (points.empty()) return 0;
  std::size_t cut = 0;
  std::vector<Vec2> part;
  const auto flush = [&] {
    if (!part.empty()) sink(part);
    part.clear();
  };
  for (std::size_t i = points.size() == 1 ? 0 : 1; i < points.size(); ++i) {
    const Vec2 a = points[i == 0 ? 0 : i - 1], b = points[i];
    const auto kept = clip_segment(a, b, inside);
    if (!kept || kept->first != a || kept->second != b) ++cut;
    if (!kept || kept->first != a) flush();
    if (!kept) continue;
    if (part.empty()) part.push_back(kept->first);
    if (points.size() > 1) part.push_back(kept->second);
    if (kept->second != b) flush();
  }
  flush();
  return cut;
}

}  // namespace overstrike
