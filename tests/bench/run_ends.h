#pragma once
// How far ends of runs are from where they truly are.
#include <vector>

#include "core/picture.h"
#include "tests/bench/scenes.h"

namespace overstrike::bench {

/// The largest distance, in columns, of a run's end within the rows from the nearest point where,
/// in exact arithmetic, an edge of one of the two faces that meet there crosses the row, or their
/// planes have one depth. Of at most kMostEnds ends, seeded. For scenes without light and ground.
double worst_run_end(const Prepared&, const std::vector<int>& rows,
                     const std::vector<std::vector<DensityRun>>& runs);
constexpr int kMostEnds = 1000;

}  // namespace overstrike::bench
