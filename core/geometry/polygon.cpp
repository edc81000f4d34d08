#include "core/geometry/polygon.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/geometry/error_free.h"

namespace overstrike {
namespace {

/// Bound of the error of the determinant in doubles, relative to the sum of its products' sizes:
/// (3 + 16 u) u with u = 2^-53 (Shewchuk 1997, 4.3, ccwerrboundA).
constexpr double kRoundoff = 0x1p-53;
constexpr double kTurnBound = (3 + 16 * kRoundoff) * kRoundoff;

int sign(double x) { return (x > 0) - (x < 0); }

/// Sign of a sum of doubles, exactly: a nonoverlapping expansion grown term by term.
template <std::size_t N>
int sign_of_sum(const std::array<double, N>& terms) {
  std::array<double, N> expansion{};
  for (std::size_t count = 0; count < N; ++count) {
    double carry = terms[count];
    for (std::size_t i = 0; i < count; ++i) {
      const DoubleDouble s = two_sum(carry, expansion[i]);
      expansion[i] = s.lo;
      carry = s.hi;
    }
    expansion[count] = carry;
  }
  for (std::size_t i = N; i-- > 0;)
    if (expansion[i] != 0) return sign(expansion[i]);
  return 0;
}

int exact_turn_of(const Vec2& a, const Vec2& b, const Vec2& c) {
  const DoubleDouble p[] = {two_product(a.x, b.y),  two_product(-a.y, b.x), two_product(b.x, c.y),
                            two_product(-b.y, c.x), two_product(c.x, a.y),  two_product(-c.y, a.x)};
  std::array<double, 12> terms;
  for (std::size_t i = 0; i < 6; ++i) {
    terms[2 * i] = p[i].lo;
    terms[2 * i + 1] = p[i].hi;
  }
  return sign_of_sum(terms);
}

}  // namespace

int turn_of(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double left = (a.x - c.x) * (b.y - c.y), right = (a.y - c.y) * (b.x - c.x);
  const double determinant = left - right;
  if (std::fabs(determinant) > kTurnBound * (std::fabs(left) + std::fabs(right)))
    return sign(determinant);
  return exact_turn_of(a, b, c);
}

Loop2 without_repeats(const Loop2& loop) {
  Loop2 clean;
  for (const Vec2& point : loop)
    if (clean.empty() || point != clean.back()) clean.push_back(point);
  while (clean.size() > 1 && clean.front() == clean.back()) clean.pop_back();
  return clean;
}

bool is_counter_clockwise(const Loop2& loop) {
  const std::size_t count = loop.size();
  const auto before = [](const Vec2& a, const Vec2& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  };
  const std::size_t lowest =
      static_cast<std::size_t>(std::min_element(loop.begin(), loop.end(), before) - loop.begin());
  return turn_of(loop[(lowest + count - 1) % count], loop[lowest], loop[(lowest + 1) % count]) > 0;
}

bool contains(const Loop2& loop, const Vec2& point) {
  bool inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
    if ((a.y <= point.y) == (b.y <= point.y)) continue;
    const int side = turn_of(a, b, point);
    if (a.y <= point.y ? side > 0 : side < 0) inside = !inside;
  }
  return inside;
}

namespace {

bool touches(const Loop2& loop, const Vec2& point) {
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
    const bool beside = (a.x < point.x && b.x < point.x) || (a.x > point.x && b.x > point.x) ||
                        (a.y < point.y && b.y < point.y) || (a.y > point.y && b.y > point.y);
    if (!beside && turn_of(a, b, point) == 0) return true;
  }
  return false;
}

/// Of loops that meet in single points at most.
bool within(const Loop2& inner, const Loop2& outer) {
  for (const Vec2& point : inner)
    if (!touches(outer, point)) return contains(outer, point);
  return contains(outer, (inner[0] + inner[1]) / 2.0);
}

}  // namespace

OrderedRegion in_order(const std::vector<Loop2>& loops) {
  const std::size_t count = loops.size();
  OrderedRegion region;
  std::vector<std::vector<std::size_t>> around(count);
  for (std::size_t i = 0; i < count; ++i) {
    region.loops.push_back(without_repeats(loops[i]));
    for (std::size_t j = 0; j < count; ++j)
      if (i != j && within(loops[i], loops[j])) around[i].push_back(j);
  }
  std::map<std::size_t, std::size_t> piece_of;
  for (std::size_t i = 0; i < count; ++i) {
    Loop2& loop = region.loops[i];
    const bool hole = around[i].size() % 2 == 1;
    if (is_counter_clockwise(loop) == hole) std::reverse(loop.begin(), loop.end());
    if (hole) continue;
    piece_of[i] = region.pieces.size();
    region.pieces.push_back({i, {}});
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (around[i].size() % 2 == 0) continue;
    // The loop just around a hole is the one of those around it that lies deepest.
    const std::size_t outline = *std::max_element(
        around[i].begin(), around[i].end(),
        [&](std::size_t a, std::size_t b) { return around[a].size() < around[b].size(); });
    region.pieces[piece_of.at(outline)].holes.push_back(i);
  }
  return region;
}

namespace {

class LineNumbers {
 public:
  std::vector<Index> of(const Loop2& loop) {
    const std::size_t count = loop.size();
    const auto corner = [&](std::size_t i) {
      return turn_of(loop[(i + count - 1) % count], loop[i], loop[(i + 1) % count]) != 0;
    };
    // Start at a corner, so that no straight run passes the loop's end.
    std::size_t start = 0;
    while (start + 1 < count && !corner(start)) ++start;
    std::vector<Index> numbers(count);
    Index current = 0;
    for (std::size_t step = 0; step < count; ++step) {
      const std::size_t i = (start + step) % count;
      if (step == 0 || corner(i)) current = number_of(loop[i], loop[(i + 1) % count]);
      numbers[i] = current;
    }
    return numbers;
  }

 private:
  Index number_of(const Vec2& a, const Vec2& b) {
    const Index number = a.x == b.x   ? upright_.try_emplace(a.x, next_).first->second
                         : a.y == b.y ? level_.try_emplace(a.y, next_).first->second
                                      : next_;
    if (number == next_) ++next_;
    return number;
  }

  std::map<double, Index> upright_, level_;
  Index next_ = 0;
};

}  // namespace

std::vector<std::vector<Index>> line_numbers(const std::vector<Loop2>& loops) {
  LineNumbers lines;
  std::vector<std::vector<Index>> numbers;
  for (const Loop2& loop : loops) numbers.push_back(lines.of(loop));
  return numbers;
}

Vec3 vector_area(const std::vector<Vec3>& loop) {
  Vec3 sum{0};
  for (std::size_t i = 1; i + 1 < loop.size(); ++i)
    sum += glm::cross(loop[i] - loop[0], loop[i + 1] - loop[0]);
  return sum;
}

}  // namespace overstrike
