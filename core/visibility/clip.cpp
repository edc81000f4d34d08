#include "core/visibility/clip.h"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "core/geometry/cut_polyhedron.h"
#include "core/geometry/winged_edges.h"
#include "core/visibility/clip_heights.h"
#include "core/visibility/depth.h"
#include "core/visibility/plane_rounding.h"

namespace overstrike {
namespace {

double height(const Plane& plane, const Vec3& p) {
  return glm::dot(plane.normal, p) - plane.offset;
}

std::uint64_t edge_key(Index a, Index b) {
  return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

/// The old edge that the edge between two vertices of a cut polyhedron is, or is a part of; an edge
/// of no cap has an old vertex at one end at least.
std::uint64_t source_edge(const CutPolyhedron::Origin& a, const CutPolyhedron::Origin& b) {
  if (a.low != a.high) return edge_key(a.low, a.high);
  return b.low != b.high ? edge_key(b.low, b.high) : edge_key(a.low, b.low);
}

/// One body's faces as a polyhedron of its own.
Polyhedron polyhedron_of(const Canonical& c, const CanonicalBody& body) {
  Polyhedron p;
  p.vertices.assign(c.vertices.begin() + body.first_vertex, c.vertices.begin() + body.end_vertex);
  for (Index f = body.first_face; f < body.end_face; ++f) {
    for (Index l = c.faces[f].first_loop; l < c.faces[f].end_loop; ++l) {
      for (const Index v : c.loop(l)) p.indices.push_back(v - body.first_vertex);
      p.loop_ends.push_back(static_cast<Index>(p.indices.size()));
    }
    p.end_face();
  }
  if (c.corner_normals.empty() || body.first_face == body.end_face) return p;
  const Index first_loop = c.faces[body.first_face].first_loop;
  const auto first = c.corner_normals.begin() + (first_loop == 0 ? 0 : c.loop_ends[first_loop - 1]);
  p.corner_normals.assign(first, first + static_cast<std::ptrdiff_t>(p.indices.size()));
  return p;
}

/// Faces as they are shaded: a smooth face is a fan of triangles from its first corner, and must
/// stay that fan when it is cut, or its tones would move.
struct Fanned {
  Polyhedron polyhedron;
  std::vector<Index> source;        ///< per face: the face it is a part of
  std::vector<std::uint64_t> ribs;  ///< the edges within fans
};

bool shaded_as_fan(const Polyhedron& p, Index face) {
  const Index loop = p.first_loop(face);
  if (p.corner_normals.empty() || p.face_ends[face] - loop != 1 || p.loop(loop).size() < 4)
    return false;
  const auto first = p.corner_normals.begin() + p.first_index(loop);
  return std::any_of(first, first + static_cast<std::ptrdiff_t>(p.loop(loop).size()),
                     [&](const Vec3& normal) { return normal != *first; });
}

Fanned fanned(const Polyhedron& p) {
  Fanned result;
  result.polyhedron.vertices = p.vertices;
  const auto add = [&](Index index) {
    result.polyhedron.indices.push_back(p.indices[index]);
    if (!p.corner_normals.empty())
      result.polyhedron.corner_normals.push_back(p.corner_normals[index]);
  };
  const auto end_loop = [&] {
    result.polyhedron.loop_ends.push_back(static_cast<Index>(result.polyhedron.indices.size()));
  };
  const auto end_face = [&](Index face) {
    result.polyhedron.end_face();
    result.source.push_back(face);
  };
  for (Index f = 0; f < p.face_count(); ++f) {
    if (!shaded_as_fan(p, f)) {
      for (Index l = p.first_loop(f); l < p.face_ends[f]; ++l) {
        for (Index i = p.first_index(l); i < p.loop_ends[l]; ++i) add(i);
        end_loop();
      }
      end_face(f);
      continue;
    }
    const Index first = p.first_index(p.first_loop(f)), end = p.loop_ends[p.first_loop(f)];
    for (Index i = first + 1; i + 1 < end; ++i) {
      add(first), add(i), add(i + 1);
      end_loop();
      end_face(f);
      if (i > first + 1) result.ribs.push_back(edge_key(p.indices[first], p.indices[i]));
    }
  }
  return result;
}

/// Takes from a normal what points away from the light on the side of the face that is seen. Tones
/// are the same, and become linear in it, so that corners that are cut between have the tone that
/// was there.
Vec3 turned_to_light(const Vec3& normal, const Vec3& light, bool from_behind) {
  const double towards = glm::dot(normal, light);
  return normal - light * (from_behind ? std::max(0.0, towards) : std::min(0.0, towards));
}

/// The pieces of a polyline on the positive side.
std::vector<std::vector<Vec3>> cut_polyline(const std::vector<Vec3>& points, const Plane& keep) {
  std::vector<std::vector<Vec3>> pieces;
  std::vector<Vec3> piece;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double h = height(keep, points[i]);
    const double before = i == 0 ? h : height(keep, points[i - 1]);
    if ((h >= 0) != (before >= 0))
      piece.push_back(points[i - 1] + (points[i] - points[i - 1]) * (before / (before - h)));
    if (h >= 0) piece.push_back(points[i]);
    if (h < 0 && !piece.empty()) pieces.push_back(std::move(piece)), piece.clear();
  }
  if (!piece.empty()) pieces.push_back(std::move(piece));
  return pieces;
}

class Clipper {
 public:
  Clipper(const Canonical& in, const Plane& keep, const Vec4& eye)
      : in_(in), keep_(keep), eye_(eye) {}

  Canonical clip() {
    out_.planes = in_.planes;
    out_.twins = in_.twins;
    out_.light = in_.light;
    out_.ground_z = in_.ground_z;
    out_.law = in_.law;
    out_.solids = in_.solids;
    std::vector<Index> number(in_.bodies.size(), kNone);
    for (Index i = 0; i < in_.bodies.size(); ++i) {
      const std::size_t before = out_.bodies.size();
      add_body(in_.bodies[i]);
      if (out_.bodies.size() == before) continue;
      number[i] = static_cast<Index>(before);
      if (!in_.memberships.empty()) out_.memberships.push_back(in_.memberships[i]);
    }
    add_lines(number);
    return std::move(out_);
  }

 private:
  void add_body(const CanonicalBody& body) {
    clip_heights(in_, body, keep_, heights_);
    double lowest = 0, highest = 0;
    for (const double h : heights_) lowest = std::min(lowest, h), highest = std::max(highest, h);
    if (lowest >= 0) return copy(body);
    // Of a body that ends in the plane what lies in it may be seen: a sheet's, a back that is
    // inside out.
    if (highest >= 0) cut(body);
  }

  CanonicalBody begin(const CanonicalBody& body) const {
    CanonicalBody result = body;
    result.first_face = static_cast<Index>(out_.faces.size());
    result.first_edge = static_cast<Index>(out_.edges.size());
    result.first_vertex = static_cast<Index>(out_.vertices.size());
    result.first_corner = static_cast<Index>(out_.corners.size());
    return result;
  }
  void end(CanonicalBody& body) {
    body.end_face = static_cast<Index>(out_.faces.size());
    body.end_edge = static_cast<Index>(out_.edges.size());
    body.end_vertex = static_cast<Index>(out_.vertices.size());
    out_.bodies.push_back(body);
  }

  /// Appends the loops of face f of p and the face itself, a copy of `like`.
  void add_face(const Polyhedron& p, Index f, CanonicalFace like, Index first_vertex) {
    like.body = static_cast<Index>(out_.bodies.size());
    like.first_loop = static_cast<Index>(out_.loop_ends.size());
    for (Index l = p.first_loop(f); l < p.face_ends[f]; ++l) {
      for (const Index v : p.loop(l)) out_.corners.push_back(first_vertex + v);
      if (!p.corner_normals.empty())
        out_.corner_normals.insert(out_.corner_normals.end(),
                                   p.corner_normals.begin() + p.first_index(l),
                                   p.corner_normals.begin() + p.loop_ends[l]);
      out_.loop_ends.push_back(static_cast<Index>(out_.corners.size()));
    }
    like.end_loop = static_cast<Index>(out_.loop_ends.size());
    out_.faces.push_back(like);
  }

  void copy(const CanonicalBody& body) {
    CanonicalBody result = begin(body);
    const Polyhedron p = polyhedron_of(in_, body);
    out_.vertices.insert(out_.vertices.end(), p.vertices.begin(), p.vertices.end());
    for (Index f = 0; f < p.face_count(); ++f)
      add_face(p, f, in_.faces[body.first_face + f], result.first_vertex);
    const Index faces = result.first_face - body.first_face;
    const Index vertices = result.first_vertex - body.first_vertex;
    for (Index e = body.first_edge; e < body.end_edge; ++e) {
      WingedEdge edge = in_.edges[e];
      edge.from += vertices, edge.to += vertices, edge.left += faces;
      if (edge.right != kNone) edge.right += faces;
      out_.edges.push_back(edge);
    }
    end(result);
  }

  void cut(const CanonicalBody& body) {
    Fanned whole = fanned(polyhedron_of(in_, body));
    if (in_.light && !whole.polyhedron.corner_normals.empty()) turn_to_light(body, whole);
    CutPolyhedron cut =
        cut_polyhedron(whole.polyhedron, heights_, keep_.normal, keep_.offset, body.closed);
    for (Index& source : cut.face_source)
      if (!is_cap(source)) source = whole.source[source];
    if (cut.polyhedron.face_count() == 0) return;
    CanonicalBody result = begin(body);
    out_.vertices.insert(out_.vertices.end(), cut.polyhedron.vertices.begin(),
                         cut.polyhedron.vertices.end());
    for (Index f = 0; f < cut.polyhedron.face_count(); ++f)
      add_face(cut.polyhedron, f, face_like(body, cut.face_source[f]), result.first_vertex);
    add_edges(body, cut, whole.ribs, result);
    end(result);
  }

  /// Faces of open bodies are seen from either side, and so are those of operands: of what is taken
  /// away, and where a mesh is inside out.
  void turn_to_light(const CanonicalBody& body, Fanned& fans) const {
    Polyhedron& p = fans.polyhedron;
    const auto number = static_cast<Index>(&body - in_.bodies.data());
    const bool two_sided = !body.closed || in_.membership(number).solid != kNone;
    for (Index f = 0; f < p.face_count(); ++f) {
      const CanonicalFace& face = in_.faces[body.first_face + fans.source[f]];
      const bool behind = two_sided && side_of_eye(in_.planes[face.plane], face.flipped, eye_) < 0;
      for (Index i = p.first_index(p.first_loop(f)); i < p.loop_ends[p.face_ends[f] - 1]; ++i)
        p.corner_normals[i] = turned_to_light(p.corner_normals[i], *in_.light, behind);
    }
  }

  CanonicalFace face_like(const CanonicalBody& body, Index source) {
    if (!is_cap(source)) return in_.faces[body.first_face + source];
    if (cap_plane_ == kNone) {
      cap_plane_ = static_cast<Index>(out_.planes.size());
      out_.planes.push_back(keep_);
    }
    return {0, 0, cap_plane_, 0, source == kCap, true};
  }

  void add_edges(const CanonicalBody& body, const CutPolyhedron& cut,
                 const std::vector<std::uint64_t>& ribs, CanonicalBody& result) {
    std::unordered_set<std::uint64_t> smooth(ribs.begin(), ribs.end());
    for (Index e = body.first_edge; e < body.end_edge; ++e)
      if (!in_.edges[e].crease)
        smooth.insert(
            edge_key(in_.edges[e].from - body.first_vertex, in_.edges[e].to - body.first_vertex));
    const auto of_cap = [&](Index face) { return is_cap(cut.face_source[face]); };
    const std::vector<EdgePair> pairs = pair_edges(cut.polyhedron);
    result.first_twin = static_cast<Index>(out_.twins.size());
    for (const Twin& twin : twins_of(cut.polyhedron, pairs)) out_.twins.push_back(twin);
    for (const EdgePair& e : pairs) {
      const bool border = e.right == kNoFace;
      if (border) result.closed = false;
      const bool crease = border || of_cap(e.left) || of_cap(e.right) ||
                          smooth.count(source_edge(cut.origin[e.from], cut.origin[e.to])) == 0;
      out_.edges.push_back({result.first_vertex + e.from, result.first_vertex + e.to,
                            result.first_face + e.left,
                            border ? kNone : result.first_face + e.right, crease});
    }
  }

  void add_lines(const std::vector<Index>& number) {
    for (const CanonicalPattern& pattern : in_.patterns) {
      if (number[pattern.body] == kNone) continue;
      for (std::vector<Vec3>& piece : cut_polyline(pattern.points, keep_))
        out_.patterns.push_back({std::move(piece), number[pattern.body], pattern.pen});
    }
    for (const Segment& segment : in_.segments)
      for (const std::vector<Vec3>& piece : cut_polyline({segment.from, segment.to}, keep_))
        if (piece.size() == 2) out_.segments.push_back({piece[0], piece[1], segment.pen});
  }

  const Canonical& in_;
  const Plane keep_;
  const Vec4 eye_;
  Index cap_plane_ = kNone;
  std::vector<double> heights_;  ///< of the present body's vertices
  Canonical out_;
};

/// Whether a body has vertices that count as beyond the plane. As a rule they all lie far from it,
/// and that tells.
bool needs_cut(const Canonical& c, const Plane& keep) {
  double lowest = HUGE_VAL, reach = 0;
  for (const Vec3& p : c.vertices) {
    lowest = std::min(lowest, height(keep, p));
    reach = std::max({reach, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
  }
  if (lowest > clip_rounding(keep, 3 * reach)) return false;
  std::vector<double> heights;
  return std::any_of(c.bodies.begin(), c.bodies.end(), [&](const CanonicalBody& body) {
    clip_heights(c, body, keep, heights);
    return std::any_of(heights.begin(), heights.end(), [](double h) { return h < 0; });
  });
}

}  // namespace

bool needs_clip(const Canonical& canonical, const Plane& keep) {
  const auto beyond = [&](const Vec3& p) { return height(keep, p) < 0; };
  const auto any = [&](const std::vector<Vec3>& points) {
    return std::any_of(points.begin(), points.end(), beyond);
  };
  if (needs_cut(canonical, keep)) return true;
  for (const CanonicalPattern& pattern : canonical.patterns)
    if (any(pattern.points)) return true;
  return std::any_of(canonical.segments.begin(), canonical.segments.end(),
                     [&](const Segment& s) { return beyond(s.from) || beyond(s.to); });
}

Canonical clip(const Canonical& canonical, const Plane& keep, const Vec4& eye) {
  Canonical clipped = Clipper(canonical, keep, eye).clip();
  note_bodies_on_planes(clipped);
  return clipped;
}

}  // namespace overstrike
