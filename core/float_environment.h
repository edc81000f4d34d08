#pragma once
// The caller's floating-point environment must not reach our sums.
#include <cfenv>

namespace overstrike {

/// Round to nearest, no flushing to zero, no traps, for as long as it lives on this thread; then
/// what was set before. Every entry point of core and of the readers, and every task that is given
/// to another thread, holds one: exact arithmetic is exact in the default environment only. Sinks
/// and progress calls are made within it.
class FloatEnvironment {
 public:
  FloatEnvironment() {
    std::fegetenv(&before_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~FloatEnvironment() { std::fesetenv(&before_); }
  FloatEnvironment(const FloatEnvironment&) = delete;
  FloatEnvironment& operator=(const FloatEnvironment&) = delete;

 private:
  std::fenv_t before_;
};

}  // namespace overstrike
