#pragma once
// The difference of two depths over the grid, and for how long it is surely positive.
#include <algorithm>
#include <cmath>

#include "core/visibility/depth.h"

namespace overstrike {

/// A line that the levels y0 <= y < y1 meet, with the bound on the error of x_at.
struct SlackLine {
  double x0, y0, y1, slope;
  float slack;
  bool operator==(const SlackLine&) const = default;
  double x_at(double y) const { return x0 + (y - y0) * slope; }
};

/// Linear but for rounding of at most `error` within the columns and levels.
struct DepthDifference {
  double a, b, c, error;

  DepthDifference(const DepthPlane& p, const DepthPlane& q, double columns, double levels)
      : a(p.a - q.a),
        b(p.b - q.b),
        c(p.c - q.c),
        error((p.ea + q.ea) * columns + (p.eb + q.eb) * levels + (p.ec + q.ec)) {}
  double at(double x, double y) const { return a * x + b * y + c; }
  /// Where it vanishes on a level.
  double zero_at(double y) const { return -(b * y + c) / a; }
  /// The levels' own comparison must come out the same: what it computes is off by `error` here and
  /// there, and takes `error` for doubt; its place by the slack of the line at either level.
  double margin(double slack) const { return 3 * error + 2 * std::fabs(a) * slack; }
};

/// Levels y to `until`, between which something is sure.
struct SureLevels {
  double y, until;
  double least;  ///< what is not sure up to there is not worth while

  /// True when value(y), linear but for rounding that the margin covers, is at least the margin
  /// from y to `until`, after that was brought nearer where need be.
  template <class Value>
  bool certify(double margin, const Value& value) {
    const double now = value(y);
    if (!(now >= margin)) return false;
    constexpr int kMostTurns = 4;
    for (int turn = 0; turn < kMostTurns; ++turn) {
      const double then = value(until);
      if (then >= margin) return true;
      // A little before the level where the margin is reached.
      constexpr double kLittle = 0x1p-10;
      until = y + (until - y) * ((now - margin) / (now - then) - kLittle);
      if (!(until >= least)) return false;
    }
    return false;
  }
};

}  // namespace overstrike
