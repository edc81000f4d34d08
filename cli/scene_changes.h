#pragma once
// What the command line says over the scene's head: camera, light, ground, density.
#include <optional>
#include <string>

#include "core/scene/scene.h"

namespace overstrike {

/// The options as they were given, still text; empty means not given.
struct SceneChangeTexts {
  std::string eye, target, up;
  std::string look_at, distance, azimuth, elevation;
  std::string parallel, fov;
  std::string camera, projection;
  std::string light, ground, density;
  bool fit = false, no_light = false, no_ground = false;
  bool weld = false, no_weld = false;
};

/// The same, read and checked.
struct SceneChanges {
  std::optional<Camera> camera;  ///< as a whole
  std::optional<Vec3> eye, target, up;
  std::optional<Vec3> look_at;
  std::optional<double> distance, azimuth_deg, elevation_deg;
  bool parallel = false, fit = false;
  std::optional<double> window_width, fov_deg;
  std::optional<Direction> light;
  std::optional<double> ground_z;
  bool no_light = false, no_ground = false;
  std::optional<double> k, hmax;
  bool weld = false, no_weld = false;
};

/// Throws UsageError for what is no number, out of bounds, or excluded by another option.
SceneChanges read_scene_changes(const SceneChangeTexts& texts);

/// Options override what the scene says, and nothing else: a camera given by its eye that gets a
/// new azimuth keeps its target and distance.
void apply(const SceneChanges& changes, Scene& scene);

}  // namespace overstrike
