#include "core/visibility/front_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <random>

#include "core/visibility/clip.h"
#include "core/visibility/face_order.h"
#include "core/visibility/loose_edges.h"
#include "core/visibility/run_source.h"

namespace overstrike {
namespace {

constexpr Grid kGrid{16, 12, 1, 1};

struct Drawn {
  View view;
  Canonical canonical;
};

/// A box that the eye looks along the side of, from just beside it: cut at the near plane, its
/// corners there are thousands of cells outside of the grid.
Drawn box_beside_the_eye(std::mt19937_64& random) {
  std::uniform_real_distribution<double> u(-1, 1);
  Scene scene;
  scene.camera.eye = Vec3(u(random), 0, u(random));
  scene.camera.target = scene.camera.eye.value() + Vec3(1, 0.01 * u(random), 0.01 * u(random));
  Body body;
  body.shape = std::make_shared<const Shape>(Box{{8, 2, 8}});
  body.placement.offset = {0, 1 + std::ldexp(1 + u(random), -20), 0};
  scene.bodies.push_back(body);
  Drawn drawn{make_view(scene, kGrid), {}};
  std::vector<Diagnostic> warnings;
  drawn.canonical =
      clip(canonicalize(scene, drawn.view, 0.05, warnings), *drawn.view.near_plane, drawn.view.eye);
  return drawn;
}

/// In 64 bits of mantissa: 2^11 times as near as what is bounded.
struct Point {
  long double x, y;
};
Point projected(const View& view, const Vec3& p) {
  const auto row = [&](int r) {
    long double sum = view.matrix[3][r];
    for (int i = 0; i < 3; ++i) sum += static_cast<long double>(view.matrix[i][r]) * p[i];
    return sum;
  };
  return {row(0) / row(2), row(1) / row(2)};
}

/// Wherever in the grid a line is met it is off by no more than its bound; and the bound of one
/// that passes through the grid is small although the body's own is not.
TEST(LineError, BoundsEveryLineOfABodyThatPassesTheEye) {
  std::mt19937_64 random(5);
  int through = 0;
  for (int n = 0; n < 200; ++n) {
    const Drawn d = box_beside_the_eye(random);
    const FrontTable table(d.canonical, d.view, FrontUse::picture, 1);
    for (const WingedEdge& e : d.canonical.edges) {
      const Vec2 &a = table.points[e.from], &b = table.points[e.to];
      if (a.y == b.y) continue;
      const LevelLine line = a.y < b.y ? LevelLine(a, b) : LevelLine(b, a);
      const LineError& bound = table.bodies[0].line_error;
      const Point p = projected(d.view, d.canonical.vertices[e.from]),
                  q = projected(d.view, d.canonical.vertices[e.to]);
      for (const double y : {0.25, 3.0, 6.0, 11.5}) {
        if (!(line.y0 <= y && y < line.y1)) continue;
        const double x = line.x_at(y);
        if (!(x >= 0 && x <= kGrid.columns)) continue;
        const long double exact = p.x + (y - p.y) * ((q.x - p.x) / (q.y - p.y));
        const double error = static_cast<double>(std::fabs(x - exact));
        EXPECT_LE(error, bound.of(line));
        if (std::fabs(line.slope) > 1 || bound.constant < 2e-9) continue;
        EXPECT_LT(bound.of(line), 1e-9);
        ++through;
      }
    }
  }
  EXPECT_GT(through, 100);
}

/// The eye stands in the plane of a box's top, within it or beside it: cut close before the eye,
/// the top's corners are thousands of cells away, and all of it is seen on one line.
TEST(FrontTable, FacesSeenEdgeOnLieOnOneLine) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> u(-1, 1);
  const double beside = beside_line(kGrid.columns, kGrid.rows), horizon = kGrid.rows / 2;
  int cut = 0;
  for (int n = 0; n < 200; ++n) {
    Scene scene;
    scene.camera.eye = Vec3(u(random), u(random), 2);
    scene.camera.target = scene.camera.eye.value() + Vec3(u(random), u(random), 0);
    scene.camera.window_width = 4;
    Body body;
    body.shape = std::make_shared<const Shape>(Box{{3, 3, 2}});
    body.placement.offset = {u(random) - 1.5, u(random) - 1.5, 0};
    scene.bodies.push_back(body);
    const View view = make_view(scene, kGrid);
    std::vector<Diagnostic> warnings;
    const Canonical whole = canonicalize(scene, view, 0.05, warnings);
    const Canonical c = clip(whole, *view.near_plane, view.eye);
    const FrontTable table(c, view, FrontUse::picture, 1);
    const auto edge_on = [&](Index face) {
      return side_of_eye(c.planes[c.faces[face].plane], false, view.eye) == 0;
    };
    for (const WingedEdge& e : c.edges) {
      if (!edge_on(e.left) && !edge_on(e.right)) continue;
      cut += c.faces[e.left].cut || c.faces[e.right].cut;
      const Vec2 &a = table.points[e.from], &b = table.points[e.to];
      for (const double x : {0.25, 8.0, 15.75}) {
        if (x < std::min(a.x, b.x) || x > std::max(a.x, b.x)) continue;
        EXPECT_NEAR(a.y + (x - a.x) / (b.x - a.x) * (b.y - a.y), horizon, beside / 4) << n;
      }
    }
  }
  EXPECT_GT(cut, 100);
}

/// Edges that lie along the diagonal but for a millionth of a millionth, in a grid that is turned
/// by it: the planes of a front and a back cross on every level where their edge meets it.
TEST(LooseEdges, ThatAreNearlyLevelLieWhereTheirFacesCross) {
  std::mt19937_64 random(9);
  int nearly_level = 0;
  for (int n = 0; n < 300; ++n) {
    const auto whole = [&] { return static_cast<double>(random() % 5) - 2; };
    Scene scene;
    scene.camera.look_at = Vec3(0.5, 0.5, 0);
    scene.camera.from = {0, -90};
    scene.camera.parallel = true;
    scene.camera.window_width = 16;
    Body body;
    body.shape = std::make_shared<const Shape>(Tetrahedron{
        {{1, 1, whole()}, {-1, -0.999999999998, whole()}, {-2, 2, whole()}, {0, 2, -1}}});
    scene.bodies.push_back(body);
    scene.solids.push_back({{{SetOperation::operand, 0, 1}}, {}, {}, 0});
    const View view = turned(make_view(scene, kGrid), n % 2 == 0 ? 45 : -45, {0, -20}, 1);
    std::vector<Diagnostic> warnings;
    const Canonical c = canonicalize(scene, view, 0.05, warnings);
    const FrontTable table(c, view, FrontUse::picture, 1);
    const FaceOrder order(table);
    for (const WingedEdge& e : c.edges) {
      LooseEdge edge;
      if (!to_loose_edge(table, e, 0, edge) || table.sides[e.left] == table.sides[e.right])
        continue;
      const double height = edge.line.y1 - edge.line.y0, y = edge.line.y0 + height / 3;
      if (height > 1e-11 || height < 5 * table.bodies[0].line_error.per_slope) continue;
      const Vec3 &p = c.planes[c.faces[e.left].plane].normal,
                 &q = c.planes[c.faces[e.right].plane].normal;
      if (glm::length(glm::cross(p, q)) < 0.1) continue;  // it is almost flat
      EXPECT_NEAR(edge.line.x_at(y), order.crossing(edge.faces[0], edge.faces[1], y), 1e-9);
      ++nearly_level;
    }
  }
  EXPECT_GT(nearly_level, 50);
}

}  // namespace
}  // namespace overstrike
