#pragma once
// A straight line that may be drawn, and how points of the grid lie to it.
#include <array>
#include <cmath>

#include "core/picture.h"
#include "core/visibility/intervals.h"
#include "core/visibility/projected_scene.h"

namespace overstrike {

constexpr std::array<Index, 2> kNoPlanes{kNone, kNone};

struct LineEnd {
  Vec3 world;
  GridPoint grid;
  Index vertex = kNone;  ///< of the canonical input, when it is one
};

/// A candidate for a stroke: straight in space, so straight in the grid, with linear depth there.
/// Parameters along it run from 0 at `a` to 1 at `b`, by distance in the grid.
struct SightLine {
  LineEnd a, b;
  /// The planes it lies in by topology: no face of these hides it.
  std::array<Index, 2> planes = kNoPlanes;
  StrokeKind kind;
  Index body;  ///< kNoSurface: none
  int pen = 0;
  bool curved = false;  ///< stands for a piece of a curve
  Intervals within{{0.0, 1.0}};
  /// The solids in whose surfaces it lies: it is drawn where they are there. Where both are the
  /// same one, it is drawn where that one's surface ends in it or bends.
  std::array<Index, 2> solids{kNone, kNone};
  bool smooth = false;  ///< a surface that bends in it as its facets do is not bent

  bool lies_in(Index plane) const { return planes[0] == plane || planes[1] == plane; }
  /// The parameter of a point that divides the line by s : 1 - s in space.
  double in_grid(double s) const {
    if (s == 0 || s == 1) return s;
    const double wb = s * b.grid.w;
    return wb / ((1 - s) * a.grid.w + wb);
  }
  Vec2 at(double t) const {
    if (t == 0) return a.grid.xy();
    if (t == 1) return b.grid.xy();
    return a.grid.xy() + (b.grid.xy() - a.grid.xy()) * t;
  }
};

/// Measures points of the grid against the straight line through two of them.
class Ruler {
 public:
  Ruler(const GridPoint& a, const GridPoint& b)
      : origin_(a.xy()),
        along_(b.xy() - a.xy()),
        square_(glm::dot(along_, along_)),
        length_(std::sqrt(square_)),
        error_(a.error + b.error) {}

  double length() const { return length_; }
  /// A vector across the line, to its right.
  Vec2 right() const { return Vec2(-along_.y, along_.x); }
  /// Bound on how far the line's ends are from where they were meant.
  double error() const { return error_; }
  /// The ends cannot be told apart: there is no line.
  bool is_point() const { return !(length_ > error_); }
  double parameter(const Vec2& p) const { return glm::dot(along_, p - origin_) / square_; }
  /// Twice the area of the triangle over the line, positive to its right (y is down); exactly 0
  /// when the point lies on the line but for rounding: its own, that of the line's ends (grown by
  /// the lever where the point lies beyond them), and that of the determinant, at most 4 eps of its
  /// terms.
  double side(const GridPoint& p) const {
    const Vec2 v = p.xy() - origin_;
    const double area = along_.x * v.y - along_.y * v.x;
    const double far = std::fabs(v.x) + std::fabs(v.y);
    const double bound = length_ * p.error + error_ * (length_ + far) + 4 * kEps * length_ * far;
    return std::fabs(area) <= bound ? 0 : area;
  }
  /// The parameter at which a side from p to q passes the line; `side_p` and `side_q` are theirs,
  /// of different sign, or one of them 0.
  double crossing(const Vec2& p, double side_p, const Vec2& q, double side_q) const {
    if (side_p == 0) return parameter(p);
    if (side_q == 0) return parameter(q);
    return parameter(p + (q - p) * (side_p / (side_p - side_q)));
  }

 private:
  static constexpr double kEps = 0x1p-52;
  Vec2 origin_, along_;
  double square_, length_, error_;
};

}  // namespace overstrike
