#pragma once
// TEMPORARY, to be emptied: cases whose failure lies in the resolver or in the shadows that are
// being replaced. They are judged all the same, and told on standard output.
#include <algorithm>
#include <array>
#include <string_view>

namespace overstrike::hard {

constexpr std::array<std::string_view, 1> kAwaited{""};

inline bool is_awaited(std::string_view name) {
  return std::find(kAwaited.begin(), kAwaited.end(), name) != kAwaited.end();
}

}  // namespace overstrike::hard
