#include "scenes/readers/openscad/dxf.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <numbers>
#include <utility>

#include "core/geometry/trig.h"
#include "scenes/readers/openscad/join_lines.h"

namespace overstrike::openscad {
namespace {

/// A group: a code, and what it says.
struct Group {
  int code;
  std::string_view value;
  int line;
};

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

class Groups {
 public:
  Groups(std::string_view text, const std::string& name) : rest_(text), name_(name) {}

  bool next(Group& group) {
    std::string_view code;
    if (!line(code)) return false;
    group.line = line_;
    const auto [end, error] = std::from_chars(code.data(), code.data() + code.size(), group.code);
    if (error != std::errc{} || end != code.data() + code.size()) {
      if (trimmed(rest_).empty() && code.empty()) return false;
      throw InputError(Place{name_, line_, 1},
                       "expected a group code, found " + in_quotes(code.substr(0, 40)));
    }
    return line(group.value);
  }

  double number(const Group& group) const {
    double value = 0;
    const std::string_view text = group.value;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
      throw InputError(Place{name_, group.line + 1, 1},
                       "expected a number, found " + in_quotes(text.substr(0, 40)));
    return value;
  }

 private:
  bool line(std::string_view& text) {
    if (rest_.empty()) return false;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    text = trimmed(rest_.substr(0, end));
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++line_;
    return true;
  }

  std::string_view rest_;
  const std::string& name_;
  int line_ = 0;
};

/// What an entity says, by group codes; which means what hangs on its kind.
struct Entity {
  std::string kind, layer, name;
  std::vector<Vec2> points;         ///< codes 10 and 20
  Vec2 second{0.0};                 ///< 11 and 21
  double radius = 0;                ///< 40; of an ellipse minor to major
  double scale_x = 1, scale_y = 1;  ///< 41 and 42 of an insert; an ellipse's ends (radians)
  double start = 0, end = 0;        ///< 50 and 51, degrees
  bool is_closed = false;           ///< 70 is odd
};

Vec2 polar(double radius, double degrees) {
  return {radius * cos_deg(degrees), radius * sin_deg(degrees)};
}

class DxfReader {
 public:
  DxfReader(std::string_view text, const std::string& name, const DxfOptions& options,
            const Arguments& arguments)
      : groups_(text, name), name_(name), options_(options), arguments_(arguments) {}

  Region read() {
    Group group{};
    while (groups_.next(group)) {
      if (group.code == 0) {
        finish();
        entity_ = {};
        entity_.kind = group.value;
      } else {
        take(group);
      }
    }
    finish();
    for (const auto& [kind, count] : unknown_)
      arguments_.reporter().warning(arguments_.at(), name_ + ": " + std::to_string(count) + " of " +
                                                         in_quotes(kind) +
                                                         " left out: no such entity is read");
    return {join_lines(lines_)};
  }

 private:
  void take(const Group& group) {
    switch (group.code) {
      case 2:
        entity_.name = group.value;
        break;
      case 8:
        entity_.layer = group.value;
        break;
      case 10:
        entity_.points.emplace_back(groups_.number(group), 0);
        break;
      case 20:
        if (!entity_.points.empty()) entity_.points.back().y = groups_.number(group);
        break;
      case 11:
        entity_.second.x = groups_.number(group);
        break;
      case 21:
        entity_.second.y = groups_.number(group);
        break;
      case 40:
        entity_.radius = groups_.number(group);
        break;
      case 41:
        entity_.scale_x = groups_.number(group);
        break;
      case 42:
        entity_.scale_y = groups_.number(group);
        break;
      case 50:
        entity_.start = groups_.number(group);
        break;
      case 51:
        entity_.end = groups_.number(group);
        break;
      case 70:
        entity_.is_closed = std::fmod(groups_.number(group), 2) != 0;
        break;
      default:
        break;
    }
  }

  void finish() {
    const std::string& kind = entity_.kind;
    if (kind == "SECTION") {
      in_entities_ = entity_.name == "ENTITIES";
      in_blocks_ = entity_.name == "BLOCKS";
    } else if (kind == "BLOCK") {
      block_ = entity_.name;
    } else if (kind == "ENDBLK") {
      block_.clear();
    } else if (kind == "POLYLINE") {
      polyline_ = entity_;
      polyline_.points.clear();
    } else if (kind == "VERTEX") {
      polyline_.points.insert(polyline_.points.end(), entity_.points.begin(), entity_.points.end());
    } else if (kind == "SEQEND") {
      entity_ = std::exchange(polyline_, {});
      draw();
    } else {
      draw();
    }
  }

  void draw() {
    if (!in_blocks_ &&
        !(in_entities_ && (options_.layer.empty() || options_.layer == entity_.layer)))
      return;
    const std::string& kind = entity_.kind;
    const std::vector<Vec2>& points = entity_.points;
    if (kind == "LINE" && !points.empty()) {
      path({points[0], entity_.second});
    } else if (kind == "LWPOLYLINE" || kind == "POLYLINE") {
      std::vector<Vec2> corners = points;
      if (entity_.is_closed && !corners.empty()) corners.push_back(corners[0]);
      path(corners);
    } else if (kind == "CIRCLE" && !points.empty()) {
      arc(0, 360);
    } else if (kind == "ARC" && !points.empty()) {
      double end = within_a_turn(entity_.end - entity_.start);
      if (end < 0) end += 360;
      arc(entity_.start, entity_.start + end);
    } else if (kind == "ELLIPSE" && !points.empty()) {
      ellipse();
    } else if (kind == "INSERT" && !points.empty()) {
      insert();
    } else if (kind != "ENDSEC" && kind != "EOF" && kind != "DIMENSION" && !kind.empty()) {
      ++unknown_[kind];
    }
  }

  Vec2 in_drawing(const Vec2& p) const {
    return in_blocks_ ? p : (p - options_.origin) * options_.scale;
  }

  void path(const std::vector<Vec2>& points) {
    std::vector<Line>& lines = in_blocks_ ? blocks_[block_] : lines_;
    for (std::size_t i = 1; i < points.size(); ++i)
      lines.push_back({in_drawing(points[i - 1]), in_drawing(points[i])});
  }

  /// Facets of so many degrees of a circle.
  int facets(double radius, double degrees) const {
    const double shown = in_blocks_ ? radius : radius * options_.scale;
    return std::max(static_cast<int>(std::ceil(arguments_.fragments(shown) * degrees / 360)), 1);
  }

  static double within_a_turn(double degrees) {
    return std::isfinite(degrees) ? std::fmod(degrees, 360) : 0;
  }

  void arc(double from, double to) {
    const int n = facets(entity_.radius, to - from);
    std::vector<Vec2> points;
    for (int i = 0; i <= n; ++i)
      points.push_back(entity_.points[0] + polar(entity_.radius, from + (to - from) * i / n));
    path(points);
  }

  /// 11/21 is the end of the major axis, counted from the middle.
  void ellipse() {
    const Vec2 major = entity_.second, minor = Vec2(-major.y, major.x) * entity_.radius;
    constexpr double kDegrees = 180 / std::numbers::pi;
    const double from = entity_.scale_x * kDegrees;
    double sweep = within_a_turn(entity_.scale_y * kDegrees - from);
    if (sweep <= 0) sweep += 360;
    const int n = facets(glm::length(major), sweep);
    std::vector<Vec2> points;
    for (int i = 0; i <= n; ++i) {
      const Vec2 unit = polar(1, from + sweep * i / n);
      points.push_back(entity_.points[0] + major * unit.x + minor * unit.y);
    }
    path(points);
  }

  void insert() {
    const auto block = blocks_.find(entity_.name);
    if (block == blocks_.end()) return;
    const Vec2 right = polar(entity_.scale_x, entity_.start);
    const Vec2 up = polar(entity_.scale_y, entity_.start + 90);
    const auto placed = [&](const Vec2& p) { return entity_.points[0] + right * p.x + up * p.y; };
    const std::vector<Line> lines = block->second;
    if (in_blocks_ && block_ == entity_.name) return;  // a block in itself
    for (const Line& line : lines) path({placed(line.from), placed(line.to)});
  }

  Groups groups_;
  const std::string& name_;
  const DxfOptions& options_;
  const Arguments& arguments_;
  Entity entity_, polyline_;
  bool in_entities_ = false, in_blocks_ = false;
  std::string block_;
  std::map<std::string, std::vector<Line>> blocks_;
  std::vector<Line> lines_;
  std::map<std::string, int> unknown_;
};

}  // namespace

Region read_dxf(std::string_view text, const std::string& name, const DxfOptions& options,
                const Arguments& arguments) {
  return DxfReader(text, name, options, arguments).read();
}

}  // namespace overstrike::openscad
