#pragma once
// Work in parallel, results in order, on the caller's thread.
#include <functional>

namespace overstrike {

/// Calls compute(i, slot) for i = 0 .. count-1 on up to `threads` threads (0: all processors), and
/// consume(i, slot) for each i in order on the calling thread, while later ones are being computed.
/// `slot` is 0 .. slots-1, the place for i's result: it is free again when consume returns.
/// Exceptions of either end the work and are thrown on.
void in_order(std::size_t count, int threads, std::size_t slots,
              const std::function<void(std::size_t, std::size_t)>& compute,
              const std::function<void(std::size_t, std::size_t)>& consume);

/// Slots that keep `threads` threads busy.
std::size_t slots_for(int threads);

}  // namespace overstrike
