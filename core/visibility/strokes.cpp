#include "core/visibility/strokes.h"

#include <algorithm>

#include "core/visibility/candidate_lines.h"
#include "core/visibility/edge_resolver.h"
#include "core/visibility/pieces.h"

namespace overstrike {
namespace {

std::vector<SightLine> candidates(const ProjectedScene& scene, const FaceIndex& index,
                                  const std::vector<Shadow>& shadows, const StrokeOptions& options,
                                  double tolerance) {
  std::vector<SightLine> lines;
  add_edges(scene, options, lines);
  if (options.intersections) add_intersections(scene, index, lines);
  if (options.shadow_outlines) add_shadow_outlines(scene, index, shadows, lines);
  if (options.patterns) add_patterns(scene, tolerance, lines);
  if (options.segments) add_segments(scene, lines);
  return lines;
}

std::vector<LinePiece> visible_pieces(const ProjectedScene& scene, const FaceIndex& index,
                                      const std::vector<SightLine>& lines) {
  EdgeResolver resolver(scene, index);
  const Vec2 page(scene.view.grid.columns, scene.view.grid.rows);
  std::vector<LinePiece> pieces;
  for (const SightLine& line : lines) {
    const bool of_body = line.body < scene.canonical.bodies.size();
    const double factor = of_body ? scene.canonical.bodies[line.body].density_factor : 0;
    const double error = line.a.grid.error + line.b.grid.error;
    for (const Interval& part : resolver.visible(line))
      pieces.push_back({glm::clamp(line.at(part.first), Vec2(0), page),
                        glm::clamp(line.at(part.second), Vec2(0), page), error, line.kind,
                        line.body, line.pen, line.curved, factor});
  }
  return pieces;
}

}  // namespace

std::vector<Stroke> visible_strokes(const Canonical& seen, const View& view,
                                    const std::vector<Shadow>& shadows,
                                    const StrokeOptions& options, double tolerance) {
  const ProjectedScene scene(seen, view);
  const FaceIndex index(scene);
  const std::vector<SightLine> lines = candidates(scene, index, shadows, options, tolerance);
  return chained(merged(visible_pieces(scene, index, lines), view.grid), tolerance);
}

}  // namespace overstrike
