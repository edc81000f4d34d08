#include "tests/bench/contest.h"

#include "core/drawing.h"
#include "tests/bench/embree_peer.h"
#include "tests/bench/z_buffer.h"

namespace overstrike::bench {
namespace {

constexpr double kBudgetMs = 3000;

}  // namespace

std::size_t draw_runs(const Prepared& prepared, int threads) {
  DrawOptions options;
  options.threads = threads;
  Drawing drawing(prepared.canonical, prepared.view, options);
  std::size_t runs = 0;
  drawing.runs({}, [&](const RunRow& row) { runs += row.runs.size(); });
  return runs;
}

std::vector<Line> contest(const Scene& scene, int size) {
  const Prepared prepared = prepare(scene, square_grid(size));
  const Triangles triangles = triangles_of(*prepared.canonical);
  ZBuffer z_buffer(triangles, prepared.view, 1);
  EmbreePeer embree(triangles, prepared.view);
  std::size_t runs = 0;
  const std::vector<Times> times =
      interleaved({[&] { embree.build(); }, [&] { embree.trace(); }, [&] { z_buffer.draw(); },
                   [&] { runs = draw_runs(prepared, 1); }},
                  kBudgetMs);
  const Times& ours = times[3];
  const Times with_build{sum(times[0].cpu, times[1].cpu), sum(times[0].wall, times[1].wall)};
  Line embree_line{with_build, {{"build_ms", median(times[0].cpu)}}};
  Line z_line{times[2], {}};
  Line our_line{ours,
                {{"x_embree", ratio(with_build.cpu, ours.cpu)},
                 {"x_zbuffer", ratio(z_line.times.cpu, ours.cpu)},
                 {"runs", static_cast<double>(runs)},
                 {"canonicalize_ms", prepared.canonicalize_ms}}};
  return {embree_line, z_line, our_line};
}

}  // namespace overstrike::bench
