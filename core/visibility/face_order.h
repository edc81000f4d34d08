#pragma once
// How the seen faces of a FrontTable lie to one another in depth. One a thread.
#include <unordered_map>
#include <vector>

#include "core/visibility/front_table.h"
#include "core/visibility/layer_order.h"

namespace overstrike {

class FaceOrder final : public LayerOrder {
 public:
  explicit FaceOrder(const FrontTable& table) : table_(table), cache_(kCached) {}

  std::size_t face_count() const { return table_.tones.size(); }
  Index plane_of(Index face) const { return table_.plane_of(face); }
  /// A body that is not known to be simple may pass through itself; other bodies are asked for
  /// elsewhere.
  bool crosses(Index face) const {
    return !table_.canonical.bodies[table_.tones[face].body].simple;
  }
  /// Precondition: the face is seen.
  const DepthPlane& depth_of(Index face) const override;
  /// Sign of depth(f) - depth(g) at the point of the grid, exact: 1 when f is nearer.
  int compare(Index f, Index g, double x, double y) const override;
  /// Where on the level the two have one depth, whatever the angle at which they cross; NaN or
  /// infinite when they are parallel along it.
  double crossing(Index f, Index g, double y) const override;
  int enters(Index face) const override { return table_.from_behind(face) ? -1 : 1; }
  /// The same of two planes, to the bit; NaN also where the eye is in one of them.
  double crossing_of_planes(Index p, Index q, double y) const;
  /// f before g at the point, ties decided (tie.h): the ground last.
  bool in_front(Index f, Index g, double x, double y) const;

 private:
  bool wins_tie(Index f, Index g) const;
  double crossing(const DepthPlane& p, Index plane_p, const DepthPlane& q, Index plane_q,
                  double y) const;
  const ExactPlane& exact_of(Index plane) const;
  /// Before two calls of exact_of().
  void make_room() const;

  /// Depths are found when they are wanted; few faces meet others.
  static constexpr std::size_t kCached = 1024;
  struct Cached {
    Index face = kNone;
    DepthPlane depth;
  };
  const FrontTable& table_;
  mutable std::vector<Cached> cache_;
  mutable std::unordered_map<Index, ExactPlane> exact_;  ///< of planes that doubles did not tell
};

}  // namespace overstrike
