#include "scenes/readers/yaml/scene.h"

#include <fmt/format.h>

#include <utility>

#include "scenes/readers/yaml/parts.h"

namespace overstrike::yaml {
namespace {

constexpr Range kElevation{-90, 90, false, {}};
constexpr std::string_view kProjections[] = {"perspective", "parallel"};
constexpr std::string_view kOrbitKeys[] = {"look-at", "distance", "azimuth", "elevation"};

std::optional<Direction> read_light(Reporter& reporter, const Node& node) {
  if (is_word(node, "none")) return {};
  if (node.kind != NodeKind::map) {
    reporter.error(node.mark,
                   "light must be none or a map {azimuth, elevation}, found " + describe(node));
    return {};
  }
  const Fields f(reporter, node, kLightMap);
  return Direction{f.number("azimuth"), f.number("elevation", kElevation)};
}

std::optional<double> read_ground(Reporter& reporter, const Node& node) {
  if (is_word(node, "none")) return {};
  constexpr std::string_view kStarts = "+-.0123456789";
  if (node.kind == NodeKind::scalar && kStarts.find(node.text[0]) != std::string_view::npos)
    return number(reporter, node, "ground");
  reporter.error(node.mark, "ground must be a height or none, found " + describe(node));
  return {};
}

DensityLaw read_density(Reporter& reporter, const Node& node) {
  const Fields f(reporter, node, kDensityMap);
  const DensityLaw law;
  return {f.number_or("k", law.k, kZeroToOne), f.number_or("hmax", law.hmax, kZeroToOne),
          f.number_or("ground-shadow", law.ground_shadow_factor, kZeroToOne),
          f.number_or("cut", law.cut_factor, kZeroToOne)};
}

/// Eye, target and up; the keys of the other form don't go with them, nor these with the other.
void read_eye(Camera& camera, const Fields& f) {
  Reporter& reporter = f.reporter();
  const Node* eye = f.find("eye");
  if (!eye) {
    for (const std::string_view key : {"target", "up"})
      if (f.has(key))
        reporter.error(f.mark(key), in_quotes(key) + " goes with 'eye'",
                       key == "target" ? "did you mean 'look-at'?" : "");
    return;
  }
  for (const std::string_view key : kOrbitKeys)
    if (f.has(key))
      reporter.error(f.mark(key), in_quotes(key) + " beside 'eye'",
                     "give eye, target and up, or look-at, distance, azimuth and elevation");
  camera.eye = vec3(reporter, *eye, "eye");
  if (f.has("target")) camera.target = f.vec3_or("target", Vec3(0));
  camera.up = f.vec3_or("up", camera.up);
  if (camera.target && *camera.target == *camera.eye)
    reporter.error(f.mark("target"), "eye and target must not be the same point");
  else if (camera.up == Vec3(0))
    reporter.error(f.mark("up"), "up must not be [0, 0, 0]");
  else if (camera.target && glm::cross(*camera.target - *camera.eye, camera.up) == Vec3(0))
    reporter.error(f.mark("up"), "up must not point along the line of sight",
                   f.has("up") ? "" : "give another 'up' than [0, 0, 1]");
}

void read_window(Camera& camera, const Fields& f) {
  const Node* window = f.find("window");
  const Node* fov = f.find("fov");
  if (window && !is_word(*window, "fit"))
    camera.window_width = number(f.reporter(), *window, "window", kPositive);
  if (fov) camera.fov_deg = number(f.reporter(), *fov, "fov", {0, 180, true, {}});
  if (window && fov)
    f.reporter().error(fov->mark, "'fov' beside 'window'", "either says how much is seen");
  if (fov && camera.parallel)
    f.reporter().error(fov->mark, "a parallel view has no 'fov'", "give 'window', its width");
}

Camera read_camera(Reporter& reporter, const Node& node) {
  const Fields f(reporter, node, kCameraMap);
  Camera camera;
  if (const Node* projection = f.find("projection"))
    camera.parallel = choice(reporter, *projection, "projection", kProjections) == 1;
  read_eye(camera, f);
  if (f.has("look-at")) camera.look_at = f.vec3_or("look-at", Vec3(0));
  if (f.has("distance")) camera.distance = f.number("distance", kPositive);
  camera.from.azimuth_deg = f.number_or("azimuth", camera.from.azimuth_deg);
  camera.from.elevation_deg = f.number_or("elevation", camera.from.elevation_deg, kElevation);
  read_window(camera, f);
  if (f.has("near")) camera.near_distance = f.number("near", kPositive);
  return camera;
}

/// {from, to, pen} or a polyline {points, closed, pen}.
void read_segment(std::vector<Segment>& segments, Reporter& reporter, const Node& node) {
  const Fields f(reporter, node, kSegmentMap);
  if (node.kind != NodeKind::map) return;
  if (f.has("points")) {
    for (const std::string_view key : {"from", "to"})
      if (f.has(key)) reporter.error(f.mark(key), in_quotes(key) + " beside 'points'");
    const Pattern line = read_polyline(f);
    for (std::size_t i = 1; i < line.points.size(); ++i)
      segments.push_back({line.points[i - 1], line.points[i], line.pen});
    return;
  }
  if (const Node* closed = f.find("closed"))
    reporter.error(closed->mark, "'closed' goes with 'points'");
  const Node* from = f.need("from");
  const Node* to = f.need("to");
  if (!from || !to) return;
  segments.push_back({vec3(reporter, *from, "from"), vec3(reporter, *to, "to"),
                      f.whole_number_or("pen", 0, 0, 99)});
}

Scene read_parts_of_scene(const Fields& f, MeshFiles& meshes) {
  Reporter& reporter = f.reporter();
  Scene scene;
  if (const Node* ground = f.find("ground")) scene.ground_z = read_ground(reporter, *ground);
  if (const Node* light = f.find("light")) scene.light = read_light(reporter, *light);
  if (const Node* camera = f.find("camera")) scene.camera = read_camera(reporter, *camera);
  if (const Node* density = f.find("density")) scene.law = read_density(reporter, *density);
  if (const Node* segments = f.find("segments"))
    for (const Node* one : list(reporter, *segments, "segments", "segments {from, to, pen}"))
      read_segment(scene.segments, reporter, *one);
  Definitions definitions;
  std::vector<Part> parts;
  if (const Node* define = f.find("define"))
    definitions = read_definitions(reporter, *define, meshes);
  if (const Node* bodies = f.find("bodies"))
    parts = read_parts(reporter, *bodies, "bodies", meshes);
  if (!f.has("bodies") && !f.has("segments") && reporter.errors() == 0)
    reporter.error(f.mark(), "a scene needs 'bodies' or 'segments'");
  Expanded expanded = expand(reporter, parts, definitions);
  scene.bodies = std::move(expanded.bodies);
  scene.solids = std::move(expanded.solids);
  return scene;
}

/// Binary files have no lines; a text in another encoding has, but its line cannot be shown.
void check_text(std::string_view text, const std::string& name) {
  const std::size_t odd = first_non_text(text);
  if (odd == std::string_view::npos) return;
  const std::size_t nul = text.find('\0');
  if (nul != std::string_view::npos)
    throw InputError(Place{name, 0, 0}, fmt::format("not a text file: byte {} is NUL", nul + 1));
  const TextMark mark = mark_at(text, odd);
  throw InputError(Place{name, mark.line, mark.column},
                   fmt::format("not UTF-8: byte 0x{:02X}", static_cast<unsigned char>(text[odd])),
                   "save the file as UTF-8");
}

}  // namespace

ReadResult read_scene(std::string_view text, const std::string& name,
                      const std::filesystem::path& folder) {
  text = without_bom(text);
  Reporter reporter(text, name);
  check_text(text, name);
  const Tree tree(text, reporter);
  reporter.throw_errors();
  if (!tree.root() || tree.root()->kind == NodeKind::nothing) {
    reporter.error({1, 1, 0}, "the file is empty; a scene needs 'bodies' or 'segments'");
    reporter.throw_errors();
  }
  MeshFiles meshes(folder);
  Scene scene = read_parts_of_scene(Fields(reporter, *tree.root(), kSceneMap), meshes);
  reporter.throw_errors();
  scene.source = name;
  return {std::move(scene), reporter.warnings()};
}

}  // namespace overstrike::yaml
