#pragma once
// How wrong a picture is, by the oracle: exact arithmetic over the canonical input, sharing nothing
// with what it judges.
#include <vector>

#include "core/picture.h"
#include "tests/bench/scenes.h"

namespace overstrike::bench {

/// Some rows of a grid, seeded, in increasing order.
std::vector<int> sampled_rows(const Grid&, int count);

/// The runs of some rows, as Overstrike draws them; rows in increasing order.
std::vector<std::vector<DensityRun>> runs_of_rows(const Prepared&, const std::vector<int>& rows,
                                                  int threads = 1);

/// What a method shows at the centres of a row's cells: faces of the canonical input, kNone for
/// paper.
using Shown = std::vector<Index>;
Shown shown_by(const std::vector<DensityRun>& runs, int columns);

/// Of a million cell centres of the rows, at how many each method shows another face than the
/// oracle sees; the last must show that very face, of the others (who have no rule for coincident
/// faces) any in its plane will do. methods[m][i] is what method m shows of rows[i]. Asked wherever
/// two methods differ (at most kMostAsked, seeded, standing for the rest), and at some centres
/// where all agree. For scenes without light and ground.
std::vector<double> wrong_ppm(const Prepared&, const std::vector<int>& rows,
                              const std::vector<std::vector<Shown>>& methods);
constexpr std::size_t kMostAsked = 1000;

/// The same of Overstrike's runs by kind and density, shadows and all, at `count` centres.
double wrong_ppm(const Prepared&, const std::vector<int>& rows,
                 const std::vector<std::vector<DensityRun>>& runs, int count);

}  // namespace overstrike::bench
