#pragma once
// Small scenes for the tests beside this file.
#include <memory>
#include <random>
#include <span>
#include <vector>

#include "core/geometry/trig.h"
#include "core/picture.h"
#include "core/scene/scene.h"

namespace overstrike::testing {

inline Body& add(Scene& scene, Shape shape, Vec3 at = Vec3(0), double turn_deg = 0) {
  Body body;
  body.shape = std::make_shared<const Shape>(std::move(shape));
  const double c = cos_deg(turn_deg), s = sin_deg(turn_deg);
  body.placement = {Mat3(Vec3(c, s, 0), Vec3(-s, c, 0), Vec3(0, 0, 1)), at};
  scene.bodies.push_back(std::move(body));
  return scene.bodies.back();
}

/// A tree that is one operand.
inline std::vector<SolidNode> operand_tree(std::uint32_t body) {
  return {{SetOperation::operand, body, 1}};
}

/// A tree of trees.
inline std::vector<SolidNode> tree_of(SetOperation operation,
                                      const std::vector<std::vector<SolidNode>>& operands) {
  std::vector<SolidNode> nodes{{operation, 0, 1}};
  for (const std::vector<SolidNode>& operand : operands) {
    const auto start = static_cast<std::uint32_t>(nodes.size());
    for (SolidNode below : operand) {
      below.end += start;
      nodes.push_back(below);
    }
  }
  nodes[0].end = static_cast<std::uint32_t>(nodes.size());
  return nodes;
}

/// Adds a solid of copies of the bodies that the tree names.
inline void add_solid(Scene& scene, const std::vector<SolidNode>& nodes,
                      std::span<const Body> bodies) {
  Solid solid;
  for (SolidNode node : nodes) {
    if (node.operation == SetOperation::operand) {
      scene.bodies.push_back(bodies[node.body]);
      node.body = static_cast<std::uint32_t>(scene.bodies.size() - 1);
    }
    solid.nodes.push_back(node);
  }
  scene.solids.push_back(std::move(solid));
}

/// A - (S - B) - (S - C) - ...: A less S, and A in B, C, ...
inline std::vector<SolidNode> differences_of_one(std::uint32_t operands) {
  std::vector<std::vector<SolidNode>> members{operand_tree(0)};
  for (std::uint32_t i = 2; i < operands; ++i)
    members.push_back(tree_of(SetOperation::subtract, {operand_tree(1), operand_tree(i)}));
  return tree_of(SetOperation::subtract, members);
}

/// Up to so deep, of operands 0 to `operands` - 1; some of its nodes have no members.
inline std::vector<SolidNode> random_tree(std::mt19937_64& random, int depth,
                                          std::uint32_t operands) {
  const auto below = [&](std::size_t n) { return random() % n; };
  if (depth == 0 || below(4) == 0) return operand_tree(static_cast<std::uint32_t>(below(operands)));
  std::vector<std::vector<SolidNode>> members;
  for (std::size_t i = below(8) == 0 ? 0 : 1 + below(3); i > 0; --i)
    members.push_back(random_tree(random, depth - 1, operands));
  return tree_of(static_cast<SetOperation>(1 + below(3)), members);
}

/// Looking straight down on [0, columns] x [0, rows] of the world's x and -y, one unit a cell.
inline void look_down(Scene& scene, double columns, double rows) {
  scene.camera.look_at = Vec3(columns / 2, -rows / 2, 0);
  scene.camera.from = {-90, 90};
  scene.camera.up = Vec3(0, 1, 0);
  scene.camera.parallel = true;
  scene.camera.window_width = columns;
  scene.camera.distance = 100;
}

inline Grid square_grid(double columns, double rows) { return {columns, rows, 1, 1}; }

/// Boxes, pyramids, faceted spheres and wedges that pass through one another, on a lit ground;
/// `round` adds smooth tori of many facets.
inline Scene crowd(unsigned seed, int bodies, bool round = true) {
  std::mt19937 random(seed);
  const auto u = [&](double low, double high) {
    return low + (high - low) * (random() / 4294967296.0);
  };
  Scene scene;
  for (int i = 0; i < bodies; ++i) {
    const Vec3 at(u(-3, 3), u(-3, 3), u(-0.3, 2));
    switch (random() % (round ? 5 : 4)) {
      case 0:
        add(scene, Box{{u(.3, 2), u(.3, 2), u(.3, 2)}}, at, u(0, 360));
        break;
      case 1:
        add(scene, Frustum{u(.3, 1), u(0, 1), u(.5, 2), 5}, at, u(0, 360));
        break;
      case 2:
        add(scene, Ellipsoid{{u(.3, 1), u(.3, 1), u(.3, 1)}, 8, 5}, at, u(0, 360));
        break;
      case 3:
        add(scene, Wedge{{u(.5, 2), u(.5, 2), u(.5, 1)}, u(0, .4), 0}, at, u(0, 360));
        break;
      default:
        add(scene, Torus{u(.8, 1), u(.2, .4)}, at).shading = Shading::smooth;
    }
  }
  scene.light = Direction{u(0, 360), u(20, 70)};
  scene.ground_z = 0;
  scene.camera.from = {u(0, 360), u(5, 60)};
  return scene;
}

}  // namespace overstrike::testing
