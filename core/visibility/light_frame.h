#pragma once
// The light's view: coordinates across and along the light.
#include <vector>

#include "core/visibility/canonical.h"

namespace overstrike {

/// Right-handed: x, y across the light, z the height towards it.
struct LightFrame {
  explicit LightFrame(const Vec3& towards_light);
  Vec3 operator()(const Vec3& p) const {
    return Vec3(glm::dot(right, p), glm::dot(up, p), glm::dot(light, p));
  }

  Vec3 right, up, light;
};

/// Turns an outline counter-clockwise; leaves nothing of one that is not strictly convex.
void keep_if_convex(std::vector<Vec2>& outline);

}  // namespace overstrike
