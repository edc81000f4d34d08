// Draws scene files as TK's experiments do: the lines of a picture resolved, nothing written.
//
//     tk_driver < cases          tells how long each takes
//     tk_driver --once < cases   draws each once, in tk_region(), for callgrind to count
//
// Each line of cases is FILE SIZE COHERENCE BOOLEAN, the latter two as `overstrike render` has
// them. Prints for each MILLISECONDS RUNS LEAVES SPANS CROSSINGS RESORTS DECISIONS FLIPS UPDATES:
// of CPU, one thread, the median of rounds in which all cases take turns, from the canonical input
// to runs; the leaves of all solids in the form that they are followed in; and SolidCounts.
#include <algorithm>
#include <array>
#include <cstdio>
#include <iostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/drawing.h"
#include "core/error.h"
#include "core/visibility/solid_forms.h"
#include "scenes/readers/read.h"
#include "tests/bench/scenes.h"
#include "tests/bench/timing.h"

namespace overstrike::bench {

struct Case {
  DrawOptions options;
  Prepared prepared;
  std::size_t runs = 0;
  SolidCounts counts;
};

}  // namespace overstrike::bench

/// What is counted.
extern "C" __attribute__((noinline)) void tk_region(overstrike::bench::Case& one) {
  overstrike::Drawing drawing(one.prepared.canonical, one.prepared.view, one.options);
  one.runs = 0;
  drawing.runs({0, 1, 0.5}, [&](const overstrike::RunRow& row) { one.runs += row.runs.size(); });
  one.counts = drawing.timings().solids;
}

namespace overstrike::bench {
namespace {

constexpr double kBudgetMs = 4000;

template <std::size_t N>
std::size_t which(const std::array<std::string_view, N>& names, const std::string& name) {
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end()) throw std::runtime_error("unknown word in a case: '" + name + "'");
  return static_cast<std::size_t>(at - names.begin());
}

DrawOptions options_of(const std::string& coherence, const std::string& form) {
  constexpr std::array<std::string_view, 4> kCoherence{"none", "span", "span+behind", "all"};
  constexpr std::array<std::string_view, 3> kForms{"auto", "tree", "sop"};
  DrawOptions options;
  options.threads = 1;
  options.coherence = static_cast<Coherence>(which(kCoherence, coherence));
  options.boolean = static_cast<BooleanForm>(which(kForms, form));
  return options;
}

std::vector<Case> read_cases(std::istream& in) {
  std::vector<Case> cases;
  std::string file, coherence, form;
  for (int size = 0; in >> file >> size >> coherence >> form;)
    cases.push_back(
        {options_of(coherence, form), prepare(read_scene(file).scene, square_grid(size)), 0, {}});
  return cases;
}

std::size_t leaves(const Case& one) {
  std::size_t sum = 0;
  for (const auto& solid : solids_in_form(*one.prepared.canonical, one.options.boolean, {}))
    sum += solid->expression.leaf_count();
  return sum;
}

void run(bool once) {
  std::vector<Case> cases = read_cases(std::cin);
  std::vector<Job> jobs;
  for (Case& one : cases) jobs.push_back([&one] { tk_region(one); });
  std::vector<Times> times(cases.size());
  if (once) {
    for (const Job& job : jobs) job();
  } else {
    times = interleaved(jobs, kBudgetMs);
  }
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const SolidCounts& c = cases[i].counts;
    std::printf(
        "%.4f %zu %zu %llu %llu %llu %llu %llu %llu\n", once ? 0 : median(times[i].cpu),
        cases[i].runs, leaves(cases[i]), static_cast<unsigned long long>(c.spans),
        static_cast<unsigned long long>(c.crossings), static_cast<unsigned long long>(c.resorts),
        static_cast<unsigned long long>(c.decisions), static_cast<unsigned long long>(c.flips),
        static_cast<unsigned long long>(c.updates));
  }
}

}  // namespace
}  // namespace overstrike::bench

int main(int argc, char** argv) {
  try {
    overstrike::bench::run(argc == 2 && std::string_view(argv[1]) == "--once");
  } catch (const overstrike::InputError& error) {
    for (const auto& diagnostic : error.diagnostics()) std::cerr << to_string(diagnostic) << "\n";
    return 2;
  } catch (const std::runtime_error& error) {
    std::cerr << "tk_driver: " << error.what() << "\n";
    return 2;
  }
  return 0;
}
