// Times scene files as TK's experiments do: the lines of a picture resolved, nothing written.
//
//     tk_driver < cases      each line: NAME FILE SIZE
//
// prints for each case NAME SIZE MILLISECONDS RUNS: of CPU, one thread, the median of rounds in
// which all cases take turns, from the canonical input to runs.
#include <cstdio>
#include <iostream>
#include <string>
#include <vector>

#include "core/drawing.h"
#include "core/error.h"
#include "scenes/readers/read.h"
#include "tests/bench/scenes.h"
#include "tests/bench/timing.h"

namespace overstrike::bench {
namespace {

constexpr double kBudgetMs = 4000;

struct Case {
  std::string name;
  int size;
  Prepared prepared;
  std::size_t runs = 0;
};

void draw(Case& one) {
  DrawOptions options;
  options.threads = 1;
  Drawing drawing(one.prepared.canonical, one.prepared.view, options);
  one.runs = 0;
  drawing.runs({0, 1, 0.5}, [&](const RunRow& row) { one.runs += row.runs.size(); });
}

void measure_all() {
  std::vector<Case> cases;
  std::string name, file;
  for (int size = 0; std::cin >> name >> file >> size;)
    cases.push_back({name, size, prepare(read_scene(file).scene, square_grid(size))});
  std::vector<Job> jobs;
  for (Case& one : cases) jobs.push_back([&one] { draw(one); });
  const std::vector<Times> times = interleaved(jobs, kBudgetMs);
  for (std::size_t i = 0; i < cases.size(); ++i)
    std::printf("%s %d %.4f %zu\n", cases[i].name.c_str(), cases[i].size, median(times[i].cpu),
                cases[i].runs);
}

}  // namespace
}  // namespace overstrike::bench

int main() {
  try {
    overstrike::bench::measure_all();
  } catch (const overstrike::InputError& error) {
    for (const auto& diagnostic : error.diagnostics()) std::cerr << to_string(diagnostic) << "\n";
    return 2;
  }
  return 0;
}
