#include "core/geometry/circle.h"

#include <cmath>
#include <utility>

#include "core/geometry/trig.h"

namespace overstrike {

Vec2 turn(int k, int n) {
  const long long quarters = 4LL * k;
  long long rest = quarters % n;
  const bool beyond_45 = 2 * rest > n;
  if (beyond_45) rest = n - rest;
  const double angle = 90.0 * static_cast<double>(rest) / n;
  double c = cos_deg(angle), s = sin_deg(angle);
  if (beyond_45) std::swap(c, s);
  switch (quarters / n % 4) {
    case 1:
      return {0 - s, c};
    case 2:
      return {0 - c, 0 - s};
    case 3:
      return {s, 0 - c};
    default:
      return {c, s};
  }
}

Vec2 part_of_turn(int k, int n, double angle_deg) {
  if (angle_deg == 360) return turn(k, n);
  const double angle = angle_deg * k / n;
  return {cos_deg(angle), sin_deg(angle)};
}

double sagitta(double radius, int n, double angle_deg) {
  const double half = sin_deg(angle_deg / (4.0 * n));
  return 2 * radius * half * half;
}

int chords_for(double radius, double chord, double angle_deg) {
  int low = static_cast<int>(std::ceil(kFewestSides * angle_deg / 360));
  int high = static_cast<int>(std::ceil(kMostSides * angle_deg / 360));
  while (low < high) {
    const int middle = (low + high) / 2;
    if (sagitta(radius, middle, angle_deg) <= chord)
      high = middle;
    else
      low = middle + 1;
  }
  return low;
}

}  // namespace overstrike
