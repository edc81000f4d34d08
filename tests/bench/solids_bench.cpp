// Boolean solids: TK's nine prisms, nested differences and plates with holes, one thread, from the
// canonical input to runs. `wrong_ppm`: of random points on the lines, those at which the oracle
// sees something else, but for points at a true edge; not of nested differences, which share so
// many planes that its definition of what is shown takes forever.
#include <benchmark/benchmark.h>

#include <cmath>
#include <functional>
#include <string>

#include "core/drawing.h"
#include "tests/bench/scenes.h"
#include "tests/oracle/oracle.h"
#include "tests/oracle/random.h"

namespace overstrike::bench {
namespace {

constexpr SetOperation kOperand = SetOperation::operand;

/// Appends a body to the scene and to the tree.
void add_leaf(Scene& scene, Solid& solid, Body body) {
  const auto at = static_cast<Index>(solid.nodes.size());
  solid.nodes.push_back({kOperand, static_cast<Index>(scene.bodies.size()), at + 1});
  scene.bodies.push_back(std::move(body));
}

void end_root(Solid& solid) { solid.nodes[0].end = static_cast<Index>(solid.nodes.size()); }

/// TK 4.8 to 4.11: scene B, its central prism taken from `cut` of the eight others. With none it
/// belongs to the union.
Scene nine_prisms(int sides, int cut) {
  Scene scene = scene_b(sides);
  const std::vector<Body> prisms = std::move(scene.bodies);
  scene.bodies.clear();
  Solid solid;
  solid.nodes.push_back({SetOperation::unite, 0, 0});
  for (int i = 0; i < 8; ++i) {
    if (i < cut) {
      const auto at = static_cast<Index>(solid.nodes.size());
      solid.nodes.push_back({SetOperation::subtract, 0, at + 3});
    }
    add_leaf(scene, solid, prisms[static_cast<std::size_t>(i)]);
    if (i < cut) add_leaf(scene, solid, prisms[8]);
  }
  if (cut == 0) add_leaf(scene, solid, prisms[8]);
  end_root(solid);
  scene.solids.push_back(std::move(solid));
  return scene;
}

Body box(const Vec3& low, const Vec3& size) {
  Body body;
  body.shape = std::make_shared<Shape>(Box{size});
  body.placement.offset = low + Vec3(size.x / 2, size.y / 2, 0);
  return body;
}

/// A plate of 50 x 50 x 20, from which n differences of a slab and a block are taken. Written as
/// sums of products they are (n + 1) 2^n terms. Seen along (-1, 1, -1), or from below.
Scene nested_differences(int n, bool below) {
  Scene scene;
  Solid solid;
  solid.nodes.push_back({SetOperation::subtract, 0, 0});
  add_leaf(scene, solid, box({0, 0, 0}, {50, 50, 20}));
  const Body slab = box({0, 0, 0}, {200, 200, 10});
  Body block = box({0, 0, 0}, {20, 20, 10});
  for (int i = 0; i < n; ++i) {
    const auto at = static_cast<Index>(solid.nodes.size());
    solid.nodes.push_back({SetOperation::subtract, 0, at + 3});
    add_leaf(scene, solid, slab);
    block.placement.offset = Vec3(i + 10, 10, 0);
    add_leaf(scene, solid, block);
  }
  end_root(solid);
  scene.solids.push_back(std::move(solid));
  const Vec3 middle(25, 25, 10);
  scene.camera.eye = middle + Vec3(50, -50, below ? -50 : 50);
  scene.camera.target = middle;
  scene.camera.parallel = true;
  return scene;
}

/// Holes of 16 sides through a plate, a lattice of them.
Scene holes(int n) {
  Scene scene;
  Solid solid;
  solid.nodes.push_back({SetOperation::subtract, 0, 0});
  const int columns = static_cast<int>(std::ceil(std::sqrt(n)));
  add_leaf(scene, solid, box({0, 0, 0}, {1.0 * columns, 1.0 * columns, 1}));
  Body hole;
  hole.shape = std::make_shared<Shape>(Frustum{0.35, 0.35, 1, 16});
  for (int i = 0; i < n; ++i) {
    hole.placement.offset = Vec3(i % columns + 0.5, i / columns + 0.5, 0);
    add_leaf(scene, solid, hole);
  }
  end_root(solid);
  scene.solids.push_back(std::move(solid));
  scene.camera.parallel = true;
  scene.camera.from = {-50, 50};
  return scene;
}

double wrong_ppm(const Prepared& input, const std::vector<std::vector<DensityRun>>& rows) {
  constexpr int kPoints = 500;
  const oracle::Oracle oracle(*input.canonical, input.view);
  oracle::Random random(7);
  int wrong = 0;
  for (int i = 0; i < kPoints; ++i) {
    const auto row = static_cast<std::size_t>(random.below(static_cast<int>(rows.size())));
    const double x = random.in(0, input.view.grid.columns), y = static_cast<double>(row) + 0.5;
    Index face = kNone;
    for (const DensityRun& run : rows[row])
      if (run.x0 <= x && x < run.x1) face = run.surface;
    wrong += oracle.at(x, y).face != face && !oracle.near_edge(x, y, oracle::kEdgeRadius);
  }
  return 1e6 * wrong / kPoints;
}

void draw(benchmark::State& state, const std::function<Scene()>& make, int size, bool judged) {
  const Prepared input = prepare(make(), square_grid(size));
  DrawOptions options;
  options.threads = 1;
  std::size_t runs = 0;
  std::vector<std::vector<DensityRun>> rows(static_cast<std::size_t>(size));
  for (auto _ : state) {
    Drawing drawing(input.canonical, input.view, options);
    runs = 0;
    drawing.runs({0, 1, 0.5}, [&](const RunRow& row) { runs += row.runs.size(); });
  }
  state.counters["runs"] = static_cast<double>(runs);
  if (!judged) return;
  Drawing drawing(input.canonical, input.view, options);
  drawing.runs({0, 1, 0.5}, [&](const RunRow& row) {
    rows[static_cast<std::size_t>(row.index)].assign(row.runs.begin(), row.runs.end());
  });
  state.counters["wrong_ppm"] = wrong_ppm(input, rows);
}

void add(const std::string& name, const std::function<Scene()>& make, int size, bool judged) {
  benchmark::RegisterBenchmark((name + "/" + std::to_string(size)).c_str(),
                               [=](benchmark::State& state) { draw(state, make, size, judged); })
      ->Unit(benchmark::kMillisecond);
}

void add_all() {
  for (const int sides : {10, 20, 32, 50, 100})
    for (const int cut : {0, 4, 8})
      add(
          "nine_prisms/sides:" + std::to_string(sides) + "/cut:" + std::to_string(cut),
          [=] { return nine_prisms(sides, cut); }, 512, true);
  for (const int size : {128, 256, 1024, 2048, 4096})
    add(
        "nine_prisms/sides:32/cut:8", [] { return nine_prisms(32, 8); }, size, true);
  for (const int n : {10, 200})
    for (const bool below : {false, true})
      add(
          "nested:" + std::to_string(n) + (below ? "/below" : "/above"),
          [=] { return nested_differences(n, below); }, 512, false);
  for (const int n : {1000, 10'000})
    add(
        "holes:" + std::to_string(n), [=] { return holes(n); }, 512, n < 10'000);
}

}  // namespace
}  // namespace overstrike::bench

int main(int argc, char** argv) {
  overstrike::bench::add_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
