#include "core/visibility/placed_shapes.h"

#include <charconv>
#include <cmath>

#include "core/geometry/direction.h"
#include "core/geometry/tessellate.h"
#include "core/visibility/camera_frame.h"

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
double chord_of(const Shape& shape, const Affine& placement, const View& view, double chord_cells) {
  const Bounds box = bounds(shape, placement);
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
  const double chord = chord_cells * view.world_per_cell * w / stretch(placement.linear);
  return chord > 0 && chord < 1e300 ? quantised(chord) : 1;
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

}  // namespace

std::string name_of(const Body& body) {
  std::string name(shape_name(*body.shape));
  if (!body.name.empty()) name += " '" + body.name + "'";
  return name;
}

PlacedShapes::PlacedShapes(const Scene& scene, const View& view, double chord_cells,
                           std::vector<Diagnostic>& warnings)
    : scene_(scene), view_(view), chord_cells_(chord_cells), warnings_(warnings) {
  all_.reserve(scene.bodies.size());
  for (Index i = 0; i < scene.bodies.size(); ++i)
    if (scene.bodies[i].shape != nullptr) add(i);
}

Affine PlacedShapes::placement(const PlacedShape& placed) const {
  return placed.flattened ? Affine{} : from_origin(body(placed).placement, view_.origin);
}

void PlacedShapes::warn(const Body& body, const std::string& what) {
  warnings_.push_back({Severity::warning, body.place, name_of(body) + ": " + what, {}, {}});
}

double PlacedShapes::chord_of_shape(const Body& body, const Affine& placement) {
  if (!is_curved(*body.shape)) return 1;
  const double asked = chord_of(*body.shape, placement, view_, chord_cells_);
  const double chord = drawable_chord(*body.shape, asked);
  if (chord > asked)
    warn(body, "drawn to " + roughly(chord / asked * chord_cells_) + " cells instead of " +
                   roughly(chord_cells_) + ": finer would take too many facets");
  return chord;
}

const PreparedShape& PlacedShapes::prepared(const Body& body, const Affine& placement) {
  const double chord = chord_of_shape(body, placement);
  const bool smooth = body.shading == Shading::smooth;
  auto& slot = shapes_[{body.shape.get(), chord, smooth}];
  if (slot == nullptr)
    slot = std::make_unique<PreparedShape>(prepare_shape(*body.shape, chord, smooth));
  return *slot;
}

/// Faces may have lost their area, so that the repairs must see them in their place.
const PreparedShape& PlacedShapes::flattened(const PreparedShape& shape, const Affine& placement) {
  Mesh flat{shape.polyhedron, {}, {}, shape.precision};
  flat.polyhedron.corner_normals.clear();
  for (Vec3& p : flat.polyhedron.vertices) p = placement(p);
  flattened_.push_back(std::make_unique<PreparedShape>(prepare_shape(Shape(flat), 1, false)));
  return *flattened_.back();
}

void PlacedShapes::add(Index source) {
  const Body& body = scene_.bodies[source];
  const Affine placement = from_origin(body.placement, view_.origin);
  if (!finite(placement)) return warn(body, "its place is not finite: not drawn");
  const PreparedShape& shape = prepared(body, placement);
  for (const std::string& flaw : shape.flaws) warn(body, flaw);
  if (!is_flattened(placement.linear)) {
    all_.push_back({source, false, &shape});
    return;
  }
  if (!std::holds_alternative<FlatPolygon>(*body.shape)) warn(body, "flattened by its place");
  all_.push_back({source, true, &flattened(shape, placement)});
}

}  // namespace overstrike
