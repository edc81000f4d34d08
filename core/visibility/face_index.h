#pragma once
// The faces that the eye sees, by where they lie in the picture: what may hide a line, nearest
// first.
#include <vector>

#include "core/visibility/cell_grid.h"
#include "core/visibility/projected_scene.h"

namespace overstrike {

/// A seen face's bounds in the grid, rounding included.
struct FaceBox {
  Vec2 low, high;
  double far, near;  ///< depths; larger is nearer
  Index face;
};

class FaceIndex {
 public:
  explicit FaceIndex(const ProjectedScene& scene);

  const std::vector<FaceBox>& boxes() const { return boxes_; }

  /// Visits each face once a query.
  class Query {
   public:
    explicit Query(const FaceIndex& index) : index_(index), stamp_(index.boxes_.size(), 0) {}
    /// visit(box) for the faces near the line from p to q that reach nearer to the eye than
    /// `behind`, until it returns false.
    template <class Visit>
    void along(const Vec2& p, const Vec2& q, double pad, double behind, const Visit& visit);
    /// visit(number in boxes()) for the faces whose boxes meet this one, depths too.
    template <class Visit>
    void meeting(const FaceBox& box, const Visit& visit);

   private:
    bool first_time(Index item) {
      if (stamp_[item] == turn_) return false;
      stamp_[item] = turn_;
      return true;
    }
    const FaceIndex& index_;
    std::vector<std::uint32_t> stamp_;
    std::uint32_t turn_ = 0;
  };

 private:
  void fill();

  CellGrid grid_;
  std::vector<FaceBox> boxes_;  ///< nearest first
  std::vector<Index> start_, items_;
};

template <class Visit>
void FaceIndex::Query::along(const Vec2& p, const Vec2& q, double pad, double behind,
                             const Visit& visit) {
  ++turn_;
  const Vec2 low = glm::min(p, q) - pad, high = glm::max(p, q) + pad;
  bool go_on = true;
  index_.grid_.along(p, q, pad, [&](std::size_t cell) {
    for (Index i = index_.start_[cell]; go_on && i < index_.start_[cell + 1]; ++i) {
      const Index item = index_.items_[i];
      const FaceBox& box = index_.boxes_[item];
      if (box.near <= behind) break;
      if (!first_time(item)) continue;
      if (box.low.x <= high.x && low.x <= box.high.x && box.low.y <= high.y && low.y <= box.high.y)
        go_on = visit(box);
    }
    return go_on;
  });
}

template <class Visit>
void FaceIndex::Query::meeting(const FaceBox& box, const Visit& visit) {
  ++turn_;
  index_.grid_.in_box(box.low, box.high, [&](std::size_t cell) {
    for (Index i = index_.start_[cell]; i < index_.start_[cell + 1]; ++i) {
      const Index item = index_.items_[i];
      const FaceBox& other = index_.boxes_[item];
      if (other.near < box.far) break;
      if (other.far <= box.near && other.low.x <= box.high.x && box.low.x <= other.high.x &&
          other.low.y <= box.high.y && box.low.y <= other.high.y && first_time(item))
        visit(item);
    }
  });
}

}  // namespace overstrike
