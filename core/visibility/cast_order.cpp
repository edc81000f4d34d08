#include "core/visibility/cast_order.h"

#include <algorithm>

#include "core/visibility/plane_gap.h"

namespace overstrike {
namespace {

constexpr double kEps = 0x1p-52;

/// n . L, and a bound of its error as a part of it.
std::pair<double, double> facing(const Plane& plane, const Vec3& light) {
  const double rough = along(plane, light);
  // What doubles leave twelve digits of they may say (along() has bounded their error).
  constexpr double kDigits = 1e-12;
  if (std::fabs(rough) * kDigits > kDotError) return {rough, kDotError / std::fabs(rough)};
  return {height_of_point(Plane{plane.normal, 0}, light), 2 * kEps};
}

}  // namespace

CastOrder::CastOrder(const DepthMap& eye, const Canonical& casting, const Plane& receiver,
                     std::vector<Index> faces)
    : eye_(eye),
      casting_(casting),
      receiver_(receiver),
      receiver_in_grid_(eye.rounded_with_depth(receiver)),
      sign_(receiver_in_grid_.value[3] > 0 ? eye.orientation() : -eye.orientation()),
      faces_(std::move(faces)) {
  depths_.reserve(faces_.size());
  for (const Index face : faces_) depths_.push_back(height_of(plane_of(face)));
}

std::size_t CastOrder::number_of(Index face) const {
  return static_cast<std::size_t>(std::lower_bound(faces_.begin(), faces_.end(), face) -
                                  faces_.begin());
}

int CastOrder::enters(Index face) const {
  const CanonicalFace& f = casting_.faces[face];
  return side_of_direction(casting_.planes[f.plane], f.flipped, *casting_.light);
}

// Each component of c is the difference of two products of two components: off by their errors
// times each other, and by three roundings. Doubled for rounding the bound.
DepthPlane CastOrder::height_of(const Plane& plane) const {
  const DepthMap::RoundedPlane g = eye_.rounded(plane);
  const DepthMap::RoundedPlane& r = receiver_in_grid_;
  const auto [along_light, relative] = facing(plane, *casting_.light);
  const double over = -sign_ / along_light;
  double value[3], error[3];
  for (int j = 0; j < 3; ++j) {
    const double p = r.value[3] * g.value[j], q = g.value[3] * r.value[j];
    value[j] = (p - q) * over;
    const double off = std::fabs(r.value[3]) * g.error[j] + r.error[3] * std::fabs(g.value[j]) +
                       r.error[3] * g.error[j] + std::fabs(g.value[3]) * r.error[j] +
                       g.error[3] * std::fabs(r.value[j]) + g.error[3] * r.error[j] +
                       2 * kEps * (std::fabs(p) + std::fabs(q));
    // To these the sum over (x, y, 1) adds its own rounding.
    error[j] = 2 * (off * std::fabs(over) + std::fabs(value[j]) * (relative + 4 * kEps));
  }
  return {value[0], value[1], value[2], error[0], error[1], error[2]};
}

ExactPlane CastOrder::exact_height_of(const Plane& plane) const {
  const ExactPlane g = eye_.exact(plane), r = eye_.exact(receiver_);
  ExactPlane result;
  for (int j = 0; j < 3; ++j) result[j] = r[3] * g[j] - g[3] * r[j];
  const Vec3& light = *casting_.light;
  for (int i = 0; i < 3; ++i)
    result[3] = result[3] + Expansion(plane.normal[i]) * Expansion(light[i]);
  if (sign_ < 0) result[3] = -result[3];
  return result;
}

int CastOrder::compare(Index f, Index g, double x, double y) const {
  if (casting_.faces[f].plane == casting_.faces[g].plane) return 0;
  const int side = compare_roughly(depth_of(f), depth_of(g), x, y);
  if (side != 0) return side;
  return compare_exactly(exact_height_of(plane_of(f)), exact_height_of(plane_of(g)), x, y);
}

double CastOrder::crossing(Index f, Index g, double y) const {
  const DepthPlane &p = depth_of(f), &q = depth_of(g);
  const double slope = p.a - q.a;
  const double x = -((p.b - q.b) * y + (p.c - q.c)) / slope;
  const double error = (p.ea + q.ea) * std::fabs(x) + (p.eb + q.eb) * std::fabs(y) + (p.ec + q.ec);
  if (error <= kCrossingError * std::fabs(slope)) return x;
  return crossing_exactly(exact_height_of(plane_of(f)), exact_height_of(plane_of(g)), y);
}

}  // namespace overstrike
