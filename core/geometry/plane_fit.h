#pragma once
// The plane of a face, and how well its vertices say where it lies.
#include <cmath>
#include <span>

#include "core/geometry/polyhedron.h"

namespace overstrike {

/// A plane fitted to loops by Newell's sum of cross products. Positions are relative to nothing:
/// the plane is { p : dot(normal, p - middle) = 0 }.
struct PlaneFit {
  Vec3 normal{0.0};   ///< unit; zero when the loops have no area
  Vec3 middle{0.0};   ///< a point of the plane near the loops
  double offset = 0;  ///< dot(normal, middle); exactly the common coordinate on an axis plane
  double area = 0;
  double perimeter = 0;
  /// The loops cross so that their parts cancel: normal and area are those of one triangle of them.
  bool cancels = false;
  /// Bound of the normal's turn, in radians, when every vertex may be off by `error`: moving vertex
  /// i changes Newell's vector by at most error * |p(i+1) - p(i-1)| / 2, all of them by error *
  /// perimeter.
  double tilt(double error) const { return area > 0 ? error * perimeter / area : 1; }
};

/// Below this square of the sine of their angle the products of two vectors cancel to less than a
/// thousandth, and 2^-53 of them turns the normal by more than a thousand of its last places.
constexpr double kSmallSineSquared = 0x1p-20;

/// The cross product from what the products' rounding lost, too.
Vec3 compensated_cross(const Vec3& a, const Vec3& b);

inline Vec3 accurate_cross(const Vec3& a, const Vec3& b) {
  const Vec3 usual = glm::cross(a, b);
  if (glm::dot(usual, usual) >= kSmallSineSquared * glm::dot(a, a) * glm::dot(b, b)) return usual;
  return compensated_cross(a, b);
}

/// Gathers loops of one plane.
class PlaneFitter {
 public:
  /// `at(i)` gives the position of the loop's i-th vertex. `sign` -1 takes the loop reversed.
  template <class At>
  void add(std::size_t count, At at, double sign = 1) {
    if (count == 0) return;
    if (points_ == 0) base_ = at(0);
    const Vec3 first = at(0) - base_;
    Vec3 previous = at(count - 1) - base_;
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 p = at(i) - base_;
      const Vec3 step = p - previous;
      if (i > 1) add_triangle(accurate_cross(previous - first, p - first) * sign);
      perimeter_ += std::sqrt(glm::dot(step, step));
      sum_ += p;
      previous = p;
    }
    points_ += static_cast<double>(count);
  }
  PlaneFit fit() const;

 private:
  void add_triangle(const Vec3& triangle) {
    vector_ += triangle;
    if (glm::dot(triangle, triangle) > glm::dot(widest_, widest_)) widest_ = triangle;
  }

  Vec3 base_{0.0}, vector_{0.0}, widest_{0.0}, sum_{0.0};
  double perimeter_ = 0, points_ = 0;
};

/// The plane of one face of a polyhedron.
PlaneFit fit_plane(const Polyhedron& polyhedron, Index face);

}  // namespace overstrike
