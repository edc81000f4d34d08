#pragma once
// Room for things that will all be written before they are read.
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace overstrike {

/// Leaves new elements as they are found in memory: filling megabytes with zeros first, and having
/// the system bring their pages for it, costs as much as writing them.
template <class T>
struct UnsetAllocator : std::allocator<T> {
  static_assert(std::is_trivially_copyable_v<T>);
  template <class U>
  struct rebind {
    using other = UnsetAllocator<U>;
  };
  template <class U>
  void construct(U*) {}
  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    ::new (static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
  }
};

template <class T>
using UnsetVector = std::vector<T, UnsetAllocator<T>>;

}  // namespace overstrike
