#pragma once
// Which edges matter to which band of a picture.
#include <vector>

#include "core/visibility/eye_table.h"

namespace overstrike {

/// The edges of each band of the grid, in increasing order; an edge that passes through several is
/// in all of them.
class Bands {
 public:
  /// Bands of `height` from y = 0.
  Bands(const EyeTable& table, double height);
  std::size_t count() const { return edges_.size(); }
  /// The band that holds y; the first or last one for what lies outside.
  std::size_t at(double y) const;
  const std::vector<Index>& edges(std::size_t band) const { return edges_[band]; }
  const std::vector<Index>& flat_edges(std::size_t band) const { return flat_edges_[band]; }

 private:
  double height_;
  std::vector<std::vector<Index>> edges_;
  std::vector<std::vector<Index>> flat_edges_;
};

}  // namespace overstrike
