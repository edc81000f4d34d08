// The law: what is drawn of Boolean solids is what the oracle sees. Operands stand on a small
// lattice, so that faces, edges and vertices coincide on purpose.
#include <gtest/gtest.h>

#include "tests/oracle/random_trees.h"
#include "tests/oracle/trial.h"

namespace overstrike::oracle {
namespace {

#ifdef OVERSTRIKE_ORACLE_LONG
constexpr int kTrees = 500;
#else
constexpr int kTrees = 60;
#endif

void judge_trees(TreeMaker::Shapes shapes) {
  int skipped = 0;
  for (int n = 0; n < kTrees; ++n) {
    const Scene scene = TreeMaker(static_cast<std::uint64_t>(n) + 1, shapes).make_lit();
    Trial trial(scene, Grid{32, 40}, 2, "tree " + std::to_string(n));
    trial.judge(kPoints, kEnds);
    skipped += trial.skipped();
  }
  EXPECT_LE(skipped, kMaxSkipped * kPoints * kTrees);
}

TEST(Agreement, RandomTreesOfCoincidentOperands) { judge_trees(TreeMaker::Shapes::convex); }

TEST(Agreement, RandomTreesOfOperandsThatAreNotConvex) { judge_trees(TreeMaker::Shapes::all); }

}  // namespace
}  // namespace overstrike::oracle
