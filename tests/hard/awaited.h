#pragma once
// TEMPORARY, to be emptied: cases that the resolver and the shadows that are being replaced do not
// draw as the laws want. They are judged all the same, and told on standard output.
#include <string_view>

namespace overstrike::hard {

struct Awaited {
  std::string_view law;   ///< "oracle", or the law's name
  std::string_view name;  ///< of the case; empty: any
};

constexpr Awaited kAwaited[] = {
    {"oracle", "bodies-crossing-flatly"},
    {"oracle", "coplanar-opposite-inside"},
    {"oracle", "coplanar-opposite-shifted"},
    {"oracle", "coplanar-same-inside"},
    {"oracle", "coplanar-same-shifted"},
    {"oracle", "cyclic-bars"},
    {"oracle", "edge-on-to-eye"},
    {"oracle", "eye-on-face-plane"},
    {"oracle", "glued-caps-turned"},
    {"oracle", "glued-eight"},
    {"oracle", "huge-and-tiny"},
    {"oracle", "inside-out"},
    {"oracle", "interpenetrating-along-an-edge"},
    {"oracle", "near-in-a-face"},
    {"oracle", "near-through-vertices"},
    {"oracle", "needle-cone"},
    {"oracle", "needles"},
    {"oracle", "on-and-through-the-ground"},
    {"oracle", "open-mesh"},
    {"oracle", "plug-in-a-hole"},
    {"oracle", "round-bodies-cross"},
    {"oracle", "round-bodies-touch"},
    {"oracle", "slivers"},
    {"oracle", "t-junctions"},
    {"oracle", "whole-numbers"},
    {"oracle", "wide-angle-among-bodies"},
};

inline bool is_awaited(std::string_view law, std::string_view name) {
  for (const Awaited& a : kAwaited)
    if (a.law == law && (a.name.empty() || a.name == name)) return true;
  return false;
}

}  // namespace overstrike::hard
