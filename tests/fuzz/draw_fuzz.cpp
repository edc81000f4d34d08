// Any bytes that are a scene can be drawn, whatever sizes and places they say: extremes are the
// reader's to refuse or core's to draw. Scenes that say many bodies or corners are left out.
#include <algorithm>

#include "core/error.h"
#include "scenes/readers/read.h"
#include "tests/fuzz/core/drawn.h"
#include "tests/fuzz/fuzz.h"

namespace overstrike::fuzz {
namespace {

constexpr std::size_t kMostBodies = 12, kMostCorners = 400;

std::size_t corners_of(const Shape& shape) {
  if (const auto* mesh = std::get_if<Mesh>(&shape)) return mesh->polyhedron.indices.size();
  if (const auto* sweep = std::get_if<Sweep>(&shape))
    return 4 * sweep->profile.size() * sweep->path.size();
  if (const auto* frustum = std::get_if<Frustum>(&shape)) return 2 * frustum->sides;
  if (const auto* ball = std::get_if<Ellipsoid>(&shape))
    return ball->sides * std::max(ball->rings, ball->sides / 2);
  if (const auto* turned = std::get_if<Revolution>(&shape))
    return turned->profile.size() * std::max(turned->sides, 8);
  return 1;
}

bool is_small(const Scene& scene) {
  std::size_t corners = 0;
  for (const Body& body : scene.bodies) corners += corners_of(*body.shape);
  return scene.bodies.size() <= kMostBodies && corners <= kMostCorners;
}

void draw(const Scene& scene) {
  DrawOptions options;
  options.tolerance = 1;  // few facets
  options.threads = 1;
  Drawing drawing(scene, kGrid, options);
  draw_lines(drawing, {0, 1, 0.5});
  draw_lines(drawing, {30, 3, 0.1});
  draw_cells(drawing);
  draw_strokes(drawing, scene.bodies.size());
}

}  // namespace
}  // namespace overstrike::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace overstrike;
  try {
    const ReadResult read =
        read_scene_text(fuzz::text_of(data, size), "yaml", "fuzz", "/nonexistent");
    if (fuzz::is_small(read.scene)) fuzz::draw(read.scene);
  } catch (const InputError& error) {
    fuzz::expect(!error.diagnostics().empty(), "an error says what is wrong");
  }
  return 0;
}
