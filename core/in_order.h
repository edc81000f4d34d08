#pragma once
// Work in parallel, results in order.
#include <functional>

namespace overstrike {

/// Calls compute(i, slot) for i = 0 .. count-1 on up to `threads` threads (0: all processors), and
/// consume(i, slot) for each i in order, on one thread at a time, while others are being computed.
/// `slot` is 0 .. slots-1, the place for i's result: it is free again when consume returns.
/// Exceptions of either end the work and are thrown on.
void in_order(std::size_t count, int threads, std::size_t slots,
              const std::function<void(std::size_t, std::size_t)>& compute,
              const std::function<void(std::size_t, std::size_t)>& consume);

/// Calls work(first, end) for parts of 0 .. count on up to `threads` threads, each of at least
/// `grain` things but the last.
void in_parallel(std::size_t count, int threads, std::size_t grain,
                 const std::function<void(std::size_t, std::size_t)>& work);

/// Slots that keep `threads` threads busy.
std::size_t slots_for(int threads);

}  // namespace overstrike
