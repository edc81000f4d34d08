#pragma once
// The words of .csg: which nodes there are, what each is given, and what is done with it.
#include <cstdint>
#include <span>
#include <string_view>

namespace overstrike::openscad {

enum class WordKind : std::uint8_t {
  unite,
  subtract,
  intersect,
  place,
  tint,
  cube,
  sphere,
  cylinder,
  polyhedron,
  square,
  circle,
  polygon,
  text,
  linear_extrude,
  rotate_extrude,
  hull,
  minkowski,
  resize,
  offset,
  projection,
  surface,
  import,
  refused,
};

/// What a node is to those above it.
enum class WordRole : std::uint8_t {
  structure,  ///< passes its children on: a set operation, a place, a colour
  leaf,       ///< a shape
  consumer,   ///< a shape made of its children's
};

struct Word {
  std::string_view name;
  WordKind kind;
  WordRole role;
  int dimension;  ///< 2, 3, or 0: that of its children, or of its file
  std::span<const std::string_view> arguments;  ///< those told by their place, in order
  std::string_view refusal{};                   ///< why it is not drawn
};

/// Null where there is none of that name.
const Word* find_word(std::string_view name);
/// The names of all words, for suggestions.
std::span<const std::string_view> word_names();

/// Words of OpenSCAD's language that never stand in its export.
bool is_program_word(std::string_view name);

}  // namespace overstrike::openscad
