#pragma once
// Which bodies, and which of a body's faces, lie over a region across the light.
#include <memory>
#include <mutex>
#include <vector>

#include "core/visibility/front_table.h"

namespace overstrike {

struct LightRegion {
  Vec2 low{1e300}, high{-1e300};
  void add(const Vec2& p) { low = glm::min(low, p), high = glm::max(high, p); }
  /// More than a touch.
  bool overlaps(const LightRegion& o) const {
    return low.x < o.high.x && o.low.x < high.x && low.y < o.high.y && o.low.y < high.y;
  }
};

/// Things with regions in a grid of cells.
class RegionGrid {
 public:
  RegionGrid() = default;
  /// About `cells_per_thing` cells for each.
  RegionGrid(std::vector<LightRegion> regions, double cells_per_thing);

  /// What turns of looking have seen, so that a thing in several cells is visited once.
  struct Stamps {
    std::vector<std::uint32_t> at;
    std::uint32_t turn = 0;
  };
  /// Calls `visit` once for every thing whose region overlaps.
  template <class Visit>
  void over(const LightRegion& region, Stamps& stamps, const Visit& visit) const {
    if (regions_.empty()) return;
    if (stamps.at.size() < regions_.size()) stamps.at.resize(regions_.size(), 0);
    ++stamps.turn;
    for (int row = row_of(region.low.y), last = row_of(region.high.y); row <= last; ++row)
      for (int column = column_of(region.low.x); column <= column_of(region.high.x); ++column)
        for (Index i = start_[row * side_ + column]; i < start_[row * side_ + column + 1]; ++i) {
          const Index item = items_[i];
          if (stamps.at[item] == stamps.turn) continue;
          stamps.at[item] = stamps.turn;
          if (regions_[item].overlaps(region)) visit(item);
        }
  }

 private:
  int place(double p, double origin, double cells_per_unit) const {
    const double at = (p - origin) * cells_per_unit;
    return at > 0 ? static_cast<int>(at < side_ - 1 ? at : side_ - 1) : 0;
  }
  int column_of(double x) const { return place(x, origin_.x, scale_.x); }
  int row_of(double y) const { return place(y, origin_.y, scale_.y); }

  std::vector<LightRegion> regions_;
  std::vector<Index> start_, items_;
  Vec2 origin_{0.0}, scale_{1.0};
  int side_ = 1;
};

/// The casters of a light's view. What belongs to one body is made when it is first wanted; any
/// number of threads may ask.
class CasterIndex {
 public:
  explicit CasterIndex(const FrontTable& light);

  const RegionGrid& bodies() const { return bodies_; }
  /// The body's casting faces; items count in faces_of().
  const RegionGrid& grid_of(Index body) const { return of_body(body).grid; }
  const std::vector<Index>& faces_of(Index body) const { return of_body(body).faces; }
  /// Per item: the face's outlines cross, so that winding numbers do not say what is inside.
  const std::vector<char>& crossed(Index body) const { return of_body(body).crossed; }

 private:
  struct OfBody {
    std::once_flag faces_once;
    std::vector<Index> faces;
    std::vector<char> crossed;
    RegionGrid grid;
  };
  const OfBody& of_body(Index body) const;
  bool is_crossed(Index face) const;
  void find_faces(Index body, OfBody& of) const;

  const FrontTable& light_;
  RegionGrid bodies_;
  std::unique_ptr<OfBody[]> of_body_;
};

}  // namespace overstrike
