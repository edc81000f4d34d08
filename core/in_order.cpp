#include "core/in_order.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/parallel_pipeline.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>

#include "core/float_environment.h"

namespace overstrike {
namespace {

int threads_of(int threads) {
  return threads > 0 ? threads : oneapi::tbb::info::default_concurrency();
}

}  // namespace

std::size_t slots_for(int threads) { return 2 * static_cast<std::size_t>(threads_of(threads)); }

void in_parallel(std::size_t count, int threads, std::size_t grain,
                 const std::function<void(std::size_t, std::size_t)>& work) {
  if (threads_of(threads) == 1 || count <= grain) return work(0, count);
  using Range = oneapi::tbb::blocked_range<std::size_t>;
  oneapi::tbb::task_arena(threads_of(threads)).execute([&] {
    oneapi::tbb::parallel_for(Range(0, count, grain), [&](const Range& part) {
      const FloatEnvironment ours;
      work(part.begin(), part.end());
    });
  });
}

void in_order(std::size_t count, int threads, std::size_t slots,
              const std::function<void(std::size_t, std::size_t)>& compute,
              const std::function<void(std::size_t, std::size_t)>& consume) {
  if (threads_of(threads) == 1) {
    for (std::size_t i = 0; i < count; ++i) compute(i, 0), consume(i, 0);
    return;
  }
  // More threads than processors are as asked; without the limit raised, TBB complains on stderr.
  using oneapi::tbb::filter_mode, oneapi::tbb::make_filter;
  const oneapi::tbb::global_control allowed(
      oneapi::tbb::global_control::max_allowed_parallelism,
      static_cast<std::size_t>(std::max(threads_of(threads), threads_of(0))));
  std::size_t next = 0;
  const auto begin = [&](oneapi::tbb::flow_control& flow) {
    if (next == count) flow.stop();
    return next == count ? count : next++;
  };
  // What is under way is at most `slots` in a row, so that no two of them share a slot.
  const auto work = [&](std::size_t i) {
    compute(i, i % slots);
    return i;
  };
  const auto end = [&](std::size_t i) { consume(i, i % slots); };
  oneapi::tbb::task_arena(threads_of(threads)).execute([&] {
    oneapi::tbb::parallel_pipeline(
        slots, make_filter<void, std::size_t>(filter_mode::serial_in_order, begin) &
                   make_filter<std::size_t, std::size_t>(filter_mode::parallel, work) &
                   make_filter<std::size_t, void>(filter_mode::serial_in_order, end));
  });
}

}  // namespace overstrike
