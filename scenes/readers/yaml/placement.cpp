#include "scenes/readers/yaml/placement.h"

#include <cmath>

#include "core/geometry/trig.h"

namespace overstrike::yaml {
namespace {

constexpr std::string_view kAxes[] = {"x", "y", "z"};

Affine move(const Vec3& by) { return {Mat3(1.0), by}; }

Affine scaling(const Vec3& by) {
  Mat3 m(1.0);
  for (int i = 0; i < 3; ++i) m[i][i] = by[i];
  return {m, Vec3(0)};
}

/// Counter-clockwise about a coordinate axis, seen from its end. Multiples of 90 degrees are exact.
Mat3 rotation(int axis, double degrees) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const double c = cos_deg(degrees), s = sin_deg(degrees);
  Mat3 m(1.0);
  m[u][u] = c, m[u][v] = s;
  m[v][u] = -s, m[v][v] = c;
  return m;
}

/// About any axis (Rodrigues); a coordinate axis keeps its exactness.
Mat3 rotation(const Vec3& axis, double degrees) {
  for (int i = 0; i < 3; ++i)
    if (axis[(i + 1) % 3] == 0 && axis[(i + 2) % 3] == 0)
      return rotation(i, axis[i] < 0 ? -degrees : degrees);
  const double largest = std::fmax(std::fmax(std::fabs(axis.x), std::fabs(axis.y)),
                                   std::fabs(axis.z));  // first, so that squares don't underflow
  const Vec3 a = glm::normalize(axis / largest);
  const double c = cos_deg(degrees), s = sin_deg(degrees);
  Mat3 m = glm::outerProduct(a, a) * (1 - c);
  for (int i = 0; i < 3; ++i) m[i][i] += c;
  m[0][1] += s * a.z, m[1][0] -= s * a.z;
  m[1][2] += s * a.x, m[2][1] -= s * a.x;
  m[2][0] += s * a.y, m[0][2] -= s * a.y;
  return m;
}

/// x, y or z, or a direction [x, y, z] that is not zero.
Vec3 axis_of(Reporter& reporter, const Node& node, std::string_view label) {
  if (node.kind == NodeKind::list) {
    const Vec3 axis = vec3(reporter, node, label);
    if (axis != Vec3(0)) return axis;
    reporter.error(node.mark, std::string(label) + " must not be [0, 0, 0]");
    return {0, 0, 1};
  }
  for (int i = 0; i < 3; ++i)
    if (is_word(node, kAxes[i])) return Mat3(1.0)[i];
  reporter.error(
      node.mark,
      std::string(label) + " must be x, y, z or a direction [x, y, z], found " + describe(node));
  return {0, 0, 1};
}

Affine read_scale(Reporter& reporter, const Node& node) {
  constexpr Range kFactor{1 / kLargest, kLargest, false, "must be positive"};
  const std::size_t errors_before = reporter.errors();
  const Vec3 by = node.kind == NodeKind::list ? vec3(reporter, node, "scale", kFactor)
                                              : Vec3(number(reporter, node, "scale", kFactor));
  return reporter.errors() == errors_before ? scaling(by) : Affine{};
}

/// The reflection in the plane through the origin across `axis` (Householder).
Affine read_mirror(Reporter& reporter, const Node& node) {
  Vec3 n = axis_of(reporter, node, "mirror");
  n /= std::fmax(std::fmax(std::fabs(n.x), std::fabs(n.y)), std::fabs(n.z));
  Mat3 m = glm::outerProduct(n, n) * (-2 / glm::dot(n, n));
  for (int i = 0; i < 3; ++i) m[i][i] += 1;
  return {m, Vec3(0)};
}

/// [x, y, z] degrees, about z alone, or {axis, angle}.
Affine read_rotate(Reporter& reporter, const Node& node) {
  if (node.kind == NodeKind::scalar)
    return {rotation(2, number(reporter, node, "rotate")), Vec3(0)};
  if (node.kind == NodeKind::list) {
    const Vec3 a = vec3(reporter, node, "rotate");
    return {rotation(2, a.z) * rotation(1, a.y) * rotation(0, a.x), Vec3(0)};
  }
  const Fields f(reporter, node, kRotateMap);
  const Node* axis = f.need("axis");
  const double angle = f.number("angle");
  return {rotation(axis ? axis_of(reporter, *axis, "axis") : Vec3(0, 0, 1), angle), Vec3(0)};
}

Affine read_step(Reporter& reporter, std::string_view key, const Node& value) {
  if (key == "scale") return read_scale(reporter, value);
  if (key == "mirror") return read_mirror(reporter, value);
  if (key == "rotate") return read_rotate(reporter, value);
  return move(vec3(reporter, value, "at"));
}

Affine read_steps(Reporter& reporter, const Node& steps) {
  Affine placement;
  for (const Node* step : list(reporter, steps, "transform", "steps")) {
    const Fields f(reporter, *step, kTransformMap);
    if (step->kind != NodeKind::map) continue;
    if (step->entries() != 1)
      reporter.error(step->mark, "a step of transform must have one key, found " +
                                     std::to_string(step->entries()));
    for (const std::string_view key : kTransformMap.keys)
      if (const Node* value = f.find(key)) placement = read_step(reporter, key, *value) * placement;
  }
  return placement;
}

int read_count(const Fields& f) {
  const Node* count = f.need("count");
  return count ? whole_number(f.reporter(), *count, "count", 1, static_cast<int>(kMostCopies)) : 1;
}

Array read_linear(const Fields& f) {
  Array array;
  array.count = read_count(f);
  if (const Node* step = f.need("step")) array.step = vec3(f.reporter(), *step, "step");
  return array;
}

Array read_polar(const Fields& f) {
  Array array;
  array.polar = true;
  array.count = read_count(f);
  array.all_round = !f.has("step");
  array.degrees = f.number_or("step", 360);
  if (const Node* axis = f.find("axis")) array.axis = axis_of(f.reporter(), *axis, "axis");
  array.center = f.vec3_or("center", Vec3(0));
  return array;
}

Array read_array(Reporter& reporter, const Node& node) {
  const Fields f(reporter, node, kArrayMap);
  const Node* row = f.find("linear");
  const Node* ring = f.find("polar");
  if (node.kind == NodeKind::map && (row != nullptr) == (ring != nullptr))
    reporter.error(node.mark, "array must be either linear or polar",
                   "a list of arrays nests them");
  if (row) return read_linear(Fields(reporter, *row, kLinearMap));
  if (ring) return read_polar(Fields(reporter, *ring, kPolarMap));
  return {};
}

}  // namespace

Affine read_placement(const Fields& body) {
  Affine placement;
  const Node* steps = body.find("transform");
  for (const std::string_view key : kTransformMap.keys) {
    const Node* value = body.find(key);
    if (!value) continue;
    if (steps)
      body.reporter().error(value->mark, in_quotes(key) + " beside 'transform'",
                            "make it a step of transform");
    placement = read_step(body.reporter(), key, *value) * placement;
  }
  return steps ? read_steps(body.reporter(), *steps) : placement;
}

Affine Array::place(int copy) const {
  if (!polar) return move(step * static_cast<double>(copy));
  const double turned = all_round ? degrees * copy / count : degrees * copy;
  return move(center) * Affine{rotation(axis, turned), Vec3(0)} * move(-center);
}

std::vector<Array> read_arrays(const Fields& body) {
  std::vector<Array> arrays;
  const Node* said = body.find("array");
  if (!said) return arrays;
  if (said->kind != NodeKind::list) return {read_array(body.reporter(), *said)};
  for (const Node* one : said->items) arrays.push_back(read_array(body.reporter(), *one));
  return arrays;
}

}  // namespace overstrike::yaml
