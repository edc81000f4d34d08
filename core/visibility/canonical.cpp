#include "core/visibility/canonical.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "core/geometry/direction.h"
#include "core/geometry/plane_fit.h"
#include "core/geometry/tessellate.h"
#include "core/visibility/prepare_shape.h"
#include "core/visibility/view.h"

namespace overstrike {
namespace {

/// Of a body that reaches from far away to the eye, what is nearer than this part of its greatest
/// depth gets no finer facets: nearly all of its surface is farther.
constexpr double kNearestDepth = 1.0 / 64;

/// Upper bound of the largest stretch of a linear map, at most 8 % too large: the Frobenius norm of
/// (AtA)^4 is at least the eighth power of the largest singular value, and at most sqrt(3) times
/// it.
double stretch(const Mat3& a) {
  double scale = 0;
  for (int c = 0; c < 3; ++c) scale = std::fmax(scale, max_norm(a[c]));
  if (!(scale > 0)) return 0;
  const Mat3 b = a / scale;
  const Mat3 b2 = glm::transpose(b) * b, b4 = b2 * b2, b8 = b4 * b4;
  const double square = glm::dot(b8[0], b8[0]) + glm::dot(b8[1], b8[1]) + glm::dot(b8[2], b8[2]);
  return scale * std::sqrt(std::sqrt(std::sqrt(std::sqrt(square))));
}

/// Rounded down to two bits after the leading one, so that copies share their facets.
double quantised(double chord) {
  int exponent = 0;
  const double mantissa = std::frexp(chord, &exponent);
  return std::ldexp(std::floor(mantissa * 8) / 8, exponent);
}

/// The chord for a body, in its own units.
double chord_of(const Body& body, const View& view, double chord_cells) {
  const Bounds box = bounds(*body.shape, body.placement);
  double nearest = 1e300, farthest = 0;
  for (int i = 0; i < 8; ++i) {
    const Vec4 p(i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y,
                 i & 4 ? box.high.z : box.low.z, 1);
    const double w = (view.matrix * p).z;
    nearest = std::fmin(nearest, w);
    farthest = std::fmax(farthest, w);
  }
  const double w = farthest > 0 ? std::fmax(nearest, farthest * kNearestDepth) : 1;
  const double chord = chord_cells * view.world_per_cell * w / stretch(body.placement.linear);
  return chord > 0 && chord < 1e300 ? quantised(chord) : 1;
}

bool finite(const Affine& a) {
  const Vec3 sum = a.linear[0] + a.linear[1] + a.linear[2] + a.offset;
  return std::isfinite(sum.x) && std::isfinite(sum.y) && std::isfinite(sum.z);
}

class Assembler {
 public:
  Assembler(const Scene& scene, const View& view, double chord_cells,
            std::vector<Diagnostic>& warnings)
      : scene_(scene), view_(view), chord_cells_(chord_cells), warnings_(warnings) {
    out_.segments = scene.segments;
    out_.law = scene.law;
    out_.ground_z = scene.ground_z;
    if (scene.light) out_.light = unit_vector(*scene.light);
  }

  Canonical assemble() {
    for (Index i = 0; i < scene_.bodies.size(); ++i)
      if (scene_.bodies[i].shape != nullptr) add(i);
    for (WingedEdge& e : out_.edges)
      if (e.right != kNone && out_.faces[e.left].plane == out_.faces[e.right].plane)
        e.crease = false;
    return std::move(out_);
  }

 private:
  void warn(const Body& body, const std::string& what) {
    std::string subject(shape_name(*body.shape));
    if (!body.name.empty()) subject += " '" + body.name + "'";
    warnings_.push_back({Severity::warning, body.place, subject + ": " + what, {}, {}});
  }

  const PreparedShape& prepared(const Body& body) {
    const bool curved = is_curved(*body.shape);
    const double chord = curved ? chord_of(body, view_, chord_cells_) : 1;
    auto& slot = shapes_[{body.shape.get(), chord}];
    if (slot == nullptr) slot = std::make_unique<PreparedShape>(prepare_shape(*body.shape, chord));
    return *slot;
  }

  void add(Index source) {
    const Body& body = scene_.bodies[source];
    if (!finite(body.placement)) return warn(body, "its place is not finite: not drawn");
    const PreparedShape& shape = prepared(body);
    for (const std::string& flaw : shape.flaws) warn(body, flaw);
    const bool mirrored = glm::determinant(body.placement.linear) < 0;
    CanonicalBody result{};
    result.first_face = static_cast<Index>(out_.faces.size());
    result.first_edge = static_cast<Index>(out_.edges.size());
    result.first_vertex = static_cast<Index>(out_.vertices.size());
    result.closed = shape.closed;
    result.smooth = body.shading == Shading::smooth;
    result.density_factor = body.density_factor;
    result.pen = body.pen;
    result.source = source;
    for (const Vec3& p : shape.polyhedron.vertices) out_.vertices.push_back(body.placement(p));
    add_faces(shape.polyhedron, result, mirrored);
    add_edges(shape, result, mirrored);
    result.end_face = static_cast<Index>(out_.faces.size());
    result.end_edge = static_cast<Index>(out_.edges.size());
    result.end_vertex = static_cast<Index>(out_.vertices.size());
    add_patterns(body, static_cast<Index>(out_.bodies.size()));
    out_.bodies.push_back(result);
  }

  void add_faces(const Polyhedron& p, const CanonicalBody& body, bool mirrored) {
    for (Index f = 0; f < p.face_count(); ++f) {
      CanonicalFace face{};
      face.first_loop = static_cast<Index>(out_.loop_ends.size());
      PlaneFitter fitter;
      for (Index l = p.first_loop(f); l < p.face_ends[f]; ++l) {
        add_loop(p.loop(l), body.first_vertex, mirrored);
        const std::span<const Index> loop =
            out_.loop(static_cast<Index>(out_.loop_ends.size()) - 1);
        fitter.add(loop.size(), [&](std::size_t i) { return out_.vertices[loop[i]]; });
      }
      const PlaneFit fit = fitter.fit();
      face.end_loop = static_cast<Index>(out_.loop_ends.size());
      face.plane = static_cast<Index>(out_.planes.size());
      face.body = static_cast<Index>(out_.bodies.size());
      out_.planes.push_back({fit.normal, fit.offset});
      out_.faces.push_back(face);
    }
  }

  void add_loop(std::span<const Index> loop, Index first_vertex, bool mirrored) {
    const std::size_t start = out_.corners.size();
    for (const Index v : loop) out_.corners.push_back(first_vertex + v);
    if (mirrored) std::reverse(out_.corners.begin() + start, out_.corners.end());
    out_.loop_ends.push_back(static_cast<Index>(out_.corners.size()));
  }

  void add_edges(const PreparedShape& shape, const CanonicalBody& body, bool mirrored) {
    for (std::size_t i = 0; i < shape.edges.size(); ++i) {
      const EdgePair& e = shape.edges[i];
      WingedEdge edge{
          body.first_vertex + e.from, body.first_vertex + e.to, body.first_face + e.left,
          e.right == kNoFace ? kNone : body.first_face + e.right, !shape.smooth_edge[i]};
      if (mirrored) std::swap(edge.from, edge.to);
      out_.edges.push_back(edge);
    }
  }

  void add_patterns(const Body& body, Index number) {
    for (const Pattern& pattern : body.patterns) {
      CanonicalPattern placed{{}, number, pattern.pen};
      for (const Vec3& p : pattern.points) placed.points.push_back(body.placement(p));
      out_.patterns.push_back(std::move(placed));
    }
  }

  const Scene& scene_;
  const View& view_;
  double chord_cells_;
  std::vector<Diagnostic>& warnings_;
  std::map<std::pair<const Shape*, double>, std::unique_ptr<PreparedShape>> shapes_;
  Canonical out_;
};

}  // namespace

Canonical canonicalize(const Scene& scene, const View& view, double chord_cells,
                       std::vector<Diagnostic>& warnings) {
  return Assembler(scene, view, chord_cells, warnings).assemble();
}

}  // namespace overstrike
