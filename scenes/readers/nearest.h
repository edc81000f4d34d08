#pragma once
// What somebody may have meant.
#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace overstrike {

/// Fewest insertions, deletions, replacements and swaps of neighbours that turn `a` into `b`, no
/// part edited twice (Damerau 1964, optimal string alignment).
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The nearest of the known words, if it is so near that it may have been meant (one edit,
/// and another for every five letters; case and '_' for '-' cost nothing), else empty.
std::string_view nearest(std::string_view word, std::span<const std::string_view> known);

/// "did you mean 'radius'?", or empty.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> known);

}  // namespace overstrike
