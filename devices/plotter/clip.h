#pragma once
// What may not leave the drawable part of a sheet is cut at its border.
#include <functional>
#include <optional>
#include <span>
#include <utility>

#include "core/geometry/vec.h"

namespace overstrike {

struct Rectangle {
  Vec2 low, high;
};

/// The part of the segment inside, ends included; none when it lies outside or is not finite.
/// Liang and Barsky's parameters; an end that is cut lies on the border bit for bit.
std::optional<std::pair<Vec2, Vec2>> clip_segment(Vec2 a, Vec2 b, const Rectangle& inside);

/// Calls `sink` with each connected part of the polyline inside; a single point is a polyline.
/// Returns how many of its segments (or points) were cut or lost.
std::size_t clip_polyline(std::span<const Vec2> points, const Rectangle& inside,
                          const std::function<void(std::span<const Vec2>)>& sink);

}  // namespace overstrike
