#pragma once
// The front of one body on a level, found by walking from face to face (NN74, scan).
#include <optional>
#include <span>
#include <vector>

#include "core/visibility/front_table.h"

namespace overstrike {

/// A side that a level meets, and the seen face on its right (kNone: none, the front ends).
struct FrontSide {
  double x0, y0, y1;  ///< met by the levels y0 <= y < y1
  double slope;
  Index face;
  float slack;  ///< bound on the error of x_at

  double x_at(double y) const { return x0 + (y - y0) * slope; }
};

/// Where a front begins and ends on a level.
struct Outline {
  enum class Kind { none, one, several };
  Kind kind = Kind::none;
  const LevelLine *left = nullptr, *right = nullptr;
  Side first{};               ///< what a walk begins with; not of a small body
  Index last_corner = kNone;  ///< and what it ends with
};

/// Walks fronts; what was found is kept for the levels between the same vertices. One a thread.
class FrontWalker {
 public:
  explicit FrontWalker(const FrontTable& table);

  /// Cheap for rising levels.
  Outline outline_at(Index body, double y);
  /// The front's sides from left to right; empty when the walk did not arrive, which rounding can
  /// do where faces are seen edge-on, and faces that are not convex where a level meets them twice.
  /// Precondition: outline_at() found one. Valid until the next call.
  std::span<const FrontSide> front_at(Index body, double y, const Outline& outline);

  /// A front whose sides stay in order, but for their slack, at the levels from <= y < until.
  struct SteadyFront {
    std::span<const FrontSide> sides;
    double from, until;
  };
  /// What front_at() found last for the body, if it is kept and steady. Valid as that is.
  std::optional<SteadyFront> steady_front(Index body);

 private:
  enum class Steady : std::uint8_t { unknown, no, yes };
  struct Front {
    double from = 0, until = 0;
    Index first = 0, count = 0, room = 0;  ///< in kept_
    Index turn = 0;                        ///< when not turn_, nothing is kept
    Steady steady = Steady::unknown;
  };
  struct Cursor {
    Index left = 0, right = 0;
  };
  const LevelLine* chain_at(Index first, Index end, double y) const;
  Outline small_outline(const FrontBody& front, double y) const;
  bool list_small(const FrontBody& front, double y);
  bool walk(Index body, double y, const Outline& outline, Front& front);
  bool walk_triangles(const CanonicalBody& body, const LineError& error, double y,
                      const Outline& outline, Front& front);
  void keep(Front& front);
  bool stays_in_order(const Front& front) const;
  void add(const FrontBody& body, const LevelLine& line, Index face, Front& front);
  Index exit_of(Index face, Index entry, double y) const;
  void seek(Index& cursor, Index first, Index end, double y) const;

  const FrontTable& table_;
  std::vector<Front> fronts_;
  std::vector<FrontSide> kept_;   ///< of all fronts; emptied when there are too many
  Index turn_ = 1;                ///< of emptying
  std::vector<FrontSide> sides_;  ///< of the walk in hand
  std::vector<Cursor> cursors_;
};

}  // namespace overstrike
