#include "core/visibility/nn74/conditions.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/visibility/nn74/pairs.h"
#include "core/visibility/nn74/separation.h"
#include "core/visibility/placed_shapes.h"

namespace overstrike::nn74 {
namespace {

constexpr const char* kHint = "method line draws it";

double reach_of(const Canonical& c, const CanonicalBody& body) {
  double reach = 0;
  for (Index v = body.first_vertex; v < body.end_vertex; ++v) {
    const Vec3 size = glm::abs(c.vertices[v]);
    reach = std::max({reach, size.x, size.y, size.z});
  }
  return reach;
}

/// No corner lies right of an edge, seen from the normal's side.
bool is_convex_loop(const Canonical& c, const CanonicalFace& face, double touch) {
  const std::span<const Index> loop = c.loop(face.first_loop);
  const Vec3 normal = c.outward(face);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3 from = c.vertices[loop[i]];
    const Vec3 along = c.vertices[loop[i + 1 == loop.size() ? 0 : i + 1]] - from;
    const Vec3 inwards = glm::cross(normal, along);
    const double least = -touch * std::sqrt(glm::dot(along, along));
    for (const Index v : loop)
      if (glm::dot(inwards, c.vertices[v] - from) < least) return false;
  }
  return true;
}

/// All of the body lies on the face's plane or behind it; vertices of faces with its plane identity
/// are on it.
bool has_body_behind(const Canonical& c, const CanonicalBody& body, Index f, double touch) {
  const CanonicalFace& face = c.faces[f];
  const Plane& plane = c.planes[face.plane];
  const double side = face.flipped ? -1 : 1;
  for (Index v = body.first_vertex; v < body.end_vertex; ++v)
    if (side * (glm::dot(plane.normal, c.vertices[v]) - plane.offset) > touch &&
        !has_face_in(c, body, face.plane, v))
      return false;
  return true;
}

/// Nothing of it lies behind any of its faces: a surface that is folded onto itself.
bool is_flat(const Canonical& c, const CanonicalBody& body) {
  const Index plane = c.faces[body.first_face].plane;
  return std::all_of(c.faces.begin() + body.first_face, c.faces.begin() + body.end_face,
                     [&](const CanonicalFace& f) { return f.plane == plane; });
}

/// What keeps a body from being drawn, or nothing.
std::string fault_of(const Canonical& c, const CanonicalBody& body) {
  const double touch = kTouch * reach_of(c, body);
  const Index faces = body.end_face - body.first_face;
  if (!body.closed && faces != 1) return "is neither closed nor one flat polygon";
  if (body.closed && faces > 0 && is_flat(c, body)) return "is closed but has no inside";
  for (Index f = body.first_face; f < body.end_face; ++f) {
    const CanonicalFace& face = c.faces[f];
    if (face.end_loop - face.first_loop != 1)
      return body.closed ? "is not convex: a face has a hole" : "is not convex: it has a hole";
    if (!is_convex_loop(c, face, touch))
      return body.closed ? "is not convex: a face is not" : "is not convex";
    if (body.closed && !has_body_behind(c, body, f, touch)) return "is not convex";
  }
  if (body.smooth) return "is smooth; nn74 draws flat shading only";
  return {};
}

/// By more than it may where it stands on the ground; or with all of it, by whatever: then the
/// ground hides it.
bool reaches_below(const Canonical& c, const CanonicalBody& body, double ground) {
  const double touch = kTouch * std::max(reach_of(c, body), std::fabs(ground));
  double lowest = HUGE_VAL, highest = -HUGE_VAL;
  for (Index v = body.first_vertex; v < body.end_vertex; ++v)
    lowest = std::min(lowest, c.vertices[v].z), highest = std::max(highest, c.vertices[v].z);
  return lowest < ground - touch || (lowest <= highest && highest < ground);
}

/// Copies of one body have one place in the scene, and one fault.
bool is_copy(const Diagnostic& last, const Place& place, const std::string& message) {
  return place.line > 0 && last.place.file == place.file && last.place.line == place.line &&
         last.place.column == place.column && last.message == message;
}

void check_bodies(const Scene& scene, const Canonical& c, const View& view) {
  std::vector<Diagnostic> errors;
  const bool sees_ground = c.ground_z && view.eye.z - *c.ground_z * view.eye.w > 0;
  for (const CanonicalBody& body : c.bodies) {
    std::string fault = fault_of(c, body);
    if (fault.empty() && sees_ground && reaches_below(c, body, *c.ground_z))
      fault = "reaches below the ground";
    if (fault.empty()) continue;
    const Body& source = scene.bodies[body.source];
    const std::string message = "method nn74: " + name_of(source) + ' ' + fault;
    if (!errors.empty() && is_copy(errors.back(), source.place, message)) continue;
    errors.push_back({Severity::error, source.place, message, kHint, {}});
  }
  if (!errors.empty()) throw InputError(std::move(errors));
}

void check_pairs(const Scene& scene, const Canonical& c) {
  std::vector<Bounds> boxes;
  std::vector<Extent> across;
  for (const CanonicalBody& body : c.bodies) {
    boxes.push_back(bounds_of(c, body));
    across.push_back({Vec2(boxes.back().low), Vec2(boxes.back().high)});
  }
  for (const auto& [i, j] : overlapping_boxes(across)) {
    if (!(boxes[i].low.z < boxes[j].high.z && boxes[j].low.z < boxes[i].high.z)) continue;
    if (separate(c, c.bodies[i], c, c.bodies[j])) continue;
    const Body& a = scene.bodies[c.bodies[i].source];
    const Body& b = scene.bodies[c.bodies[j].source];
    throw InputError(a.place,
                     "method nn74: " + name_of(a) + " and " + name_of(b) + " interpenetrate",
                     "method line draws them");
  }
}

}  // namespace

void check_conditions(const Scene& scene, const Canonical& canonical, const View& view) {
  check_bodies(scene, canonical, view);
  check_pairs(scene, canonical);
}

}  // namespace overstrike::nn74
