#include "core/geometry/even_odd.h"

#include <algorithm>

namespace overstrike {
namespace {

struct Line {
  Vec2 low, high;
  int winding;  ///< 1 when it goes up
  double x_at(double y) const {
    if (y == low.y) return low.x;
    if (y == high.y) return high.x;
    return low.x + (high.x - low.x) * ((y - low.y) / (high.y - low.y));
  }
};

std::vector<Line> lines_of(const std::vector<std::vector<Vec2>>& loops) {
  std::vector<Line> lines;
  for (const std::vector<Vec2>& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec2 &a = loop[i], &b = loop[i + 1 == loop.size() ? 0 : i + 1];
      if (a.y < b.y) lines.push_back({a, b, 1});
      if (b.y < a.y) lines.push_back({b, a, -1});
    }
  return lines;
}

std::vector<double> heights_of(const std::vector<Line>& lines) {
  std::vector<double> heights;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Line& a = lines[i];
    heights.push_back(a.low.y), heights.push_back(a.high.y);
    for (std::size_t j = 0; j < i; ++j) {
      const Line& b = lines[j];
      const double low = std::max(a.low.y, b.low.y), high = std::min(a.high.y, b.high.y);
      if (!(low < high)) continue;
      const double before = a.x_at(low) - b.x_at(low), after = a.x_at(high) - b.x_at(high);
      if ((before < 0 && after > 0) || (before > 0 && after < 0))
        heights.push_back(low + (high - low) * (before / (before - after)));
    }
  }
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  return heights;
}

}  // namespace

EvenOdd even_odd(const std::vector<std::vector<Vec2>>& loops) {
  const std::vector<Line> lines = lines_of(loops);
  const std::vector<double> heights = heights_of(lines);
  EvenOdd result;
  int way = 0;
  std::vector<std::pair<double, const Line*>> meeting;
  for (std::size_t h = 0; h + 1 < heights.size(); ++h) {
    const double low = heights[h], high = heights[h + 1], middle = low + (high - low) / 2;
    meeting.clear();
    for (const Line& line : lines)
      if (line.low.y <= low && line.high.y >= high) meeting.emplace_back(line.x_at(middle), &line);
    std::sort(meeting.begin(), meeting.end());
    int winding = 0;
    for (std::size_t i = 0; i < meeting.size(); ++i) {
      winding += meeting[i].second->winding;
      if (winding != 0 && way == 0) way = winding;
      // An even number, or an odd one that is not the way round.
      if (winding != 0 && winding != way) result.simple = false;
      if (i % 2 == 1 || i + 1 == meeting.size()) continue;
      const Line &left = *meeting[i].second, &right = *meeting[i + 1].second;
      result.parts.push_back({Vec2(left.x_at(high), high), Vec2(left.x_at(low), low),
                              Vec2(right.x_at(low), low), Vec2(right.x_at(high), high)});
    }
  }
  if (way != 1 && way != -1) result.simple = way == 0;
  return result;
}

}  // namespace overstrike
