#include "scenes/readers/openscad/words.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace overstrike::openscad {
namespace {

constexpr std::string_view kMatrix[] = {"m"};
constexpr std::string_view kColor[] = {"c", "alpha"};
constexpr std::string_view kCube[] = {"size", "center"};
constexpr std::string_view kSphere[] = {"r"};
constexpr std::string_view kCylinder[] = {"h", "r1", "r2", "center"};
constexpr std::string_view kPolyhedron[] = {"points", "faces", "convexity", "triangles"};
constexpr std::string_view kPolygon[] = {"points", "paths", "convexity"};
constexpr std::string_view kText[] = {"text",    "size",      "font",     "halign", "valign",
                                      "spacing", "direction", "language", "script"};
constexpr std::string_view kLinear[] = {"height", "v",      "scale",    "center",
                                        "twist",  "slices", "segments", "convexity"};
constexpr std::string_view kRotate[] = {"angle", "start", "convexity"};
constexpr std::string_view kConvexity[] = {"convexity"};
constexpr std::string_view kResize[] = {"newsize", "auto", "convexity"};
constexpr std::string_view kOffset[] = {"r", "delta", "chamfer"};
constexpr std::string_view kProjection[] = {"cut", "convexity"};
constexpr std::string_view kSurface[] = {"file", "center", "invert", "convexity", "timestamp"};
constexpr std::string_view kImport[] = {"file",  "layer",  "origin",    "scale",
                                        "width", "height", "filename",  "center",
                                        "dpi",   "id",     "convexity", "timestamp"};

using enum WordKind;
constexpr WordRole kStructure = WordRole::structure, kLeaf = WordRole::leaf,
                   kConsumer = WordRole::consumer;

constexpr Word kWords[] = {
    {"group", unite, kStructure, 0, {}},
    {"union", unite, kStructure, 0, {}},
    {"render", unite, kStructure, 0, kConvexity},
    {"difference", subtract, kStructure, 0, {}},
    {"intersection", intersect, kStructure, 0, {}},
    {"multmatrix", place, kStructure, 0, kMatrix},
    {"color", tint, kStructure, 0, kColor},
    {"cube", cube, kLeaf, 3, kCube},
    {"sphere", sphere, kLeaf, 3, kSphere},
    {"cylinder", cylinder, kLeaf, 3, kCylinder},
    {"polyhedron", polyhedron, kLeaf, 3, kPolyhedron},
    {"square", square, kLeaf, 2, kCube},
    {"circle", circle, kLeaf, 2, kSphere},
    {"polygon", polygon, kLeaf, 2, kPolygon},
    {"text", text, kLeaf, 2, kText},
    {"surface", surface, kLeaf, 3, kSurface},
    {"import", import, kLeaf, 0, kImport},
    {"linear_extrude", linear_extrude, kConsumer, 3, kLinear},
    {"rotate_extrude", rotate_extrude, kConsumer, 3, kRotate},
    {"hull", hull, kConsumer, 0, {}},
    {"minkowski", minkowski, kConsumer, 0, kConvexity},
    {"resize", resize, kConsumer, 0, kResize},
    {"offset", offset, kConsumer, 2, kOffset},
    {"projection", projection, kConsumer, 2, kProjection},
    {"roof", refused, kConsumer, 3, {}, "straight skeletons are not computed"},
    {"fill", refused, kConsumer, 2, {}, "holes are not filled"},
};

constexpr auto kNames = [] {
  std::array<std::string_view, std::size(kWords)> names{};
  for (std::size_t i = 0; i < names.size(); ++i) names[i] = kWords[i].name;
  return names;
}();

constexpr std::string_view kProgramWords[] = {
    "translate", "rotate", "scale", "mirror", "children", "echo",       "assert",
    "for",       "if",     "let",   "else",   "each",     "import_dxf", "intersection_for",
};

}  // namespace

const Word* find_word(std::string_view name) {
  const auto* const found = std::find_if(std::begin(kWords), std::end(kWords),
                                         [&](const Word& word) { return word.name == name; });
  return found == std::end(kWords) ? nullptr : found;
}

std::span<const std::string_view> word_names() { return kNames; }

bool is_program_word(std::string_view name) {
  return std::find(std::begin(kProgramWords), std::end(kProgramWords), name) !=
         std::end(kProgramWords);
}

}  // namespace overstrike::openscad
