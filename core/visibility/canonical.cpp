#include "core/visibility/canonical.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/float_environment.h"
#include "core/geometry/direction.h"
#include "core/geometry/tessellate.h"
#include "core/geometry/weld_planes.h"
#include "core/large_pages.h"
#include "core/visibility/camera_frame.h"
#include "core/visibility/placed_shapes.h"
#include "core/visibility/placed_solids.h"
#include "core/visibility/plane_rounding.h"
#include "core/visibility/view.h"

namespace overstrike {
namespace {

/// A place is the product of moves, each of which adds four roundings to a coordinate (three
/// products and the offset), relative to the largest that takes part; sixteen nested moves, the
/// shape's own vertices and the placing itself stay below this many units of 2^-53.
constexpr double kPlacementRoundings = 72;

/// How far a placed vertex may be from where it was meant. The placement is from the origin; in the
/// world, where it was rounded, it reaches no farther than both together. Against the other
/// vertices of its body it is nearer than that: the placement is one for all, and what made it
/// inexact has moved them together; only its four roundings and the shape's vertices are a vertex's
/// own.
VertexError placed_error(const Polyhedron& p, const Affine& placement, const Vec3& origin,
                         double precision, double place_precision) {
  constexpr double kUnit = 0x1p-53;
  Vec3 reach(0.0);
  for (const Vec3& v : p.vertices) reach = glm::max(reach, glm::abs(v));
  const Mat3 size(glm::abs(placement.linear[0]), glm::abs(placement.linear[1]),
                  glm::abs(placement.linear[2]));
  const Vec3 own = size * reach, offset = glm::abs(placement.offset);
  const double rounding = max_norm(own + offset + glm::abs(origin)) * kUnit;
  const double given = max_norm(size * Vec3(precision));
  return {kPlacementRoundings * rounding + given + place_precision,
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

/// The loop from `start` on runs backwards, from the corner that it began with: smooth tones hang
/// on where a loop begins, and must not change in a mirror.
template <class T>
void turn_round(std::vector<T>& corners, std::size_t start) {
  std::reverse(corners.begin() + static_cast<std::ptrdiff_t>(start) + 1, corners.end());
}

/// Where a body's shape stands.
struct Placing {
  const PreparedShape& shape;
  Affine placement;
  bool mirrored;
};

class Assembler {
 public:
  Assembler(const Scene& scene, const View& view, double chord_cells,
            std::vector<Diagnostic>& warnings)
      : view_(view), placed_(scene, view, chord_cells, warnings) {
    for (const Segment& s : scene.segments)
      out_.segments.push_back({s.from - view.origin, s.to - view.origin, s.pen});
    out_.law = scene.law;
    if (scene.ground_z) out_.ground_z = *scene.ground_z - view.origin.z;
    if (scene.light || scene.light_beside_eye)
      out_.light = light_of(scene, camera_frame(scene.camera, stage_of(scene)));
    for (const Body& body : scene.bodies)
      any_smooth_ = any_smooth_ || body.shading == Shading::smooth;
    bodies_ = placed_.all();
    if (scene.solids.empty()) return;
    distinct_ = with_solids(scene, placed_, out_, warnings);
    bodies_ = distinct_;
  }

  /// Edges come last, when what welding needs has been given back.
  Canonical assemble() {
    make_room();
    for (const PlacedShape& placed : bodies_) add(placed);
    weld();
    for (std::size_t b = 0; b < out_.bodies.size(); ++b) add_edges(b);
    return std::move(out_);
  }

 private:
  /// A vector that grows holds what it has twice.
  void make_room() {
    std::size_t vertices = 0, corners = 0, loops = 0, faces = 0, edges = 0;
    for (const PlacedShape& placed : bodies_) {
      const Polyhedron& p = placed.shape->polyhedron;
      vertices += p.vertices.size(), corners += p.indices.size(), loops += p.loop_ends.size();
      faces += p.face_count(), edges += placed.shape->edges.size();
    }
    out_.bodies.reserve(bodies_.size());
    out_.vertices.reserve(vertices), out_.corners.reserve(corners), out_.loop_ends.reserve(loops);
    out_.faces.reserve(faces), out_.edges.reserve(edges), samples_.reserve(faces);
    if (any_smooth_) out_.corner_normals.reserve(corners);
    prefer_large_pages(out_.bodies), prefer_large_pages(out_.vertices);
    prefer_large_pages(out_.corners), prefer_large_pages(out_.loop_ends);
    prefer_large_pages(out_.faces), prefer_large_pages(out_.edges);
  }

  void add(const PlacedShape& placed) {
    const Body& body = placed_.body(placed);
    Placing placing{*placed.shape, placed_.placement(placed), false};
    placing.mirrored = glm::determinant(placing.placement.linear) < 0;
    CanonicalBody result{};
    result.first_face = static_cast<Index>(out_.faces.size());
    result.first_edge = out_.bodies.empty() ? 0 : out_.bodies.back().end_edge;
    result.first_vertex = static_cast<Index>(out_.vertices.size());
    result.first_corner = static_cast<Index>(out_.corners.size());
    result.first_twin = twins_of_shape(placing);
    result.closed = placing.shape.closed;
    result.smooth = body.shading == Shading::smooth;
    result.simple =
        !std::holds_alternative<Mesh>(*body.shape) && !std::holds_alternative<Sweep>(*body.shape);
    result.curved = is_curved(*body.shape);
    result.density_factor = body.density_factor;
    result.pen = body.pen;
    result.source = placed.source;
    for (const Vec3& p : placing.shape.polyhedron.vertices)
      out_.vertices.push_back(placing.placement(p));
    add_faces(placing, result, body.precision);
    result.end_face = static_cast<Index>(out_.faces.size());
    result.end_edge = result.first_edge + static_cast<Index>(placing.shape.edges.size());
    result.end_vertex = static_cast<Index>(out_.vertices.size());
    add_patterns(body, static_cast<Index>(out_.bodies.size()));
    out_.bodies.push_back(result);
  }

  void add_faces(const Placing& placing, const CanonicalBody& body, double body_precision) {
    const Polyhedron& p = placing.shape.polyhedron;
    const Index number = static_cast<Index>(out_.bodies.size());
    errors_.push_back(
        placed_error(p, placing.placement, view_.origin, placing.shape.precision, body_precision));
    std::map<Index, Index> sample_of_group;
    for (Index f = 0; f < p.face_count(); ++f) {
      CanonicalFace face{};
      face.first_loop = static_cast<Index>(out_.loop_ends.size());
      PlaneSample sample{{}, static_cast<Index>(out_.corners.size()), 0, number};
      PlaneFitter fitter;
      for (Index l = p.first_loop(f); l < p.face_ends[f]; ++l) {
        const std::span<const Index> loop =
            add_loop(p.loop(l), body.first_vertex, placing.mirrored);
        fitter.add(loop.size(), [&](std::size_t i) { return out_.vertices[loop[i]]; });
      }
      sample.fit = fitter.fit();
      sample.end_point = static_cast<Index>(out_.corners.size());
      face.end_loop = static_cast<Index>(out_.loop_ends.size());
      face.body = number;
      face.plane = static_cast<Index>(samples_.size());
      if (!p.plane_groups.empty()) {
        grouped_normals_.push_back(sample.fit.normal);
        face.plane = sample_of_group.try_emplace(p.plane_groups[f], face.plane).first->second;
      }
      if (face.plane == samples_.size()) {
        samples_.push_back(sample);
      } else if (samples_[face.plane].fit.area < sample.fit.area) {
        samples_[face.plane] = sample;
      }
      out_.faces.push_back(face);
      if (any_smooth_) add_corner_normals(placing, f, body.smooth, sample.fit.normal);
    }
  }

  std::span<const Index> add_loop(std::span<const Index> loop, Index first_vertex, bool mirrored) {
    const std::size_t start = out_.corners.size();
    for (const Index v : loop) out_.corners.push_back(first_vertex + v);
    if (mirrored) turn_round(out_.corners, start);
    out_.loop_ends.push_back(static_cast<Index>(out_.corners.size()));
    return {out_.corners.data() + start, loop.size()};
  }

  void add_corner_normals(const Placing& placing, Index f, bool smooth, const Vec3& flat) {
    const Polyhedron& p = placing.shape.polyhedron;
    const Mat3 map = normal_map(placing.placement.linear);
    for (Index l = p.first_loop(f); l < p.face_ends[f]; ++l) {
      const std::size_t start = out_.corner_normals.size();
      for (Index i = p.first_index(l); i < p.loop_ends[l]; ++i) {
        const Vec3 given =
            smooth && !p.corner_normals.empty() ? unit(map * p.corner_normals[i]) : Vec3(0.0);
        out_.corner_normals.push_back(given != Vec3(0.0) ? given : flat);
      }
      if (placing.mirrored) turn_round(out_.corner_normals, start);
    }
  }

  /// Decides which faces share a plane, once for all bodies. Planes are in the order of the faces
  /// that lie in them first: who goes over faces in order finds their planes in order.
  void weld() {
    const WeldedPlanes welded = weld_planes(
        samples_, errors_, out_.vertices, [this] { return neighbours(); }, out_.corners);
    out_.planes.reserve(welded.representative.size());
    prefer_large_pages(out_.planes);
    std::vector<Index> number(welded.representative.size(), kNone);
    std::size_t grouped = 0;
    for (std::size_t b = 0; b < out_.bodies.size(); ++b) {
      const CanonicalBody& body = out_.bodies[b];
      const bool in_groups = !bodies_[b].shape->polyhedron.plane_groups.empty();
      for (Index f = body.first_face; f < body.end_face; ++f) {
        CanonicalFace& face = out_.faces[f];
        const Vec3& normal =
            in_groups ? grouped_normals_[grouped++] : samples_[face.plane].fit.normal;
        const Index group = welded.group[face.plane];
        if (number[group] == kNone) {
          number[group] = static_cast<Index>(out_.planes.size());
          out_.planes.push_back(upright(samples_[welded.representative[group]].fit));
        }
        face.plane = number[group];
        face.flipped = glm::dot(normal, out_.planes[face.plane].normal) < 0;
        const Index other = samples_[welded.representative[group]].body;
        put_on_axis_plane(face, errors_[b].in_world + errors_[other].in_world);
      }
    }
    samples_ = {}, errors_ = {}, grouped_normals_ = {};
  }

  /// Vertices of faces that share a plane across an axis share its coordinate: a line along the
  /// seam of two bodies must not look between them. They move by no more than they may be off,
  /// `most`: a face without an area stands in a plane that says nothing of its vertices.
  void put_on_axis_plane(const CanonicalFace& face, double most) {
    const Plane& plane = out_.planes[face.plane];
    int axis = 0;
    while (axis < 3 && plane.normal[axis] != 1) ++axis;
    if (axis == 3 || plane.normal[(axis + 1) % 3] != 0 || plane.normal[(axis + 2) % 3] != 0) return;
    const Index end = out_.loop_ends[face.end_loop - 1];
    const std::span<const Index> corners(out_.corners.data() + out_.first_corner(face.first_loop),
                                         out_.corners.data() + end);
    for (const Index v : corners)
      if (!(std::fabs(out_.vertices[v][axis] - plane.offset) <= most)) return;
    for (const Index v : corners) out_.vertices[v][axis] = plane.offset;
  }

  /// Of samples, as faces number them until they are welded.
  std::vector<std::pair<Index, Index>> neighbours() const {
    std::vector<std::pair<Index, Index>> pairs;
    for (std::size_t b = 0; b < out_.bodies.size(); ++b) {
      const CanonicalFace* const faces = out_.faces.data() + out_.bodies[b].first_face;
      for (const EdgePair& e : bodies_[b].shape->edges)
        if (e.right != kNoFace) pairs.emplace_back(faces[e.left].plane, faces[e.right].plane);
    }
    return pairs;
  }

  void add_edges(std::size_t number) {
    const CanonicalBody& body = out_.bodies[number];
    const PlacedShape& placed = bodies_[number];
    const bool mirrored = glm::determinant(placed_.placement(placed).linear) < 0;
    for (std::size_t i = 0; i < placed.shape->edges.size(); ++i) {
      const EdgePair& e = placed.shape->edges[i];
      WingedEdge edge{
          body.first_vertex + e.from, body.first_vertex + e.to, body.first_face + e.left,
          e.right == kNoFace ? kNone : body.first_face + e.right, !placed.shape->smooth_edge[i]};
      if (mirrored) std::swap(edge.from, edge.to);
      if (edge.right != kNone && out_.faces[edge.left].plane == out_.faces[edge.right].plane)
        edge.crease = false;
      out_.edges.push_back(edge);
    }
  }

  /// Where the twins of the shape's corners begin. A mirrored loop runs backwards, so that a side
  /// begins where its other end was.
  Index twins_of_shape(const Placing& placing) {
    const bool mirrored = placing.mirrored;
    Index& first = first_twin_.try_emplace({&placing.shape, mirrored}, kNone).first->second;
    if (first != kNone) return first;
    first = static_cast<Index>(out_.twins.size());
    const Polyhedron& p = placing.shape.polyhedron;
    const std::vector<Twin> twins = twins_of(p, placing.shape.edges);
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
    const Affine placement = from_origin(body.placement, view_.origin);
    for (const Pattern& pattern : body.patterns) {
      CanonicalPattern placed{{}, number, pattern.pen};
      for (const Vec3& p : pattern.points) placed.points.push_back(placement(p));
      out_.patterns.push_back(std::move(placed));
    }
  }

  const View& view_;
  PlacedShapes placed_;
  std::vector<PlacedShape> distinct_;    ///< of a scene with solids
  std::span<const PlacedShape> bodies_;  ///< in the order of Canonical::bodies
  std::map<std::pair<const PreparedShape*, bool>, Index> first_twin_;
  bool any_smooth_ = false;
  std::vector<VertexError> errors_;    ///< per body
  std::vector<PlaneSample> samples_;   ///< until weld(), a face's plane is the number of its sample
  std::vector<Vec3> grouped_normals_;  ///< of faces that may share their sample, in order
  Canonical out_;
};

}  // namespace

Canonical canonicalize(const Scene& scene, const View& view, double chord_cells,
                       std::vector<Diagnostic>& warnings) {
  const FloatEnvironment ours;
  Canonical canonical = Assembler(scene, view, chord_cells, warnings).assemble();
  note_bodies_on_planes(canonical);
  return canonical;
}

}  // namespace overstrike
