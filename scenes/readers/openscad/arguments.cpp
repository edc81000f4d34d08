#include "scenes/readers/openscad/arguments.h"

#include <algorithm>
#include <charconv>
#include <numbers>

#include "scenes/readers/nearest.h"

namespace overstrike::openscad {
namespace {

/// OpenSCAD takes a radius below this for nothing (its GRID_FINE).
constexpr double kSmallestRadius = 0.00000095367431640625;
/// As core draws circles.
constexpr double kMostFragments = 4096;

std::string describe(const Value& value) {
  switch (value.kind) {
    case ValueKind::undefined:
      return "undef";
    case ValueKind::boolean:
      return value.number != 0 ? "true" : "false";
    case ValueKind::number:
      return "a number";
    case ValueKind::text:
      return "a string";
    case ValueKind::list:
      return "a list";
  }
  return {};
}

Affine abs(const Affine& a) {
  return {Mat3(glm::abs(a.linear[0]), glm::abs(a.linear[1]), glm::abs(a.linear[2])),
          glm::abs(a.offset)};
}

}  // namespace

std::string roughly(double number) {
  char text[32];
  const auto [end, error] =
      std::to_chars(text, text + sizeof text, number, std::chars_format::general, 6);
  return {text, end};
}

Placement operator*(const Placement& a, const Placement& b) {
  const Affine sizes_a = abs(a.affine), sizes_b = abs(b.affine);
  Placement result{a.affine * b.affine, {}};
  result.error.linear = sizes_a.linear * b.error.linear + a.error.linear * sizes_b.linear;
  result.error.offset =
      sizes_a.linear * b.error.offset + a.error.linear * sizes_b.offset + a.error.offset;
  return result;
}

Arguments::Arguments(const Tree& tree, Index node, const Word& word, Reporter& reporter)
    : tree_(tree), node_(tree.nodes[node]), reporter_(reporter) {
  name_arguments(node, word);
}

void Arguments::name_arguments(Index number, const Word& word) {
  const Node& node = tree_.nodes[number];
  std::size_t place = 0;
  for (Index i = node.first_argument; i < node.end_argument; ++i) {
    const Argument& argument = tree_.arguments[i];
    if (!argument.name.empty()) {
      named_.push_back({argument.name, argument.value});
    } else if (place < word.arguments.size()) {
      named_.push_back({word.arguments[place++], argument.value});
    } else {
      reporter_.error(argument.at, in_quotes(node.name) + " takes no further argument");
    }
  }
}

void Arguments::error(std::string message, std::string hint) const {
  reporter_.error(node_.at, std::move(message), std::move(hint));
}

const Value* Arguments::find(std::string_view name) const {
  const Value* found = nullptr;
  for (const Named& n : named_)
    if (n.name == name) found = &tree_.values[n.value];
  return found != nullptr && found->kind == ValueKind::undefined ? nullptr : found;
}

std::vector<const Value*> Arguments::items(const Value& list) const {
  std::vector<const Value*> all;
  const Index number = static_cast<Index>(&list - tree_.values.data());
  for (Index i = number + 1; i < list.end; i = tree_.values[i].end) all.push_back(&tree_.values[i]);
  return all;
}

bool Arguments::is_number(const Value& value, std::string_view name) const {
  if (value.kind == ValueKind::number) return true;
  reporter_.error(value.at, std::string(name) + " must be a number, found " + describe(value));
  return false;
}

double Arguments::number(std::string_view name, double otherwise) const {
  const Value* const value = find(name);
  return value != nullptr && is_number(*value, name) ? value->number : otherwise;
}

bool Arguments::boolean(std::string_view name, bool otherwise) const {
  const Value* const value = find(name);
  if (value == nullptr) return otherwise;
  if (value->kind == ValueKind::boolean || value->kind == ValueKind::number)
    return value->number != 0;
  reporter_.error(value->at,
                  std::string(name) + " must be true or false, found " + describe(*value));
  return otherwise;
}

std::string Arguments::text(std::string_view name, std::string_view otherwise) const {
  const Value* const value = find(name);
  if (value == nullptr) return std::string(otherwise);
  if (value->kind == ValueKind::text) return tree_.texts[static_cast<std::size_t>(value->number)];
  reporter_.error(value->at, std::string(name) + " must be a string, found " + describe(*value));
  return std::string(otherwise);
}

Vec3 Arguments::sizes(std::string_view name, int count, double otherwise) const {
  Vec3 result(otherwise);
  const Value* const value = find(name);
  if (value == nullptr) return result;
  if (value->kind != ValueKind::list) return is_number(*value, name) ? Vec3(value->number) : result;
  const std::vector<const Value*> numbers = items(*value);
  if (static_cast<int>(numbers.size()) < count)
    reporter_.error(value->at, std::string(name) + " must be " + std::to_string(count) +
                                   " numbers, found " + std::to_string(numbers.size()));
  for (int i = 0; i < count && i < static_cast<int>(numbers.size()); ++i)
    if (is_number(*numbers[static_cast<std::size_t>(i)], name))
      result[i] = numbers[static_cast<std::size_t>(i)]->number;
  return result;
}

Vec3 Arguments::flags(std::string_view name) const {
  const Value* const value = find(name);
  if (value == nullptr) return Vec3(0.0);
  if (value->kind != ValueKind::list) return Vec3(boolean(name, false) ? 1 : 0);
  Vec3 result(0.0);
  const std::vector<const Value*> all = items(*value);
  for (std::size_t axis = 0; axis < all.size() && axis < 3; ++axis)
    result[static_cast<int>(axis)] = all[axis]->number != 0 ? 1 : 0;
  return result;
}

template <class Point>
std::vector<Point> Arguments::points(std::string_view name) const {
  std::vector<Point> result;
  const Value* const value = find(name);
  if (value == nullptr) return result;
  for (const Value* const item : items(*value)) {
    const std::vector<const Value*> numbers = items(*item);
    Point p(0.0);
    if (static_cast<int>(numbers.size()) < Point::length()) {
      reporter_.error(item->at, "a point must be " + std::to_string(Point::length()) +
                                    " numbers, found " + describe(*item));
      return {};
    }
    for (int i = 0; i < Point::length(); ++i) {
      const Value& number = *numbers[static_cast<std::size_t>(i)];
      if (!is_number(number, "a coordinate")) return {};
      if (!std::isfinite(number.number)) {
        reporter_.error(number.at, "a coordinate must be finite");
        return {};
      }
      p[i] = number.number + 0.0;
    }
    result.push_back(p);
  }
  return result;
}

std::vector<Vec2> Arguments::points2(std::string_view name) const { return points<Vec2>(name); }
std::vector<Vec3> Arguments::points3(std::string_view name) const { return points<Vec3>(name); }

std::vector<std::vector<Index>> Arguments::index_lists(std::string_view name,
                                                       std::size_t count) const {
  std::vector<std::vector<Index>> result;
  const Value* const value = find(name);
  if (value == nullptr) return result;
  for (const Value* const item : items(*value)) {
    if (item->kind == ValueKind::undefined) continue;
    std::vector<Index>& list = result.emplace_back();
    for (const Value* const number : items(*item)) {
      if (!is_number(*number, "a point's number")) return {};
      if (!(number->number >= 0) || !(number->number < static_cast<double>(count))) {
        reporter_.error(number->at, "point " + roughly(number->number) + " does not exist",
                        "there are " + std::to_string(count) + ", numbered from 0");
        return {};
      }
      list.push_back(static_cast<Index>(number->number));
    }
  }
  return result;
}

Vec4 Arguments::color() const {
  Vec4 result(0, 0, 0, 1);
  const Value* const value = find("c");
  if (value == nullptr) return Vec4(-1);
  const std::vector<const Value*> numbers = items(*value);
  if (numbers.size() != 3 && numbers.size() != 4) {
    reporter_.error(value->at, "a colour must be 3 or 4 numbers, found " + describe(*value));
    return Vec4(-1);
  }
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (is_number(*numbers[i], "a part of a colour"))
      result[static_cast<int>(i)] = numbers[i]->number;
  return result;
}

std::optional<Placement> Arguments::matrix() const {
  const Value* const value = find("m");
  Placement result;
  if (value == nullptr) return result;
  const std::vector<const Value*> rows = items(*value);
  double entries[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
  double errors[4][4] = {};
  if (rows.size() < 3 || rows.size() > 4) {
    reporter_.error(value->at, "a matrix must be 4 rows of 4 numbers, found " + describe(*value));
    return std::nullopt;
  }
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const std::vector<const Value*> numbers = items(*rows[r]);
    if (numbers.size() != 4) {
      reporter_.error(rows[r]->at,
                      "a matrix's row must be 4 numbers, found " + std::to_string(numbers.size()));
      return std::nullopt;
    }
    for (std::size_t c = 0; c < 4; ++c) {
      if (!is_number(*numbers[c], "a matrix's entry")) return std::nullopt;
      entries[r][c] = numbers[c]->number, errors[r][c] = numbers[c]->precision;
    }
  }
  if (entries[3][0] != 0 || entries[3][1] != 0 || entries[3][2] != 0 || !(entries[3][3] != 0)) {
    reporter_.error(rows[3]->at, "the last row of a matrix must be [0, 0, 0, 1]",
                    "perspective is the camera's");
    return std::nullopt;
  }
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) {
      result.affine.linear[c][r] = entries[r][c] / entries[3][3];
      result.error.linear[c][r] = errors[r][c] / std::fabs(entries[3][3]);
    }
    result.affine.offset[r] = entries[r][3] / entries[3][3];
    result.error.offset[r] = errors[r][3] / std::fabs(entries[3][3]);
  }
  return result;
}

double Arguments::precision(std::string_view name) const {
  const Value* const value = find(name);
  if (value == nullptr) return 0;
  double worst = value->precision;
  const Index number = static_cast<Index>(value - tree_.values.data());
  for (Index i = number; i < value->end; ++i) worst = std::fmax(worst, tree_.values[i].precision);
  return worst;
}

int Arguments::fragments(double radius) const {
  const double fn = this->fn();
  if (!(radius >= kSmallestRadius) || !std::isfinite(fn)) return 3;
  const double wanted =
      fn > 0
          ? std::fmax(std::floor(fn), 3)
          : std::ceil(std::fmax(std::fmin(360.0 / fa(), radius * 2 * std::numbers::pi / fs()), 5));
  if (wanted <= kMostFragments) return static_cast<int>(wanted);
  error("too many facets round a circle: " + roughly(wanted),
        "at most 4096; mind $fn, $fa and $fs");
  return 3;
}

}  // namespace overstrike::openscad
