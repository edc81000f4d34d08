#include "scenes/readers/openscad/offset.h"

#include <algorithm>

#include "core/geometry/region_sets.h"
#include "core/geometry/trig.h"

namespace overstrike::openscad {
namespace {

enum class Corner : std::uint8_t { round, sharp, chamfer };

Vec2 left_of(const Vec2& v) { return {-v.y, v.x}; }
double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

/// The band between a region's border and where it moves to: a strip along each edge, and at each
/// corner that opens to that side what joins its strips.
class Band {
 public:
  Band(double distance, Corner corner, int fragments)
      : distance_(distance), corner_(corner), step_deg_(360.0 / fragments) {}

  void add(const std::vector<Vec2>& loop) {
    const std::size_t n = loop.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vec2 &a = loop[i], &b = loop[(i + 1) % n], &c = loop[(i + 2) % n];
      const Vec2 before = moved(a, b), after = moved(b, c);
      parts.push_back({{{a, b, b + before, a + before}}});
      if (cross(before, after) * distance_ > 0) add_corner(b, before, after);
    }
  }

  std::vector<Region> parts;

 private:
  /// Outwards from the edge, a region's outlines being counter-clockwise and its holes clockwise.
  Vec2 moved(const Vec2& a, const Vec2& b) const {
    return left_of(glm::normalize(b - a)) * -distance_;
  }

  void add_corner(const Vec2& at, const Vec2& before, const Vec2& after) {
    std::vector<Vec2> fan{at, at + before};
    if (corner_ == Corner::sharp) {
      fan.push_back(at + meeting(before, after));
    } else if (corner_ == Corner::chamfer) {
      // A cut across the bisector, `distance` from the corner.
      const Vec2 far = glm::normalize(before + after) * std::fabs(distance_);
      fan.push_back(at + meeting(before, far));
      fan.push_back(at + meeting(after, far));
    } else {
      const double turn = atan2_deg(cross(before, after), glm::dot(before, after));
      const int steps = static_cast<int>(std::fabs(turn) / step_deg_ + 0.5);
      for (int k = 1; k < steps; ++k) {
        const double angle = k * (turn < 0 ? -step_deg_ : step_deg_);
        fan.push_back(at + before * cos_deg(angle) + left_of(before) * sin_deg(angle));
      }
    }
    fan.push_back(at + after);
    parts.push_back({{std::move(fan)}});
  }

  /// Where the lines across the ends of two equally long vectors meet.
  static Vec2 meeting(const Vec2& a, const Vec2& b) {
    const Vec2 middle = a + b;
    return middle * (glm::dot(a, a) / (glm::dot(middle, middle) / 2));
  }

  double distance_;
  Corner corner_;
  double step_deg_;
};

}  // namespace

Region offset(const Arguments& a, const Region& region) {
  const bool round = a.has("r") || !a.has("delta");
  const double distance = a.number(round ? "r" : "delta", 1);
  if (distance == 0 || !std::isfinite(distance) || region.loops.empty()) return region;
  const Corner corner = round                         ? Corner::round
                        : a.boolean("chamfer", false) ? Corner::chamfer
                                                      : Corner::sharp;
  Band band(distance, corner, a.fragments(std::fabs(distance)));
  for (const auto& loop : region.loops) band.add(loop);
  std::vector<Region> operands{region};
  operands.insert(operands.end(), band.parts.begin(), band.parts.end());
  return combine(distance > 0 ? SetOperation::unite : SetOperation::subtract, operands);
}

}  // namespace overstrike::openscad
