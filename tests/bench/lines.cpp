#include "tests/bench/lines.h"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <memory>

namespace overstrike::bench {
namespace {

constexpr const char* kCpu = "cpu_ms";

/// One line for each benchmark: its wall time, the CPU time that was measured (that of the
/// benchmark's own loop, which only hands it over, means nothing) and what stands beside them.
class Table : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& context) override {
    PrintBasicContext(&GetErrorStream(), context);
    char line[80];
    std::snprintf(line, sizeof line, "%-34s %9s %9s", "ms", "wall", "CPU");
    GetOutputStream() << line << std::endl;
    return true;
  }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) print(run);
  }

 private:
  void print(const Run& run) {
    char text[120];
    const auto cpu = run.counters.find(kCpu);
    std::snprintf(text, sizeof text, "%-34s %9.3f %9.3f", run.run_name.function_name.c_str(),
                  run.GetAdjustedRealTime(), cpu == run.counters.end() ? 0 : cpu->second.value);
    GetOutputStream() << text;
    for (const auto& [name, counter] : run.counters) {
      if (name == kCpu) continue;
      std::snprintf(text, sizeof text, "  %s=%.4g", name.c_str(), counter.value);
      GetOutputStream() << text;
    }
    GetOutputStream() << std::endl;
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
