#include "tests/bench/lines.h"

#include <benchmark/benchmark.h>

#include <memory>

namespace overstrike::bench {
namespace {

constexpr const char* kCpu = "cpu_ms";

/// The benchmark's own loop only hands over what was measured before: its CPU time is not the
/// work's, which goes into the column instead.
class Table : public benchmark::ConsoleReporter {
 public:
  Table() : ConsoleReporter(OO_None) {}
  void ReportRuns(const std::vector<Run>& runs) override {
    std::vector<Run> mended = runs;
    for (Run& run : mended) {
      run.run_name.iterations.clear(), run.run_name.time_type.clear();
      const auto cpu = run.counters.find(kCpu);
      if (cpu == run.counters.end()) continue;
      run.cpu_accumulated_time = cpu->second.value * 1e-3 * static_cast<double>(run.iterations);
      run.counters.erase(cpu);
    }
    ConsoleReporter::ReportRuns(mended);
  }
};

struct Measured {
  Group group;
  std::vector<Line> lines;
};

void report(benchmark::State& state, Measured& measured, std::size_t method) {
  if (measured.lines.empty()) measured.lines = measured.group.measure();
  const Line& line = measured.lines[method];
  for (auto _ : state) state.SetIterationTime(median(line.times.wall) * 1e-3);
  state.counters[kCpu] = median(line.times.cpu);
  for (const auto& [name, value] : line.counters) state.counters[name] = value;
}

}  // namespace

void register_lines(Group group) {
  const auto measured = std::make_shared<Measured>(Measured{std::move(group), {}});
  for (std::size_t i = 0; i < measured->group.methods.size(); ++i)
    benchmark::RegisterBenchmark(
        (measured->group.name + "/" + measured->group.methods[i]).c_str(),
        [measured, i](benchmark::State& state) { report(state, *measured, i); })
        ->Unit(benchmark::kMillisecond)
        ->UseManualTime()
        ->Iterations(1);
}

int run_lines(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  Table table;
  benchmark::RunSpecifiedBenchmarks(&table);
  return 0;
}

}  // namespace overstrike::bench
