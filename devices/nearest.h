#pragma once
#include <span>
#include <string_view>

namespace overstrike {

/// The name that a mistyped word most likely meant: the least number of inserted, left out, changed
/// or swapped neighbouring letters, at most one in three of the word's; the first of equals. Empty
/// when none is near.
std::string_view nearest_name(std::string_view word, std::span<const std::string_view> names);

}  // namespace overstrike
