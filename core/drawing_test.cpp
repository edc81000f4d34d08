#include "core/drawing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "core/visibility/test_scenes.h"

namespace overstrike {
namespace {

using testing::add;
using testing::crowd;
using testing::look_down;
using testing::square_grid;

std::vector<std::vector<float>> cells_of(const Scene& scene, const Grid& grid,
                                         const DrawOptions& options = {}) {
  std::vector<std::vector<float>> rows;
  Drawing(scene, grid, options).cells([&](const CellRow& row) {
    EXPECT_EQ(row.row, static_cast<std::int64_t>(rows.size()));
    rows.emplace_back(row.density.begin(), row.density.end());
  });
  return rows;
}

std::vector<std::vector<DensityRun>> runs_of(const Scene& scene, const Grid& grid,
                                             const ScanFamily& family,
                                             const DrawOptions& options = {}) {
  std::vector<std::vector<DensityRun>> rows;
  Drawing(scene, grid, options).runs(family, [&](const RunRow& row) {
    rows.emplace_back(row.runs.begin(), row.runs.end());
  });
  return rows;
}

bool same(const DensityRun& a, const DensityRun& b) {
  return a.x0 == b.x0 && a.x1 == b.x1 && a.density0 == b.density0 && a.density1 == b.density1 &&
         a.surface == b.surface && a.body == b.body && a.kind == b.kind;
}

TEST(Drawing, AnEmptySceneIsBarePaper) {
  const auto rows = cells_of(Scene{}, square_grid(7, 3));
  ASSERT_EQ(rows.size(), 3u);
  for (const auto& row : rows) EXPECT_EQ(row, std::vector<float>(7, 0.0f));
}

TEST(Drawing, CellsHoldTheExactAreaOfABox) {
  Scene scene;
  look_down(scene, 10, 8);
  scene.light = Direction{0, 90};
  // From x = 2.25 to 5.75 and 1.5 to 4.25 rows down; its top faces the light: density 0.2.
  add(scene, Box{{3.5, 2.75, 1}}, {4, -2.875, 0});
  const auto rows = cells_of(scene, square_grid(10, 8));
  const auto cover = [](double low, double high, int i) {
    return std::max(0.0, std::min(high, i + 1.0) - std::max(low, static_cast<double>(i)));
  };
  for (int r = 0; r < 8; ++r)
    for (int c = 0; c < 10; ++c)
      EXPECT_NEAR(rows[r][c], 0.2 * cover(2.25, 5.75, c) * cover(1.5, 4.25, r), 1e-7)
          << r << ' ' << c;
  EXPECT_EQ(rows[2][3], 0.2f) << "cells inside a flat face hold its density itself";
}

TEST(Drawing, RunsEndWhereTheBoxEnds) {
  Scene scene;
  look_down(scene, 10, 8);
  scene.light = Direction{0, 90};
  add(scene, Box{{3.5, 2.75, 1}}, {4, -2.875, 0});
  const auto rows = runs_of(scene, square_grid(10, 8), {});
  ASSERT_EQ(rows.size(), 8u);
  ASSERT_EQ(rows[2].size(), 1u);
  EXPECT_NEAR(rows[2][0].x0, 2.25, 1e-12);
  EXPECT_NEAR(rows[2][0].x1, 5.75, 1e-12);
  EXPECT_EQ(rows[2][0].kind, Kind::lit);
  EXPECT_NEAR(rows[2][0].density0, 0.2, 1e-15);
  EXPECT_TRUE(rows[0].empty());
}

TEST(Drawing, ACubesGroundShadowIsThatOfNN74) {
  Scene scene;
  look_down(scene, 10, 8);
  scene.ground_z = 0;
  scene.light = Direction{180, 45};  // from -X: the shadow reaches one height towards +X
  add(scene, Box{{2, 2, 2}}, {4, -4, 0});
  const auto rows = runs_of(scene, square_grid(10, 8), {});
  const auto& row = rows[4];
  ASSERT_EQ(row.size(), 2u);
  EXPECT_EQ(row[0].kind, Kind::lit);
  EXPECT_NEAR(row[0].x1, 5, 1e-12);
  EXPECT_EQ(row[1].kind, Kind::ground_shadow);
  EXPECT_NEAR(row[1].x0, 5, 1e-12);
  EXPECT_NEAR(row[1].x1, 7, 1e-12);
  EXPECT_EQ(row[1].density0, 0.85);
  EXPECT_EQ(row[1].surface, kNoSurface);
}

TEST(Drawing, ABodyCastsOntoAnother) {
  Scene scene;
  look_down(scene, 10, 8);
  scene.light = Direction{180, 45};
  add(scene, Box{{8, 6, 1}}, {5, -4, 0});  // a slab, its top at 1
  add(scene, Box{{1, 2, 2}}, {3, -4, 1});  // stands on it; 2 high: the shadow is 2 long
  const auto rows = runs_of(scene, square_grid(10, 8), {});
  const auto& row = rows[4];
  ASSERT_EQ(row.size(), 4u);
  EXPECT_EQ(row[0].kind, Kind::lit);
  EXPECT_NEAR(row[0].x1, 2.5, 1e-12);
  EXPECT_EQ(row[1].kind, Kind::lit);
  EXPECT_NEAR(row[1].x1, 3.5, 1e-12);
  EXPECT_EQ(row[2].kind, Kind::shadow);
  EXPECT_NEAR(row[2].x1, 5.5, 1e-12);
  EXPECT_EQ(row[2].density0, 1);
  EXPECT_EQ(row[3].kind, Kind::lit);
  EXPECT_EQ(row[3].surface, row[0].surface);
}

TEST(Drawing, InterpenetratingBodiesMeetAtTheirCrossing) {
  Scene scene;
  look_down(scene, 10, 8);
  // Two roofs along y whose slopes pass through each other at x = 5.
  add(scene, Wedge{{4, 6, 2}, 0, 0}, {4, -4, 0});
  add(scene, Wedge{{4, 6, 2}, 0, 0}, {6, -4, 0});
  const auto rows = runs_of(scene, square_grid(10, 8), {});
  const auto& row = rows[4];
  ASSERT_EQ(row.size(), 4u);
  const double ends[4] = {4, 5, 6, 8};
  for (int i = 0; i < 4; ++i) EXPECT_NEAR(row[i].x1, ends[i], 1e-12);
  EXPECT_EQ(row[1].body, 0u);
  EXPECT_EQ(row[2].body, 1u);
}

/// What lies in the ground's plane is seen before it, in a shadow that is darker than it, too.
TEST(Drawing, ARugIsSeenInTheShadowOfAPlate) {
  Scene scene;
  look_down(scene, 10, 8);
  scene.ground_z = 0;
  scene.light = Direction{180, 45};
  const FlatPolygon rug{{{{5, -5, 0}, {7, -5, 0}, {7, -3, 0}, {5, -3, 0}}}};
  const FlatPolygon plate{{{{-4, -6, 8}, {0, -6, 8}, {0, -2, 8}, {-4, -2, 8}}}};
  add(scene, rug).density_factor = 0.5;
  add(scene, plate);  // beside the page; its shadow lies from x = 4 to 8
  const auto rows = runs_of(scene, square_grid(10, 8), {});
  ASSERT_EQ(rows[4].size(), 3u);
  EXPECT_EQ(rows[4][0].kind, Kind::ground_shadow);
  EXPECT_EQ(rows[4][1].kind, Kind::shadow);
  EXPECT_EQ(rows[4][1].density0, 0.5);
  EXPECT_NEAR(rows[4][1].x0, 5, 1e-12);
  EXPECT_NEAR(rows[4][1].x1, 7, 1e-12);
  EXPECT_EQ(rows[4][2].kind, Kind::ground_shadow);
}

TEST(Drawing, ABodyExactlyHidingAnotherHidesAllOfIt) {
  Scene scene;
  look_down(scene, 10, 8);
  add(scene, Box{{4, 4, 1}}, {5, -4, 0});
  add(scene, Box{{4, 4, 1}}, {5, -4, 3});
  for (const auto& row : runs_of(scene, square_grid(10, 8), {}))
    for (const DensityRun& run : row) EXPECT_EQ(run.body, 1u);
}

TEST(Drawing, RunsAreSortedDisjointAndWithinTheGrid) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    const Scene scene = crowd(seed, 8);
    for (const double angle : {0.0, 30.0, 90.0, 137.0})
      for (const auto& row : runs_of(scene, square_grid(60, 45), {angle, 1, 0.5}))
        for (std::size_t i = 0; i < row.size(); ++i) {
          EXPECT_LT(row[i].x0, row[i].x1);
          if (i > 0) {
            EXPECT_LE(row[i - 1].x1, row[i].x0);
          }
          EXPECT_GE(row[i].density0, 0);
          EXPECT_LE(row[i].density0, 1);
        }
  }
}

/// Law: a row of cells is the mean of its scan lines, each standing for a strip of the row; a
/// border is seen by them to within half of their distance, and a cell has few.
void expect_mean_of_lines(const Scene& scene, double most) {
  constexpr int kLines = 256, kRows = 30, kColumns = 40;
  const Grid grid = square_grid(kColumns, kRows);
  const auto cells = cells_of(scene, grid);
  std::vector<std::vector<double>> mean(kRows, std::vector<double>(kColumns, 0.0));
  int line = 0;
  for (const auto& row : runs_of(scene, grid, {0, 1.0 / kLines, 0.5 / kLines})) {
    for (const DensityRun& run : row)
      for (int i = static_cast<int>(run.x0); i < kColumns && i < run.x1; ++i) {
        const double low = std::max<double>(run.x0, i), high = std::min<double>(run.x1, i + 1);
        const double t = ((low + high) / 2 - run.x0) / (run.x1 - run.x0);
        const double density = run.density0 + t * (run.density1 - run.density0);
        mean[line / kLines][i] += (high - low) * density / kLines;
      }
    ++line;
  }
  for (int r = 0; r < kRows; ++r)
    for (int c = 0; c < kColumns; ++c)
      EXPECT_NEAR(cells[r][c], mean[r][c], most) << "row " << r << " column " << c;
}

TEST(Drawing, CellsAreTheMeanOfManyScanLines) {
  for (unsigned seed = 0; seed < 12; ++seed) {
    SCOPED_TRACE(seed);
    expect_mean_of_lines(crowd(seed, 7, false), 4.0 / 256);
  }
}

/// What lies beyond the last column is not known; bodies that pass it were once judged there.
TEST(Drawing, BodiesThatPassTheBordersAreRightInTheLastColumn) {
  for (unsigned seed = 30; seed < 36; ++seed) {
    SCOPED_TRACE(seed);
    Scene scene = crowd(seed, 9, false);
    scene.camera.window_width = 2.5;
    expect_mean_of_lines(scene, 4.0 / 256);
  }
}

TEST(Drawing, CrowdedCellsKeepToTheTolerance) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE(seed);
    expect_mean_of_lines(crowd(seed, 7, true), 0.05 + 4.0 / 256);
  }
}

/// Shadows and outlines meet in the lines in which the boxes touch: spans there are of rounding's
/// making, and tell nothing about their neighbours.
TEST(Drawing, BodiesThatStandOnOthersAreSeenDownToTheirFeet) {
  std::mt19937 random(7);
  const auto u = [&](double low, double high) {
    return low + (high - low) * (random() / 4294967296.0);
  };
  for (int turn = 0; turn < 24; ++turn) {
    SCOPED_TRACE(turn);
    Scene scene;
    add(scene, Box{{36, 7, 20}}, {0, 6, 4.5});
    add(scene, Box{{u(5, 14), u(2, 6), u(1, 4)}}, {u(-8, 8), 6, 24.5});
    add(scene, Box{{44, 26, 4.5}});
    scene.camera.from = {u(-80, -20), u(15, 50)};
    scene.light = Direction{u(-150, -30), u(20, 60)};
    scene.ground_z = 0;
    expect_mean_of_lines(scene, 4.0 / 256);
  }
}

/// A line that meets exactly the edges of boxes, shadows and sheets in one plane shows what is seen
/// on one side of them.
TEST(Drawing, LinesAlongEdgesShowOneOfTheirSides) {
  constexpr double kBeside = 1e-7;
  std::mt19937 random(1974);
  const auto whole = [&](int low, int high) {
    return low + static_cast<double>(random() % static_cast<unsigned>(high - low + 1));
  };
  const auto lines_of = [](const Scene& scene, const ScanFamily& family) {
    std::map<std::int64_t, std::vector<DensityRun>> lines;
    Drawing(scene, square_grid(16, 12), {}).runs(family, [&](const RunRow& row) {
      lines[row.index].assign(row.runs.begin(), row.runs.end());
    });
    return lines;
  };
  const auto seen_at = [](const std::vector<DensityRun>& runs, double x) {
    for (const DensityRun& run : runs)
      if (run.x0 <= x && x < run.x1) return std::pair(run.surface, run.kind);
    return std::pair(kNoSurface, Kind::lit);
  };
  int judged = 0;
  for (int i = 0; i < 300; ++i) {
    Scene scene;
    const Direction from[] = {{0, 0}, {-90, 0}, {-45, 0}, {45, 30}, {0, 45}};
    scene.camera.from = from[i % 5];
    scene.camera.parallel = i % 2 == 0;
    scene.camera.window_width = 16;
    scene.camera.look_at = Vec3(0);
    scene.light = Direction{30.0 * (i % 12), 45};
    scene.ground_z = -2;
    for (int b = 0; b < 4; ++b)
      add(scene, Box{{whole(1, 4), whole(1, 4), whole(1, 3)}},
          {whole(-3, 3), whole(-3, 3), whole(-2, 1)}, i % 3 == 0 ? 45 : 0);
    for (const double angle : {0.0, 90.0}) {
      const auto at = lines_of(scene, {angle, 1, 0});
      auto before = lines_of(scene, {angle, 1, -kBeside});
      auto after = lines_of(scene, {angle, 1, kBeside});
      for (const auto& [line, runs] : at)
        for (const DensityRun& run : runs) {
          if (run.x1 - run.x0 < 1e-3 || before.count(line) + after.count(line) < 2) continue;
          const double x = run.x0 + (run.x1 - run.x0) / 2;
          const std::pair drawn(run.surface, run.kind);
          EXPECT_TRUE(seen_at(before[line], x) == drawn || seen_at(after[line], x) == drawn)
              << "scene " << i << " angle " << angle << " line " << line << " at " << x;
          ++judged;
        }
    }
  }
  EXPECT_GT(judged, 5000);
}

/// A face of an open body that crosses itself turns the other way beyond the crossing, where it is
/// seen no less.
TEST(Drawing, AFaceThatCrossesItselfIsSeenOnBothSidesOfTheCrossing) {
  Scene scene;
  look_down(scene, 10, 8);
  Mesh mesh;
  const Vec3 corners[] = {{1, -7, 0}, {9, -4, 0}, {1, -1, 0}, {5, -1, 0}};
  for (const Vec3& p : corners) mesh.polyhedron.add_vertex(p);
  mesh.polyhedron.add_face({3, 2, 0});
  mesh.polyhedron.add_face({3, 0, 1, 2});  // crosses the one before, and itself
  add(scene, mesh);
  const auto inside = [&](std::initializer_list<int> loop, const Vec2& p) {
    bool odd = false;
    const std::vector<int> l(loop);
    for (std::size_t i = 0; i < l.size(); ++i) {
      const Vec2 a(corners[l[i]]), b(corners[l[(i + 1) % l.size()]]);
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) * (b.x - a.x) / (b.y - a.y))
        odd = !odd;
    }
    return odd;
  };
  const auto rows = runs_of(scene, square_grid(10, 8), {});
  for (int r = 0; r < 8; ++r)
    for (double x = 0.03; x < 10; x += 0.0917) {
      const Vec2 p(x, -(r + 0.5));
      bool drawn = false;
      for (const DensityRun& run : rows[r]) drawn = drawn || (run.x0 <= x && x < run.x1);
      EXPECT_EQ(drawn, inside({3, 2, 0}, p) || inside({3, 0, 1, 2}, p)) << r << ' ' << x;
    }
}

/// Faces of one plane: the greater density factor, which is what is darker of flat ones; then flat
/// before smooth. Nowhere does it matter where they are looked at.
TEST(Drawing, TiesAreDecidedByWhatFacesAre) {
  Scene scene;
  look_down(scene, 10, 8);
  scene.light = Direction{20, 40};
  const auto roof = [](double ridge) {  // smooth: its corners' densities differ
    Mesh mesh;
    for (const Vec3& p : {Vec3(1, -7, 0), Vec3(9, -7, 0), Vec3(9, -1, 0), Vec3(1, -1, 0),
                          Vec3(1, -9, ridge), Vec3(9, -9, ridge)})
      mesh.polyhedron.add_vertex(p);
    mesh.polyhedron.add_face({0, 1, 2, 3});
    mesh.polyhedron.add_face({1, 0, 4, 5});
    return mesh;
  };
  const FlatPolygon sheet{{{{1, -7, 0}, {9, -7, 0}, {9, -1, 0}, {1, -1, 0}}}};
  add(scene, roof(-1)).shading = Shading::smooth;
  const auto front = [&](double of_roof, double of_sheet, bool sheet_first) {
    Scene both = scene;
    both.bodies[0].density_factor = of_roof;
    add(both, sheet).density_factor = of_sheet;
    if (sheet_first) std::swap(both.bodies[0], both.bodies[1]);
    std::vector<Index> bodies;
    const auto rows = runs_of(both, square_grid(10, 8), {});
    for (int r = 1; r < 7; ++r)
      for (const DensityRun& run : rows[r]) bodies.push_back(run.body ^ Index{sheet_first});
    return bodies;
  };
  for (const bool sheet_first : {false, true}) {
    for (const Index body : front(0.5, 0.5, sheet_first)) EXPECT_EQ(body, 1u) << "flat first";
    for (const Index body : front(0.51, 0.5, sheet_first)) EXPECT_EQ(body, 0u);
    for (const Index body : front(0.5, 0.51, sheet_first)) EXPECT_EQ(body, 1u);
  }
}

/// Corners of one density make a flat face, as dark as they are: no darker and no lighter than on
/// lines.
TEST(Drawing, CellsOfASmoothRidgeAreAsDarkAsItsLines) {
  Scene scene;
  add(scene, Frustum{2, 2, 2, 3}, {1, 0, 0}).shading = Shading::smooth;
  scene.camera.from = {0, -45};
  scene.camera.look_at = Vec3(0);
  scene.camera.parallel = true;
  scene.camera.window_width = 4;
  scene.light = Direction{-60, 25};
  const auto cells = cells_of(scene, square_grid(16, 12));
  const auto rows = runs_of(scene, square_grid(16, 12), {});
  int flat = 0;
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (const DensityRun& run : rows[r]) {
      if (run.density0 != run.density1) continue;
      for (int c = static_cast<int>(run.x0) + 2; c + 2 < run.x1; ++c, ++flat)
        EXPECT_NEAR(cells[r][c], run.density0, 1e-6) << r << ' ' << c;
    }
  EXPECT_GT(flat, 20);
}

/// A sheet in the ground's plane and a body through both share their cells as lines do.
TEST(Drawing, CellsOfASheetInTheGroundUnderABodyAreTheMeanOfManyScanLines) {
  Scene scene;
  add(scene, Box{{3, 3, 1}}, {0, 0, 1}).density_factor = 0.5;  // its top lies in the ground
  add(scene, Frustum{2, 1, 4, 4}, {0.4, 0.3, 1}, 17).density_factor = 0.3;
  scene.ground_z = 2;
  scene.light = Direction{45, 35};
  scene.camera.from = {-60, 60};
  expect_mean_of_lines(scene, 4.0 / 256);
}

TEST(Drawing, OneThreadEqualsMany) {
  const Scene scene = crowd(3, 9);
  DrawOptions one, many;
  one.threads = 1, many.threads = 4;
  const Grid grid = square_grid(80, 70);
  EXPECT_EQ(cells_of(scene, grid, one), cells_of(scene, grid, many));
  const auto a = runs_of(scene, grid, {20, 0.7, 0.1}, one),
             b = runs_of(scene, grid, {20, 0.7, 0.1}, many);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_EQ(a[i].size(), b[i].size());
    for (std::size_t k = 0; k < a[i].size(); ++k) EXPECT_TRUE(same(a[i][k], b[i][k]));
  }
}

TEST(Drawing, TheOrderOfBodiesDoesNotMatter) {
  Scene scene = crowd(5, 8);
  const auto before = cells_of(scene, square_grid(50, 40));
  std::reverse(scene.bodies.begin(), scene.bodies.end());
  const auto after = cells_of(scene, square_grid(50, 40));
  for (std::size_t r = 0; r < before.size(); ++r)
    for (std::size_t c = 0; c < before[r].size(); ++c) EXPECT_NEAR(before[r][c], after[r][c], 1e-6);
}

TEST(Drawing, TurnedLinesSeeTheSameArea) {
  for (unsigned seed = 20; seed < 24; ++seed) {
    const Scene scene = crowd(seed, 6);
    const auto length = [&](double angle) {
      double sum = 0;
      for (const auto& row : runs_of(scene, square_grid(60, 50), {angle, 0.05, 0}))
        for (const DensityRun& run : row)
          sum += (run.x1 - run.x0) * 0.05 * (run.density0 + run.density1) / 2;
      return sum;
    };
    const double level = length(0);
    for (const double angle : {45.0, 90.0, -33.0}) EXPECT_NEAR(length(angle), level, level * 2e-3);
  }
}

/// Lines that run backwards end at 0, where the next one starts in its own grid: no run may be
/// carried from line to line.
TEST(Drawing, LinesThatRunBackwardsSeeTheSame) {
  Scene scene;
  look_down(scene, 20, 20);
  add(scene, Box{{30, 30, 1}}, {10, -10, 0});
  for (const double angle : {180.0, -180.0, -90.0, 270.0}) {
    const auto rows = runs_of(scene, square_grid(20, 20), {angle, 1, 0.5});
    SCOPED_TRACE(angle);
    ASSERT_FALSE(rows.empty());
    for (const auto& row : rows) {
      ASSERT_EQ(row.size(), 1u);
      EXPECT_EQ(row[0].x0, -20);
      EXPECT_EQ(row[0].x1, 0);
    }
  }
}

TEST(Drawing, ASinkThatThrowsEndsTheWork) {
  Drawing drawing(crowd(1, 5), square_grid(40, 300), {});
  int rows = 0;
  EXPECT_THROW(drawing.cells([&](const CellRow&) {
    if (++rows == 5) throw WorkError("disk full");
  }),
               WorkError);
  EXPECT_EQ(rows, 5);
  rows = 0;
  drawing.cells([&](const CellRow&) { ++rows; });
  EXPECT_EQ(rows, 300);
}

TEST(Drawing, ASphereIsADisc) {
  Scene scene;
  look_down(scene, 100, 100);
  scene.law.k = 0;
  add(scene, Ellipsoid{Vec3(40)}, {50, -50, 0});
  double area = 0;
  for (const auto& row : cells_of(scene, square_grid(100, 100)))
    for (const float d : row) area += d;
  const double disc = 3.14159265358979 * 40 * 40;
  // Chords lie inside, by the tolerance of 0.05 at most: that ring's area.
  EXPECT_LE(area, disc);
  EXPECT_GE(area, disc - 2 * 3.1416 * 40 * 0.05);
}

}  // namespace
}  // namespace overstrike
