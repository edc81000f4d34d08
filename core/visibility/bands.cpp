#include "core/visibility/bands.h"

#include <algorithm>
#include <cmath>

namespace overstrike {

Bands::Bands(const EyeTable& table, double height) : height_(height) {
  const std::size_t n =
      std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(table.rows / height)));
  edges_.resize(n);
  flat_edges_.resize(n);
  for (Index e = 0; e < table.edges.size(); ++e)
    for (std::size_t b = at(table.edges[e].y0); b <= at(table.edges[e].y1); ++b)
      edges_[b].push_back(e);
  for (Index e = 0; e < table.flat_edges.size(); ++e)
    flat_edges_[at(table.flat_edges[e].y)].push_back(e);
}

std::size_t Bands::at(double y) const {
  const double last = static_cast<double>(edges_.size() - 1);
  return static_cast<std::size_t>(std::clamp(std::floor(y / height_), 0.0, last));
}

}  // namespace overstrike
