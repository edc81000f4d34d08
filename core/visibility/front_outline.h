#pragma once
// A body's outline: the sides where its front begins and ends (front_table.h).
#include <span>
#include <vector>

#include "core/visibility/front_table.h"

namespace overstrike {

/// Finds outlines one after another, of bodies whose seen faces are known.
class OutlineFinder {
 public:
  explicit OutlineFinder(FrontTable& table) : table_(table), c_(table.canonical) {}

  /// Lays the body's outline out in the table, or notes that the body is loose.
  void find(Index number);
  /// The ground's, which is the polygon of the grid. Precondition: it has an area.
  void find_ground(std::span<const Vec2> polygon);

 private:
  void clear();
  void find_sides(const CanonicalBody& body, const FrontBody& front, Index face);
  void add_side(const FrontBody& front, const Side& side, Index next, Index other);
  void add_inner_side(const FrontBody& front, const Side& side, Index next, Index other);
  void keep_small(FrontBody& front);
  void keep_outline(Index number);
  void note_manifold_levels(Index number);

  FrontTable& table_;
  const Canonical& c_;
  // Of the body in hand.
  std::vector<OutlineSide> left_, right_;
  std::vector<SmallSide> inner_;  ///< in a picture, as long as they are few
};

}  // namespace overstrike
