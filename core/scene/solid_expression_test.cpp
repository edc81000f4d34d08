#include "core/scene/solid_expression.h"

#include <gtest/gtest.h>

#include <random>

#include "core/visibility/test_scenes.h"

namespace overstrike {
namespace {

using testing::operand_tree;
using testing::tree_of;
using Nodes = std::vector<SolidNode>;

/// The definition.
bool holds(const Nodes& nodes, Index at, const std::vector<bool>& in) {
  const SolidNode& n = nodes[at];
  if (n.operation == SetOperation::operand) return in[n.body];
  std::vector<bool> values;
  for (Index i = at + 1; i < n.end; i = nodes[i].end) values.push_back(holds(nodes, i, in));
  if (values.empty()) return false;
  bool result = values[0];
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (n.operation == SetOperation::unite) result = result || values[i];
    if (n.operation == SetOperation::subtract) result = result && !values[i];
    if (n.operation == SetOperation::intersect) result = result && values[i];
  }
  return result;
}

Nodes random_tree(std::mt19937_64& random, int depth, Index operands) {
  const auto below = [&](std::size_t n) { return random() % n; };
  if (depth == 0 || below(4) == 0) return operand_tree(static_cast<Index>(below(operands)));
  std::vector<Nodes> members;
  for (std::size_t i = below(8) == 0 ? 0 : 1 + below(3); i > 0; --i)
    members.push_back(random_tree(random, depth - 1, operands));
  return tree_of(static_cast<SetOperation>(1 + below(3)), members);
}

TEST(SolidExpression, IsWhatItsTreeSaysWhereverOnTheWay) {
  std::mt19937_64 random(11);
  constexpr Index kOperands = 7;
  int inside = 0;
  for (int n = 0; n < 500; ++n) {
    const Nodes tree = random_tree(random, 5, kOperands);
    const SolidExpression expression(tree, kOperands);
    SolidExpression::State state(expression);
    std::vector<bool> in(kOperands, false);
    EXPECT_FALSE(state.inside());
    for (int step = 0; step < 60; ++step) {
      const auto operand = static_cast<Index>(random() % kOperands);
      in[operand] = !in[operand];
      state.flip(operand);
      ASSERT_EQ(state.inside(), holds(tree, 0, in)) << n << " " << step;
      inside += state.inside();
    }
  }
  EXPECT_GT(inside, 3000);
}

TEST(SolidExpression, NestedUnionsAndDifferencesAreOneTerm) {
  constexpr Index kOperands = 50;
  Nodes chain = operand_tree(0);
  for (Index i = 1; i < kOperands; ++i)
    chain = tree_of(i % 2 != 0 ? SetOperation::subtract : SetOperation::intersect,
                    {chain, operand_tree(i)});
  EXPECT_EQ(SolidExpression(chain, kOperands).terms(), 1u);
  Nodes tools = operand_tree(1);
  for (Index i = 2; i < kOperands; ++i)
    tools = tree_of(SetOperation::unite, {operand_tree(i), tools});
  EXPECT_EQ(
      SolidExpression(tree_of(SetOperation::subtract, {operand_tree(0), tools}), kOperands).terms(),
      1u);
}

/// A0 - (A1 - (A2 - ...)), preorder by hand: composing would take the square of the depth.
TEST(SolidExpression, GoesAsDeepAsMemoryDoes) {
  constexpr Index kDepth = 100'000;
  Nodes nodes;
  for (Index i = 0; i + 1 < kDepth; ++i) {
    nodes.push_back({SetOperation::subtract, 0, 2 * kDepth - 1});
    nodes.push_back({SetOperation::operand, i, static_cast<Index>(nodes.size() + 1)});
  }
  nodes.push_back({SetOperation::operand, kDepth - 1, 2 * kDepth - 1});
  const SolidExpression expression(nodes, kDepth);
  SolidExpression::State state(expression);
  state.flip(kDepth - 1);
  EXPECT_FALSE(state.inside());
  for (Index i = kDepth - 1; i-- > 0;) state.flip(i);
  // Inside of all: A0 - (A1 - ...) with an even number of sets is empty there.
  EXPECT_FALSE(state.inside());
  state.flip(kDepth - 1);
  EXPECT_TRUE(state.inside());
}

TEST(SolidExpression, LeavesOfOneOperandAreOneSet) {
  const Nodes nothing = tree_of(SetOperation::subtract, {operand_tree(0), operand_tree(0)});
  const SolidExpression expression(nothing, 1);
  SolidExpression::State state(expression);
  state.flip(0);
  EXPECT_FALSE(state.inside());
}

TEST(SolidExpression, NodesWithoutOperandsAreEmpty) {
  const Nodes empty = tree_of(SetOperation::intersect, {});
  for (const SetOperation operation :
       {SetOperation::unite, SetOperation::subtract, SetOperation::intersect}) {
    const SolidExpression expression(tree_of(operation, {operand_tree(0), empty}), 1);
    SolidExpression::State state(expression);
    state.flip(0);
    EXPECT_EQ(state.inside(), operation != SetOperation::intersect);
  }
}

TEST(SolidExpression, AnOperandWithoutLeavesChangesNothing) {
  const SolidExpression expression(tree_of(SetOperation::unite, {operand_tree(1)}), 3);
  SolidExpression::State state(expression);
  state.flip(0), state.flip(2);
  EXPECT_FALSE(state.inside());
  state.flip(1);
  EXPECT_TRUE(state.inside());
  for (Index operand = 0; operand < 3; ++operand) EXPECT_EQ(expression.last_term(operand), 0u);
}

}  // namespace
}  // namespace overstrike
