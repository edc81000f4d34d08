#pragma once
// The light's view: coordinates across and along the light, and a grid that finds the faces over a
// region.
#include <functional>
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
  std::vector<Vec2> convex_outline(const Canonical& canonical, const CanonicalFace& face) const;

  Vec3 right, up, light;
};

/// The faces that cast, by where they lie across the light: of closed bodies those that face it, of
/// open ones all that are not edge-on.
class LightGrid {
 public:
  LightGrid(const Canonical& canonical, const LightFrame& frame);

  /// Calls `visit` once, in increasing order, for every caster whose bounds meet the region and
  /// that reaches above `lowest`.
  void over(const Vec2& low, const Vec2& high, double lowest,
            const std::function<void(Index)>& visit);

 private:
  struct Box {
    Vec2 low, high;
    double highest;
    Index face;
  };
  int column(double x) const;
  int row(double y) const;

  std::vector<Box> boxes_;
  std::vector<Index> start_, items_;
  std::vector<std::uint32_t> stamp_;
  std::vector<Index> found_;
  std::uint32_t turn_ = 0;
  Vec2 origin_{0.0}, cell_{1.0};
  int side_ = 1;
};

}  // namespace overstrike
