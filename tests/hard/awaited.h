#pragma once
// TEMPORARY, to be emptied: cases that the resolver and the shadows that are being replaced do not
// draw as the laws want. They are judged all the same, and told on standard output.
#include <string_view>

namespace overstrike::hard {

struct Awaited {
  std::string_view
      law;  ///< "oracle", "oracle, far away" (moved by 1e6 sizes or more), or the law's
  std::string_view name;  ///< of the case; empty: any
};

constexpr Awaited kAwaited[] = {
    {"oracle, far away", "huge-and-tiny"},
};

inline bool is_awaited(std::string_view law, std::string_view name) {
  for (const Awaited& a : kAwaited)
    if (a.law == law && (a.name.empty() || a.name == name)) return true;
  return false;
}

}  // namespace overstrike::hard
