// NN74, Table 1, on today's machine: the six scenes, 135 x 180, one thread, by phase.
//
// I light, II eye (tessellation, welding and winged edges are counted here), III scan, all from the
// scene to runs of density; Table 1's own seconds stand beside them. `cells_ms` is what exact area
// averages cost instead of scan lines.
#include <benchmark/benchmark.h>

#include <array>
#include <string>

#include "core/drawing.h"
#include "scenes/readers/read.h"

namespace overstrike {
namespace {

struct Row {
  const char* scene;
  double light_s, eye_s, scan_s;  ///< FACOM 230-60, 1974
};

constexpr std::array<Row, 6> kTable = {{{"nn74-a-solids", 0.19, 0.48, 0.46},
                                        {"nn74-b-prisms", 0.30, 0.80, 0.33},
                                        {"nn74-c-boxes", 0.62, 0.63, 0.31},
                                        {"nn74-d-patterns", 0.65, 0.80, 0.44},
                                        {"nn74-e-hospital", 1.14, 2.80, 0.99},
                                        {"nn74-f-hospital", 1.14, 2.69, 0.59}}};

void draw(benchmark::State& state, const Row& row, Method method) {
  const Scene scene =
      read_scene(std::string(OVERSTRIKE_SOURCE_DIR "/scenes/") + row.scene + ".yaml").scene;
  DrawOptions options;
  options.threads = 1;
  options.method = method;
  Timings sum;
  double cells_ms = 0;
  std::size_t runs = 0;
  for (auto _ : state) {
    Drawing drawing(scene, Grid{}, options);
    runs = 0;
    drawing.runs({}, [&](const RunRow& line) { runs += line.runs.size(); });
    const Timings& t = drawing.timings();
    sum.light_ms += t.light_ms, sum.eye_ms += t.eye_ms, sum.scan_ms += t.scan_ms;
    state.PauseTiming();
    const double before = t.scan_ms;
    drawing.cells([](const CellRow& cells) { benchmark::DoNotOptimize(cells.density.data()); });
    cells_ms += drawing.timings().scan_ms - before;
    state.ResumeTiming();
  }
  const auto mean = [](double ms) {
    return benchmark::Counter(ms, benchmark::Counter::kAvgIterations);
  };
  state.counters["I_ms"] = mean(sum.light_ms);
  state.counters["II_ms"] = mean(sum.eye_ms);
  state.counters["III_ms"] = mean(sum.scan_ms);
  state.counters["cells_ms"] = mean(cells_ms);
  state.counters["runs"] = static_cast<double>(runs);
  state.counters["I_1974_s"] = row.light_s;
  state.counters["II_1974_s"] = row.eye_s;
  state.counters["III_1974_s"] = row.scan_s;
}

}  // namespace
}  // namespace overstrike

int main(int argc, char** argv) {
  using namespace overstrike;
  for (const Row& row : kTable)
    for (const auto& [name, method] :
         {std::pair{"line", Method::line}, std::pair{"nn74", Method::nn74}})
      benchmark::RegisterBenchmark(
          (std::string(row.scene) + "/" + name).c_str(),
          [&row, method = method](benchmark::State& state) { draw(state, row, method); })
          ->Unit(benchmark::kMillisecond);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
}
