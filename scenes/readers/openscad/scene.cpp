#include "scenes/readers/openscad/scene.h"

#include "core/geometry/tessellate.h"
#include "scenes/readers/openscad/bodies.h"

namespace overstrike::openscad {
namespace {

/// From where OpenSCAD first looks at a model: it is turned by 55 degrees about x and 25 about z.
constexpr Direction kFirstLook{-65, 35};

void check_shapes(const Scene& scene) {
  for (const Body& body : scene.bodies) {
    const std::string fault = validate(*body.shape);
    if (!fault.empty()) throw InputError(body.place, fault);
  }
}

void append(const Scene& from, Scene& to) {
  const auto bodies = static_cast<Index>(to.bodies.size());
  to.bodies.insert(to.bodies.end(), from.bodies.begin(), from.bodies.end());
  for (Solid solid : from.solids) {
    for (SolidNode& node : solid.nodes)
      if (node.operation == SetOperation::operand) node.body += bodies;
    to.solids.push_back(std::move(solid));
  }
}

/// What is marked by % is no part of the model: where something of it cannot be drawn, the picture
/// goes without it, and says so.
void read_backgrounds(const Tree& tree, const Nodes& nodes, const std::filesystem::path& folder,
                      Reporter reporter, ReadResult& result) {
  if (nodes.backgrounds.empty()) return;
  try {
    const Nodes backgrounds = resolve_backgrounds(tree, nodes, reporter);
    ShapeBuilder builder(tree, backgrounds, folder, reporter);
    const std::vector<NodeShape> shapes = builder.build();
    reporter.throw_errors();
    Scene scene;
    add_backgrounds(tree, backgrounds, shapes, reporter, scene);
    check_shapes(scene);
    append(scene, result.scene);
    for (Diagnostic& warning : reporter.warnings()) result.warnings.push_back(std::move(warning));
  } catch (const InputError& error) {
    for (Diagnostic fault : error.diagnostics()) {
      if (fault.severity == Severity::error)
        fault.message = "the background (%) is left out: " + fault.message;
      fault.severity = Severity::warning;
      result.warnings.push_back(std::move(fault));
    }
  }
}

}  // namespace

ReadResult read_scene(std::string_view text, const std::string& name,
                      const std::filesystem::path& folder) {
  text = without_bom(text);
  Reporter reporter(text, name);
  if (const std::size_t bad = first_non_text(text); bad != std::string_view::npos)
    throw InputError(reporter.place(mark_at(text, bad)), "is not UTF-8 text");
  const Tree tree = parse(text, reporter);
  const Nodes nodes = resolve(tree, reporter);
  reporter.throw_errors();
  ShapeBuilder builder(tree, nodes, folder, reporter);
  const std::vector<NodeShape> shapes = builder.build();
  reporter.throw_errors();
  ReadResult result;
  result.scene.source = name;
  result.scene.camera.from = kFirstLook;
  result.scene.light_beside_eye = true;
  add_bodies(tree, nodes, shapes, reporter, result.scene);
  check_shapes(result.scene);
  result.warnings = reporter.warnings();
  read_backgrounds(tree, nodes, folder, Reporter(text, name), result);
  return result;
}

}  // namespace overstrike::openscad
