#pragma once
// Pictures of 256 levels, to compare one view of a scene with the same view of it elsewhere: a face
// is 25 + 230 |n.f| for a line of sight along f, paper 0. Parallel views.
#include <cstdint>
#include <functional>
#include <vector>

#include "tests/bench/scenes.h"

namespace overstrike::bench {

/// Row after row, at the centres of cells.
using Levels = std::vector<std::uint8_t>;

/// What shows a face, or kNone, at the centre of each cell of a row.
using FacesOfRow = std::function<std::vector<Index>(int row)>;
Levels levels_of(const Prepared&, const FacesOfRow&);

/// As Overstrike draws it, and as the oracle sees it.
Levels drawn_levels(const Prepared&, int threads = 1);
Levels true_levels(const Prepared&);

/// Pixels that differ by more than two levels: what normals' rounding makes of a level is less.
int wrong_pixels(const Levels& truth, const Levels& found);

}  // namespace overstrike::bench
