#include "core/geometry/polyline.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace overstrike {
namespace {

double distance_from(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a, v = p - a;
  const double square = glm::dot(along, along);
  const double t = square > 0 ? std::clamp(glm::dot(along, v) / square, 0.0, 1.0) : 0;
  const Vec2 off = v - along * t;
  return std::sqrt(glm::dot(off, off));
}

}  // namespace

std::vector<Vec2> simplified(const std::vector<Vec2>& points, double tolerance) {
  std::vector<char> keep(points.size(), 0);
  keep.front() = keep.back() = 1;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    double worst = tolerance;
    std::size_t at = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double off = distance_from(points[i], points[first], points[last]);
      if (off > worst) worst = off, at = i;
    }
    if (at == first) continue;
    keep[at] = 1;
    open.emplace_back(first, at);
    open.emplace_back(at, last);
  }
  std::vector<Vec2> result;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (keep[i] != 0) result.push_back(points[i]);
  return result;
}

}  // namespace overstrike
