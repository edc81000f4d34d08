#include "core/visibility/camera_frame.h"

#include <cmath>

#include "core/geometry/direction.h"
#include "core/geometry/trig.h"

namespace overstrike {
namespace {

/// An `up` nearer to the line of sight than this sine is no up: the rounding of the eye's
/// coordinates (2^-53) would turn the picture by more than 2^-53 / 2^-40 = 1e-4 of a radian.
constexpr double kParallelSine = 0x1p-40;

/// Default distance in diameters of the scene.
constexpr double kDefaultDiameters = 3;
/// Default near distance as a part of the distance.
constexpr double kDefaultNear = 1.0 / 1000;

/// Scene::light_beside_eye, for one unit towards the eye. The light is 35 degrees from the line of
/// sight, so that most of what is seen is lit, and farther up than to the right: the three faces of
/// a box get tones of their own.
constexpr double kLightRight = 0.4, kLightUp = 0.57;

/// The axes for looking along -back.
void aim(CameraFrame& frame, const Vec3& up) {
  Vec3 right = glm::cross(unit(up), frame.back);
  if (!(glm::dot(right, right) > kParallelSine * kParallelSine)) {
    const bool along_y = std::fabs(frame.back.y) > std::sqrt(0.5);
    right = glm::cross(along_y ? Vec3(0, 0, 1) : Vec3(0, 1, 0), frame.back);
  }
  frame.right = unit(right);
  frame.up = glm::cross(frame.back, frame.right);
}

/// NN74 (1), exact at multiples of 30 and 45 degrees, and defined at elevation 90.
void aim_from(CameraFrame& frame, const Direction& from, const Vec3& up) {
  const double ct = cos_deg(from.azimuth_deg), st = sin_deg(from.azimuth_deg);
  const double cp = cos_deg(from.elevation_deg), sp = sin_deg(from.elevation_deg);
  frame.back = unit_vector(from);
  if (up.x == 0 && up.y == 0 && up.z > 0) {
    frame.right = {-st, ct, 0};
    frame.up = {-ct * sp, -st * sp, cp};
  } else {
    aim(frame, up);
  }
}

/// Of a unit cube round zero when they are empty.
Vec3 middle_of(const Bounds& b) { return b.empty() ? Vec3(0.0) : b.low + (b.high - b.low) * 0.5; }

/// See stage_of.
constexpr double kOriginStep = 0x1p-20, kOriginReach = 0x1p10;

/// The power of two not below `size`, or 0 where that is no number.
double power_of_two(double size) {
  const double power = size > 0 ? std::ldexp(1.0, std::ilogb(size) + 1) : 0;
  return std::isfinite(power) ? power : 0;
}

/// To a multiple of `step`; as it is where a double has no such places.
Vec3 rounded(const Vec3& p, double step) {
  if (!(step > 0)) return p;
  // Exact, of numbers of any size (glm's rounding goes by way of an int) and in any rounding mode.
  const auto left = [step](double x) { return std::remainder(x, step); };
  const Vec3 q = p - Vec3(left(p.x), left(p.y), left(p.z));
  return std::isfinite(q.x) && std::isfinite(q.y) && std::isfinite(q.z) ? q : p;
}

std::optional<Vec3> from(const std::optional<Vec3>& p, const Vec3& origin) {
  return p ? std::optional(*p - origin) : std::nullopt;
}

}  // namespace

Bounds scene_bounds(const Scene& scene, const Vec3& origin) {
  Bounds all;
  BoundsOfCopies bounds;
  for (const Body& body : scene.bodies) {
    if (body.shape == nullptr) continue;
    const Affine placement = from_origin(body.placement, origin);
    const Bounds b = bounds(*body.shape, placement);
    if (!b.empty()) all.add(b.low), all.add(b.high);
    for (const Pattern& pattern : body.patterns)
      for (const Vec3& p : pattern.points) all.add(placement(p));
  }
  for (const Segment& s : scene.segments) all.add(s.from - origin), all.add(s.to - origin);
  return all;
}

Stage stage_of(const Scene& scene) {
  const Bounds world = scene_bounds(scene);
  const Camera& camera = scene.camera;
  Vec3 origin = middle_of(world);
  if (camera.eye ? camera.target : camera.look_at)
    origin = camera.eye ? *camera.target : *camera.look_at;
  const double size = world.empty() ? 1 : max_norm(world.high - world.low);
  double step = kOriginStep * power_of_two(size);
  if (!camera.parallel) {
    const CameraFrame frame = camera_frame(camera, {Vec3(0.0), world});
    const double reach = kOriginReach * frame.near_distance;
    if (max_norm(frame.eye - origin) > reach) origin = frame.eye;
    if (reach > 0) step = std::fmin(step, power_of_two(reach));
  }
  origin = rounded(origin, step);
  return {origin, origin == Vec3(0.0) ? world : scene_bounds(scene, origin)};
}

CameraFrame camera_frame(const Camera& camera, const Stage& stage) {
  const Bounds& bounds = stage.bounds;
  const Vec3 low = bounds.empty() ? Vec3(-0.5) : bounds.low;
  const Vec3 high = bounds.empty() ? Vec3(0.5) : bounds.high;
  const Vec3 middle = middle_of(bounds);
  const Vec3 extent = high - low;
  const double diameter = std::sqrt(glm::dot(extent, extent));

  CameraFrame frame{};
  frame.origin = stage.origin;
  frame.parallel = camera.parallel;
  frame.distance = camera.distance.value_or(kDefaultDiameters * diameter);
  if (!(frame.distance > 0)) frame.distance = 1;
  const std::optional<Vec3> eye = from(camera.eye, stage.origin);
  frame.target = from(camera.eye ? camera.target : camera.look_at, stage.origin).value_or(middle);
  if (eye && *eye != frame.target) {
    const Vec3 back = *eye - frame.target;
    frame.eye = *eye;
    frame.distance = std::sqrt(glm::dot(back, back));
    frame.back = unit(back);
    aim(frame, camera.up);
  } else {
    aim_from(frame, camera.from, camera.up);
    if (eye) frame.target = *eye - frame.back * frame.distance;
    frame.eye = eye.value_or(frame.target + frame.back * frame.distance);
  }
  frame.near_distance = camera.near_distance.value_or(frame.distance * kDefaultNear);
  return frame;
}

std::optional<Vec3> light_of(const Scene& scene, const CameraFrame& frame) {
  if (scene.light) return unit_vector(*scene.light);
  if (!scene.light_beside_eye) return std::nullopt;
  return unit(frame.back + frame.right * kLightRight + frame.up * kLightUp);
}

}  // namespace overstrike
