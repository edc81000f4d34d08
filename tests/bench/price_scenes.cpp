#include "tests/bench/price_scenes.h"

#include "core/drawing.h"

namespace overstrike::bench {
namespace {

constexpr int kLattice = 5;
constexpr double kCell = 2.0 / kLattice;
constexpr double kRadius = 0.15;

void add_pattern(Body& cube) {
  // A cross on the top and on one side, in the cube's own frame.
  const double h = kRadius / 2;
  cube.patterns.push_back({{{-h, -h, 2 * kRadius}, {h, h, 2 * kRadius}}, 0});
  cube.patterns.push_back({{{-h, h, 2 * kRadius}, {h, -h, 2 * kRadius}}, 0});
  cube.patterns.push_back({{{-h, -kRadius, h}, {h, -kRadius, 3 * h}}, 0});
}

Body body_at(int i, const ShapePtr& shape, double scale, const Vec3& shift) {
  const Vec3 cell(i % kLattice, i / kLattice % kLattice, i / (kLattice * kLattice));
  Body body;
  body.shape = shape;
  body.placement = {Mat3(scale), Vec3(-1.0) + (cell + 0.5) * kCell + shift};
  return body;
}

}  // namespace

Scene priced_scene(Feature feature, bool with) {
  const ShapePtr sphere = icosphere(2);
  const ShapePtr cube = std::make_shared<const Shape>(Box{Vec3(2 * kRadius)});
  // Spheres that touch the cubes beside them and pass through.
  const double reach = with && feature == Feature::interpenetration ? 2 : 1;
  Scene scene;
  scene.camera.parallel = true;
  scene.camera.look_at = Vec3(0.0);
  scene.camera.window_width = 3.6;
  for (int i = 0; i < kLattice * kLattice * kLattice; ++i) {
    const bool is_cube = i % 2 == 0;
    Body body = is_cube ? body_at(i, cube, 1, Vec3(0, 0, -kRadius))
                        : body_at(i, sphere, kRadius * reach, Vec3(0.0));
    if (with && feature == Feature::smooth) body.shading = Shading::smooth;
    if (with && feature == Feature::patterns && is_cube) add_pattern(body);
    if (with && feature == Feature::segments)
      scene.segments.push_back({body.placement.offset, body.placement.offset + Vec3(kCell), 0});
    scene.bodies.push_back(std::move(body));
  }
  if ((with && feature == Feature::light) || feature == Feature::smooth)
    scene.light = Direction{-20, 45};
  if (with && feature == Feature::ground) scene.ground_z = -1.0;
  return scene;
}

std::size_t draw_priced(const Prepared& prepared, Feature feature, bool with) {
  DrawOptions options;
  options.threads = 1;
  Drawing drawing(prepared.canonical, prepared.view, options);
  const bool strokes = feature == Feature::patterns || feature == Feature::segments;
  std::size_t count = 0;
  if (!strokes) drawing.runs({}, [&](const RunRow& row) { count += row.runs.size(); });
  if (strokes || (with && feature == Feature::strokes)) count += drawing.strokes({}).size();
  return count;
}

}  // namespace overstrike::bench
