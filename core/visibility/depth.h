#pragma once
// Depth of planes in a view, compared exactly: error-bounded doubles first, expansions when those
// cannot tell.
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "core/geometry/expansion.h"
#include "core/visibility/canonical.h"
#include "core/visibility/view.h"

namespace overstrike {

/// z = a x + b y + c over the grid (larger is nearer), off from the exact depth of the stored plane
/// through the stored matrix by at most ea |x| + eb |y| + ec.
struct DepthPlane {
  double a, b, c;
  double ea, eb, ec;
  double at(double x, double y) const { return a * x + b * y + c; }
};

/// The depths of planes in one view, each found when asked for.
class DepthMap {
 public:
  /// `planes` are numbered first, `further` after them. Both are kept by reference.
  DepthMap(const std::vector<Plane>& planes, const std::vector<Plane>& further, const View& view);

  const Plane& plane(Index number) const {
    return number < planes_.size() ? planes_[number] : further_[number - planes_.size()];
  }
  /// nullopt when the plane passes through the eye (exactly): it has no depth.
  std::optional<DepthPlane> depth(Index plane) const;
  /// Sign of depth(f) - depth(g) at the point of the grid, in exact arithmetic: 1 when f is nearer.
  int compare_exactly(Index f, Index g, double x, double y) const;

 private:
  std::array<Expansion, 4> exact(Index plane) const;

  const std::vector<Plane>& planes_;
  const std::vector<Plane>& further_;
  std::array<std::array<Expansion, 4>, 4> adjugate_;
  std::array<std::array<double, 4>, 4> rounded_;
};

/// Sign of the difference of two depths at the point of the grid where doubles can tell, else 0.
inline int compare_roughly(const DepthPlane& p, const DepthPlane& q, double x, double y) {
  const double difference = p.at(x, y) - q.at(x, y);
  const double error = (p.ea + q.ea) * std::fabs(x) + (p.eb + q.eb) * std::fabs(y) + (p.ec + q.ec);
  return (difference > error) - (difference < -error);
}

/// All planes of a canonical input in one view.
class DepthField {
 public:
  DepthField(const std::vector<Plane>& planes, const View& view);

  const DepthPlane& operator[](Index plane) const { return depths_[plane]; }
  /// False when the plane passes through the eye (exactly): it has no depth.
  bool has_depth(Index plane) const { return seen_edge_on_[plane] == 0; }
  /// Sign of depth(f) - depth(g) at the point of the grid, exact: 1 when f is nearer.
  int compare(Index f, Index g, double x, double y) const;

 private:
  DepthMap map_;
  std::vector<DepthPlane> depths_;
  std::vector<char> seen_edge_on_;
};

/// Which side of the face's plane the eye is on: 1 outside (front), -1 behind, 0 in its plane.
/// Exact (NN74 (4)).
int side_of_eye(const Plane& plane, bool flipped, const Vec4& eye);
/// Sign of dot(normal, direction), exact (NN74 (5)).
int side_of_direction(const Plane& plane, bool flipped, const Vec3& direction);
/// Sign of dot(normal, p) - offset, exact.
int side_of_point(const Plane& plane, const Vec3& p);

}  // namespace overstrike
