#pragma once
// A scene without a feature, and the same with it.
#include <array>
#include <string_view>

#include "tests/bench/scenes.h"

namespace overstrike::bench {

enum class Feature { light, ground, smooth, patterns, segments, strokes, interpenetration };
constexpr std::array<std::string_view, 7> kFeatureNames = {
    "light", "ground", "smooth", "patterns", "segments", "strokes", "interpenetration"};

/// 64 cubes and 61 icospheres of 320 triangles in turn, on a lattice of 5^3, none touching another.
/// Patterns, segments and smooth shading: as `with` has it, by the feature; smooth shading needs
/// light, so that there is light either way.
Scene priced_scene(Feature, bool with);

/// Draws runs; strokes where the feature is one of strokes. The number of runs and strokes.
std::size_t draw_priced(const Prepared&, Feature, bool with);
/// The runs again, through the narrowest entry: the scan alone.
std::size_t scan_alone(const Prepared&);

}  // namespace overstrike::bench
