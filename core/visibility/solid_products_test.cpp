#include "core/visibility/solid_products.h"

#include <gtest/gtest.h>

#include <random>

#include "core/visibility/operand_reach.h"
#include "core/visibility/test_scenes.h"

namespace overstrike {
namespace {

using testing::operand_tree;
using testing::random_tree;
using testing::tree_of;
using Nodes = std::vector<SolidNode>;

constexpr SetOperation kUnite = SetOperation::unite, kSubtract = SetOperation::subtract,
                       kIntersect = SetOperation::intersect;

WorldBox cube(double low, double high) { return {Vec3(low), Vec3(high)}; }

/// All in one place.
std::vector<WorldBox> together(Index operands) {
  return std::vector<WorldBox>(operands, cube(0, 1));
}

SolidProducts products_of(const Nodes& nodes, const std::vector<WorldBox>& bounds) {
  const SolidExpression expression(nodes, static_cast<Index>(bounds.size()));
  return SolidProducts::of(expression, bounds).value();
}

TEST(SolidProducts, AreTheSetThatTheTreeIs) {
  constexpr Index kOperands = 6;
  std::mt19937_64 random(3);
  int inside = 0;
  for (int n = 0; n < 500; ++n) {
    const Nodes tree = random_tree(random, 4, kOperands);
    const SolidExpression expression(tree, kOperands);
    const SolidProducts products = products_of(tree, together(kOperands));
    const SolidExpression sum(products.nodes(), kOperands);
    SolidExpression::State of_tree(expression), of_sum(sum);
    for (int step = 0; step < 60; ++step) {
      const auto operand = static_cast<Index>(random() % kOperands);
      of_tree.flip(operand), of_sum.flip(operand);
      ASSERT_EQ(of_tree.inside(), of_sum.inside()) << n << " " << step;
      inside += of_tree.inside();
    }
  }
  EXPECT_GT(inside, 3000);
}

TEST(SolidProducts, ManyDifferencesOfOneOperandAreTwoProducts) {
  constexpr Index kOperands = 200;
  const SolidProducts products =
      products_of(testing::differences_of_one(kOperands), together(kOperands));
  ASSERT_EQ(products.products().size(), 2u);
  EXPECT_EQ(products.products()[0], (SolidProducts::Product{{0, false}, {1, true}}));
  EXPECT_EQ(products.products()[1].size(), kOperands - 1);
}

Nodes nested_differences(Index n) {
  std::vector<Nodes> members{operand_tree(0)};
  for (Index i = 0; i < n; ++i)
    members.push_back(tree_of(kSubtract, {operand_tree(2 * i + 1), operand_tree(2 * i + 2)}));
  return tree_of(kSubtract, members);
}

TEST(SolidProducts, HaveALimit) {
  const SolidProducts ten = products_of(nested_differences(10), together(21));
  EXPECT_EQ(ten.products().size(), 1024u);
  EXPECT_EQ(ten.elements(), 11264u);
  const SolidExpression eleven(nested_differences(11), 23);
  EXPECT_FALSE(SolidProducts::of(eleven, together(23)));
}

TEST(SolidProducts, LeaveOutWhatCannotBe) {
  const Nodes a = operand_tree(0), b = operand_tree(1);
  EXPECT_TRUE(products_of(tree_of(kIntersect, {tree_of(kSubtract, {a, b}), b}), together(2))
                  .products()
                  .empty())
      << "an operand and its complement";
  const std::vector<WorldBox> apart{cube(0, 1), cube(2, 3)}, touching{cube(0, 1), cube(1, 2)};
  EXPECT_TRUE(products_of(tree_of(kIntersect, {a, b}), apart).products().empty());
  EXPECT_EQ(products_of(tree_of(kSubtract, {a, b}), apart).elements(), 1u);
  EXPECT_EQ(products_of(tree_of(kIntersect, {a, b}), touching).elements(), 2u)
      << "faces of one plane are counted together";
}

TEST(OperandReach, IsWhereAllElseMayHold) {
  const std::vector<WorldBox> bounds{cube(0, 4), cube(3, 9), cube(1, 5)};
  const auto reach_in = [&](const Nodes& nodes) {
    std::vector<WorldBox> reach(bounds.size());
    add_reach(nodes, bounds, reach);
    return reach;
  };
  const Nodes a = operand_tree(0), b = operand_tree(1), c = operand_tree(2);
  const auto is = [](const WorldBox& box, const WorldBox& other) {
    return box.low == other.low && box.high == other.high;
  };
  const auto taken = reach_in(tree_of(kSubtract, {a, b, c}));
  EXPECT_TRUE(is(taken[0], WorldBox::everything()));
  EXPECT_TRUE(is(taken[1], bounds[0]) && is(taken[2], bounds[0]));
  const auto common_to_all = reach_in(tree_of(kIntersect, {a, b, c}));
  EXPECT_TRUE(is(common_to_all[0], cube(3, 5)));
  EXPECT_TRUE(is(common_to_all[1], cube(1, 4)));
  const auto united = reach_in(tree_of(kUnite, {tree_of(kIntersect, {a, b}), c}));
  EXPECT_TRUE(is(united[0], bounds[1]) && is(united[2], WorldBox::everything()));
  EXPECT_TRUE(reach_in(tree_of(kUnite, {a}))[1].empty()) << "it is no operand";
}

}  // namespace
}  // namespace overstrike
