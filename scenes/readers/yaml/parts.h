#pragma once
// Bodies, groups and uses as a scene file says them, before copies are made.
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/scene/scene.h"
#include "scenes/readers/yaml/placement.h"
#include "scenes/readers/yaml/shapes.h"

namespace overstrike::yaml {

struct Part;
struct Use {
  std::string name;
  TextMark mark;
};

/// A Boolean solid of its members: `difference` takes all others from the first.
struct Combination {
  SetOperation operation;
  std::vector<Part> members;
  double translucent = 0;
};

/// How much a part becomes, copies counted; each number stops at kUncountable.
struct Cost {
  std::uint64_t parts = 0;   ///< bodies and groups
  std::uint64_t points = 0;  ///< of patterns
};
constexpr std::uint64_t kUncountable = std::uint64_t{1} << 32;

/// One entry of a list of bodies.
struct Part {
  std::variant<ShapePtr, std::vector<Part>, Combination, Use> content;
  std::string name;
  double density = 1;
  std::optional<Shading> shading;
  std::optional<int> pen;
  std::vector<Pattern> patterns;
  Affine placement;
  std::vector<Array> arrays;
  TextMark mark;
};

struct Definition {
  Part part;
  TextMark mark;
};
using Definitions = std::map<std::string, Definition, std::less<>>;

Part read_part(Reporter&, const Node&, MeshFiles&);
/// `label` names the list in messages.
std::vector<Part> read_parts(Reporter&, const Node&, std::string_view label, MeshFiles&);
Definitions read_definitions(Reporter&, const Node&, MeshFiles&);
/// A polyline of `pattern` or `segment`: points, closed, pen.
Pattern read_polyline(const Fields&);

/// What is drawn: bodies, and the solids that some of them are operands of.
struct Expanded {
  std::vector<Body> bodies;
  std::vector<Solid> solids;
};

/// Makes bodies of parts: uses become what they name, arrays become copies, groups dissolve; within
/// a solid copies and groups are united. Unknown names, definitions in a circle and too many copies
/// are reported, and then there is nothing.
Expanded expand(Reporter&, const std::vector<Part>&, const Definitions&);

}  // namespace overstrike::yaml
