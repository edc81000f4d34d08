#include "cli/scene_changes.h"

#include <cmath>
#include <limits>

#include "cli/numbers.h"
#include "cli/openscad_camera.h"
#include "cli/usage.h"
#include "core/geometry/tessellate.h"

namespace overstrike {
namespace {

constexpr double kAny = std::numeric_limits<double>::max();

struct Named {
  std::string_view option;
  bool given;
};

/// At most one of `ours` and `theirs` may be given.
void exclude(std::initializer_list<Named> ours, std::initializer_list<Named> theirs) {
  for (const Named& a : ours) {
    for (const Named& b : theirs) {
      if (a.given && b.given)
        throw UsageError(std::string(a.option) + " excludes " + std::string(b.option));
    }
  }
}

void check_exclusions(const SceneChangeTexts& t) {
  exclude({{"--eye", !t.eye.empty()}, {"--target", !t.target.empty()}},
          {{"--look-at", !t.look_at.empty()},
           {"--distance", !t.distance.empty()},
           {"--azimuth", !t.azimuth.empty()},
           {"--elevation", !t.elevation.empty()}});
  exclude({{"--parallel", !t.parallel.empty()}}, {{"--fov", !t.fov.empty()}, {"--fit", t.fit}});
  exclude({{"--fov", !t.fov.empty()}}, {{"--fit", t.fit}});
  exclude({{"--camera", !t.camera.empty()}}, {{"--eye", !t.eye.empty()},
                                              {"--target", !t.target.empty()},
                                              {"--up", !t.up.empty()},
                                              {"--look-at", !t.look_at.empty()},
                                              {"--distance", !t.distance.empty()},
                                              {"--azimuth", !t.azimuth.empty()},
                                              {"--elevation", !t.elevation.empty()},
                                              {"--parallel", !t.parallel.empty()},
                                              {"--fov", !t.fov.empty()},
                                              {"--fit", t.fit}});
  exclude({{"--weld", t.weld}}, {{"--no-weld", t.no_weld}});
  exclude({{"--light", !t.light.empty()}}, {{"--no-light", t.no_light}});
  exclude({{"--ground", !t.ground.empty()}}, {{"--no-ground", t.no_ground}});
}

std::optional<Vec3> point(std::string_view option, const std::string& text) {
  if (text.empty()) return std::nullopt;
  const auto n = read_numbers({option, "X,Y,Z in world units", 3}, text);
  return Vec3(n[0], n[1], n[2]);
}

std::optional<double> number(std::string_view option, std::string_view expected,
                             const std::string& text) {
  if (text.empty()) return std::nullopt;
  return read_numbers({option, expected}, text).front();
}

std::optional<double> number_in(const NumberRule& rule, const std::string& text, double low,
                                double high) {
  const auto value = number(rule.option, rule.expected, text);
  if (value && !(*value >= low && *value <= high)) refuse(rule, text);
  return value;
}

std::optional<double> positive(const NumberRule& rule, const std::string& text, double most) {
  if (text.empty()) return std::nullopt;
  return read_number_above(rule, text, 0, most);
}

void read_whole_camera(const SceneChangeTexts& t, SceneChanges& c) {
  if (!t.projection.empty() && t.camera.empty())
    throw UsageError("--projection goes with --camera; a scene's own camera takes --parallel");
  const bool parallel = t.projection == "o" || t.projection == "ortho";
  if (!parallel && !t.projection.empty() && t.projection != "p" && t.projection != "perspective")
    throw UsageError("--projection: expected o or p, found '" + t.projection + "'");
  if (!t.camera.empty()) c.camera = read_openscad_camera(t.camera, parallel);
}

void read_camera(const SceneChangeTexts& t, SceneChanges& c) {
  c.eye = point("--eye", t.eye);
  c.target = point("--target", t.target);
  c.up = point("--up", t.up);
  if (c.up && *c.up == Vec3(0.0)) refuse({"--up", "X,Y,Z, a direction that is not 0,0,0", 3}, t.up);
  if (c.eye && c.target && *c.eye == *c.target)
    refuse({"--target", "a point that is not the eye", 3}, t.target);
  c.look_at = point("--look-at", t.look_at);
  c.distance = positive({"--distance", "R in world units, above 0"}, t.distance, kAny);
  c.azimuth_deg = number("--azimuth", "DEG from +X towards +Y", t.azimuth);
  c.elevation_deg =
      number_in({"--elevation", "DEG up from the ground, -90 to 90"}, t.elevation, -90, 90);
}

void read_window(const SceneChangeTexts& t, SceneChanges& c) {
  c.fit = t.fit || t.parallel == "fit";
  c.parallel = !t.parallel.empty();
  if (t.parallel != "fit") {
    const NumberRule rule{"--parallel", "WIDTH of the window in world units, above 0, or 'fit'"};
    c.window_width = positive(rule, t.parallel, kAny);
  }
  const NumberRule rule{"--fov", "DEG, the vertical angle of view, above 0 and at most 179"};
  c.fov_deg = positive(rule, t.fov, 179);
}

void read_light_and_ground(const SceneChangeTexts& t, SceneChanges& c) {
  if (!t.light.empty()) {
    const NumberRule rule{"--light", "AZ,EL in degrees, EL from -90 to 90", 2};
    const auto n = read_numbers(rule, t.light);
    if (n[1] < -90 || n[1] > 90) refuse(rule, t.light);
    c.light = Direction{n[0], n[1]};
  }
  c.ground_z = number("--ground", "Z, the height of the ground in world units", t.ground);
  c.no_light = t.no_light;
  c.no_ground = t.no_ground;
  if (!t.density.empty()) {
    const NumberRule rule{"--density", "K,HMAX, both from 0 to 1", 2};
    const auto n = read_numbers(rule, t.density);
    if (n[0] < 0 || n[0] > 1 || n[1] < 0 || n[1] > 1) refuse(rule, t.density);
    c.k = n[0], c.hmax = n[1];
  }
}

/// NN74's camera takes over from one that was given by its eye; what is not said anew stays.
void turn_to_look_at(Camera& camera) {
  if (!camera.eye) return;
  if (camera.target) {
    camera.look_at = camera.target;
    camera.distance = glm::distance(*camera.eye, *camera.target);
  }
  camera.eye.reset();
  camera.target.reset();
}

void apply_camera(const SceneChanges& c, Camera& camera) {
  if (c.eye) camera.eye = c.eye;
  if (c.target) (camera.eye ? camera.target : camera.look_at) = c.target;
  if (c.up) camera.up = *c.up;
  if (c.look_at || c.distance || c.azimuth_deg || c.elevation_deg) turn_to_look_at(camera);
  if (c.look_at) camera.look_at = c.look_at;
  if (c.distance) camera.distance = c.distance;
  if (c.azimuth_deg) camera.from.azimuth_deg = *c.azimuth_deg;
  if (c.elevation_deg) camera.from.elevation_deg = *c.elevation_deg;
}

void apply_window(const SceneChanges& c, Camera& camera) {
  if (!c.parallel && !c.fov_deg && !c.fit) return;
  camera.window_width = c.window_width;
  camera.fov_deg = c.fov_deg;
  if (c.parallel) camera.parallel = true;
  if (c.fov_deg) camera.parallel = false;
}

/// Half a unit of the sixth digit of a number as large as the body's coordinates.
double six_digits(const Body& body) {
  const Bounds box = bounds(*body.shape, body.placement);
  const Vec3 reach = glm::max(glm::abs(box.low), glm::abs(box.high));
  const double largest = std::fmax(reach.x, std::fmax(reach.y, reach.z));
  return largest > 0 ? 0.5 * std::pow(10.0, std::floor(std::log10(largest)) - 5) : 0;
}

}  // namespace

SceneChanges read_scene_changes(const SceneChangeTexts& texts) {
  check_exclusions(texts);
  SceneChanges changes;
  read_whole_camera(texts, changes);
  read_camera(texts, changes);
  read_window(texts, changes);
  read_light_and_ground(texts, changes);
  changes.weld = texts.weld, changes.no_weld = texts.no_weld;
  return changes;
}

void apply(const SceneChanges& c, Scene& scene) {
  if (c.camera) scene.camera = *c.camera;
  for (Body& body : scene.bodies) {
    if (c.no_weld) body.precision = 0;
    if (c.weld && body.precision == 0) body.precision = six_digits(body);
  }
  apply_camera(c, scene.camera);
  apply_window(c, scene.camera);
  if (c.light || c.no_light) scene.light = c.light, scene.light_beside_eye = false;
  if (c.ground_z || c.no_ground) scene.ground_z = c.ground_z;
  if (c.k) scene.law.k = *c.k;
  if (c.hmax) scene.law.hmax = *c.hmax;
}

}  // namespace overstrike
