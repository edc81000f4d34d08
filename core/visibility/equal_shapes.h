#pragma once
// Which prepared shapes are the same, number for number: a file that writes a mesh out once for
// every copy has as many shapes as copies.
#include <unordered_map>
#include <vector>

#include "core/visibility/prepare_shape.h"

namespace overstrike {

class EqualShapes {
 public:
  /// The first shape asked for that is the same as this one; it must outlive this.
  const PreparedShape* first_of(const PreparedShape& shape);

 private:
  std::unordered_map<const PreparedShape*, const PreparedShape*> known_;
  std::unordered_multimap<std::size_t, const PreparedShape*> by_hash_;
};

}  // namespace overstrike
