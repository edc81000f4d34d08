#pragma once
// Overstrike and its peers on one scene: times, ratios and errors of one run.
#include "tests/bench/judge.h"
#include "tests/bench/lines.h"
#include "tests/bench/scenes.h"
#include "tests/bench/triangles.h"

namespace overstrike::bench {

/// Draws all rows as runs from the canonical input; the number of runs.
std::size_t draw_runs(const Prepared&, int threads);

/// How long to measure a group, when its jobs are not slow.
constexpr double kBudgetMs = 3000;

/// What a peer shows in a row.
using ShownRow = std::function<Shown(int row)>;
/// `peer` has row(); it and the triangles must outlive the result.
template <class Peer>
ShownRow shown_by(Peer& peer, const Triangles& triangles) {
  return [&peer, &triangles](int row) {
    Shown shown;
    for (const std::uint32_t t : peer.row(row))
      shown.push_back(t == kNothing ? kNone : triangles.faces[t]);
    return shown;
  };
}

/// The peers' errors in their order, and Overstrike's: judge.h and run_ends.h.
struct Errors {
  std::vector<double> peers;
  double ours, run_end;
};
Errors judge(const Prepared&, const std::vector<ShownRow>& peers, int threads = 1);

inline const std::vector<std::string> kContestants = {"embree", "z_buffer", "overstrike"};
/// One line for each of kContestants, one thread. Embree's time has its build in it, which is told
/// as build_ms. x_embree and x_zbuffer: how many times faster than the peer; wrong_ppm: see
/// judge.h; run_end: see run_ends.h.
std::vector<Line> contest(const Scene&, int size, bool copies = false);

}  // namespace overstrike::bench
