#include "core/geometry/winding_layers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "core/geometry/polygon.h"

namespace overstrike {
namespace {

struct Outlines {
  std::vector<Vec3> points;
  std::vector<DirectedEdge> edges;

  void add(const std::vector<Vec2>& loop) {
    const Index first = static_cast<Index>(points.size()), n = static_cast<Index>(loop.size());
    for (const Vec2& p : loop) points.push_back(Vec3(p, 0));
    for (Index i = 0; i < n; ++i) edges.push_back({first + i, first + (i + 1) % n});
  }
};

std::vector<Vec2> square(double low, double high) {
  return {{low, low}, {high, low}, {high, high}, {low, high}};
}
std::vector<Vec2> turned(std::vector<Vec2> loop) {
  std::reverse(loop.begin(), loop.end());
  return loop;
}

/// How often closed edges go round a point that lies on none of them.
int winding_of(const Outlines& o, const Vec2& p) {
  int winding = 0;
  for (const DirectedEdge& e : o.edges) {
    const Vec2 a(o.points[e.from]), b(o.points[e.to]);
    if (a.y <= p.y && b.y > p.y && turn_of(a, b, p) > 0) ++winding;
    if (a.y > p.y && b.y <= p.y && turn_of(a, b, p) < 0) --winding;
  }
  return winding;
}

/// What a layer says of a point, by even and odd.
bool holds(const WindingLayers& found, const WindingLayers::Layer& layer, const Vec2& p) {
  bool inside = false;
  for (const auto& loop : layer.loops) {
    Loop2 flat;
    for (const Index v : loop) flat.push_back(Vec2(found.points[v]));
    inside = inside != contains(flat, p);
  }
  return inside;
}

/// The laws at a point: w is the number of layers, of each sign, that hold it.
void expect_layers(const Outlines& o, const WindingLayers& found, const Vec2& p) {
  const int w = winding_of(o, p);
  for (const WindingLayers::Layer& layer : found.layers)
    EXPECT_EQ(holds(found, layer, p), layer.winding > 0 ? w >= layer.winding : w <= layer.winding)
        << "layer " << layer.winding << " at " << p.x << ", " << p.y << " where w is " << w;
  int lowest = 0, highest = 0;
  for (const WindingLayers::Layer& layer : found.layers) {
    lowest = std::min(lowest, layer.winding);
    highest = std::max(highest, layer.winding);
  }
  EXPECT_LE(w, highest);
  EXPECT_GE(w, lowest);
}

/// Every piece of the edges is in as many loops as the edges need to be closed.
void expect_closed(const Outlines& o, const WindingLayers& found) {
  std::map<std::pair<Index, Index>, int> balance;
  const auto count = [&](Index a, Index b, int by) {
    if (a != b) balance[std::minmax(a, b)] += a < b ? by : -by;
  };
  ASSERT_EQ(found.paths.size(), o.edges.size());
  for (const auto& path : found.paths)
    for (std::size_t i = 0; i + 1 < path.size(); ++i) count(path[i], path[i + 1], 1);
  for (const auto& layer : found.layers)
    for (const auto& loop : layer.loops)
      for (std::size_t i = 0; i < loop.size(); ++i) count(loop[i], loop[(i + 1) % loop.size()], -1);
  for (const auto& [ends, left] : balance)
    EXPECT_EQ(left, 0) << ends.first << " to " << ends.second;
}

WindingLayers layers_of(const Outlines& o) {
  const WindingLayers found = winding_layers(o.points, o.edges, FlatAxes({0, 0, 1}));
  expect_closed(o, found);
  return found;
}

std::vector<int> windings(const WindingLayers& found) {
  std::vector<int> all;
  for (const auto& layer : found.layers) all.push_back(layer.winding);
  return all;
}

TEST(WindingLayers, OneSquareIsOneLayer) {
  Outlines o;
  o.add(square(0, 1));
  const WindingLayers found = layers_of(o);
  EXPECT_EQ(windings(found), std::vector<int>({1}));
  EXPECT_EQ(found.points.size(), 4u);
  EXPECT_EQ(found.layers[0].loops, (std::vector<std::vector<Index>>{{0, 1, 2, 3}}));
}

TEST(WindingLayers, OverlappingSquaresAreTheirUnionAndTheirOverlap) {
  Outlines o;
  o.add(square(0, 2)), o.add(square(1, 3));
  const WindingLayers found = layers_of(o);
  EXPECT_EQ(windings(found), std::vector<int>({1, 2}));
  EXPECT_EQ(found.points.size(), 10u);
  EXPECT_EQ(found.layers[0].loops.at(0).size(), 8u);
  EXPECT_EQ(found.layers[1].loops.at(0).size(), 4u);
}

TEST(WindingLayers, NestedSquaresAreTwoLayersAndAHoleIsOne) {
  Outlines nested, hollow;
  nested.add(square(0, 3)), nested.add(square(1, 2));
  hollow.add(square(0, 3)), hollow.add(turned(square(1, 2)));
  EXPECT_EQ(windings(layers_of(nested)), std::vector<int>({1, 2}));
  const WindingLayers found = layers_of(hollow);
  EXPECT_EQ(windings(found), std::vector<int>({1}));
  EXPECT_EQ(found.layers[0].loops.size(), 2u);
  expect_layers(hollow, found, {1.5, 1.5});
}

TEST(WindingLayers, WhatIsTurnedInsideOutIsALayerOfItsOwn) {
  Outlines o;
  o.add(turned(square(0, 1))), o.add(square(2, 3));
  const WindingLayers found = layers_of(o);
  EXPECT_EQ(windings(found), std::vector<int>({1, -1}));
  expect_layers(o, found, {0.5, 0.5});
  expect_layers(o, found, {2.5, 2.5});
}

TEST(WindingLayers, OutlinesInOnePlaceAddUpOrCancel) {
  Outlines twice, none;
  twice.add(square(0, 1)), twice.add(square(0, 1));
  none.add(square(0, 1)), none.add(turned(square(0, 1)));
  EXPECT_EQ(windings(layers_of(twice)), std::vector<int>({1, 2}));
  EXPECT_TRUE(layers_of(none).layers.empty());
}

TEST(WindingLayers, SquaresThatTouchAreOneLayer) {
  Outlines vertex, edge, part;
  vertex.add(square(0, 1)), vertex.add(square(1, 2));
  edge.add(square(0, 1)), edge.add({{1, 0}, {2, 0}, {2, 1}, {1, 1}});
  part.add(square(0, 1)), part.add({{1, 0.25}, {2, 0.25}, {2, 0.5}, {1, 0.5}});
  for (const Outlines& o : {vertex, edge, part}) {
    const WindingLayers found = layers_of(o);
    EXPECT_EQ(windings(found), std::vector<int>({1}));
    expect_layers(o, found, {0.5, 0.5});
    expect_layers(o, found, {1.5, 0.375});
    expect_layers(o, found, {1.5, 1.5});
  }
}

TEST(WindingLayers, APentagramIsTwiceInItsMiddle) {
  Outlines o;
  o.add({{0, 3}, {-2, -3}, {3, 1}, {-3, 1}, {2, -3}});
  const WindingLayers found = layers_of(o);
  EXPECT_EQ(windings(found), std::vector<int>({1, 2}));
  EXPECT_EQ(winding_of(o, {0, 0}), 2);
  expect_layers(o, found, {0, 0});
  expect_layers(o, found, {0, 2});
}

TEST(WindingLayers, CounterClockwiseIsSeenFromTheOutwardSide) {
  for (const Vec3 outward : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0.1, 0.2, -0.9)}) {
    const FlatAxes axes(outward);
    Vec3 x(0.0), y(0.0);
    x[axes.x] = 1, y[axes.y] = 1;
    EXPECT_GT(glm::dot(glm::cross(x, y), outward), 0);
  }
}

/// Random loops on a lattice, where points on edges and edges on edges are the rule. The points
/// asked about lie on no line through two lattice points.
TEST(WindingLayers, RandomLoopsOnALatticeAreAsOftenInsideAsTheyGoRound) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 2000; ++i) {
    Outlines o;
    const int loops = 1 + static_cast<int>(random() % 3);
    for (int l = 0; l < loops; ++l) {
      std::vector<Vec2> loop;
      for (std::size_t n = 3 + random() % 5; n > 0; --n)
        loop.push_back({static_cast<double>(random() % 6), static_cast<double>(random() % 6)});
      o.add(loop);
    }
    const WindingLayers found = layers_of(o);
    // Crossings are rounded to 2^-52 of 5: 1e-6 off the lattice's lines is far from them.
    for (int k = 0; k < 12; ++k)
      expect_layers(o, found,
                    {static_cast<double>(random() % 5) + 0.3141592,
                     static_cast<double>(random() % 5) + 0.7182818});
    if (HasFailure()) FAIL() << "loops " << i;
  }
}

TEST(WindingLayers, RandomLoopsAnywhereAreAsOftenInsideAsTheyGoRound) {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> u(-1, 1);
  for (int i = 0; i < 300; ++i) {
    Outlines o;
    for (int l = 0; l < 3; ++l) {
      std::vector<Vec2> loop;
      for (int n = 0; n < 9; ++n) loop.push_back({u(random), u(random)});
      o.add(loop);
    }
    const WindingLayers found = layers_of(o);
    for (int k = 0; k < 40; ++k) expect_layers(o, found, {u(random), u(random)});
  }
}

}  // namespace
}  // namespace overstrike
