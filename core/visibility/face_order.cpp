#include "core/visibility/face_order.h"

#include <limits>

#include "core/visibility/tie.h"

namespace overstrike {

const DepthPlane& FaceOrder::depth_of(Index face) const {
  Cached& cached = cache_[face % kCached];
  if (cached.face != face) cached = {face, *table_.depths.depth(table_.plane_of(face))};
  return cached.depth;
}

const ExactPlane& FaceOrder::exact_of(Index plane) const {
  const auto [at, is_new] = exact_.try_emplace(plane);
  if (is_new) at->second = table_.depths.exact(plane);
  return at->second;
}

void FaceOrder::make_room() const {
  constexpr std::size_t kMostExact = 4096;
  if (exact_.size() >= kMostExact) exact_.clear();
}

int FaceOrder::compare(Index f, Index g, double x, double y) const {
  const Index p = plane_of(f), q = plane_of(g);
  if (p == q) return 0;
  const DepthPlane of_f = depth_of(f);
  const int side = compare_roughly(of_f, depth_of(g), x, y);
  if (side != 0) return side;
  make_room();
  return compare_exactly(exact_of(p), exact_of(q), x, y);
}

double FaceOrder::crossing(Index f, Index g, double y) const {
  const DepthPlane at_f = depth_of(f);
  return crossing(at_f, plane_of(f), depth_of(g), plane_of(g), y);
}

double FaceOrder::crossing_of_planes(Index p, Index q, double y) const {
  const std::optional<DepthPlane> at_p = table_.depths.depth(p), at_q = table_.depths.depth(q);
  if (!at_p || !at_q) return std::numeric_limits<double>::quiet_NaN();
  return crossing(*at_p, p, *at_q, q, y);
}

double FaceOrder::crossing(const DepthPlane& p, Index plane_p, const DepthPlane& q, Index plane_q,
                           double y) const {
  const double slope = p.a - q.a;
  const double x = -((p.b - q.b) * y + (p.c - q.c)) / slope;
  const double error = (p.ea + q.ea) * std::fabs(x) + (p.eb + q.eb) * std::fabs(y) + (p.ec + q.ec);
  if (error <= kCrossingError * std::fabs(slope)) return x;
  make_room();
  return crossing_exactly(exact_of(plane_p), exact_of(plane_q), y);
}

bool FaceOrder::in_front(Index f, Index g, double x, double y) const {
  const int side = compare(f, g, x, y);
  return side != 0 ? side > 0 : wins_tie(f, g);
}

bool FaceOrder::wins_tie(Index f, Index g) const {
  if (f == table_.ground() || g == table_.ground()) return g == table_.ground();
  return overstrike::wins_tie(table_.canonical, f, g);
}

}  // namespace overstrike
