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
  return result;
}

}  // namespace overstrike::openscad
