#include "scenes/readers/openscad/leaf_shapes.h"

#include "core/geometry/region_sets.h"
#include "scenes/readers/mesh.h"
#include "scenes/readers/mesh_file.h"
#include "scenes/readers/openscad/dxf.h"
#include "scenes/readers/openscad/primitives.h"
#include "scenes/readers/openscad/regions.h"
#include "scenes/readers/openscad/surface.h"
#include "scenes/readers/openscad/text.h"

namespace overstrike::openscad {
namespace {

/// Larger drawings are refused as they are read.
void check_drawing(std::string_view, std::uint64_t, const std::string&) {}

}  // namespace

std::vector<Part> LeafShapes::solid(const Word& word, const Arguments& arguments) {
  switch (word.kind) {
    case WordKind::cube:
      return cube(arguments);
    case WordKind::sphere:
      return sphere(arguments);
    case WordKind::cylinder:
      return cylinder(arguments);
    case WordKind::polyhedron:
      return polyhedron(arguments);
    default:
      break;
  }
  const std::optional<std::filesystem::path> path = file_of(word, arguments);
  if (!path) return {};
  std::vector<Part> parts;
  try {
    if (word.kind == WordKind::surface) return surface(arguments, *path);
    parts = {imported_mesh(*path)};
  } catch (const InputError& error) {
    refuse(word, arguments, error);
  }
  return parts;
}

std::optional<std::filesystem::path> LeafShapes::file_of(const Word& word,
                                                         const Arguments& arguments) {
  const std::string name = arguments.text("file", "");
  if (!name.empty()) return folder_ / name;
  arguments.error(in_quotes(word.name) + " names no file", "file = \"...\"");
  return {};
}

void LeafShapes::refuse(const Word& word, const Arguments& arguments, const InputError& error) {
  for (const Diagnostic& d : error.diagnostics()) {
    if (d.severity != Severity::error) {
      reporter_.append({d});
      continue;
    }
    std::string place = d.place.file;
    if (d.place.line > 0) place += ':' + std::to_string(d.place.line);
    if (d.place.line > 0 && d.place.column > 0) place += ':' + std::to_string(d.place.column);
    arguments.error(in_quotes(word.name) + " cannot be drawn: " + place + ": " + d.message, d.hint);
  }
}

Part LeafShapes::imported_mesh(const std::filesystem::path& path) {
  const auto [known, is_new] = meshes_.try_emplace(path.string());
  if (is_new) {
    std::vector<Diagnostic> warnings;
    known->second = std::make_shared<const Shape>(read_mesh(path, warnings));
    reporter_.append(warnings);
  }
  if (known->second == nullptr) throw InputError(Place{path.string(), 0, 0}, "cannot be read");
  return {known->second, {}, 0};
}

Region LeafShapes::imported_region(const Word& word, const Arguments& arguments) {
  const std::filesystem::path path = folder_ / arguments.text("file", "");
  if (path.extension() != ".dxf" && path.extension() != ".DXF") {
    arguments.error("'import' of " + path.extension().string() + " cannot be drawn",
                    "flat drawings are read as DXF");
    return {};
  }
  const Vec3 origin = arguments.sizes("origin", 2, 0);
  try {
    const std::string text = read_mesh_file(path, check_drawing);
    return read_dxf(text, path.string(),
                    {arguments.text("layer", ""), Vec2(origin), arguments.number("scale", 1)},
                    arguments);
  } catch (const InputError& error) {
    refuse(word, arguments, error);
    return {};
  }
}

Flat LeafShapes::flat(const NodeState& state, const Arguments& arguments) {
  std::vector<Region> regions(1);
  double precision = 0;
  const auto take = [&](Flat flat) {
    regions[0] = std::move(flat.region);
    precision = flat.precision;
  };
  switch (state.word->kind) {
    case WordKind::square:
      take(square(arguments));
      break;
    case WordKind::circle:
      take(circle(arguments));
      break;
    case WordKind::polygon:
      take(polygon(arguments));
      break;
    case WordKind::text:
      regions = text_outlines(arguments);
      break;
    case WordKind::import:
      regions[0] = imported_region(*state.word, arguments);
      break;
    default:
      break;
  }
  const Affine& place = state.place.affine;
  for (Region& region : regions) region = placed(region, place);
  return {combine(SetOperation::unite, regions), precision};
}

}  // namespace overstrike::openscad
