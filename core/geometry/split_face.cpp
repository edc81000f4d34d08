#include "core/geometry/split_face.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace overstrike {
namespace {

/// Seen along the axis that the normal is nearest to, orientation kept. Coordinates stay as given.
Vec2 flat(const Vec3& p, const Vec3& normal) {
  const Vec3 size = glm::abs(normal);
  if (size.z >= size.x && size.z >= size.y) return normal.z > 0 ? Vec2(p.x, p.y) : Vec2(p.y, p.x);
  if (size.y >= size.x) return normal.y > 0 ? Vec2(p.z, p.x) : Vec2(p.x, p.z);
  return normal.x > 0 ? Vec2(p.y, p.z) : Vec2(p.z, p.y);
}

/// The rounding of a 2 x 2 determinant of differences is below (3 + 16u) u times the sum of its
/// products' magnitudes (Shewchuk 1997).
constexpr double kTurnError = 3.3306690738754716e-16;

/// 1 when a, b, c turn left, -1 when right, 0 when rounding could hide which.
int turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double left = (b.x - a.x) * (c.y - a.y), right = (b.y - a.y) * (c.x - a.x);
  const double error = kTurnError * (std::fabs(left) + std::fabs(right));
  return left - right > error ? 1 : left - right < -error ? -1 : 0;
}

bool cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

bool before(const Vec3& a, const Vec3& b) {
  if (a.x != b.x) return a.x < b.x;
  return a.y != b.y ? a.y < b.y : a.z < b.z;
}

class EarCutter {
 public:
  EarCutter(std::span<const Vec3> loop, const Vec3& normal) : loop_(loop) {
    for (const Vec3& p : loop) flat_.push_back(flat(p, normal));
    const auto lowest = std::min_element(loop.begin(), loop.end(), before) - loop.begin();
    for (std::size_t i = 0; i < loop.size(); ++i)
      left_.push_back(static_cast<Index>((lowest + i) % loop.size()));
  }

  std::vector<std::array<Index, 3>> cut() {
    std::vector<std::array<Index, 3>> triangles;
    std::vector<double> cost(left_.size());
    for (std::size_t i = 0; i < left_.size(); ++i) cost[i] = cost_of(i);
    while (left_.size() > 3) {
      const std::size_t i = std::min_element(cost.begin(), cost.end()) - cost.begin();
      triangles.push_back({left_[before_(i)], left_[i], left_[after(i)]});
      left_.erase(left_.begin() + i);
      cost.erase(cost.begin() + i);
      const std::size_t next = i == left_.size() ? 0 : i;
      cost[next] = cost_of(next);
      cost[before_(next)] = cost_of(before_(next));
    }
    triangles.push_back({left_[0], left_[1], left_[2]});
    return triangles;
  }

 private:
  std::size_t before_(std::size_t i) const { return (i == 0 ? left_.size() : i) - 1; }
  std::size_t after(std::size_t i) const { return i + 1 == left_.size() ? 0 : i + 1; }

  /// The length of the diagonal; much more for what is no ear, so that it is cut last.
  double cost_of(std::size_t i) const {
    const Index a = left_[before_(i)], b = left_[i], c = left_[after(i)];
    const double length = glm::distance(loop_[a], loop_[c]);
    return is_ear(a, b, c) ? length : 1e300;
  }
  bool is_ear(Index a, Index b, Index c) const {
    if (turn(flat_[a], flat_[b], flat_[c]) <= 0) return false;
    return std::none_of(left_.begin(), left_.end(), [&](Index v) {
      if (loop_[v] == loop_[a] || loop_[v] == loop_[b] || loop_[v] == loop_[c]) return false;
      return turn(flat_[a], flat_[b], flat_[v]) >= 0 && turn(flat_[b], flat_[c], flat_[v]) >= 0 &&
             turn(flat_[c], flat_[a], flat_[v]) >= 0;
    });
  }

  std::span<const Vec3> loop_;
  std::vector<Vec2> flat_;
  std::vector<Index> left_;  ///< corners not cut off yet
};

struct Side {
  Vec2 a, b;
};

std::vector<Side> sides_of(std::span<const std::vector<Vec3>> loops, const Vec3& normal) {
  std::vector<Side> sides;
  for (const std::vector<Vec3>& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i)
      sides.push_back({flat(loop[i], normal), flat(loop[(i + 1) % loop.size()], normal)});
  return sides;
}

}  // namespace

bool is_convex(std::span<const Vec3> loop, const Vec3& normal) {
  const std::size_t n = loop.size();
  int peaks = 0;  // of x; a convex loop has one
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = flat(loop[i], normal), b = flat(loop[(i + 1) % n], normal),
               c = flat(loop[(i + 2) % n], normal);
    if (turn(a, b, c) <= 0) return false;
    peaks += a.x <= b.x && b.x > c.x;
  }
  return peaks == 1;
}

std::vector<std::array<Index, 3>> triangles_of(std::span<const Vec3> loop, const Vec3& normal) {
  return loop.size() < 3 ? std::vector<std::array<Index, 3>>{} : EarCutter(loop, normal).cut();
}

std::vector<Index> bridged(std::span<const std::vector<Vec3>> loops, const Vec3& normal) {
  std::vector<Vec3> all;
  std::vector<std::vector<Index>> waiting;
  for (const std::vector<Vec3>& loop : loops) {
    waiting.emplace_back(loop.size());
    std::iota(waiting.back().begin(), waiting.back().end(), static_cast<Index>(all.size()));
    all.insert(all.end(), loop.begin(), loop.end());
  }
  const std::vector<Side> sides = sides_of(loops, normal);
  std::vector<Index> outline = waiting.front();
  waiting.erase(waiting.begin());
  while (!waiting.empty()) {
    double shortest = 1e300;
    std::size_t hole = 0, from = 0, to = 0;
    for (std::size_t h = 0; h < waiting.size(); ++h)
      for (std::size_t i = 0; i < outline.size(); ++i)
        for (std::size_t k = 0; k < waiting[h].size(); ++k) {
          const Vec3 &a = all[outline[i]], &b = all[waiting[h][k]];
          const double length = glm::distance(a, b);
          if (length >= shortest) continue;
          const Side bridge{flat(a, normal), flat(b, normal)};
          if (std::any_of(sides.begin(), sides.end(),
                          [&](const Side& s) { return cross(bridge.a, bridge.b, s.a, s.b); }))
            continue;
          shortest = length, hole = h, from = i, to = k;
        }
    std::vector<Index> detour(waiting[hole].begin() + to, waiting[hole].end());
    detour.insert(detour.end(), waiting[hole].begin(), waiting[hole].begin() + to + 1);
    detour.push_back(outline[from]);
    outline.insert(outline.begin() + from + 1, detour.begin(), detour.end());
    waiting.erase(waiting.begin() + hole);
  }
  return outline;
}

bool crosses_itself(std::span<const std::vector<Vec3>> loops, const Vec3& normal) {
  if (loops.size() == 1 && is_convex(loops[0], normal)) return false;
  std::vector<Side> sides = sides_of(loops, normal);
  const auto low = [](const Side& s) { return std::min(s.a.x, s.b.x); };
  const auto high = [](const Side& s) { return std::max(s.a.x, s.b.x); };
  std::sort(sides.begin(), sides.end(),
            [&](const Side& s, const Side& t) { return low(s) < low(t); });
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t k = i + 1; k < sides.size() && low(sides[k]) <= high(sides[i]); ++k)
      if (cross(sides[i].a, sides[i].b, sides[k].a, sides[k].b)) return true;
  return false;
}

}  // namespace overstrike
