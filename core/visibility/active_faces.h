#pragma once
// The active face list of a scan line: what lies over the present sample span, and which of it is
// seen.
//
// Faces of bodies that cannot pass through one another keep their order while they are active, so
// that a face is compared once, when it enters, with the one that is seen (TK, ch. 4: the candidate
// carried from span to span). Passing an edge between two faces of one surface replaces the
// candidate without a comparison. Only while bodies that may cross are active are depths compared
// at both ends of every span.
#include <functional>
#include <vector>

#include "core/visibility/eye_table.h"

namespace overstrike {

class ActiveFaces {
 public:
  explicit ActiveFaces(const EyeTable& table);

  /// Passes an edge from left to right, or back.
  void pass(const ScanEdge& edge);
  void pass_back(const ScanEdge& edge);
  /// What is seen in the present span says nothing about the next one.
  void forget() { candidate_known_ = false; }
  /// Forgets everything: the place left of every edge.
  void clear();

  bool crossing() const { return crossing_ > 0; }
  const std::vector<Index>& faces() const { return active_; }
  bool shadowed(Index face) const;

  /// The face that is seen at the point, or kNone. Precondition: not crossing(), or the caller
  /// knows that no crossing lies in the span around the point.
  Index seen_at(double x, double y);
  /// The same by comparing all faces.
  Index nearest(double x, double y) const;

 private:
  void toggle(Index face);
  /// True when another active face lies in the face's plane: the face is seen by winning a tie, and
  /// its neighbour, in another plane, need not be seen.
  bool shares_plane(Index face) const;

  const EyeTable& table_;
  std::vector<Index> active_;
  std::vector<Index> position_;  ///< per face: its place in active_, or kNone
  std::vector<int> shadow_count_;
  std::vector<Index> entered_;  ///< since the candidate was found
  Index candidate_ = kNone;
  bool candidate_known_ = true;
  int crossing_ = 0;
};

}  // namespace overstrike
