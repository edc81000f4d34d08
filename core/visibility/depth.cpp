#include "core/visibility/depth.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace overstrike {
namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();  // 2 u, u the unit roundoff

Expansion minor3(const Mat4& m, int row, int column) {
  int r[3], c[3];
  for (int i = 0, k = 0; i < 4; ++i)
    if (i != row) r[k++] = i;
  for (int i = 0, k = 0; i < 4; ++i)
    if (i != column) c[k++] = i;
  const auto at = [&](int i, int j) { return Expansion(m[c[j]][r[i]]); };
  return at(0, 0) * (at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1)) -
         at(0, 1) * (at(1, 0) * at(2, 2) - at(1, 2) * at(2, 0)) +
         at(0, 2) * (at(1, 0) * at(2, 1) - at(1, 1) * at(2, 0));
}

Vec4 homogeneous(const Plane& plane) { return Vec4(plane.normal, -plane.offset); }

}  // namespace

int sign_of_dot_exactly(const Vec4& p, const Vec4& q) {
  Expansion exact;
  for (int i = 0; i < 4; ++i) exact = exact + Expansion(p[i]) * Expansion(q[i]);
  return exact.sign();
}

int side_of_direction(const Plane& plane, bool flipped, const Vec3& direction) {
  return side_of_eye(plane, flipped, Vec4(direction, 0.0));
}

int side_of_point(const Plane& plane, const Vec3& p) {
  return sign_of_dot(homogeneous(plane), Vec4(p, 1.0));
}

double height_of_point(const Plane& plane, const Vec3& p) {
  const Vec4 at = homogeneous(plane);
  Expansion exact(at.w);
  for (int i = 0; i < 3; ++i) exact = exact + Expansion(at[i]) * Expansion(p[i]);
  return exact.approximate();
}

DepthMap::DepthMap(const std::vector<Plane>& planes, const std::vector<Plane>& further,
                   const View& view)
    : planes_(planes), further_(further) {
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      Expansion cofactor = minor3(view.matrix, j, i);
      if ((i + j) % 2 == 1) cofactor = -cofactor;
      rounded_[i][j] = cofactor.approximate();
      adjugate_[i][j] = std::move(cofactor);
    }
  Expansion determinant;
  for (int i = 0; i < 4; ++i)
    determinant = determinant + Expansion(view.matrix[i][0]) * adjugate_[i][0];
  orientation_ = determinant.sign();
  // A normal is of unit length but for rounding.
  for (int j = 0; j < 4; ++j)
    normal_size_[j] = 1.0001 * (std::fabs(rounded_[0][j]) + std::fabs(rounded_[1][j]) +
                                std::fabs(rounded_[2][j]));
}

// A plane row vector pi becomes pi' = pi adj(M) (up to det M): pi' . (x^, y^, w^, z^) = 0 on it, so
// z = -(pi'_x x + pi'_y y + pi'_w) / pi'_z.
std::optional<DepthPlane> DepthMap::depth(Index number) const {
  const auto [value, error] = rounded_with_depth(plane(number));
  if (value[3] == 0) return std::nullopt;
  const double over = 1 / value[3];
  const double relative =
      error[3] * std::fabs(over) + 4 * kEps;  // of 1 / pi'_z, products and the sum a x + b y + c
  DepthPlane d{-value[0] * over, -value[1] * over, -value[2] * over, 0, 0, 0};
  const auto bound = [&](double v, double e) {
    return 2 * (e * std::fabs(over) + std::fabs(v) * relative);
  };
  d.ea = bound(d.a, error[0]);
  d.eb = bound(d.b, error[1]);
  d.ec = bound(d.c, error[2]);
  return d;
}

// Rows of the view's matrix are in the order x^, y^, w^, z^.
DepthMap::RoundedPlane DepthMap::rounded(const Plane& plane) const {
  RoundedPlane r;
  for (int j = 0; j < 4; ++j)
    r.value[j] = component(plane, j), r.error[j] = kDotError * size(plane, j);
  return r;
}

DepthMap::RoundedPlane DepthMap::rounded_with_depth(const Plane& plane) const {
  constexpr double kDigitsWanted = 1e-13;
  RoundedPlane r = rounded(plane);
  if (r.error[3] <= kDigitsWanted * std::fabs(r.value[3])) return r;
  const ExactPlane sure = exact(plane);
  for (int j = 0; j < 4; ++j) {
    r.value[j] = sure[j].approximate();
    r.error[j] = 2 * kEps * std::fabs(r.value[j]);
  }
  return r;
}

ExactPlane DepthMap::exact(const Plane& plane) const {
  const Vec4 pi = homogeneous(plane);
  ExactPlane result;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 4; ++i) result[j] = result[j] + Expansion(pi[i]) * adjugate_[i][j];
  return result;
}

int compare_exactly(const ExactPlane& p, const ExactPlane& q, double x, double y) {
  const auto over = [&](const ExactPlane& e) {
    return e[0] * Expansion(x) + e[1] * Expansion(y) + e[2];
  };
  // z_f - z_g = -P/p3 + Q/q3, so its sign is that of (Q p3 - P q3) times those of p3 and q3.
  const Expansion difference = over(q) * p[3] - over(p) * q[3];
  return difference.sign() * p[3].sign() * q[3].sign();
}

namespace {
const std::vector<Plane> kNoFurther;
}

double crossing_exactly(const ExactPlane& p, const ExactPlane& q, double y) {
  const auto difference = [&](int i) { return q[i] * p[3] - p[i] * q[3]; };
  const Expansion at_zero = difference(1) * Expansion(y) + difference(2);
  return -at_zero.approximate() / difference(0).approximate();
}

DepthField::DepthField(const std::vector<Plane>& planes, const View& view)
    : map_(planes, kNoFurther, view), asked_(planes.size()), exact_(planes.size()) {
  depths_.reserve(planes.size());
  seen_edge_on_.reserve(planes.size());
  for (Index p = 0; p < planes.size(); ++p) {
    const std::optional<DepthPlane> d = map_.depth(p);
    depths_.push_back(d.value_or(DepthPlane{}));
    seen_edge_on_.push_back(!d);
  }
}

const ExactPlane& DepthField::exact(Index plane) const {
  std::call_once(asked_[plane],
                 [&] { exact_[plane] = std::make_unique<const ExactPlane>(map_.exact(plane)); });
  return *exact_[plane];
}

int DepthField::compare(Index f, Index g, double x, double y) const {
  if (f == g) return 0;
  const int side = compare_roughly(depths_[f], depths_[g], x, y);
  return side != 0 ? side : compare_exactly(exact(f), exact(g), x, y);
}

}  // namespace overstrike
