// Set operations on plane regions of 100 000 edges. `edges_out`: of the result, which tells that
// something was found.
#include <benchmark/benchmark.h>

#include <random>

#include "core/geometry/circle.h"
#include "core/geometry/region_sets.h"

namespace overstrike::bench {
namespace {

using Regions = std::vector<Region>;

Region disc(const Vec2& middle, double radius, int sides) {
  Region region;
  region.loops.emplace_back();
  for (int i = 0; i < sides; ++i)
    region.loops[0].push_back(middle + radius * part_of_turn(i, sides, 360));
  return region;
}

/// Discs of 100 sides that overlap by threes and fours.
Regions crowd() {
  std::mt19937_64 random(1);
  Regions regions;
  for (int i = 0; i < 1000; ++i) {
    const double x = static_cast<double>(random() % 4096), y = static_cast<double>(random() % 4096);
    regions.push_back(disc(Vec2(x, y) / 4096.0, 0.02, 100));
  }
  return regions;
}

Regions plate_with_holes() {
  Regions regions{Region{{{{0, 0}, {400, 0}, {400, 400}, {0, 400}}}}};
  for (int i = 0; i < 6250; ++i)
    regions.push_back(disc(Vec2(2.5 + 5 * (i % 79), 2.5 + 5 * (i / 79)), 2, 16));
  return regions;
}

Regions two_large() { return {disc({0, 0}, 1, 50'000), disc({0.1, 0}, 1, 50'000)}; }

/// Long parallels that slant, in two directions that differ by little.
Regions zigzag() {
  Region region;
  region.loops.emplace_back();
  for (int i = 0; i < 50'000; ++i) {
    region.loops[0].push_back({i * 2e-5, i * 2e-5 - 0.5});
    region.loops[0].push_back({i * 2e-5 + 1e-5 - 0.5, i * 2e-5 + 1e-5});
  }
  return {region};
}

void combined(benchmark::State& state, const Regions& operands, SetOperation operation) {
  std::size_t edges = 0;
  for (auto _ : state) {
    edges = 0;
    for (const auto& loop : combine(operation, operands).loops) edges += loop.size();
  }
  state.counters["edges_out"] = static_cast<double>(edges);
}

void add(const char* name, const Regions& operands, SetOperation operation) {
  benchmark::RegisterBenchmark(name, [=](benchmark::State& state) {
    combined(state, operands, operation);
  })->Unit(benchmark::kMillisecond);
}

}  // namespace
}  // namespace overstrike::bench

int main(int argc, char** argv) {
  using namespace overstrike;
  using namespace overstrike::bench;
  benchmark::Initialize(&argc, argv);
  add("1000 discs of 100 sides, united", crowd(), SetOperation::unite);
  add("1000 discs of 100 sides, one without the others", crowd(), SetOperation::subtract);
  add("6250 holes of 16 sides in a plate", plate_with_holes(), SetOperation::subtract);
  add("two discs of 50 000 sides, united", two_large(), SetOperation::unite);
  add("a zigzag of slanted parallels", zigzag(), SetOperation::unite);
  benchmark::RunSpecifiedBenchmarks();
}
