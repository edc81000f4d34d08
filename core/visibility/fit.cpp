#include "core/visibility/fit.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/geometry/direction.h"
#include "core/geometry/trig.h"

namespace overstrike {
namespace {

/// Light below this elevation has no say in the window: a shadow is then longer than 2.7 heights.
constexpr double kLowestFittedLight = 20;
/// Curved shapes are measured with chords of this part of their size: less than a twentieth of a
/// cell on a page of 135 columns.
constexpr double kChordOfSize = 1.0 / 4096;

bool sees_ground_from_above(const Scene& scene, const CameraFrame& frame) {
  if (!scene.ground_z) return false;
  return frame.parallel ? frame.back.z > 0 : frame.eye.z > *scene.ground_z - frame.origin.z;
}

/// Grows a window by points, counted from the frame's origin, and their shadows.
class Fitter {
 public:
  /// With `above_only`, what lies under the ground does not count.
  Fitter(const Scene& scene, const CameraFrame& frame, bool above_only) : frame_(frame) {
    if (!sees_ground_from_above(scene, frame)) return;
    ground_ = *scene.ground_z - frame.origin.z;
    above_only_ = above_only;
    const std::optional<Vec3> light = light_of(scene, frame);
    if (!light || !(light->z >= sin_deg(kLowestFittedLight))) return;
    shadows_ = light->z > 0;
    slide_ = *light / light->z;
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

  bool counts(const Vec3& p) const { return !above_only_ || p.z >= ground_; }

  void add(const Vec3& p) {
    if (!counts(p)) return;
    if (!in_front(p)) {
      fits_ = false;
    } else {
      window_.add(flat(p));
    }
    if (casts(p) && in_front(shadow(p))) window_.add(flat(shadow(p)));
  }

  /// Adds the point where the line from `a` to `b` goes into the ground, if it does and only what
  /// is above counts.
  void add_dip(const Vec3& a, const Vec3& b) {
    if (counts(a) == counts(b)) return;
    window_.reach = std::fmax(window_.reach, std::fmax(max_norm(a), max_norm(b)));
    Vec3 p = a + (b - a) * ((ground_ - a.z) / (b.z - a.z));
    p.z = ground_;
    add(p);
  }
  void add_line(const Vec3& a, const Vec3& b) { add(a), add(b), add_dip(a, b); }

  void add(const Polyhedron& solid, const Affine& placement) {
    std::vector<Vec3> placed;
    for (const Vec3& p : solid.vertices) placed.push_back(placement(p)), add(placed.back());
    if (std::all_of(placed.begin(), placed.end(), [&](const Vec3& p) { return counts(p); })) return;
    for (Index l = 0; l < solid.loop_ends.size(); ++l) {
      const std::span<const Index> loop = solid.loop(l);
      for (std::size_t i = 0; i < loop.size(); ++i)
        add_dip(placed[loop[i]], placed[loop[(i + 1) % loop.size()]]);
    }
  }

  /// True when no point of the box that counts, nor its shadow, can widen the window.
  bool covers(Bounds box) const {
    if (above_only_ && box.high.z < ground_) return true;
    if (above_only_) box.low.z = std::fmax(box.low.z, ground_);
    for (int i = 0; i < 8; ++i) {
      const Vec3 p(i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y,
                   i & 4 ? box.high.z : box.low.z);
      if (!covers(p)) return false;
      if (shadows_ && box.high.z > ground_ && !covers(shadow(p))) return false;
    }
    return true;
  }

  const Vec3& origin() const { return frame_.origin; }
  bool fits() const { return fits_; }
  const Window& window() const { return window_; }

 private:
  bool covers(const Vec3& p) const { return in_front(p) && window_.holds(flat(p)); }

  const CameraFrame& frame_;
  bool shadows_ = false, above_only_ = false;
  Vec3 slide_{0.0};
  double ground_ = 0;
  bool fits_ = true;
  Window window_;
};

/// Shapes as faces, tessellated finely once a shape however many copies it has.
class Outlines {
 public:
  const Polyhedron& of(const ShapePtr& shape) {
    if (const auto* mesh = std::get_if<Mesh>(shape.get())) return mesh->polyhedron;
    const auto [it, fresh] = faces_.try_emplace(shape.get());
    if (fresh) {
      const Bounds own = bounds(*shape, Affine{});
      const Vec3 extent = own.high - own.low;
      const double chord = std::sqrt(glm::dot(extent, extent)) * kChordOfSize;
      it->second = tessellate(*shape, chord, false);
    }
    return it->second;
  }

 private:
  std::map<const Shape*, Polyhedron> faces_;
};

void add_pattern(Fitter& fitter, const Pattern& pattern, const Affine& placement) {
  for (std::size_t i = 0; i < pattern.points.size(); ++i)
    fitter.add_line(placement(pattern.points[i > 0 ? i - 1 : 0]), placement(pattern.points[i]));
}

std::optional<Window> window_of(const Scene& scene, Fitter fitter, Outlines& outlines,
                                BoundsOfCopies& bounds) {
  const Vec3& origin = fitter.origin();
  for (const Segment& s : scene.segments) fitter.add_line(s.from - origin, s.to - origin);
  for (const Body& body : scene.bodies) {
    if (body.shape == nullptr) continue;
    const Affine placement = from_origin(body.placement, origin);
    for (const Pattern& pattern : body.patterns) add_pattern(fitter, pattern, placement);
    const Bounds box = bounds(*body.shape, placement);
    if (box.empty() || fitter.covers(box)) continue;
    fitter.add(outlines.of(body.shape), placement);
  }
  if (!fitter.fits()) return std::nullopt;
  return fitter.window();
}

}  // namespace

std::optional<Window> fitted_window(const Scene& scene, const CameraFrame& frame) {
  Outlines outlines;
  BoundsOfCopies bounds;
  const std::optional<Window> above = window_of(scene, {scene, frame, true}, outlines, bounds);
  if (!above || !above->empty()) return above;
  return window_of(scene, {scene, frame, false}, outlines, bounds);
}

}  // namespace overstrike
