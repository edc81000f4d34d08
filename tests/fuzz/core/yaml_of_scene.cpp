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

std::string text(const Body& b) {
  const Mat3& m = b.placement.linear;
  const bool mirrored = glm::determinant(m) < 0;
  const double turn = std::atan2(-m[1].x, m[1].y) * (180 / 3.14159265358979323846);
  return fmt::format("  - {}\n{}    rotate: {:.0f}\n    at: {}\n    density: {}\n    shading: {}\n",
                     std::visit(ShapeText{}, *b.shape), mirrored ? "    mirror: x\n" : "", turn,
                     text(b.placement.offset), b.density_factor,
                     b.shading == Shading::smooth ? "smooth" : "flat");
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
  for (const Body& b : scene.bodies) made += text(b);
  return made;
}

}  // namespace overstrike::fuzz
