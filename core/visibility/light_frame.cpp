#include "core/visibility/light_frame.h"

#include <algorithm>
#include <cmath>

namespace overstrike {

LightFrame::LightFrame(const Vec3& towards_light) : light(towards_light) {
  // Across the axis that the light is farthest from.
  const Vec3 size = glm::abs(light);
  const Vec3 axis = size.x <= size.y && size.x <= size.z ? Vec3(1, 0, 0)
                    : size.y <= size.z                   ? Vec3(0, 1, 0)
                                                         : Vec3(0, 0, 1);
  right = glm::normalize(glm::cross(axis, light));
  up = glm::cross(light, right);
}

void keep_if_convex(std::vector<Vec2>& outline) {
  const std::size_t n = outline.size();
  double area = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = outline[i] - outline[0], b = outline[i + 1 < n ? i + 1 : 0] - outline[0];
    area += a.x * b.y - a.y * b.x;
  }
  if (area < 0) std::reverse(outline.begin(), outline.end());
  double turns = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = outline[i + 1 < n ? i + 1 : 0] - outline[i],
               b = outline[i + 2 < n ? i + 2 : i + 2 - n] - outline[i + 1 < n ? i + 1 : 0];
    if (a.x * b.y - a.y * b.x <= 0) return outline.clear();
    turns += (a.y < 0) != (b.y < 0);
  }
  if (turns != 2) outline.clear();
}

}  // namespace overstrike
