#include "core/visibility/strokes.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include "core/visibility/candidate_lines.h"
#include "core/visibility/edge_resolver.h"
#include "core/visibility/pieces.h"

namespace overstrike {
namespace {

std::vector<SightLine> candidates(const ProjectedScene& scene, const FaceIndex& index,
                                  const Canonical& casting, const std::vector<Shadow>& shadows,
                                  const StrokeOptions& options, double tolerance) {
  std::vector<SightLine> lines;
  add_edges(scene, options, lines);
  if (options.intersections) add_intersections(scene, index, lines);
  if (options.shadow_outlines) add_shadow_outlines(scene, index, casting, shadows, lines);
  if (options.patterns) add_patterns(scene, tolerance, lines);
  if (options.segments) add_segments(scene, lines);
  return lines;
}

/// Per body its place in an order that goes by what bodies are, not by their numbers: the darker
/// first, then the one with the lexicographically smaller vertices, then with the smaller pen.
std::vector<Index> ranks_of_bodies(const Canonical& c) {
  using Key = std::tuple<double, std::vector<std::array<double, 3>>, int>;
  std::vector<std::pair<Key, Index>> order;
  for (Index b = 0; b < c.bodies.size(); ++b) {
    const CanonicalBody& body = c.bodies[b];
    std::vector<std::array<double, 3>> vertices;
    for (Index v = body.first_vertex; v < body.end_vertex; ++v)
      vertices.push_back({c.vertices[v].x, c.vertices[v].y, c.vertices[v].z});
    std::sort(vertices.begin(), vertices.end());
    order.emplace_back(Key{-body.density_factor, std::move(vertices), body.pen}, b);
  }
  std::sort(order.begin(), order.end());
  std::vector<Index> ranks(c.bodies.size());
  for (Index r = 0; r < order.size(); ++r) ranks[order[r].second] = r;
  return ranks;
}

std::vector<LinePiece> visible_pieces(const ProjectedScene& scene, const FaceIndex& index,
                                      const std::vector<SightLine>& lines,
                                      const StrokeOptions& options) {
  EdgeResolver resolver(scene, index);
  const Vec2 page(scene.view.grid.columns, scene.view.grid.rows);
  const std::vector<Index> ranks = ranks_of_bodies(scene.canonical);
  const std::vector<char> curved = curved_bodies(scene.canonical);
  std::vector<LinePiece> pieces;
  for (const SightLine& line : lines) {
    const double error = line.a.grid.error + line.b.grid.error;
    for (const auto& [part, kind, body] : resolver.visible(line)) {
      if (!wanted(kind, options)) continue;
      const bool of_line = kind == line.kind && body == line.body;
      pieces.push_back({glm::clamp(line.at(part.first), Vec2(0), page),
                        glm::clamp(line.at(part.second), Vec2(0), page), error, kind, body,
                        of_line ? line.pen : scene.canonical.bodies[body].pen,
                        of_line ? line.curved : curved[body] != 0,
                        body < ranks.size() ? ranks[body] : kNone});
    }
  }
  return pieces;
}

}  // namespace

std::vector<Stroke> visible_strokes(const Canonical& casting, const Canonical& seen,
                                    const View& view, const std::vector<Shadow>& shadows,
                                    const StrokeOptions& options, double tolerance) {
  const ProjectedScene scene(seen, view);
  const FaceIndex index(scene);
  const std::vector<SightLine> lines =
      candidates(scene, index, casting, shadows, options, tolerance);
  return chained(merged(visible_pieces(scene, index, lines, options), view.grid), tolerance);
}

}  // namespace overstrike
