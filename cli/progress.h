#pragma once
// A bar on standard error while long work goes on.
#include <chrono>
#include <string>

namespace overstrike {

/// The bar at `fraction` (0..1, clamped) of the work: "[####......]  40%".
std::string progress_bar(double fraction);

/// Shows nothing before half a second of work has passed, and takes its line away at the end.
class Progress {
 public:
  explicit Progress(bool shown);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  void show(double fraction);

 private:
  using Clock = std::chrono::steady_clock;
  bool shown_;
  bool drawn_ = false;
  Clock::time_point next_;
};

}  // namespace overstrike
