#include "scenes/readers/openscad/shapes.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/region_sets.h"
#include "scenes/readers/openscad/extrude.h"
#include "scenes/readers/openscad/hull.h"
#include "scenes/readers/openscad/offset.h"
#include "scenes/readers/openscad/project.h"
#include "scenes/readers/openscad/regions.h"
#include "scenes/readers/openscad/resize.h"
#include "scenes/readers/openscad/solid_tree.h"

namespace overstrike::openscad {
namespace {

void append_placed(const std::vector<Part>& parts, const Placement& place, std::vector<Part>& all) {
  for (const Part& part : parts)
    all.push_back({part.shape, place.affine * part.place, placed_precision(part, place)});
}

double worst_precision(const std::vector<Part>& parts) {
  double worst = 0;
  for (const Part& part : parts) worst = std::fmax(worst, part.precision);
  return worst;
}

void add_hull(std::vector<Vec2> points, const Affine& place, Region& region) {
  std::vector<Vec2> outline = hull(std::move(points));
  if (outline.size() < 3) return;
  region.loops.push_back(std::move(outline));
  region = placed(region, place);
}

void add_hull(const std::vector<Vec3>& points, double precision, std::vector<Part>& parts) {
  std::optional<Polyhedron> faces = hull(points);
  if (!faces) return;
  parts.push_back(
      {std::make_shared<const Shape>(Mesh{std::move(*faces), {}, {}, 0}), {}, precision});
}

}  // namespace

std::vector<NodeShape> ShapeBuilder::build() {
  shapes_.resize(tree_.nodes.size());
  for (auto i = nodes_.order.rbegin(); i != nodes_.order.rend(); ++i) build_node(*i);
  return std::move(shapes_);
}

void ShapeBuilder::build_node(Index i) {
  switch (state(i).word->role) {
    case WordRole::leaf:
      build_leaf(i);
      break;
    case WordRole::consumer:
      build_consumer(i);
      break;
    case WordRole::structure:
      build_structure(i);
      break;
  }
}

void ShapeBuilder::build_leaf(Index i) {
  const Arguments arguments(tree_, i, *state(i).word, reporter_);
  NodeShape& shape = shapes_[i];
  if (state(i).dimension == 2) {
    shape.flat = leaves_.flat(state(i), arguments);
    shape.filled = !shape.flat.region.loops.empty();
  } else {
    shape.parts = leaves_.solid(*state(i).word, arguments);
    shape.filled = !shape.parts.empty();
  }
  for (Part& part : shape.parts) part.shape = pool_.shared(std::move(part.shape));
}

/// The children but those that OpenSCAD has no operand for: what is marked by % or *.
std::vector<Index> ShapeBuilder::operands(Index i) const {
  std::vector<Index> children;
  for (Index c = i + 1; c < tree_.nodes[i].end; c = tree_.nodes[c].end)
    if (state(c).drawn || state(c).misfit) children.push_back(c);
  return children;
}

void ShapeBuilder::build_structure(Index i) {
  NodeShape& shape = shapes_[i];
  const SetOperation operation = operation_of(*state(i).word);
  const std::vector<Index> children = operands(i);
  for (const Index c : children)
    if (shapes_[c].filled) ++shape.filled_children;
  shape.filled = shape.filled_children > 0;
  if (operation == SetOperation::subtract)
    shape.filled = shape.filled && shapes_[children.front()].filled;
  if (operation == SetOperation::intersect)
    shape.filled = shape.filled && shape.filled_children == children.size();
  if (state(i).dimension != 2 || !shape.filled) return;
  const bool has_leaves_drawn = state(i).loose && unites(*state(i).word);
  if (has_leaves_drawn) return;
  shape.flat = combined(i, operation);
  shape.filled = !shape.flat.region.loops.empty();
}

Flat ShapeBuilder::united_children(Index i) { return combined(i, SetOperation::unite); }

Flat ShapeBuilder::combined(Index i, SetOperation operation) {
  std::vector<Region> regions;
  double precision = 0;
  for (const Index c : operands(i)) {
    Flat& flat = shapes_[c].flat;
    if (!shapes_[c].filled) continue;
    precision = std::fmax(precision, flat.precision);
    regions.push_back(std::move(flat.region));
  }
  if (regions.empty()) return {};
  if (regions.size() == 1) return {std::move(regions[0]), precision};
  return {combine(operation, regions), precision};
}

/// Of the solids between two nodes below node i: those of leaves, in the frame of node i.
std::vector<Part> ShapeBuilder::parts_below(Index i, Index first, Index end) {
  std::vector<Part> all;
  for (Index c = first; c < end;) {
    const bool skip = !state(c).drawn || !shapes_[c].filled;
    const Word* const word = state(c).word;
    if (skip || word->role != WordRole::structure) {
      if (!skip) append_placed(shapes_[c].parts, state(c).place, all);
      c = tree_.nodes[c].end;
      continue;
    }
    if (!unites(*word) && shapes_[c].filled_children > 1) {
      const std::string article = word->kind == WordKind::intersect ? "an " : "a ";
      reporter_.error(tree_.nodes[i].at,
                      in_quotes(tree_.nodes[i].name) + " of " + article + tree_.nodes[c].name +
                          " cannot be drawn: the surface of a Boolean solid is never computed");
      return {};
    }
    ++c;
  }
  return all;
}

void ShapeBuilder::hull_of(Index i) {
  NodeShape& shape = shapes_[i];
  if (state(i).dimension == 2) {
    std::vector<Vec2> points;
    for (const Index c : operands(i)) {
      shape.flat.precision = std::fmax(shape.flat.precision, shapes_[c].flat.precision);
      for (const auto& loop : shapes_[c].flat.region.loops)
        points.insert(points.end(), loop.begin(), loop.end());
    }
    add_hull(std::move(points), state(i).place.affine, shape.flat.region);
    return;
  }
  const std::vector<Part> parts = parts_below(i, i + 1, tree_.nodes[i].end);
  std::vector<Vec3> points;
  for (const Part& part : parts) {
    const std::vector<Vec3> corners = corners_of(part);
    points.insert(points.end(), corners.begin(), corners.end());
  }
  add_hull(points, worst_precision(parts), shape.parts);
}

/// The sum of unions is the union of the sums of their parts, and the sum of convex parts is the
/// hull of the sums of their corners.
void ShapeBuilder::minkowski_of(Index i) {
  if (state(i).dimension == 2) return flat_minkowski_of(i);
  std::vector<Part> sum;
  for (const Index c : operands(i)) {
    if (!shapes_[c].filled) continue;
    const std::vector<Part> parts = parts_below(i, c, tree_.nodes[c].end);
    for (const Part& part : parts)
      if (!is_convex(part)) return refuse_not_convex(i);
    if (sum.empty()) {
      sum = parts;
      continue;
    }
    std::vector<Part> next;
    for (const Part& a : sum)
      for (const Part& b : parts)
        add_hull(sums(corners_of(a), corners_of(b)), a.precision + b.precision, next);
    sum = std::move(next);
  }
  shapes_[i].parts = std::move(sum);
}

/// To OpenSCAD 2021.01 nothing but what is filled is an operand of a sum in space; in the plane the
/// sum is empty where the first is, or all others are.
void ShapeBuilder::flat_minkowski_of(Index i) {
  std::vector<Vec2> sum;
  double precision = 0;
  const std::vector<Index> children = operands(i);
  const auto filled =
      std::count_if(children.begin(), children.end(), [&](Index c) { return shapes_[c].filled; });
  if (!shapes_[children.front()].filled || (children.size() > 1 && filled == 1)) return;
  for (const Index c : children) {
    if (!shapes_[c].filled) continue;
    const Flat& flat = shapes_[c].flat;
    if (!is_convex(flat.region)) return refuse_not_convex(i);
    precision += flat.precision;
    sum = sum.empty() ? flat.region.loops[0] : hull(sums(sum, flat.region.loops[0]));
  }
  shapes_[i].flat.precision = precision;
  add_hull(std::move(sum), state(i).place.affine, shapes_[i].flat.region);
}

void ShapeBuilder::project(Index i, bool cut) {
  std::vector<Part> parts;
  const std::vector<SolidNode> tree =
      solid_tree(tree_, nodes_, shapes_, i, [&](Index leaf, const Part& part) {
        append_placed({part}, state(leaf).place, parts);
        return static_cast<Index>(parts.size() - 1);
      });
  const std::optional<Flat> flat = projected(tree, parts, cut);
  if (!flat)
    return reporter_.error(tree_.nodes[i].at,
                           "'projection' cannot be drawn: so many faces take too long to project");
  shapes_[i].flat = {placed(flat->region, state(i).place.affine), flat->precision};
}

void ShapeBuilder::refuse_not_convex(Index i) {
  reporter_.error(tree_.nodes[i].at, "'minkowski' cannot be drawn: an operand is not convex");
}

void ShapeBuilder::resize(Index i, const Arguments& arguments) {
  NodeShape& shape = shapes_[i];
  const bool flat = state(i).dimension == 2;
  Vec3 low(1e300), high(-1e300);
  const auto reach = [&](const Vec3& p) { low = glm::min(low, p), high = glm::max(high, p); };
  if (flat) {
    shape.flat = united_children(i);
    for (const auto& loop : shape.flat.region.loops)
      for (const Vec2& p : loop) reach(Vec3(p, 0));
  } else {
    shape.parts = parts_below(i, i + 1, tree_.nodes[i].end);
    for (const Part& part : shape.parts)
      for (const Vec3& p : corners_of(part)) reach(p);
  }
  const Affine change = resizing(high - low, flat ? 2 : 3, arguments);
  shape.flat.region = placed(shape.flat.region, state(i).place.affine * change);
  for (Part& part : shape.parts) part.place = change * part.place;
}

void ShapeBuilder::build_consumer(Index i) {
  const Arguments arguments(tree_, i, *state(i).word, reporter_);
  NodeShape& shape = shapes_[i];
  bool any = false;
  for (const Index c : operands(i)) any = any || shapes_[c].filled;
  if (!any) return;
  switch (state(i).word->kind) {
    case WordKind::linear_extrude:
      shape.parts = linear_extrude(arguments, united_children(i));
      break;
    case WordKind::rotate_extrude:
      shape.parts = rotate_extrude(arguments, united_children(i));
      break;
    case WordKind::hull:
      hull_of(i);
      break;
    case WordKind::minkowski:
      minkowski_of(i);
      break;
    case WordKind::resize:
      resize(i, arguments);
      break;
    case WordKind::offset: {
      const Flat flat = united_children(i);
      shape.flat = {placed(offset(arguments, flat.region), state(i).place.affine), flat.precision};
      break;
    }
    case WordKind::projection:
      project(i, arguments.boolean("cut", false));
      break;
    default:
      break;
  }
  shape.filled = state(i).dimension == 2 ? !shape.flat.region.loops.empty() : !shape.parts.empty();
  for (Part& part : shape.parts) part.shape = pool_.shared(std::move(part.shape));
}

}  // namespace overstrike::openscad
