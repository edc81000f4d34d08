#pragma once
// Overstrike and its peers on one scene: times, ratios and errors of one run.
#include "tests/bench/lines.h"
#include "tests/bench/scenes.h"

namespace overstrike::bench {

/// Draws all rows as runs from the canonical input; the number of runs.
std::size_t draw_runs(const Prepared&, int threads);

/// How long to measure a group, when its jobs are not slow.
constexpr double kBudgetMs = 3000;

inline const std::vector<std::string> kContestants = {"embree", "z_buffer", "overstrike"};
/// One line for each of kContestants, one thread. Embree's time has its build in it, which is told
/// as build_ms. x_embree and x_zbuffer: how many times faster than the peer; wrong_ppm: see
/// judge.h; run_end: see run_ends.h.
std::vector<Line> contest(const Scene&, int size);

}  // namespace overstrike::bench
