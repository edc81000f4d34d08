#pragma once
// The edges of a solid's operands as levels meet them: in the picture, or over a receiver of its
// shadow.
#include <array>

#include "core/visibility/front_table.h"

namespace overstrike {

struct SolidLine {
  LevelLine line;
  float slack;                 ///< bound on the error of line.x_at
  std::array<Index, 2> faces;  ///< the second may be kNone
  const GridWindow* within;    ///< beyond that it is taken for its border; null: all of it counts
};

class SolidLines {
 public:
  virtual SolidLine line(Index number) const = 0;

 protected:
  ~SolidLines() = default;
};

}  // namespace overstrike
