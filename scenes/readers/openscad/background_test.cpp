// What is marked by %: shown, and no part of anything.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "scenes/readers/openscad/bodies.h"
#include "scenes/readers/openscad/scene.h"

namespace overstrike::openscad {
namespace {

using testing::HasSubstr;

ReadResult read(const std::string& text) { return read_scene(text, "m.csg", "/nonexistent"); }

constexpr const char* kAt123 =
    "multmatrix([[1, 0, 0, 1], [0, 1, 0, 2], [0, 0, 1, 3], [0, 0, 0, 1]]) ";

std::size_t operands(const Solid& solid) {
  return static_cast<std::size_t>(
      std::count_if(solid.nodes.begin(), solid.nodes.end(),
                    [](const SolidNode& node) { return node.operation == SetOperation::operand; }));
}

const Body& first_operand(const Scene& scene, const Solid& solid) {
  for (const SolidNode& node : solid.nodes)
    if (node.operation == SetOperation::operand) return scene.bodies.at(node.body);
  throw std::out_of_range("no operand");
}

TEST(CsgBackground, IsASolidOfItsOwnWhereItStands) {
  const Scene scene =
      read("difference() { cube(); " + std::string(kAt123) + "{ %sphere(); cylinder(); } cube(); }")
          .scene;
  ASSERT_EQ(scene.solids.size(), 2u);
  EXPECT_FALSE(scene.solids[0].background);
  EXPECT_EQ(operands(scene.solids[0]), 3u);
  EXPECT_TRUE(scene.solids[1].background);
  EXPECT_EQ(scene.solids[1].translucent, 0.5);
  EXPECT_EQ(operands(scene.solids[1]), 1u);
  EXPECT_EQ(first_operand(scene, scene.solids[1]).placement.offset, Vec3(1, 2, 3));
}

TEST(CsgBackground, AFirstChildIsNotWhatOthersAreTakenFrom) {
  const Scene scene = read("difference() { %cube(); sphere(); cylinder(); }").scene;
  ASSERT_EQ(scene.solids.size(), 2u);
  EXPECT_EQ(operands(scene.solids[0]), 2u);
  EXPECT_EQ(scene.solids[0].nodes[0].operation, SetOperation::subtract);
}

TEST(CsgBackground, KeepsItsSetOperations) {
  const Scene scene = read("%group() { difference() { cube(); sphere(); } cylinder(); }").scene;
  ASSERT_EQ(scene.solids.size(), 1u);
  EXPECT_EQ(scene.bodies.size(), 3u);
  ASSERT_EQ(scene.solids[0].nodes.size(), 5u);
  EXPECT_EQ(scene.solids[0].nodes[0].operation, SetOperation::unite);
  EXPECT_EQ(scene.solids[0].nodes[1].operation, SetOperation::subtract);
}

TEST(CsgBackground, WithinABackgroundStandsForItself) {
  const Scene scene = read("%difference() { sphere(); " + std::string(kAt123) +
                           "{ %group() { %sphere(); sphere(); } } }")
                          .scene;
  ASSERT_EQ(scene.solids.size(), 3u);
  for (const Solid& solid : scene.solids) {
    EXPECT_TRUE(solid.background);
    EXPECT_EQ(operands(solid), 1u);
  }
  EXPECT_EQ(first_operand(scene, scene.solids[0]).placement.offset.x, 0);
  EXPECT_EQ(first_operand(scene, scene.solids[2]).placement.offset.x, 1);
}

TEST(CsgBackground, IsGreyWhereNothingAboveColoursIt) {
  const Scene scene = read("color([1, 0, 0, 1]) { %cube(); } %sphere(); cylinder();").scene;
  ASSERT_EQ(scene.solids.size(), 2u);
  EXPECT_DOUBLE_EQ(first_operand(scene, scene.solids[0]).density_factor, density_of({1, 0, 0}));
  EXPECT_DOUBLE_EQ(first_operand(scene, scene.solids[1]).density_factor,
                   density_of(Vec3(180.0 / 255)));
  EXPECT_EQ(scene.bodies[0].density_factor, 1);
}

TEST(CsgBackground, OfOneShapeOrOfManyIsTheirUnion) {
  const Scene scene =
      read("%linear_extrude(height = 2) { square(); } %hull() { cube(); sphere(); }").scene;
  ASSERT_EQ(scene.solids.size(), 2u);
  for (const Solid& solid : scene.solids) EXPECT_EQ(operands(solid), 1u);
}

TEST(CsgBackground, IsNoPartOfAShapeThatIsMade) {
  const ReadResult made = read("hull() { cube(); %sphere(); } %square(); *%cube(); %*cube();");
  EXPECT_TRUE(made.scene.solids.empty());
  ASSERT_EQ(made.warnings.size(), 2u);
  EXPECT_EQ(made.warnings[0].message,
            "'%sphere' is left out: it is no part of the shape that is made here");
  EXPECT_EQ(made.warnings[1].message, "'%square' is left out: a flat background is not drawn");
}

TEST(CsgBackground, ThatCannotBeDrawnLeavesTheModel) {
  for (const char* const bad :
       {"%roof() { square(); }", "%import(file = \"none.stl\");", "%sphere(r = \"a\");"}) {
    const ReadResult result = read(std::string("cube(); %cube(); ") + bad);
    EXPECT_EQ(result.scene.bodies.size(), 1u) << bad;
    EXPECT_TRUE(result.scene.solids.empty()) << bad;
    ASSERT_EQ(result.warnings.size(), 1u) << bad;
    EXPECT_EQ(result.warnings[0].severity, Severity::warning);
    EXPECT_THAT(result.warnings[0].message, HasSubstr("the background (%) is left out: "));
  }
}

}  // namespace
}  // namespace overstrike::openscad
