#pragma once
// Depth of planes in a view, compared exactly: error-bounded doubles first, expansions when those
// cannot tell.
#include <array>
#include <cmath>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "core/geometry/expansion.h"
#include "core/visibility/canonical.h"
#include "core/visibility/view.h"

namespace overstrike {

/// A sum of four products of doubles rounds by at most 4 u sum |terms| (three additions, one
/// product each), 4 u = 2 eps; doubled for the rounding of the bound itself and of a factor that
/// was itself rounded once.
constexpr double kDotError = 4 * 0x1p-52;

/// z = a x + b y + c over the grid (larger is nearer), off from the exact depth of the stored plane
/// through the stored matrix by at most ea |x| + eb |y| + ec.
struct DepthPlane {
  double a, b, c;
  double ea, eb, ec;
  double at(double x, double y) const { return a * x + b * y + c; }
};

/// A plane (x, y, w, z) of the grid and its depths, up to a factor, in exact arithmetic.
using ExactPlane = std::array<Expansion, 4>;
/// Sign of depth(p) - depth(q) at the point of the grid: 1 when p is nearer.
int compare_exactly(const ExactPlane& p, const ExactPlane& q, double x, double y);
/// Where on the level y the two have one depth, to an ulp or two; NaN or infinite when they are
/// parallel along it.
double crossing_exactly(const ExactPlane& p, const ExactPlane& q, double y);

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
  /// The plane as the view's matrix takes it.
  ExactPlane exact(Index number) const { return exact(plane(number)); }
  ExactPlane exact(const Plane& plane) const;
  /// The same in doubles, each component off by `error` at most.
  struct RoundedPlane {
    std::array<double, 4> value, error;
  };
  RoundedPlane rounded(const Plane& plane) const;
  /// Where cancellation has left few digits of z, all from exact arithmetic.
  RoundedPlane rounded_with_depth(const Plane& plane) const;
  /// Sign of the view's determinant.
  int orientation() const { return orientation_; }

 private:
  friend class DepthRange;
  /// Component j of the plane as the view's matrix takes it.
  double component(const Plane& plane, int j) const {
    return plane.normal.x * rounded_[0][j] + plane.normal.y * rounded_[1][j] +
           plane.normal.z * rounded_[2][j] - plane.offset * rounded_[3][j];
  }
  /// A bound of the sum of its terms' sizes.
  double size(const Plane& plane, int j) const {
    return normal_size_[j] + std::fabs(plane.offset * rounded_[3][j]);
  }

  const std::vector<Plane>& planes_;
  const std::vector<Plane>& further_;
  std::array<std::array<Expansion, 4>, 4> adjugate_;
  std::array<std::array<double, 4>, 4> rounded_;
  std::array<double, 4> normal_size_;  ///< bounds of the sums of a normal's terms
  int orientation_;
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
  /// Found once, when doubles could not tell; by any number of threads.
  const ExactPlane& exact(Index plane) const;

  DepthMap map_;
  std::vector<DepthPlane> depths_;
  std::vector<char> seen_edge_on_;
  mutable std::vector<std::once_flag> asked_;
  mutable std::vector<std::unique_ptr<const ExactPlane>> exact_;
};

/// Sign of a . x + b . y + ... over four components, in exact arithmetic.
int sign_of_dot_exactly(const Vec4& p, const Vec4& q);
/// The same: by doubles where they can tell.
inline int sign_of_dot(const Vec4& p, const Vec4& q) {
  const double t0 = p.x * q.x, t1 = p.y * q.y, t2 = p.z * q.z, t3 = p.w * q.w;
  const double sum = ((t0 + t1) + t2) + t3;
  const double size = ((std::fabs(t0) + std::fabs(t1)) + std::fabs(t2)) + std::fabs(t3);
  if (std::fabs(sum) > kDotError * size) return sum > 0 ? 1 : -1;
  if (size == 0) return 0;
  return sign_of_dot_exactly(p, q);
}

/// Which side of the face's plane the eye is on: 1 outside (front), -1 behind, 0 in its plane.
/// Exact (NN74 (4)).
inline int side_of_eye(const Plane& plane, bool flipped, const Vec4& eye) {
  const int side = sign_of_dot(Vec4(plane.normal, -plane.offset), eye);
  return flipped ? -side : side;
}
/// Sign of dot(normal, direction), exact (NN74 (5)).
int side_of_direction(const Plane& plane, bool flipped, const Vec3& direction);
/// Sign of dot(normal, p) - offset, exact.
int side_of_point(const Plane& plane, const Vec3& p);
/// dot(normal, p) - offset to an ulp or two, however near the point is to the plane.
double height_of_point(const Plane& plane, const Vec3& p);

}  // namespace overstrike
