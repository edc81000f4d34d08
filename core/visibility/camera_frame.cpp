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

}  // namespace

Bounds scene_bounds(const Scene& scene) {
  Bounds all;
  for (const Body& body : scene.bodies) {
    if (body.shape == nullptr) continue;
    const Bounds b = bounds(*body.shape, body.placement);
    if (!b.empty()) all.add(b.low), all.add(b.high);
    for (const Pattern& pattern : body.patterns)
      for (const Vec3& p : pattern.points) all.add(body.placement(p));
  }
  for (const Segment& s : scene.segments) all.add(s.from), all.add(s.to);
  return all;
}

CameraFrame camera_frame(const Camera& camera, const Bounds& bounds) {
  const Vec3 low = bounds.empty() ? Vec3(-0.5) : bounds.low;
  const Vec3 high = bounds.empty() ? Vec3(0.5) : bounds.high;
  const Vec3 middle = low + (high - low) * 0.5;
  const Vec3 extent = high - low;
  const double diameter = std::sqrt(glm::dot(extent, extent));

  CameraFrame frame{};
  frame.parallel = camera.parallel;
  frame.distance = camera.distance.value_or(kDefaultDiameters * diameter);
  if (!(frame.distance > 0)) frame.distance = 1;
  frame.target = camera.eye ? camera.target.value_or(middle) : camera.look_at.value_or(middle);
  if (camera.eye && *camera.eye != frame.target) {
    const Vec3 back = *camera.eye - frame.target;
    frame.eye = *camera.eye;
    frame.distance = std::sqrt(glm::dot(back, back));
    frame.back = unit(back);
    aim(frame, camera.up);
  } else {
    aim_from(frame, camera.from, camera.up);
    if (camera.eye) frame.target = *camera.eye - frame.back * frame.distance;
    frame.eye = camera.eye.value_or(frame.target + frame.back * frame.distance);
  }
  frame.near_distance = camera.near_distance.value_or(frame.distance * kDefaultNear);
  return frame;
}

}  // namespace overstrike
