#include "core/visibility/intervals.h"

#include <algorithm>

namespace overstrike {

Interval positive_part(double ga, double gb) {
  if (ga <= 0 && gb <= 0) return {1, 0};
  double low = 0, high = 1;
  if (ga < 0) low = ga / (ga - gb);
  if (gb < 0) high = ga / (ga - gb);
  return {low, high};
}

void unite(Intervals& intervals) {
  std::erase_if(intervals, [](const Interval& i) { return !(i.first < i.second); });
  std::sort(intervals.begin(), intervals.end());
  std::size_t out = 0;
  for (const Interval& i : intervals) {
    if (out > 0 && i.first <= intervals[out - 1].second)
      intervals[out - 1].second = std::max(intervals[out - 1].second, i.second);
    else
      intervals[out++] = i;
  }
  intervals.resize(out);
}

Intervals common(const Intervals& a, const Intervals& b) {
  Intervals result;
  for (std::size_t i = 0, k = 0; i < a.size() && k < b.size();) {
    const double low = std::max(a[i].first, b[k].first);
    const double high = std::min(a[i].second, b[k].second);
    if (low < high) result.emplace_back(low, high);
    if (a[i].second < b[k].second) {
      ++i;
    } else {
      ++k;
    }
  }
  return result;
}

Intervals difference(const Intervals& a, const Intervals& b) {
  std::vector<double> ends;
  for (const Intervals* const set : {&a, &b})
    for (const Interval& i : *set) ends.push_back(i.first), ends.push_back(i.second);
  Intervals result;
  pair_up(ends, result);
  unite(result);
  return result;
}

void pair_up(std::vector<double>& crossings, Intervals& result) {
  std::sort(crossings.begin(), crossings.end());
  result.clear();
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2)
    if (crossings[i] < crossings[i + 1]) result.emplace_back(crossings[i], crossings[i + 1]);
}

Intervals without(const Interval& whole, const Intervals& holes, double sliver) {
  Intervals result;
  double at = whole.first;
  const auto keep_until = [&](double end) {
    if (end - at > sliver) result.emplace_back(at, end);
  };
  for (const Interval& hole : holes) {
    const double low = std::max(hole.first, whole.first);
    const double high = std::min(hole.second, whole.second);
    if (!(high - low > sliver)) continue;
    keep_until(low);
    at = std::max(at, high);
  }
  keep_until(whole.second);
  return result;
}

}  // namespace overstrike
