// The volume of what is drawn. A near plane cuts a solid open and shows its section, so that the
// lengths of the cut runs, over all lines and over near planes one behind the other, add up to the
// solid's volume (Cavalieri). That asks for nothing that drawing does not do, counts every stretch
// inside along depth, however many there are, and takes caps into the bargain.
//
// What makes an error shrinks with the cells: facets lie up to the tolerance (a part of a cell) off
// the surface, and lines and near planes, a cell apart, miss what is between them.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "core/drawing.h"
#include "core/visibility/test_scenes.h"

namespace overstrike {
namespace {

using testing::operand_tree;
using testing::tree_of;

#ifdef OVERSTRIKE_ORACLE_LONG
constexpr int kMostCells = 192;
#else
constexpr int kMostCells = 48;
#endif

constexpr double kPi = std::numbers::pi;
/// Of the window, which every solid here fits in, across and in depth.
constexpr double kWindow = 4;

struct Operand {
  Shape shape;
  Vec3 at;
  bool lies_along_x = false;  ///< instead of standing on z = 0
};

struct Known {
  const char* name;
  SetOperation operation;
  std::vector<Operand> operands;
  double volume;
  double curved;     ///< area of faces that facets stand for
  double curvature;  ///< the largest radius of the sections' ends; 0: they have corners only
};

Shape cylinder(double radius, double height) { return Frustum{radius, radius, height, 0}; }
Shape ball(double radius) { return Ellipsoid{Vec3(radius)}; }
Shape block(double x, double y, double z) { return Box{Vec3(x, y, z)}; }

const std::vector<Known>& known_solids() {
  constexpr SetOperation kUnite = SetOperation::unite, kSubtract = SetOperation::subtract,
                         kIntersect = SetOperation::intersect;
  static const std::vector<Known> all = {
      {"a box less a cylinder",
       kSubtract,
       {{block(2, 2, 1), Vec3(0)}, {cylinder(0.6, 1), Vec3(0)}},
       4 - 0.36 * kPi,
       1.2 * kPi,
       0.6},
      {"a ball less the box that has an eighth of it",
       kSubtract,
       {{ball(1), Vec3(0)}, {block(1, 1, 1), Vec3(0.5, 0.5, 0)}},
       7 / 6.0 * kPi,
       3.5 * kPi,
       1},
      {"two cylinders that cross",
       kIntersect,
       {{cylinder(0.8, 2), Vec3(0, 0, -1)}, {cylinder(0.8, 2), Vec3(-1, 0, 0), true}},
       16 / 3.0 * 0.512,
       16 * 0.64,
       0.8},
      {"a lens of two balls",
       kIntersect,
       {{ball(1), Vec3(0, 0, -0.5)}, {ball(1), Vec3(0, 0, 0.5)}},
       5 / 12.0 * kPi,
       2 * kPi,
       1},
      {"two balls that share a lens",
       kUnite,
       {{ball(0.9), Vec3(0, 0, -0.45)}, {ball(0.9), Vec3(0, 0, 0.45)}},
       0.729 * (8 / 3.0 - 5 / 12.0) * kPi,
       6 * 0.81 * kPi,
       0.9},
      {"a box of many slots",
       kSubtract,
       {{block(2, 2, 2), Vec3(0, 0, -1)},
        {block(0.2, 2, 1.5), Vec3(-0.6, 0, -0.5)},
        {block(0.2, 2, 1.5), Vec3(0, 0, -0.5)},
        {block(0.2, 2, 1.5), Vec3(0.6, 0, -0.5)},
        {block(2, 0.3, 0.3), Vec3(0, 0, -1)}},
       8 - 1.8 - 0.18,
       0,
       0}};
  return all;
}

Scene scene_of(const Known& known) {
  Scene scene;
  std::vector<std::vector<SolidNode>> trees;
  for (const Operand& operand : known.operands) {
    Body& body = testing::add(scene, operand.shape, operand.at);
    if (operand.lies_along_x) body.placement.linear = {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
    trees.push_back(operand_tree(static_cast<std::uint32_t>(trees.size())));
  }
  scene.solids.push_back({tree_of(known.operation, trees), {}, {}});
  scene.camera.parallel = true;
  scene.camera.window_width = kWindow;
  scene.camera.target = Vec3(0.0);
  // In no simple ratio to the axes.
  scene.camera.eye = Vec3(3.1, -2.3, 1.7);
  return scene;
}

/// With so many cells across the window, lines and near planes.
double drawn_volume(const Known& known, int cells) {
  Scene scene = scene_of(known);
  const Vec3 eye = *scene.camera.eye;
  const double distance = std::sqrt(glm::dot(eye, eye)), step = kWindow / cells;
  double volume = 0;
  for (int i = 0; i < cells; ++i) {
    scene.camera.near_distance = distance - kWindow / 2 + (i + 0.5) * step;
    DrawOptions options;
    options.threads = 1;
    Drawing drawing(scene, testing::square_grid(cells, cells), options);
    drawing.runs({0, 1, 0.5}, [&](const RunRow& row) {
      for (const DensityRun& run : row.runs)
        if (run.kind == Kind::cut) volume += (run.x1 - run.x0) * step * step * step;
    });
  }
  return volume;
}

/// A section's length along a line is at its ends like the square root of 2 R y, twice; the sum of
/// midpoints misses zeta(-1/2) = 0.208 of that times the step's power 3/2, at worst; where the
/// section has corners, and over near planes, what is missed is of the step's square. A section has
/// two ends, near planes meet it over no more than 3 of the window.
double largest_error(const Known& known, double step, double tolerance) {
  const double ends = 2 * 0.208 * 2 * std::sqrt(2 * known.curvature) * std::pow(step, 1.5);
  constexpr double kSquares = 3;
  return known.curved * tolerance * step + 3 * ends + kSquares * step * step;
}

TEST(SolidVolume, IsWhatIsKnownOfIt) {
  for (const Known& known : known_solids())
    for (int cells = 12; cells <= kMostCells; cells *= 2) {
      const double volume = drawn_volume(known, cells);
      const double most = largest_error(known, kWindow / cells, DrawOptions{}.tolerance);
      EXPECT_NEAR(volume, known.volume, most) << known.name << " of " << cells << " cells";
    }
}

/// Facets' error falls as the cells' size, the others faster.
TEST(SolidVolume, ComesNearerByAQuarterWithFourTimesTheCells) {
  constexpr int kCells = kMostCells / 4;
  double coarse = 0, fine = 0;
  for (const Known& known : known_solids()) {
    coarse += std::fabs(drawn_volume(known, kCells) - known.volume) / known.volume;
    fine += std::fabs(drawn_volume(known, 4 * kCells) - known.volume) / known.volume;
  }
  constexpr double kLuck = 1.25;  // six solids on one lattice
  EXPECT_LT(fine, kLuck / 4 * coarse);
  RecordProperty("relative_error", std::to_string(fine / 6));
}

}  // namespace
}  // namespace overstrike
