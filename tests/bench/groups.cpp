#include "tests/bench/groups.h"

#include "core/drawing.h"
#include "scenes/readers/read.h"
#include "tests/bench/contest.h"
#include "tests/bench/z_buffer.h"

namespace overstrike::bench {
namespace {

constexpr int kJudgedRows = 64;
constexpr int kJudgedPoints = 1000;

double wrong_ppm(const Prepared& prepared) {
  const std::vector<int> rows = sampled_rows(prepared.view.grid, kJudgedRows);
  return wrong_ppm(prepared, rows, runs_of_rows(prepared, rows), kJudgedPoints);
}

void add_errors(const Errors& errors, Line& z_buffer, Line& ours) {
  z_buffer.counters["wrong_ppm"] = errors.peers[0];
  ours.counters["wrong_ppm"] = errors.ours;
  ours.counters["run_end"] = errors.run_end;
}

}  // namespace

std::vector<Line> light_lines(const Scene& plain, const Scene& lit, int size) {
  const Prepared dark = prepare(plain, square_grid(size)), light = prepare(lit, square_grid(size));
  const std::vector<Times> times =
      interleaved({[&] { draw_runs(dark, 1); }, [&] { draw_runs(light, 1); }}, kBudgetMs);
  return {{times[0], {{"wrong_ppm", wrong_ppm(dark)}}},
          {times[1],
           {{"wrong_ppm", wrong_ppm(light)}, {"x_plain", ratio(times[1].cpu, times[0].cpu)}}}};
}

std::vector<std::string> growth_methods(const std::vector<int>& sizes) {
  std::vector<std::string> methods;
  for (const int size : sizes)
    for (const char* method : {"z_buffer/", "overstrike/"})
      methods.push_back(method + std::to_string(size));
  return methods;
}

std::vector<Line> growth_lines(const Scene& scene, const std::vector<int>& sizes) {
  std::vector<Prepared> prepared;
  for (const int size : sizes) prepared.push_back(prepare(scene, square_grid(size)));
  const Triangles triangles = triangles_of(*prepared[0].canonical);
  std::vector<ZBuffer> buffers;
  for (const Prepared& p : prepared) buffers.emplace_back(triangles, p.view, 1);
  std::vector<Job> jobs;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    jobs.push_back([&, i] { buffers[i].draw(); });
    jobs.push_back([&, i] { draw_runs(prepared[i], 1); });
  }
  const std::vector<Times> times = interleaved(jobs, kBudgetMs);
  std::vector<Line> lines;
  for (std::size_t i = 0; i < times.size(); ++i)
    lines.push_back({times[i], {{"x_first", ratio(times[i].cpu, times[i % 2].cpu)}}});
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    Line &theirs = lines[2 * i], &ours = lines[2 * i + 1];
    ours.counters["x_zbuffer"] = ratio(theirs.times.cpu, ours.times.cpu);
    const Errors errors = judge(prepared[i], {shown_by(buffers[i], triangles)});
    add_errors(errors, theirs, ours);
  }
  return lines;
}

std::vector<Line> thread_lines(const Scene& scene, int size) {
  const Prepared prepared = prepare(scene, square_grid(size));
  const Triangles triangles = triangles_of(*prepared.canonical);
  ZBuffer one(triangles, prepared.view, 1), two(triangles, prepared.view, 2);
  const std::vector<Times> times =
      interleaved({[&] { one.draw(); }, [&] { two.draw(); }, [&] { draw_runs(prepared, 1); },
                   [&] { draw_runs(prepared, 2); }},
                  kBudgetMs);
  std::vector<Line> lines;
  for (const Times& t : times) lines.push_back({t, {}});
  for (const std::size_t i : {1, 3})
    lines[i].counters["x_one"] = ratio(times[i - 1].wall, times[i].wall);
  lines[2].counters["x_zbuffer"] = ratio(times[0].wall, times[2].wall);
  lines[3].counters["x_zbuffer"] = ratio(times[1].wall, times[3].wall);
  add_errors(judge(prepared, {shown_by(one, triangles)}, 1), lines[0], lines[2]);
  add_errors(judge(prepared, {shown_by(two, triangles)}, 2), lines[1], lines[3]);
  return lines;
}

std::vector<Line> nn74_lines(const std::string& scene, double seconds_1974) {
  const Scene read = read_scene(OVERSTRIKE_SOURCE_DIR "/scenes/" + scene + ".yaml").scene;
  const Prepared prepared = prepare(read, Grid{});
  const std::vector<Times> times = interleaved({[&] { draw_runs(prepared, 1); }}, kBudgetMs / 10);
  std::vector<double> then(times[0].cpu.size(), seconds_1974 * 1e3);
  return {{times[0],
           {{"x_1974", ratio(then, times[0].cpu)},
            {"wrong_ppm", wrong_ppm(prepared)},
            {"from_scene_ms", prepared.canonicalize_ms + median(times[0].cpu)}}}};
}

}  // namespace overstrike::bench
