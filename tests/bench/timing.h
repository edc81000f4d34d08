#pragma once
// Times that mean something on a machine that others use too.
#include <functional>
#include <string>
#include <vector>

namespace overstrike::bench {

/// CPU time of all threads of the process, and the wall's.
class Stopwatch {
 public:
  Stopwatch();
  double cpu_ms() const;
  double wall_ms() const;

 private:
  double cpu_, wall_;
};

/// What a job took, round by round, in milliseconds.
struct Times {
  std::vector<double> cpu, wall;
};

double median(std::vector<double>);
/// The median of a / b, round by round: two jobs of one round saw the same weather.
double ratio(const std::vector<double>& a, const std::vector<double>& b);
std::vector<double> sum(const std::vector<double>& a, const std::vector<double>& b);

using Job = std::function<void()>;

/// The jobs in turn, round after round: once to warm up, then at least three rounds, more while
/// `budget_ms` lasts, at most 25. In the order of the jobs.
std::vector<Times> interleaved(const std::vector<Job>& jobs, double budget_ms);

}  // namespace overstrike::bench
