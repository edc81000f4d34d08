#include "core/visibility/canonical.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <memory>
#include <tuple>

#include "core/float_environment.h"
#include "core/geometry/direction.h"
#include "core/geometry/tessellate.h"
#include "core/geometry/weld_planes.h"
#include "core/visibility/camera_frame.h"
#include "core/visibility/prepare_shape.h"
#include "core/visibility/view.h"

namespace overstrike {
namespace {

/// Of a body that reaches from far away to the eye, what is nearer than this part of its greatest
/// depth gets no finer facets: nearly all of its surface is farther.
constexpr double kNearestDepth = 1.0 / 64;
/// The same of a body round the eye, which cannot have facets for a depth of 0.
constexpr double kNearestDepthAround = 1.0 / 8;

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
  const double least = farthest * (nearest > 0 ? kNearestDepth : kNearestDepthAround);
  const double w = farthest > 0 ? std::fmax(nearest, least) : 1;
  const double chord = chord_cells * view.world_per_cell * w / stretch(body.placement.linear);
  return chord > 0 && chord < 1e300 ? quantised(chord) : 1;
}

/// A place is the product of moves, each of which adds four roundings to a coordinate (three
/// products and the offset), relative to the largest that takes part; sixteen nested moves, the
/// shape's own vertices and the placing itself stay below this many units of 2^-53.
constexpr double kPlacementRoundings = 72;

/// How far a placed vertex may be from where it was meant. The placement is from the origin; in the
/// world, where it was rounded, it reaches no farther than both together. Against the other
/// vertices of its body it is nearer than that: the placement is one for all, and what made it
/// inexact has moved them together; only its four roundings and the shape's vertices are a vertex's
/// own.
struct PlacedError {
  double in_world, in_body;
};
PlacedError placed_error(const Polyhedron& p, const Affine& placement, const Vec3& origin,
                         double precision) {
  constexpr double kUnit = 0x1p-53;
  Vec3 reach(0.0);
  for (const Vec3& v : p.vertices) reach = glm::max(reach, glm::abs(v));
  const Mat3 size(glm::abs(placement.linear[0]), glm::abs(placement.linear[1]),
                  glm::abs(placement.linear[2]));
  const Vec3 own = size * reach, offset = glm::abs(placement.offset);
  const double rounding = max_norm(own + offset + glm::abs(origin)) * kUnit;
  const double given = max_norm(size * Vec3(precision));
  return {kPlacementRoundings * rounding + given,
          (kPlacementRoundings * max_norm(own) + 4 * max_norm(offset)) * kUnit + given};
}

/// Takes outward normals to outward normals, mirrored or not: the inverse transpose times |det|.
Mat3 normal_map(const Mat3& a) {
  const Mat3 cofactors(glm::cross(a[1], a[2]), glm::cross(a[2], a[0]), glm::cross(a[0], a[1]));
  return glm::determinant(a) < 0 ? cofactors * -1.0 : cofactors;
}

/// Planes are the same whichever way their faces look: the largest component is positive.
Plane upright(const PlaneFit& fit) {
  const Vec3 size = glm::abs(fit.normal);
  const int axis = size.z >= size.x && size.z >= size.y ? 2 : size.y >= size.x ? 1 : 0;
  if (fit.normal[axis] < 0) return {-fit.normal, -fit.offset};
  return {fit.normal, fit.offset};
}

/// A map that presses space to less than this part of its own size in some direction leaves faces
/// across it without a direction that 53 bits could tell; the same where squares of areas would
/// fall out of the range of a double.
constexpr double kFlattened = 0x1p-40;
constexpr double kSmallestStretch = 0x1p-200;
bool is_flattened(const Mat3& a) {
  const double size = stretch(a);
  return !(std::fabs(glm::determinant(a)) > kFlattened * size * size * size) ||
         size < kSmallestStretch;
}

bool finite(const Affine& a) {
  const Vec3 sum = a.linear[0] + a.linear[1] + a.linear[2] + a.offset;
  return std::isfinite(sum.x) && std::isfinite(sum.y) && std::isfinite(sum.z);
}

/// Three digits.
std::string roughly(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, 3).ptr};
}

/// The loop from `start` on runs backwards, from the corner that it began with: smooth tones hang
/// on where a loop begins, and must not change in a mirror.
template <class T>
void turn_round(std::vector<T>& corners, std::size_t start) {
  std::reverse(corners.begin() + static_cast<std::ptrdiff_t>(start) + 1, corners.end());
}

class Assembler {
 public:
  Assembler(const Scene& scene, const View& view, double chord_cells,
            std::vector<Diagnostic>& warnings)
      : scene_(scene), view_(view), chord_cells_(chord_cells), warnings_(warnings) {
    for (const Segment& s : scene.segments)
      out_.segments.push_back({s.from - view.origin, s.to - view.origin, s.pen});
    out_.law = scene.law;
    if (scene.ground_z) out_.ground_z = *scene.ground_z - view.origin.z;
    if (scene.light) out_.light = unit_vector(*scene.light);
  }

  Canonical assemble() {
    for (const Body& body : scene_.bodies)
      any_smooth_ = any_smooth_ || body.shading == Shading::smooth;
    for (Index i = 0; i < scene_.bodies.size(); ++i)
      if (scene_.bodies[i].shape != nullptr) add(i);
    weld();
    return std::move(out_);
  }

 private:
  void warn(const Body& body, const std::string& what) {
    std::string subject(shape_name(*body.shape));
    if (!body.name.empty()) subject += " '" + body.name + "'";
    warnings_.push_back({Severity::warning, body.place, subject + ": " + what, {}, {}});
  }

  double chord_of_shape(const Body& body) {
    if (!is_curved(*body.shape)) return 1;
    const double asked = chord_of(body, view_, chord_cells_);
    const double chord = drawable_chord(*body.shape, asked);
    if (chord > asked)
      warn(body, "drawn to " + roughly(chord / asked * chord_cells_) + " cells instead of " +
                     roughly(chord_cells_) + ": finer would take too many facets");
    return chord;
  }

  const PreparedShape& prepared(const Body& body) {
    const double chord = chord_of_shape(body);
    const bool smooth = body.shading == Shading::smooth;
    auto& slot = shapes_[{body.shape.get(), chord, smooth}];
    if (slot == nullptr)
      slot = std::make_unique<PreparedShape>(prepare_shape(*body.shape, chord, smooth));
    return *slot;
  }

  void add(Index source) {
    Body body = scene_.bodies[source];
    body.placement = from_origin(body.placement, view_.origin);
    if (!finite(body.placement)) return warn(body, "its place is not finite: not drawn");
    const PreparedShape& shape = prepared(body);
    for (const std::string& flaw : shape.flaws) warn(body, flaw);
    if (!is_flattened(body.placement.linear)) return add_placed(source, body, shape);
    // Faces may have lost their area, so that the repairs must see them in their place.
    Mesh flat{shape.polyhedron, {}, {}, shape.precision};
    flat.polyhedron.corner_normals.clear();
    for (Vec3& p : flat.polyhedron.vertices) p = body.placement(p);
    Body placed = body;
    placed.placement = {};
    for (Pattern& pattern : placed.patterns)
      for (Vec3& p : pattern.points) p = body.placement(p);
    if (!std::holds_alternative<FlatPolygon>(*body.shape)) warn(body, "flattened by its place");
    flattened_.push_back(std::make_unique<PreparedShape>(prepare_shape(Shape(flat), 1, false)));
    add_placed(source, placed, *flattened_.back());
  }

  void add_placed(Index source, const Body& body, const PreparedShape& shape) {
    const bool mirrored = glm::determinant(body.placement.linear) < 0;
    CanonicalBody result{};
    result.first_face = static_cast<Index>(out_.faces.size());
    result.first_edge = static_cast<Index>(out_.edges.size());
    result.first_vertex = static_cast<Index>(out_.vertices.size());
    result.first_corner = static_cast<Index>(out_.corners.size());
    result.first_twin = twins_of_shape(shape, mirrored);
    result.closed = shape.closed;
    result.smooth = body.shading == Shading::smooth;
    result.simple =
        !std::holds_alternative<Mesh>(*body.shape) && !std::holds_alternative<Sweep>(*body.shape);
    result.curved = is_curved(*body.shape);
    result.density_factor = body.density_factor;
    result.pen = body.pen;
    result.source = source;
    for (const Vec3& p : shape.polyhedron.vertices) out_.vertices.push_back(body.placement(p));
    add_faces(shape, result, body, mirrored);
    add_edges(shape, result, mirrored);
    result.end_face = static_cast<Index>(out_.faces.size());
    result.end_edge = static_cast<Index>(out_.edges.size());
    result.end_vertex = static_cast<Index>(out_.vertices.size());
    add_patterns(body, static_cast<Index>(out_.bodies.size()));
    out_.bodies.push_back(result);
  }

  void add_faces(const PreparedShape& shape, const CanonicalBody& body, const Body& source,
                 bool mirrored) {
    const Polyhedron& p = shape.polyhedron;
    const PlacedError error = placed_error(p, source.placement, view_.origin, shape.precision);
    const Index face_body = static_cast<Index>(out_.bodies.size());
    std::map<Index, Index> sample_of_group;
    for (Index f = 0; f < p.face_count(); ++f) {
      CanonicalFace face{};
      face.first_loop = static_cast<Index>(out_.loop_ends.size());
      PlaneSample sample{{}, error.in_world, out_.corners.size(), 0, error.in_body, face_body};
      PlaneFitter fitter;
      for (Index l = p.first_loop(f); l < p.face_ends[f]; ++l) {
        const std::span<const Index> loop = add_loop(p.loop(l), body.first_vertex, mirrored);
        fitter.add(loop.size(), [&](std::size_t i) { return out_.vertices[loop[i]]; });
      }
      sample.fit = fitter.fit();
      sample.end_point = out_.corners.size();
      face.end_loop = static_cast<Index>(out_.loop_ends.size());
      face.body = face_body;
      face.plane = static_cast<Index>(samples_.size());
      normals_.push_back(sample.fit.normal);
      if (!p.plane_groups.empty())
        face.plane = sample_of_group.try_emplace(p.plane_groups[f], face.plane).first->second;
      if (face.plane == samples_.size()) {
        samples_.push_back(sample);
      } else if (samples_[face.plane].fit.area < sample.fit.area) {
        samples_[face.plane] = sample;
      }
      out_.faces.push_back(face);
      if (any_smooth_) add_corner_normals(shape, f, body, source, mirrored);
    }
  }

  std::span<const Index> add_loop(std::span<const Index> loop, Index first_vertex, bool mirrored) {
    const std::size_t start = out_.corners.size();
    for (const Index v : loop) out_.corners.push_back(first_vertex + v);
    if (mirrored) turn_round(out_.corners, start);
    out_.loop_ends.push_back(static_cast<Index>(out_.corners.size()));
    return {out_.corners.data() + start, loop.size()};
  }

  void add_corner_normals(const PreparedShape& shape, Index f, const CanonicalBody& body,
                          const Body& source, bool mirrored) {
    const Polyhedron& p = shape.polyhedron;
    const Mat3 map = normal_map(source.placement.linear);
    for (Index l = p.first_loop(f); l < p.face_ends[f]; ++l) {
      const std::size_t start = out_.corner_normals.size();
      for (Index i = p.first_index(l); i < p.loop_ends[l]; ++i) {
        const Vec3 given =
            body.smooth && !p.corner_normals.empty() ? unit(map * p.corner_normals[i]) : Vec3(0.0);
        out_.corner_normals.push_back(given != Vec3(0.0) ? given : normals_.back());
      }
      if (mirrored) turn_round(out_.corner_normals, start);
    }
  }

  /// Decides which faces share a plane, once for all bodies.
  void weld() {
    std::vector<std::pair<Index, Index>> neighbours;
    for (const WingedEdge& e : out_.edges)
      if (e.right != kNone)
        neighbours.emplace_back(out_.faces[e.left].plane, out_.faces[e.right].plane);
    const WeldedPlanes welded = weld_planes(samples_, out_.vertices, neighbours, out_.corners);
    // Planes in the order of the faces that lie in them first: who goes over faces in order finds
    // their planes in order.
    std::vector<Index> number(welded.representative.size(), kNone);
    for (std::size_t f = 0; f < out_.faces.size(); ++f) {
      CanonicalFace& face = out_.faces[f];
      const Index group = welded.group[face.plane];
      if (number[group] == kNone) {
        number[group] = static_cast<Index>(out_.planes.size());
        out_.planes.push_back(upright(samples_[welded.representative[group]].fit));
      }
      face.plane = number[group];
      face.flipped = glm::dot(normals_[f], out_.planes[face.plane].normal) < 0;
    }
    for (WingedEdge& e : out_.edges)
      if (e.right != kNone && out_.faces[e.left].plane == out_.faces[e.right].plane)
        e.crease = false;
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

  /// Where the twins of the shape's corners begin. A mirrored loop runs backwards, so that a side
  /// begins where its other end was.
  Index twins_of_shape(const PreparedShape& shape, bool mirrored) {
    Index& first = first_twin_.try_emplace({&shape, mirrored}, kNone).first->second;
    if (first != kNone) return first;
    first = static_cast<Index>(out_.twins.size());
    const Polyhedron& p = shape.polyhedron;
    const std::vector<Twin> twins = twins_of(p, shape.edges);
    std::vector<Index> place(p.indices.size());
    for (Index l = 0; l < p.loop_ends.size(); ++l) {
      const Index start = p.first_index(l), n = p.loop_ends[l] - start;
      for (Index i = 0; i < n; ++i) place[start + i] = start + (mirrored ? n - 1 - i : i);
    }
    out_.twins.resize(first + twins.size());
    for (std::size_t i = 0; i < twins.size(); ++i)
      out_.twins[first + place[i]] =
          twins[i].face == kNone ? twins[i] : Twin{place[twins[i].corner], twins[i].face};
    return first;
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
  std::map<std::tuple<const Shape*, double, bool>, std::unique_ptr<PreparedShape>> shapes_;
  std::vector<std::unique_ptr<PreparedShape>> flattened_;
  std::map<std::pair<const PreparedShape*, bool>, Index> first_twin_;
  bool any_smooth_ = false;
  std::vector<PlaneSample> samples_;  ///< until weld(), a face's plane is the number of its sample
  std::vector<Vec3> normals_;         ///< per face
  Canonical out_;
};

}  // namespace

Canonical canonicalize(const Scene& scene, const View& view, double chord_cells,
                       std::vector<Diagnostic>& warnings) {
  const FloatEnvironment ours;
  return Assembler(scene, view, chord_cells, warnings).assemble();
}

}  // namespace overstrike
