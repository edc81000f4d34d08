#include "tests/bench/contest.h"

#include "core/drawing.h"
#include "tests/bench/embree_peer.h"
#include "tests/bench/run_ends.h"
#include "tests/bench/z_buffer.h"

namespace overstrike::bench {
namespace {

/// So many cells are judged, in whole rows.
constexpr int kJudgedCells = 1 << 21;

}  // namespace

std::size_t draw_runs(const Prepared& prepared, int threads) {
  DrawOptions options;
  options.threads = threads;
  Drawing drawing(prepared.canonical, prepared.view, options);
  std::size_t runs = 0;
  drawing.runs({}, [&](const RunRow& row) { runs += row.runs.size(); });
  return runs;
}

Errors judge(const Prepared& prepared, const std::vector<ShownRow>& peers, int threads) {
  const int columns = static_cast<int>(prepared.view.grid.columns);
  const std::vector<int> rows = sampled_rows(prepared.view.grid, kJudgedCells / columns);
  const auto runs = runs_of_rows(prepared, rows, threads);
  std::vector<std::vector<Shown>> methods(peers.size() + 1);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t p = 0; p < peers.size(); ++p) methods[p].push_back(peers[p](rows[i]));
    methods.back().push_back(shown_by(runs[i], columns));
  }
  std::vector<double> wrong = wrong_ppm(prepared, rows, methods);
  const double ours = wrong.back();
  wrong.pop_back();
  return {wrong, ours, worst_run_end(prepared, rows, runs)};
}

std::vector<Line> contest(const Scene& scene, int size, bool copies) {
  const Prepared prepared = prepare(scene, square_grid(size));
  const Triangles triangles = triangles_of(*prepared.canonical);
  ZBuffer z_buffer(triangles, prepared.view, 1);
  const Copies shared = copies ? copies_of(triangles, *prepared.canonical) : Copies{};
  EmbreePeer embree(copies ? shared.first : triangles, prepared.view, shared.shifts);
  std::size_t runs = 0;
  const std::vector<Times> times =
      interleaved({[&] { embree.build(); }, [&] { embree.trace(); }, [&] { z_buffer.draw(); },
                   [&] { runs = draw_runs(prepared, 1); }},
                  kBudgetMs);
  const Errors errors =
      judge(prepared, {shown_by(embree, triangles), shown_by(z_buffer, triangles)});
  const Times& ours = times[3];
  const Times traced{sum(times[0].cpu, times[1].cpu), sum(times[0].wall, times[1].wall)};
  const Line embree_line{traced,
                         {{"build_ms", median(times[0].cpu)}, {"wrong_ppm", errors.peers[0]}}};
  const Line z_line{times[2], {{"wrong_ppm", errors.peers[1]}}};
  const Line our_line{ours,
                      {{"x_embree", ratio(traced.cpu, ours.cpu)},
                       {"x_zbuffer", ratio(times[2].cpu, ours.cpu)},
                       {"wrong_ppm", errors.ours},
                       {"run_end", errors.run_end},
                       {"runs", static_cast<double>(runs)},
                       {"from_scene_ms", prepared.canonicalize_ms + median(ours.cpu)}}};
  return {embree_line, z_line, our_line};
}

}  // namespace overstrike::bench
