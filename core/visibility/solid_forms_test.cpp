#include "core/visibility/solid_forms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <random>

#include "core/visibility/test_scenes.h"

namespace overstrike {
namespace {

using testing::operand_tree;
using testing::random_tree;
using testing::tree_of;
using Nodes = std::vector<SolidNode>;

constexpr SetOperation kUnite = SetOperation::unite, kSubtract = SetOperation::subtract;

std::vector<WorldBox> together(Index operands) {
  return std::vector<WorldBox>(operands, {Vec3(0), Vec3(1)});
}

/// One operand in each place.
std::vector<WorldBox> apart(Index operands) {
  std::vector<WorldBox> bounds;
  for (Index i = 0; i < operands; ++i)
    bounds.push_back({Vec3(2.0 * i, 0, 0), Vec3(2.0 * i + 1, 1, 1)});
  return bounds;
}

Nodes unite(Index first, Index end) {
  std::vector<Nodes> members;
  for (Index i = first; i < end; ++i) members.push_back(operand_tree(i));
  return tree_of(kUnite, members);
}

TEST(MostUpdates, AreReachedAndNeverPassed) {
  constexpr Index kOperands = 6;
  std::mt19937_64 random(7);
  int reached = 0;
  for (int n = 0; n < 1000; ++n) {
    const SolidExpression tree(random_tree(random, 4, kOperands), kOperands);
    std::array<Index, kOperands> order;
    std::iota(order.begin(), order.end(), 0);
    std::shuffle(order.begin(), order.end(), random);
    SolidExpression::State state(tree);
    for (const Index operand : order) state.flip(operand);
    ASSERT_LE(state.updates(), most_updates(tree, tree)) << n;
    reached += state.updates() == most_updates(tree, tree);
  }
  EXPECT_GT(reached, 100);
}

TEST(FewerUpdates, AreWhereAnOperandStandsInManyPlaces) {
  constexpr Index kOperands = 20;
  const SolidExpression tree(testing::differences_of_one(kOperands), kOperands);
  const auto sum = fewer_updates(tree, together(kOperands));
  ASSERT_TRUE(sum);
  EXPECT_LT(most_updates(*sum, *sum), most_updates(tree, tree));
}

TEST(FewerUpdates, AreWhereATreeIsDeepAndProductsAreFew) {
  // (((A - B) + C) - D) + ...: the holes B, D, ... each in the bar before it.
  constexpr Index kBars = 8;
  Nodes tree = operand_tree(0);
  std::vector<WorldBox> bounds = apart(kBars);
  for (Index i = 0; i < kBars; ++i) {
    if (i > 0) tree = tree_of(kUnite, {tree, operand_tree(i)});
    tree = tree_of(kSubtract, {tree, operand_tree(kBars + i)});
    bounds.push_back(bounds[i]);
  }
  EXPECT_TRUE(fewer_updates(SolidExpression(tree, 2 * kBars), bounds));
}

TEST(FewerUpdates, AreNotWhereAnOperandComesIntoMoreProducts) {
  // (A + B + C) - D, and what of many lies in one: most of them are left out, but the one is in
  // every product that is left.
  const SolidExpression cut(tree_of(kSubtract, {unite(0, 3), operand_tree(3)}), 4);
  EXPECT_FALSE(fewer_updates(cut, together(4)));
  std::vector<WorldBox> bounds = apart(10);
  bounds.push_back({Vec3(0), Vec3(6, 1, 1)});
  const SolidExpression within(tree_of(SetOperation::intersect, {unite(0, 10), operand_tree(10)}),
                               11);
  EXPECT_FALSE(fewer_updates(within, bounds));
  std::vector<Nodes> drilled;
  for (Index i = 0; i < 5; ++i)
    drilled.push_back(tree_of(kSubtract, {operand_tree(2 * i), operand_tree(2 * i + 1)}));
  const SolidExpression deeper(
      tree_of(SetOperation::intersect, {tree_of(kUnite, drilled), operand_tree(10)}), 11);
  EXPECT_FALSE(fewer_updates(deeper, together(11)));
}

TEST(HasFewUpdates, TellsWhereNoneAreLookedFor) {
  const Nodes a = operand_tree(0), b = operand_tree(1), c = operand_tree(2);
  const auto has_few = [](const Nodes& nodes) {
    return has_few_updates(SolidExpression(nodes, 3));
  };
  EXPECT_TRUE(has_few(tree_of(kUnite, {tree_of(kSubtract, {a, b}), tree_of(kSubtract, {c, b})})));
  EXPECT_TRUE(has_few(tree_of(kSubtract, {tree_of(kUnite, {a, b}), c})));
  EXPECT_FALSE(has_few(tree_of(kSubtract, {tree_of(kUnite, {a, b}), tree_of(kSubtract, {c, b})})));
  EXPECT_FALSE(has_few(tree_of(kSubtract, {tree_of(kUnite, {tree_of(kSubtract, {a, b}), c}), b})));
}

}  // namespace
}  // namespace overstrike
