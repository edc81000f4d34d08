#pragma once
// What a picture is made of, as plain data. Readers fill it; core draws it.
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/scene/set_operation.h"
#include "core/scene/shapes.h"

namespace overstrike {

enum class Shading : std::uint8_t { flat, smooth };

/// A polyline drawn on a face (NN74's planar patterns), in the body's own frame; hidden as the face
/// is. Points that lie off every face are drawn as they stand.
struct Pattern {
  std::vector<Vec3> points;
  int pen = 0;
};

/// One shape in its place. Copies share the shape.
struct Body {
  ShapePtr shape;
  Affine placement;
  /// How far the placement may have put the body, in the world, from where it was meant: that of a
  /// file's few digits; 0 for numbers given in full. Planes of bodies that meet within theirs are
  /// one.
  double precision = 0;
  std::string name;           ///< empty when the scene gave none
  double density_factor = 1;  ///< multiplies the density law, >= 0; the product is clamped to 1
  Shading shading = Shading::flat;
  int pen = 0;
  std::vector<Pattern> patterns;
  Place place;  ///< where the scene names it
};

/// A solid that is drawn without ever computing its boundary. Its operands are bodies that do not
/// stand for themselves; each body is an operand once at most. A cut face shows what its operand
/// has: density factor, shading, pen.
struct Solid {
  std::vector<SolidNode> nodes;  ///< the root comes first
  std::string name;              ///< empty when the scene gave none
  Place place;                   ///< where the scene names it
  double translucent = 0;        ///< how dark what was cut away is shown: 0 (not at all) to 1
  /// Nothing of it is left: all of it is shown as what was cut away is. It hides nothing, casts no
  /// shadow, receives none and leaves no stroke. What is not closed of it is not drawn.
  bool background = false;
};

/// A line in space, drawn as a stroke where nothing hides it.
struct Segment {
  Vec3 from, to;
  int pen = 0;
};

/// Direction in degrees as NN74 has it: azimuth from +X towards +Y, elevation up from the ground.
struct Direction {
  double azimuth_deg = 0;
  double elevation_deg = 0;
};

/// Unit vector to that direction (NN74 (1): the Z' axis).
Vec3 unit_vector(const Direction&);

/// As in NN74: looking at a point from a distance, azimuth and elevation; or from an eye to a
/// target.
struct Camera {
  std::optional<Vec3> look_at;     ///< default: the middle of the scene
  std::optional<double> distance;  ///< default: three diameters of the scene
  Direction from{-60, 25};
  std::optional<Vec3> eye;     ///< wins over look_at/distance/from when given
  std::optional<Vec3> target;  ///< with `eye`; default: the middle of the scene
  Vec3 up{0, 0, 1};
  bool parallel = false;
  std::optional<double> window_width;  ///< width of the window in world units at the target's depth
  std::optional<double> fov_deg;       ///< vertical field of view; neither: fit the scene
  std::optional<double>
      near_distance;  ///< clip nearer than this; default: a 1/1000 of the distance
};

/// NN74 (14)(15): H = Hmax (1 - k cos a); shade and shadow Hmax; ground shadow a little lighter,
/// for legibility.
struct DensityLaw {
  double k = 0.8;
  double hmax = 1.0;
  double ground_shadow_factor = 0.85;
  double cut_factor =
      0.5;  ///< faces that clipping or cutting opened are drawn at cut_factor * Hmax
};

/// What is missing stands at its default: no light, no ground.
struct Scene {
  std::vector<Body> bodies;
  std::vector<Solid> solids;
  std::vector<Segment> segments;
  Camera camera;
  std::optional<Direction> light;
  /// Without a light of its own: one that follows the eye, from above and right of it.
  bool light_beside_eye = false;
  std::optional<double> ground_z;
  DensityLaw law;
  std::string source;  ///< the file it was read from, for messages
};

}  // namespace overstrike
