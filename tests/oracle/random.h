#pragma once
// Seeded numbers and turns that are the same everywhere.
#include <cmath>
#include <cstdint>

#include "core/geometry/vec.h"

namespace overstrike::oracle {

/// splitmix64 (Steele, Lea and Flood 2014): the same numbers everywhere.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15u);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return z ^ (z >> 31);
  }
  double in(double low, double high) {
    return low + (high - low) * (static_cast<double>(next() >> 11) * 0x1p-53);
  }
  int below(int n) { return static_cast<int>(next() % static_cast<std::uint64_t>(n)); }
  bool chance(double p) { return in(0, 1) < p; }
  Vec3 within(const Vec3& low, const Vec3& high) {
    const double x = in(low.x, high.x), y = in(low.y, high.y), z = in(low.z, high.z);
    return {x, y, z};
  }

 private:
  std::uint64_t state_;
};

/// A rotation from a random unit quaternion.
inline Mat3 turn(Random& r) {
  double w = 0, x = 0, y = 0, z = 0, square = 0;
  do {
    w = r.in(-1, 1), x = r.in(-1, 1), y = r.in(-1, 1), z = r.in(-1, 1);
    square = w * w + x * x + y * y + z * z;
  } while (square > 1 || square < 0.01);
  const double s = 2 / square;
  return Mat3(1 - s * (y * y + z * z), s * (x * y + w * z), s * (x * z - w * y),
              s * (x * y - w * z), 1 - s * (x * x + z * z), s * (y * z + w * x),
              s * (x * z + w * y), s * (y * z - w * x), 1 - s * (x * x + y * y));
}

/// A turn about Z by the angle of (3, 4, 5) or (5, 12, 13) triangles and the like.
inline Mat3 turn_about_z(Random& r) {
  const double t = r.in(-1, 1), square = 1 + t * t;
  const double c = (1 - t * t) / square, s = 2 * t / square;
  return Mat3(c, s, 0, -s, c, 0, 0, 0, 1);
}

}  // namespace overstrike::oracle
