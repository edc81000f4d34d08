#pragma once
// A .csg file as a tree with places. Nodes and values stand in preorder, so that no walk recurses
// and no depth of nesting overflows anything.
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/polyhedron.h"
#include "scenes/readers/source_text.h"

namespace overstrike::openscad {

enum class ValueKind : std::uint8_t { undefined, boolean, number, text, list };

/// A list's items follow it; each ends where the next begins.
struct Value {
  ValueKind kind = ValueKind::undefined;
  Index end = 0;         ///< in Tree::values: what comes after it and all in it
  double number = 0;     ///< of a boolean 0 or 1; of a text its number in Tree::texts
  double precision = 0;  ///< of a number, as Token::precision
  TextMark at;
};

struct Argument {
  std::string name;  ///< empty: told by its place
  Index value = 0;
  TextMark at;
};

struct Node {
  std::string name;
  TextMark at;
  Index first_argument = 0, end_argument = 0;
  Index end = 0;            ///< in Tree::nodes: what comes after it and all below it
  bool background = false;  ///< %
  bool disabled = false;    ///< *
};

struct Tree {
  std::vector<Node> nodes;  ///< the first is "group": the file itself
  std::vector<Argument> arguments;
  std::vector<Value> values;
  std::vector<std::string> texts;
  Index root = 0;  ///< where `!` stands, else the file
};

/// Throws InputError at the first place that is not .csg.
Tree parse(std::string_view text, Reporter& reporter);

}  // namespace overstrike::openscad
