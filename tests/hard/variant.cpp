#include "tests/hard/variant.h"

#include <cmath>
#include <sstream>

#include "core/geometry/direction.h"
#include "core/visibility/camera_frame.h"
#include "tests/oracle/random.h"

namespace overstrike::hard {
namespace {

constexpr double kDegrees = 3.14159265358979323846 / 180;
const Mat3 kQuarter(0, 1, 0, -1, 0, 0, 0, 0, 1);

Mat3 turn_of(int number, bool about_z) {
  if (number == 0) return Mat3(1);
  if (number == 1) return kQuarter;
  oracle::Random random(static_cast<std::uint64_t>(number));
  return about_z ? oracle::turn_about_z(random) : oracle::turn(random);
}

/// Of unit length, within rounding.
Vec3 direction_of(int number) {
  oracle::Random random(0xD1EC7104u + static_cast<std::uint64_t>(number));
  return unit(random.within(Vec3(0.5), Vec3(1)));
}

Direction direction_to(const Vec3& v) {
  return {std::atan2(v.y, v.x) / kDegrees, std::atan2(v.z, std::hypot(v.x, v.y)) / kDegrees};
}

/// With an eye, a target and a near distance of its own.
Camera explicit_camera(const Scene& scene, const Mat3& turn, const Affine& pose, double scale) {
  const CameraFrame frame = camera_frame(scene.camera, stage_of(scene));
  Camera camera = scene.camera;
  camera.look_at.reset(), camera.distance.reset();
  camera.eye = pose(frame.eye + frame.origin);
  camera.target = pose(frame.target + frame.origin);
  camera.up = turn * frame.up;
  if (camera.near_distance || !camera.parallel) camera.near_distance = frame.near_distance * scale;
  if (camera.window_width) *camera.window_width *= scale;
  return camera;
}

}  // namespace

std::string describe(const Variant& v) {
  std::ostringstream text;
  text << "turn " << v.turn << ", scale " << v.scale << ", moved " << v.move;
  return text.str();
}

const std::vector<Variant>& all_variants() {
  static const std::vector<Variant> all = [] {
    std::vector<Variant> made;
    for (int turn = 0; turn < kTurns; ++turn) {
      for (const double scale : {1.0, 1e-9, 1e9}) made.push_back({turn, scale, 0});
      for (const double move : {1e3, 1e6, 1e8}) made.push_back({turn, 1, move});
    }
    return made;
  }();
  return all;
}

double size_of(const Scene& scene) {
  const Bounds all = scene_bounds(scene);
  return all.empty() ? 1 : glm::length(all.high - all.low);
}

Scene posed(const Scene& scene, const Variant& variant) {
  if (variant.is_as_it_stands()) return scene;
  const Mat3 turn = turn_of(variant.turn, scene.ground_z.has_value());
  const Vec3 move = direction_of(variant.turn) * (variant.move * size_of(scene));
  const Affine pose{turn * variant.scale, move};
  Scene result = scene;
  result.camera = explicit_camera(scene, turn, pose, variant.scale);
  for (Body& body : result.bodies) body.placement = pose * body.placement;
  for (Segment& s : result.segments) s.from = pose(s.from), s.to = pose(s.to);
  if (scene.light) result.light = direction_to(turn * unit_vector(*scene.light));
  if (scene.ground_z) result.ground_z = *scene.ground_z * variant.scale + move.z;
  return result;
}

}  // namespace overstrike::hard
