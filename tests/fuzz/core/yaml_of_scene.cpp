// The tiny scenes' own kinds only.
#include <fmt/core.h>
#include <fmt/ranges.h>

#include <variant>

#include "tests/fuzz/core/tiny_scene.h"

namespace overstrike::fuzz {
namespace {

std::string text(const Vec3& p) { return fmt::format("[{}, {}, {}]", p.x, p.y, p.z); }

std::string text(const std::vector<Vec3>& points) {
  std::vector<std::string> parts;
  for (const Vec3& p : points) parts.push_back(text(p));
  return fmt::format("[{}]", fmt::join(parts, ", "));
}

std::string text(const Direction& d) {
  return fmt::format("{{azimuth: {}, elevation: {}}}", d.azimuth_deg, d.elevation_deg);
}

struct ShapeText {
  std::string operator()(const Box& s) const { return "box: " + text(s.size); }
  std::string operator()(const Frustum& s) const {
    return fmt::format("frustum: {{bottom: {}, top: {}, height: {}, sides: {}}}", s.bottom_radius,
                       s.top_radius, s.height, s.sides);
  }
  std::string operator()(const Wedge& s) const {
    return fmt::format("wedge: {{size: {}, top: {}}}", text(s.size), s.top);
  }
  std::string operator()(const Tetrahedron& s) const {
    return "tetrahedron: " + text({std::begin(s.vertices), std::end(s.vertices)});
  }
  std::string operator()(const Mesh& s) const {
    const Polyhedron& p = s.polyhedron;
    std::vector<std::string> faces;
    for (Index l = 0; l < p.loop_ends.size(); ++l)
      faces.push_back(fmt::format("[{}]", fmt::join(p.loop(l), ", ")));
    return fmt::format("polyhedron: {{vertices: {}, faces: [{}]}}", text(p.vertices),
                       fmt::join(faces, ", "));
  }
  std::string operator()(const FlatPolygon& s) const {
    std::vector<std::string> holes;
    for (std::size_t i = 1; i < s.loops.size(); ++i) holes.push_back(text(s.loops[i]));
    return fmt::format("polygon: {{outline: {}, holes: [{}]}}", text(s.loops[0]),
                       fmt::join(holes, ", "));
  }
  template <class Other>
  std::string operator()(const Other&) const {
    return "";
  }
};

/// What follows the dash and what `margin` spaces stand before.
std::string text(const Body& b, std::size_t margin) {
  const Mat3& m = b.placement.linear;
  const bool mirrored = glm::determinant(m) < 0;
  const double turn = std::atan2(-m[1].x, m[1].y) * (180 / 3.14159265358979323846);
  const std::string space(margin, ' ');
  return fmt::format("{}\n{}{}rotate: {:.0f}\n{}at: {}\n{}density: {}\n{}shading: {}\n",
                     std::visit(ShapeText{}, *b.shape), mirrored ? space + "mirror: x\n" : "",
                     space, turn, space, text(b.placement.offset), space, b.density_factor, space,
                     b.shading == Shading::smooth ? "smooth" : "flat");
}

/// The node at `at`, as an entry of a list that stands `margin` spaces from the left.
std::string entry(const Scene& scene, const Solid& solid, std::uint32_t at, std::size_t margin) {
  constexpr const char* kNames[] = {"", "union", "difference", "intersection"};
  const SolidNode& node = solid.nodes[at];
  const std::string dash = std::string(margin, ' ') + "- ";
  if (node.operation == SetOperation::operand)
    return dash + text(scene.bodies[node.body], margin + 2);
  std::string made = dash + kNames[static_cast<int>(node.operation)] + ":\n";
  for (std::uint32_t i = at + 1; i < node.end; i = solid.nodes[i].end)
    made += entry(scene, solid, i, margin + 4);
  return made;
}

std::string text(const Camera& c) {
  std::string made = c.eye ? "  eye: " + text(*c.eye) + "\n" : "";
  if (c.target) made += "  target: " + text(*c.target) + "\n";
  if (!c.eye)
    made +=
        fmt::format("  azimuth: {}\n  elevation: {}\n", c.from.azimuth_deg, c.from.elevation_deg);
  if (c.look_at && !c.eye) made += "  look-at: " + text(*c.look_at) + "\n";
  made += fmt::format("  projection: {}\n", c.parallel ? "parallel" : "perspective");
  if (c.window_width) made += fmt::format("  window: {}\n", *c.window_width);
  if (c.near_distance) made += fmt::format("  near: {}\n", *c.near_distance);
  return made;
}

}  // namespace

std::string to_yaml(const Scene& scene) {
  std::string made = "camera:\n" + text(scene.camera);
  if (scene.light) made += "light: " + text(*scene.light) + "\n";
  if (scene.ground_z) made += fmt::format("ground: {}\n", *scene.ground_z);
  made += fmt::format("density: {{k: {}, hmax: {}}}\nbodies:\n", scene.law.k, scene.law.hmax);
  std::vector<bool> alone(scene.bodies.size(), true);
  for (const Solid& solid : scene.solids) {
    made += entry(scene, solid, 0, 2);
    for (const SolidNode& node : solid.nodes)
      if (node.operation == SetOperation::operand) alone[node.body] = false;
  }
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if (alone[i]) made += "  - " + text(scene.bodies[i], 4);
  return made;
}

}  // namespace overstrike::fuzz
