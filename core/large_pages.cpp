#include "core/large_pages.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <cstdint>

namespace overstrike {

void prefer_large_pages([[maybe_unused]] const void* begin, [[maybe_unused]] std::size_t size) {
#ifdef MADV_HUGEPAGE
  // Whole pages only: the system would round outwards to small ones, and take the neighbours in.
  constexpr std::uintptr_t kPage = std::uintptr_t{1} << 21;
  const auto from = reinterpret_cast<std::uintptr_t>(begin);
  const std::uintptr_t first = (from + kPage - 1) / kPage * kPage;
  const std::uintptr_t end = (from + size) / kPage * kPage;
  if (first < end) madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
#endif
}

}  // namespace overstrike
