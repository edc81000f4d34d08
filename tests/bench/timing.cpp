#include "tests/bench/timing.h"

#include <algorithm>
#include <ctime>

namespace overstrike::bench {
namespace {

double now_ms(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) * 1e3 + static_cast<double>(t.tv_nsec) * 1e-6;
}

template <class Combine>
std::vector<double> each(const std::vector<double>& a, const std::vector<double>& b,
                         const Combine& combine) {
  std::vector<double> result(a.size());
  std::transform(a.begin(), a.end(), b.begin(), result.begin(), combine);
  return result;
}

}  // namespace

Stopwatch::Stopwatch() : cpu_(now_ms(CLOCK_PROCESS_CPUTIME_ID)), wall_(now_ms(CLOCK_MONOTONIC)) {}
double Stopwatch::cpu_ms() const { return now_ms(CLOCK_PROCESS_CPUTIME_ID) - cpu_; }
double Stopwatch::wall_ms() const { return now_ms(CLOCK_MONOTONIC) - wall_; }

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return (values[(n - 1) / 2] + values[n / 2]) / 2;
}

double ratio(const std::vector<double>& a, const std::vector<double>& b) {
  return median(each(a, b, std::divides<>()));
}

std::vector<double> sum(const std::vector<double>& a, const std::vector<double>& b) {
  return each(a, b, std::plus<>());
}

std::vector<Times> interleaved(const std::vector<Job>& jobs, double budget_ms) {
  constexpr int kFewest = 3, kMost = 25;
  for (const Job& job : jobs) job();
  std::vector<Times> times(jobs.size());
  const Stopwatch all;
  for (int round = 0; round < kMost; ++round) {
    if (round >= kFewest && all.wall_ms() > budget_ms) break;
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      const Stopwatch watch;
      jobs[i]();
      times[i].cpu.push_back(watch.cpu_ms());
      times[i].wall.push_back(watch.wall_ms());
    }
  }
  return times;
}

}  // namespace overstrike::bench
