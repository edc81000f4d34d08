#include "core/scene/solid_expression.h"

#include <gtest/gtest.h>

#include <algorithm>
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

/// X0 op X1 op X2 ..., each X an operand or a small tree, taken together from the right, from the
/// left, or now from here and now from there.
enum class Deep { right, left, mixed };
Nodes random_chain(std::mt19937_64& random, int length, Deep deep, Index operands) {
  Nodes chain = random_tree(random, 1, operands);
  for (int i = 1; i < length; ++i) {
    const Nodes next = random_tree(random, random() % 4 == 0 ? 3 : 0, operands);
    const bool right = deep == Deep::mixed ? random() % 2 == 0 : deep == Deep::right;
    // Differences more often than others: others of one kind become one term.
    const auto operation = static_cast<SetOperation>(1 + std::min<std::uint64_t>(random() % 5, 2));
    chain = tree_of(operation,
                    right ? std::vector<Nodes>{next, chain} : std::vector<Nodes>{chain, next});
  }
  return chain;
}

TEST(SolidExpression, ChainsAreWhatTheirTreesSay) {
  std::mt19937_64 random(12);
  int inside = 0, steps = 0;
  for (const Deep deep : {Deep::right, Deep::left, Deep::mixed})
    for (int n = 0; n < 60; ++n) {
      // Paths within a word of decisive terms, and of several.
      const int length = n % 3 == 0 ? 300 : 30;
      // With few operands each has leaves all over the chain; with many, terms wait for one.
      const Index operands = n % 2 == 0 ? 5 : 100;
      const Nodes tree = random_chain(random, length, deep, operands);
      const SolidExpression expression(tree, operands);
      SolidExpression::State state(expression);
      std::vector<bool> in(operands, false);
      for (int step = 0; step < 100; ++step) {
        const auto operand = static_cast<Index>(random() % operands);
        in[operand] = !in[operand];
        state.flip(operand);
        if (random() % 4 == 0) continue;
        ASSERT_EQ(state.inside(), holds(tree, 0, in)) << n << " " << step;
        inside += state.inside(), ++steps;
      }
    }
  EXPECT_GT(inside, steps / 10);
  EXPECT_LT(inside, steps - steps / 10);
}

/// A0 - (A1 - (A2 - ...)), preorder by hand: composing would take the square of the depth.
Nodes right_deep(Index operands) {
  Nodes nodes;
  for (Index i = 0; i + 1 < operands; ++i) {
    nodes.push_back({SetOperation::subtract, 0, 2 * operands - 1});
    nodes.push_back({SetOperation::operand, i, static_cast<Index>(nodes.size() + 1)});
  }
  nodes.push_back({SetOperation::operand, operands - 1, 2 * operands - 1});
  return nodes;
}

/// A ladder of chains: [A0 - (A1 - ...)] - ([A_m - (A_m+1 - ...)] - (...)), of chains m long.
Nodes chain_of_chains(Index operands, Index m) {
  Nodes chain;
  for (Index first = operands; first > 0; first -= m) {
    Nodes rung = right_deep(m);
    for (SolidNode& node : rung)
      if (node.operation == SetOperation::operand) node.body += first - m;
    chain = chain.empty() ? rung : tree_of(SetOperation::subtract, {rung, chain});
  }
  return chain;
}

/// How often terms count when all operands are entered and left, from the first on, from the last
/// on, and here and there.
std::uint64_t updates_of_passing(const Nodes& tree, Index operands) {
  const SolidExpression expression(tree, operands);
  SolidExpression::State state(expression);
  std::mt19937_64 random(13);
  for (const bool shuffled : {false, true}) {
    std::vector<Index> way;
    for (Index i = 0; i < operands; ++i) way.push_back(i);
    if (shuffled) std::shuffle(way.begin(), way.end(), random);
    for (const bool backwards : {false, true}) {
      if (backwards) std::reverse(way.begin(), way.end());
      for (const bool in : {true, false}) {
        bool inside = false;
        for (const Index i : way) {
          state.flip(i);
          EXPECT_EQ(state.in(i), in);
          inside = state.inside();
        }
        EXPECT_TRUE(in || !inside);
      }
    }
  }
  return state.updates();
}

TEST(SolidExpression, ToPassAChainCostsWhatItIsLongInAnyOrder) {
  constexpr Index kOperands = 1024;
  constexpr double kSlightlyMoreThanTwice = 2.1;
  const auto grows = [](const Nodes& half, const Nodes& whole) {
    return static_cast<double>(updates_of_passing(whole, 2 * kOperands)) /
           static_cast<double>(updates_of_passing(half, kOperands));
  };
  EXPECT_LT(grows(right_deep(kOperands), right_deep(2 * kOperands)), kSlightlyMoreThanTwice);
  EXPECT_LT(grows(chain_of_chains(kOperands, 32), chain_of_chains(2 * kOperands, 32)),
            kSlightlyMoreThanTwice);
  // One term a flip, in each of eight passes.
  EXPECT_EQ(updates_of_passing(right_deep(kOperands), kOperands), 8u * kOperands);
}

TEST(SolidExpression, WhatIsUndoneBeforeItIsAskedCostsNothing) {
  constexpr Index kOperands = 100;
  const Nodes tree = right_deep(kOperands);
  const SolidExpression expression(tree, kOperands);
  SolidExpression::State state(expression);
  for (Index i = 0; i < kOperands; ++i) state.flip(i);
  EXPECT_FALSE(state.inside());
  EXPECT_EQ(state.updates(), kOperands);
  for (Index i = 0; i < kOperands; ++i) state.flip(i);
  for (Index i = 1; i < kOperands; ++i) state.flip(i);
  EXPECT_FALSE(state.inside());
  EXPECT_EQ(state.updates(), kOperands + 1);
  state.flip(0), state.flip(kOperands - 1);
  EXPECT_TRUE(state.inside());
  EXPECT_EQ(state.updates(), kOperands + 3);
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

TEST(SolidExpression, GoesAsDeepAsMemoryDoes) {
  constexpr Index kDepth = 100'000;
  const Nodes nodes = right_deep(kDepth);
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
}

}  // namespace
}  // namespace overstrike
