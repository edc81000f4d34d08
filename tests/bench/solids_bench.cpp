// Boolean solids, one thread, from the canonical input to runs, beside a ray caster in the same run
// (embree_solids.h; its build is in its time). `wrong_ppm`: judge.h, but H0 and H1: levels.h.
// `x_embree`: how many times faster than that. Not judged: nested differences and deep trees, which
// share so many planes that the oracle's definition of what is shown takes forever.
#include <cmath>

#include "core/drawing.h"
#include "tests/bench/contest.h"
#include "tests/bench/embree_solids.h"
#include "tests/bench/levels.h"
#include "tests/bench/solid_scenes.h"

namespace overstrike::bench {
namespace {

/// Many faces lie in one plane there; a row of cells takes the oracle a second.
constexpr int kJudgedRowsOfHoles = 2;

Line our_line(const Prepared& prepared, const Times& times) {
  return {times, {{"from_scene_ms", prepared.canonicalize_ms + median(times.cpu)}}};
}

/// Nine prisms: the ray caster, the same bodies united (as one solid, and as bodies that stand for
/// themselves), and what is left when the middle one is taken from `cut` of the others.
std::vector<Line> against_union(int sides, int cut, int size) {
  const Grid grid = square_grid(size);
  const Prepared solid = prepare(nine_prisms(sides, cut), grid);
  const Prepared united = prepare(nine_prisms(sides, 0), grid);
  const Prepared loose = prepare(scene_b(sides), grid);
  EmbreeSolids embree(solid);
  std::size_t runs = 0;
  const std::vector<Times> times =
      interleaved({[&] { embree.build(), embree.trace(); }, [&] { draw_runs(loose, 1); },
                   [&] { draw_runs(united, 1); }, [&] { runs = draw_runs(solid, 1); }},
                  kBudgetMs);
  const Errors errors = judge(solid, {[&](int row) { return embree.row(row); }});
  Line ours = our_line(solid, times[3]);
  ours.counters["x_embree"] = ratio(times[0].cpu, times[3].cpu);
  ours.counters["x_united"] = ratio(times[3].cpu, times[2].cpu);
  ours.counters["x_loose"] = ratio(times[3].cpu, times[1].cpu);
  ours.counters["wrong_ppm"] = errors.ours;
  ours.counters["runs"] = static_cast<double>(runs);
  return {{times[0], {{"wrong_ppm", errors.peers[0]}}}, {times[1], {}}, {times[2], {}}, ours};
}

/// The same scene at several sizes: `x_lines` is the time against the first size's, over the ratio
/// of lines.
std::vector<Line> growth(const std::vector<int>& sizes) {
  std::vector<Prepared> prepared;
  for (const int size : sizes) prepared.push_back(prepare(nine_prisms(32, 8), square_grid(size)));
  std::vector<Job> jobs;
  for (const Prepared& p : prepared) jobs.push_back([&p] { draw_runs(p, 1); });
  const std::vector<Times> times = interleaved(jobs, kBudgetMs);
  std::vector<Line> lines;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    Line line = our_line(prepared[i], times[i]);
    line.counters["x_lines"] = ratio(times[i].cpu, times[0].cpu) * sizes[0] / sizes[i];
    lines.push_back(std::move(line));
  }
  return lines;
}

/// Wrong pixels of H0 or H1 where they stand, by the oracle's picture of where they were defined.
std::vector<Line> caps(double half_height, Turned turned, double far) {
  const Grid grid = square_grid(512);
  const Scene scene = nine_prisms(32, 8, half_height);
  const Levels truth = true_levels(prepare(scene, grid));
  const Prepared there = prepare(moved(scene, turned, far), grid);
  EmbreeSolids embree(there);
  const std::vector<Times> times =
      interleaved({[&] { embree.build(), embree.trace(); }, [&] { draw_runs(there, 1); }}, 0);
  const Levels theirs = levels_of(there, [&](int row) { return embree.row(row); });
  Line ours = our_line(there, times[1]);
  ours.counters["wrong_pixels"] = wrong_pixels(truth, drawn_levels(there));
  return {{times[0], {{"wrong_pixels", static_cast<double>(wrong_pixels(truth, theirs))}}}, ours};
}

std::vector<Line> alone(const Scene& scene, int judged_rows) {
  const Prepared prepared = prepare(scene, square_grid(512));
  std::size_t runs = 0;
  const std::vector<Times> times = interleaved({[&] { runs = draw_runs(prepared, 1); }}, kBudgetMs);
  Line line = our_line(prepared, times[0]);
  line.counters["runs"] = static_cast<double>(runs);
  if (judged_rows > 0) {
    const std::vector<int> rows = sampled_rows(prepared.view.grid, judged_rows);
    line.counters["wrong_ppm"] = wrong_ppm(prepared, rows, runs_of_rows(prepared, rows), 500);
  }
  return {line};
}

void add_alone(const std::string& name, const std::function<Scene()>& make, int judged_rows = 0) {
  register_lines({name, {"overstrike"}, [=] { return alone(make(), judged_rows); }});
}

void register_all() {
  const std::vector<std::string> methods = {"embree", "loose", "united", "overstrike"};
  for (const int sides : {10, 20, 32, 50, 100})
    for (const int cut : {0, 4, 8})
      register_lines(
          {"nine_prisms/sides:" + std::to_string(sides) + "/cut:" + std::to_string(cut) + "/512",
           methods, [=] { return against_union(sides, cut, 512); }});
  for (const int size : {128, 256, 1024, 2048, 4096})
    register_lines({"nine_prisms/sides:32/cut:8/" + std::to_string(size), methods,
                    [=] { return against_union(32, 8, size); }});
  const std::vector<int> sizes = {128, 256, 512, 1024, 2048, 4096};
  std::vector<std::string> names;
  for (const int size : sizes) names.push_back(std::to_string(size));
  register_lines({"growth/sides:32/cut:8", names, [=] { return growth(sizes); }});
  for (const double half_height : {1.2, 1.0})
    for (const Turned turned : {Turned::no, Turned::placed, Turned::baked})
      for (const double far : {0.0, 1e2, 1e4, 1e6, 1e8}) {
        constexpr const char* kTurned[] = {"axes", "placed", "baked"};
        register_lines({std::string(half_height > 1 ? "H0/" : "H1/") +
                            kTurned[static_cast<int>(turned)] + "/" +
                            std::to_string(static_cast<int>(far)),
                        {"embree", "overstrike"},
                        [=] { return caps(half_height, turned, far); }});
      }
  for (const int n : {10, 200})
    for (const bool below : {false, true})
      add_alone("nested:" + std::to_string(n) + (below ? "/below" : "/above"),
                [=] { return nested_differences(n, below); });
  for (const int n : {200, 2000})
    add_alone("left_deep:" + std::to_string(n), [=] { return left_deep(n); });
  add_alone("right_deep:200", [] { return right_deep(200); });
  add_alone("cups:100000", [] { return cups(100'000); });
  add_alone(
      "holes:1000", [] { return holes(1000); }, kJudgedRowsOfHoles);
  add_alone("holes:10000", [] { return holes(10'000); });
}

}  // namespace
}  // namespace overstrike::bench

int main(int argc, char** argv) {
  overstrike::bench::register_all();
  return overstrike::bench::run_lines(argc, argv);
}
