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
  /// The face's outline as the light sees it, counter-clockwise, or nothing when it is not strictly
  /// convex there.
  void convex_outline(const Canonical& canonical, const CanonicalFace& face,
                      std::vector<Vec2>& outline) const;

  Vec3 right, up, light;
};

}  // namespace overstrike
