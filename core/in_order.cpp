#include "core/in_order.h"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>
#include <oneapi/tbb/task_group.h>

#include <algorithm>

namespace overstrike {
namespace {

int threads_of(int threads) {
  return threads > 0 ? threads : oneapi::tbb::info::default_concurrency();
}

}  // namespace

std::size_t slots_for(int threads) { return 8 * static_cast<std::size_t>(threads_of(threads)); }

void in_order(std::size_t count, int threads, std::size_t slots,
              const std::function<void(std::size_t, std::size_t)>& compute,
              const std::function<void(std::size_t, std::size_t)>& consume) {
  const std::size_t half = std::max<std::size_t>(1, slots / 2);
  if (threads_of(threads) == 1) {
    for (std::size_t i = 0; i < count; ++i) compute(i, 0), consume(i, 0);
    return;
  }
  // Two halves of the slots in turn: one is computed while the other is consumed. The caller counts
  // as a thread.
  // More threads than processors are as asked; without the limit raised, TBB complains on stderr.
  using oneapi::tbb::global_control;
  const global_control allowed(
      global_control::max_allowed_parallelism,
      static_cast<std::size_t>(std::max(threads_of(threads), threads_of(0))));
  oneapi::tbb::task_arena arena(threads_of(threads), 1);
  oneapi::tbb::task_group group;
  const auto start = [&](std::size_t batch) {
    const std::size_t first = batch * half, last = std::min(count, first + half);
    arena.execute([&] {
      group.run([&, batch, first, last] {
        oneapi::tbb::parallel_for(
            first, last, [&](std::size_t i) { compute(i, (batch % 2) * half + (i - first)); });
      });
    });
  };
  const std::size_t batches = (count + half - 1) / half;
  if (batches == 0) return;
  start(0);
  for (std::size_t batch = 0; batch < batches; ++batch) {
    arena.execute([&] { group.wait(); });
    if (batch + 1 < batches) start(batch + 1);
    try {
      const std::size_t first = batch * half, last = std::min(count, first + half);
      for (std::size_t i = first; i < last; ++i) consume(i, (batch % 2) * half + (i - first));
    } catch (...) {
      arena.execute([&] { group.wait(); });
      throw;
    }
  }
}

}  // namespace overstrike
