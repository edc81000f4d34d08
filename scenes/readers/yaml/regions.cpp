#include "scenes/readers/yaml/regions.h"

#include <algorithm>
#include <string>
#include <utility>

#include "core/geometry/circle.h"
#include "core/geometry/region_sets.h"
#include "core/geometry/trig.h"
#include "scenes/readers/yaml/fields.h"

namespace overstrike::yaml {
namespace {

/// Sides of a circle that has none of its own: its chords lie within 1/830 of its radius.
constexpr int kUsualSides = 64;
/// More corners than this, of all outlines of one region, come of a slip of the pen.
constexpr std::size_t kMostCorners = 1'000'000;

constexpr std::pair<std::string_view, SetOperation> kOperations[] = {
    {"union", SetOperation::unite},
    {"difference", SetOperation::subtract},
    {"intersection", SetOperation::intersect}};

/// p -> linear * p + offset.
struct Affine2 {
  glm::dmat2 linear{1.0};
  Vec2 offset{0.0};
  Vec2 operator()(const Vec2& p) const { return linear * p + offset; }
};

Affine2 operator*(const Affine2& a, const Affine2& b) {
  return {a.linear * b.linear, a.linear * b.offset + a.offset};
}

/// One length for both, or one each.
Vec2 lengths(Reporter& reporter, const Node& value, std::string_view label) {
  if (value.kind == NodeKind::scalar) return Vec2(number(reporter, value, label, kPositive));
  const Vec2 both = vec2(reporter, value, label);
  for (const int axis : {0, 1})
    if (value.items.size() == 2 && both[axis] < kPositive.low)
      number(reporter, *value.items[static_cast<std::size_t>(axis)], label, kPositive);
  return both;
}

/// First scaled, then turned, then moved.
Affine2 placement(const Fields& f) {
  Affine2 place;
  if (const Node* scale = f.find("scale")) {
    const Vec2 by = lengths(f.reporter(), *scale, "scale");
    place.linear = glm::dmat2(by.x, 0, 0, by.y);
  }
  if (f.has("rotate")) {
    const double angle = f.number("rotate");
    const double c = cos_deg(angle), s = sin_deg(angle);
    place.linear = glm::dmat2(c, s, -s, c) * place.linear;
  }
  if (const Node* at = f.find("at")) place.offset = vec2(f.reporter(), *at, "at");
  return place;
}

class RegionReader {
 public:
  explicit RegionReader(Reporter& reporter) : reporter_(reporter) {}

  void read(const Node& node, const Affine2& around) {
    const Fields f(reporter_, node, kRegionMap);
    const std::string_view key = content_key(f, node);
    const Affine2 place = around * placement(f);
    if (key.empty()) return;
    for (const auto& [name, operation] : kOperations)
      if (key == name) return read_members(operation, *f.find(key), key, place);
    Region region;
    if (key == "outline") region.loops.push_back(points2(reporter_, *f.find(key), key, 3));
    if (key == "rectangle") region.loops.push_back(rectangle(*f.find(key)));
    if (key == "circle") region.loops.push_back(circle(*f.find(key)));
    add(std::move(region), place);
  }

  Region resolved(const TextMark& mark) {
    Region region;
    if (corners_ > kMostCorners) {
      reporter_.error(
          mark, "too much for a region: more than " + std::to_string(kMostCorners) + " corners");
      return region;
    }
    try {
      region = resolve(nodes_, operands_);
      if (region.loops.empty()) reporter_.error(mark, "nothing is left of the region");
    } catch (const WorkError& e) {
      reporter_.error(mark, std::string("too much for a region: ") + e.what());
    }
    return region;
  }

 private:
  /// The one key that says what the region is, or empty after an error.
  std::string_view content_key(const Fields& f, const Node& node) const {
    std::string_view first;
    bool meant = node.kind != NodeKind::map;
    for (const std::string_view key : region_content_keys()) {
      meant = meant || f.suggested(key);
      if (!f.has(key)) continue;
      if (first.empty()) {
        first = key;
        continue;
      }
      reporter_.error(node.mark, "a region must be one thing, found " + in_quotes(first) + " and " +
                                     in_quotes(key));
      return {};
    }
    if (first.empty() && !meant)
      reporter_.error(node.mark, "a region must say what it is",
                      "outline, rectangle, circle, union, difference or intersection");
    return first;
  }

  void read_members(SetOperation operation, const Node& value, std::string_view label,
                    const Affine2& place) {
    const std::size_t at = nodes_.size();
    nodes_.push_back({operation, 0, 0});
    for (const Node* member : list(reporter_, value, label, "regions", 1)) read(*member, place);
    nodes_[at].end = static_cast<std::uint32_t>(nodes_.size());
  }

  std::vector<Vec2> rectangle(const Node& value) const {
    const Vec2 half = lengths(reporter_, value, "rectangle") / 2.0;
    return {-half, {half.x, -half.y}, half, {-half.x, half.y}};
  }

  std::vector<Vec2> circle(const Node& value) {
    const Fields f(reporter_, value, kCircleMap);
    const double radius = f.number("radius", kPositive);
    const int sides = f.whole_number_or("sides", kUsualSides, kFewestSides, kMostSides);
    std::vector<Vec2> loop;
    if (corners_ > kMostCorners) return loop;
    for (int i = 0; i < sides; ++i) loop.push_back(radius * turn(i, sides));
    return loop;
  }

  void add(Region region, const Affine2& place) {
    for (std::vector<Vec2>& loop : region.loops) {
      corners_ += loop.size();
      for (Vec2& point : loop) point = place(point);
    }
    const auto number = static_cast<std::uint32_t>(operands_.size());
    nodes_.push_back(
        {SetOperation::operand, number, static_cast<std::uint32_t>(nodes_.size() + 1)});
    operands_.push_back(std::move(region));
  }

  Reporter& reporter_;
  std::vector<SolidNode> nodes_;
  std::vector<Region> operands_;
  std::size_t corners_ = 0;
};

}  // namespace

Region read_region(Reporter& reporter, const Node& node) {
  const std::size_t errors_before = reporter.errors();
  RegionReader reader(reporter);
  reader.read(node, {});
  return reporter.errors() == errors_before ? reader.resolved(node.mark) : Region{};
}

}  // namespace overstrike::yaml
