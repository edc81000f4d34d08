#include "scenes/readers/yaml/parts.h"

#include <algorithm>
#include <utility>

namespace overstrike::yaml {
namespace {

constexpr int kMostPens = 99;
constexpr std::string_view kShadings[] = {"flat", "smooth"};
constexpr std::pair<std::string_view, SetOperation> kOperations[] = {
    {"union", SetOperation::unite},
    {"difference", SetOperation::subtract},
    {"intersection", SetOperation::intersect}};

/// The one key that says what the body is, or empty after an error.
std::string_view content_key(const Fields& f, const Node& node) {
  std::string_view first;
  for (const std::string_view key : content_keys()) {
    if (!f.has(key)) continue;
    if (!first.empty()) {
      f.reporter().error(
          node.mark,
          "a body must be one thing, found " + in_quotes(first) + " and '" + std::string(key) + "'",
          "a group holds several");
      return {};
    }
    first = key;
  }
  const Keys contents = content_keys();
  if (first.empty() && node.kind == NodeKind::map &&
      std::none_of(contents.begin(), contents.end(), [&](auto key) { return f.suggested(key); }))
    f.reporter().error(
        node.mark, "a body must say what it is",
        "box, cylinder, sphere, ... or union, difference, intersection, group or use");
  return first;
}

void read_content(Part& part, const Fields& f, std::string_view key, MeshFiles& meshes) {
  const Node& value = *f.find(key);
  for (const auto& [name, operation] : kOperations)
    if (key == name) {
      part.content = Combination{operation, read_parts(f.reporter(), value, key, meshes), 0};
      return;
    }
  if (key == "group") {
    part.content = read_parts(f.reporter(), value, "group", meshes);
  } else if (key == "use") {
    part.content = Use{word(f.reporter(), value, "use"), value.mark};
  } else {
    std::vector<ShapePtr> shapes = read_shapes(f.reporter(), key, value, meshes);
    if (shapes.size() == 1) {
      part.content = std::move(shapes.front());
      return;
    }
    std::vector<Part> pieces(shapes.size());
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      pieces[i].content = std::move(shapes[i]);
      pieces[i].mark = part.mark;
    }
    part.content = std::move(pieces);
  }
}

void read_patterns(Part& part, const Fields& f, std::string_view content) {
  const Node* patterns = f.find("patterns");
  if (!patterns) return;
  if (!is_shape(content))
    f.reporter().error(patterns->mark,
                       "patterns are drawn on one shape, not on a " + in_quotes(content),
                       "give them to a body inside");
  for (const Node* one : list(f.reporter(), *patterns, "patterns", "patterns {points, pen}"))
    part.patterns.push_back(read_polyline(Fields(f.reporter(), *one, kPatternMap)));
}

void read_translucent(Part& part, const Fields& f, std::string_view content) {
  const Node* translucent = f.find("translucent");
  if (!translucent) return;
  const double factor = f.number_or("translucent", 0, kZeroToOne);
  if (auto* combination = std::get_if<Combination>(&part.content)) {
    combination->translucent = factor;
  } else {
    f.reporter().error(
        translucent->mark,
        "translucent shows what was cut away of a solid, not of a " + in_quotes(content),
        "give it to a difference");
  }
}

void read_looks(Part& part, const Fields& f) {
  if (const Node* name = f.find("name")) part.name = word(f.reporter(), *name, "name");
  part.density = f.number_or("density", 1, kNotNegative);
  if (const Node* shading = f.find("shading"))
    part.shading = static_cast<Shading>(choice(f.reporter(), *shading, "shading", kShadings));
  if (const Node* pen = f.find("pen"))
    part.pen = whole_number(f.reporter(), *pen, "pen", 0, kMostPens);
}

/// A list stands for a group.
Part read_definition(Reporter& reporter, const Node& value, MeshFiles& meshes) {
  if (value.kind != NodeKind::list) return read_part(reporter, value, meshes);
  Part part;
  part.mark = value.mark;
  part.content = read_parts(reporter, value, "group", meshes);
  return part;
}

}  // namespace

Part read_part(Reporter& reporter, const Node& node, MeshFiles& meshes) {
  const Fields f(reporter, node, kBodyMap);
  Part part;
  part.mark = node.mark;
  const std::string_view key = content_key(f, node);
  if (!key.empty()) {
    read_content(part, f, key, meshes);
    read_patterns(part, f, key);
    read_translucent(part, f, key);
    // Of a sheet in several pieces the first one has them.
    if (auto* pieces = std::get_if<std::vector<Part>>(&part.content); pieces && is_shape(key))
      pieces->front().patterns = std::move(part.patterns);
  }
  read_looks(part, f);
  part.placement = read_placement(f);
  part.arrays = read_arrays(f);
  return part;
}

std::vector<Part> read_parts(Reporter& reporter, const Node& node, std::string_view label,
                             MeshFiles& meshes) {
  std::vector<Part> parts;
  for (const Node* item : list(reporter, node, label, "bodies"))
    parts.push_back(read_part(reporter, *item, meshes));
  return parts;
}

Definitions read_definitions(Reporter& reporter, const Node& node, MeshFiles& meshes) {
  Definitions definitions;
  if (node.kind != NodeKind::map) {
    reporter.error(node.mark, "define must be a map of names and bodies, found " + describe(node));
    return definitions;
  }
  for (std::size_t i = 0; i < node.entries(); ++i) {
    const Node& key = node.key(i);
    const std::string name = word(reporter, key, "a definition's name");
    Part part = read_definition(reporter, node.value(i), meshes);
    const auto [at, fresh] = definitions.try_emplace(name, Definition{std::move(part), key.mark});
    if (!fresh && !name.empty())
      reporter.error(key.mark, in_quotes(name) + " is defined twice; first in line " +
                                   std::to_string(at->second.mark.line));
  }
  return definitions;
}

Pattern read_polyline(const Fields& f) {
  Pattern line;
  const bool closed = f.boolean_or("closed", false);
  if (const Node* points = f.need("points"))
    line.points = points3(f.reporter(), *points, "points", closed ? 3 : 2);
  if (closed && !line.points.empty()) line.points.push_back(line.points.front());
  line.pen = f.whole_number_or("pen", 0, 0, kMostPens);
  return line;
}

}  // namespace overstrike::yaml
