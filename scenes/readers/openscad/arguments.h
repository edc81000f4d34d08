#pragma once
// What a node was given, read as what it should be. What is wrong is reported, and the default
// taken.
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/vec.h"
#include "scenes/readers/openscad/tree.h"
#include "scenes/readers/openscad/words.h"

namespace overstrike::openscad {

/// A matrix and how far each of its entries may be from what was meant.
struct Placement {
  Affine affine;
  Affine error{Mat3(0.0), Vec3(0.0)};
};
/// First `b`, then `a`.
Placement operator*(const Placement& a, const Placement& b);

/// Six digits, however large it is, for messages.
std::string roughly(double number);

class Arguments {
 public:
  Arguments(const Tree& tree, Index node, const Word& word, Reporter& reporter);

  const Value* find(std::string_view name) const;
  bool has(std::string_view name) const { return find(name) != nullptr; }
  double number(std::string_view name, double otherwise) const;
  bool boolean(std::string_view name, bool otherwise) const;
  std::string text(std::string_view name, std::string_view otherwise) const;
  /// Two or three numbers; one number stands for all.
  Vec3 sizes(std::string_view name, int count, double otherwise) const;
  /// One flag for all axes, or one for each: 0 or 1.
  Vec3 flags(std::string_view name) const;
  /// A list of lists of numbers.
  std::vector<Vec2> points2(std::string_view name) const;
  std::vector<Vec3> points3(std::string_view name) const;
  std::vector<std::vector<Index>> index_lists(std::string_view name, std::size_t points) const;
  /// Colour and alpha, 0 to 1.
  Vec4 color() const;
  std::optional<Placement> matrix() const;

  /// The largest error of any number in the argument.
  double precision(std::string_view name) const;
  /// As Circle::fragments, with the node's own $fn, $fa and $fs.
  double fn() const { return number("$fn", 0); }
  double fa() const { return std::fmax(number("$fa", 12), 0.01); }
  double fs() const { return std::fmax(number("$fs", 2), 0.01); }
  /// OpenSCAD's number of facets round a circle of that radius. More than can be drawn is reported.
  int fragments(double radius) const;

  const TextMark& at() const { return node_.at; }
  Reporter& reporter() const { return reporter_; }
  void error(std::string message, std::string hint = {}) const;

 private:
  void name_arguments(Index number, const Word& word);
  std::vector<const Value*> items(const Value& list) const;
  bool is_number(const Value& value, std::string_view name) const;
  template <class Point>
  std::vector<Point> points(std::string_view name) const;

  const Tree& tree_;
  const Node& node_;
  Reporter& reporter_;
  struct Named {
    std::string_view name;
    Index value;
  };
  std::vector<Named> named_;
};

}  // namespace overstrike::openscad
