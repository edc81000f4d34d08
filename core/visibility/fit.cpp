#include "core/visibility/fit.h"

#include <cmath>
#include <map>

#include "core/geometry/trig.h"

namespace overstrike {
namespace {

/// Light below this elevation has no say in the window: a shadow is then longer than 2.7 heights.
constexpr double kLowestFittedLight = 20;
/// Curved shapes are measured with chords of this part of their size: less than a twentieth of a
/// cell on a page of 135 columns.
constexpr double kChordOfSize = 1.0 / 4096;

/// Grows a window by world points and their shadows.
class Fitter {
 public:
  Fitter(const Scene& scene, const CameraFrame& frame) : frame_(frame) {
    if (!scene.light || !scene.ground_z) return;
    if (!(scene.light->elevation_deg >= kLowestFittedLight)) return;
    const bool eye_above = frame.parallel ? frame.back.z > 0 : frame.eye.z > *scene.ground_z;
    if (!eye_above) return;
    const Vec3 light = unit_vector(*scene.light);
    shadows_ = light.z > 0;
    slide_ = light / light.z;
    ground_ = *scene.ground_z;
  }

  bool in_front(const Vec3& p) const {
    return frame_.parallel || frame_.distance - frame_.place(p).z > frame_.near_distance;
  }
  /// Precondition: in_front(p).
  Vec2 flat(const Vec3& p) const {
    const Vec3 q = frame_.place(p);
    return Vec2(q) / frame_.w(q.z);
  }
  /// NN74 (3).
  Vec3 shadow(const Vec3& p) const { return p - slide_ * (p.z - ground_); }
  bool casts(const Vec3& p) const { return shadows_ && p.z > ground_; }

  void add(const Vec3& p) {
    if (!in_front(p)) {
      fits_ = false;
    } else {
      window_.add(flat(p));
    }
    if (casts(p) && in_front(shadow(p))) window_.add(flat(shadow(p)));
  }

  /// True when no point of the box, nor its shadow, can widen the window.
  bool covers(const Bounds& box) const {
    for (int i = 0; i < 8; ++i) {
      const Vec3 p(i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y,
                   i & 4 ? box.high.z : box.low.z);
      if (!covers(p)) return false;
      if (shadows_ && box.high.z > ground_ && !covers(shadow(p))) return false;
    }
    return true;
  }

  bool fits() const { return fits_; }
  const Window& window() const { return window_; }

 private:
  bool covers(const Vec3& p) const { return in_front(p) && window_.holds(flat(p)); }

  const CameraFrame& frame_;
  bool shadows_ = false;
  Vec3 slide_{0.0};
  double ground_ = 0;
  bool fits_ = true;
  Window window_;
};

/// Vertices of shapes, tessellated finely once a shape however many copies it has.
class Outlines {
 public:
  const std::vector<Vec3>& of(const ShapePtr& shape) {
    if (const auto* mesh = std::get_if<Mesh>(shape.get())) return mesh->polyhedron.vertices;
    const auto [it, fresh] = vertices_.try_emplace(shape.get());
    if (fresh) {
      const Bounds own = bounds(*shape, Affine{});
      const Vec3 extent = own.high - own.low;
      const double chord = std::sqrt(glm::dot(extent, extent)) * kChordOfSize;
      it->second = tessellate(*shape, chord, false).vertices;
    }
    return it->second;
  }

 private:
  std::map<const Shape*, std::vector<Vec3>> vertices_;
};

}  // namespace

std::optional<Window> fitted_window(const Scene& scene, const CameraFrame& frame) {
  Fitter fitter(scene, frame);
  Outlines outlines;
  for (const Segment& s : scene.segments) fitter.add(s.from), fitter.add(s.to);
  for (const Body& body : scene.bodies) {
    if (body.shape == nullptr) continue;
    for (const Pattern& pattern : body.patterns)
      for (const Vec3& p : pattern.points) fitter.add(body.placement(p));
    const Bounds box = bounds(*body.shape, body.placement);
    if (box.empty() || (!fitter.window().empty() && fitter.covers(box))) continue;
    for (const Vec3& p : outlines.of(body.shape)) fitter.add(body.placement(p));
  }
  if (!fitter.fits()) return std::nullopt;
  return fitter.window();
}

}  // namespace overstrike
