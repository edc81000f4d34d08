// The laws: however a solid is resolved, the same is drawn, to the bit.
#include <gtest/gtest.h>

#include <iomanip>
#include <sstream>

#include "core/drawing.h"
#include "core/visibility/solid_forms.h"
#include "tests/oracle/random_trees.h"

namespace overstrike::oracle {
namespace {

constexpr int kTrees = 200;
constexpr Grid kGrid{32, 40};

struct Drawn {
  std::vector<double> runs;  ///< ends and tones, line after line
  SolidCounts counts;
  bool operator==(const Drawn& other) const { return runs == other.runs; }
};

/// Where operands coincide, which of their edges gives an end may hang on what else is there.
bool same_but_for_rounding(const Drawn& a, const Drawn& b) {
  constexpr double kRounding = 1e-12;
  return std::equal(a.runs.begin(), a.runs.end(), b.runs.begin(), b.runs.end(),
                    [](double x, double y) { return std::fabs(x - y) <= kRounding; });
}

/// Where two differ first, for messages.
std::string difference(const Drawn& a, const Drawn& b) {
  if (a.runs.size() != b.runs.size())
    return std::to_string(a.runs.size()) + " and " + std::to_string(b.runs.size()) + " numbers";
  const auto [at, other] = std::mismatch(a.runs.begin(), a.runs.end(), b.runs.begin());
  if (at == a.runs.end()) return "none";
  std::ostringstream text;
  text << std::setprecision(17) << *at << " and " << *other;
  return text.str();
}

Drawn drawn(const Scene& scene, const DrawOptions& options, double spacing = 0.5) {
  Drawn result;
  Drawing drawing(scene, kGrid, options);
  drawing.runs({0, spacing, spacing / 2}, [&](const RunRow& row) {
    result.runs.push_back(static_cast<double>(row.index));
    for (const DensityRun& r : row.runs)
      result.runs.insert(result.runs.end(),
                         {r.x0, r.x1, r.density0, r.density1, static_cast<double>(r.surface)});
  });
  result.counts = drawing.timings().solids;
  return result;
}

/// Of the scene's solid a union of `nodes` and of X - X for bodies X: nothing, but then each may
/// matter anywhere.
Scene united_with_nothing(const Scene& scene, std::vector<SolidNode> nodes,
                          const std::vector<Index>& bodies) {
  Scene result = scene;
  for (SolidNode& node : nodes) ++node.end;
  nodes.insert(nodes.begin(), {SetOperation::unite, 0, 0});
  for (const Index body : bodies) {
    const auto at = static_cast<Index>(nodes.size());
    const auto copy = static_cast<Index>(result.bodies.size());
    result.bodies.push_back(scene.bodies[body]);
    nodes.insert(nodes.end(), {{SetOperation::subtract, 0, at + 3},
                               {SetOperation::operand, body, at + 2},
                               {SetOperation::operand, copy, at + 3}});
  }
  nodes[0].end = static_cast<Index>(nodes.size());
  result.solids[0].nodes = std::move(nodes);
  return result;
}

/// Copies stand in the tree itself, as a body is an operand once.
Scene with_nothing_of_each(const Scene& scene) {
  Scene copied = scene;
  std::vector<Index> bodies;
  for (SolidNode& node : copied.solids[0].nodes) {
    if (node.operation != SetOperation::operand) continue;
    bodies.push_back(node.body);
    copied.bodies.push_back(scene.bodies[node.body]);
    node.body = static_cast<Index>(copied.bodies.size() - 1);
  }
  return united_with_nothing(copied, copied.solids[0].nodes, bodies);
}

/// The scene with nothing taken from its solid. What is no operand of it any more changes nothing,
/// so that the view stays what it is.
Scene with_nothing_taken(const Scene& scene) {
  const std::vector<SolidNode> kept = uncut(scene.solids[0].nodes);
  std::vector<Index> taken;
  for (Index body = 0; body < scene.bodies.size(); ++body)
    if (std::none_of(kept.begin(), kept.end(), [&](const SolidNode& node) {
          return node.operation == SetOperation::operand && node.body == body;
        }))
      taken.push_back(body);
  return united_with_nothing(scene, kept, taken);
}

TEST(SolidMethods, SumsOfProductsDrawWhatTreesDo) {
  DrawOptions tree, products, few;
  tree.boolean = BooleanForm::tree, products.boolean = BooleanForm::products;
  SolidCounts of_trees, of_products;
  for (int n = 0; n < kTrees; ++n) {
    const Scene scene = TreeMaker(static_cast<std::uint64_t>(n) + 1).make();
    const Drawn by_tree = drawn(scene, tree), by_products = drawn(scene, products);
    ASSERT_EQ(by_products, by_tree) << n << ": " << difference(by_products, by_tree);
    ASSERT_EQ(drawn(scene, few), by_tree) << n;
    of_trees += by_tree.counts, of_products += by_products.counts;
  }
  EXPECT_NE(of_products.updates, of_trees.updates);
}

TEST(SolidMethods, OperandsBeyondWhereTheyMatterChangeNothing) {
  DrawOptions options;
  options.boolean = BooleanForm::tree;
  SolidCounts clipped, whole;
  int same = 0;
  for (int n = 0; n < kTrees; ++n) {
    const Scene scene = TreeMaker(static_cast<std::uint64_t>(n) + 1).make();
    const Drawn one = drawn(scene, options), other = drawn(with_nothing_of_each(scene), options);
    ASSERT_TRUE(same_but_for_rounding(one, other)) << n << ": " << difference(one, other);
    same += one == other;
    clipped += one.counts, whole += other.counts;
  }
  EXPECT_GT(same, kTrees * 9 / 10);
  EXPECT_LT(clipped.flips, whole.flips);
  EXPECT_LT(clipped.spans, whole.spans);
}

/// What is drawn at x, or paper.
double density_at(const std::vector<DensityRun>& runs, double x) {
  for (const DensityRun& r : runs)
    if (r.x0 <= x && x < r.x1)
      return r.density0 + (r.density1 - r.density0) * ((x - r.x0) / (r.x1 - r.x0));
  return 0;
}

std::vector<std::vector<DensityRun>> rows(const Scene& scene, const DrawOptions& options) {
  std::vector<std::vector<DensityRun>> result;
  Drawing drawing(scene, kGrid, options);
  drawing.runs({0, 1, 0.5}, [&](const RunRow& row) {
    result.emplace_back(row.runs.begin(), row.runs.end());
    for (std::size_t i = 1; i < row.runs.size(); ++i)
      EXPECT_LE(row.runs[i - 1].x1, row.runs[i].x0) << "runs are disjoint and sorted";
  });
  return result;
}

TEST(SolidMethods, WhatWasCutAwayIsMixedIntoWhatIsLeft) {
  constexpr double kFactor = 0.25, kRounding = 1e-12;
  DrawOptions solid, mixed;
  mixed.translucent = kFactor;
  Random random(5);
  int as_left = 0, as_mixed = 0;
  for (int n = 0; n < kTrees; ++n) {
    const Scene scene = TreeMaker(static_cast<std::uint64_t>(n) + 1).make();
    const auto left = rows(scene, solid), before = rows(with_nothing_taken(scene), solid),
               both = rows(scene, mixed);
    for (std::size_t row = 0; row < left.size(); ++row)
      for (int i = 0; i < 20; ++i) {
        const double x = random.in(0, kGrid.columns);
        const double s = density_at(left[row], x), w = density_at(before[row], x);
        const double found = density_at(both[row], x), expected = (1 - kFactor) * s + kFactor * w;
        // What is seen of the solid itself may lie as near as what is seen of it uncut.
        const bool is_left = s > 0 && std::fabs(found - s) < kRounding;
        const bool is_mixed = std::fabs(found - expected) < kRounding;
        ASSERT_TRUE(is_left || is_mixed)
            << n << " " << row << " " << x << ": " << found << ", left " << s << ", before " << w;
        as_left += is_left && !is_mixed, as_mixed += is_mixed && !is_left;
      }
  }
  // Where the two have different tones, it is because something was cut away, or by a tie.
  EXPECT_GT(as_mixed, 1000);
  EXPECT_LT(as_left, as_mixed / 5);
}

/// Two random solids that share no plane, the second a background.
Scene before_another(int n) {
  constexpr Vec3 kAside(0.137, -0.291, 0.173);  // off the lattice
  Scene scene = TreeMaker(static_cast<std::uint64_t>(n) + 1).make();
  const Scene other = TreeMaker(static_cast<std::uint64_t>(n) + 1001).make();
  const auto bodies = static_cast<Index>(scene.bodies.size());
  for (Body body : other.bodies) {
    body.placement.offset += kAside;
    scene.bodies.push_back(std::move(body));
  }
  Solid background = other.solids[0];
  for (SolidNode& node : background.nodes)
    if (node.operation == SetOperation::operand) node.body += bodies;
  background.background = true;
  scene.solids.push_back(std::move(background));
  scene.camera.eye.reset(), scene.camera.target.reset();  // caps of a cut would share its plane
  return scene;
}

/// Leaves nothing of it: common with nothing. Its operands stay, and with them the view.
void empty(Solid& solid) {
  std::vector<SolidNode>& nodes = solid.nodes;
  for (SolidNode& node : nodes) node.end += 2;
  nodes.insert(nodes.begin(), {{SetOperation::intersect, 0, 0}, {SetOperation::unite, 0, 2}});
  nodes[0].end = static_cast<Index>(nodes.size());
}

/// By three pictures without backgrounds: of each solid alone, and of both.
TEST(SolidMethods, ABackgroundIsMixedBeforeWhatLiesBehindItAndNothingElse) {
  constexpr double kFactor = 0.25, kRounding = 1e-12;
  Random random(6);
  int mixed = 0, hidden = 0;
  for (int n = 0; n < kTrees; ++n) {
    Scene scene = before_another(n);
    scene.solids[1].translucent = kFactor;
    const auto found = rows(scene, {});
    scene.solids[1].background = false, scene.solids[1].translucent = 0;
    const auto both = rows(scene, {});
    Scene one = scene, other = scene;
    empty(one.solids[1]), empty(other.solids[0]);
    const auto behind = rows(one, {}), before = rows(other, {});
    for (std::size_t row = 0; row < found.size(); ++row)
      for (int i = 0; i < 20; ++i) {
        const double x = random.in(0, kGrid.columns);
        const double s = density_at(behind[row], x), b = density_at(before[row], x);
        // Where both have one tone, so has the mixture.
        const bool is_before = std::fabs(density_at(both[row], x) - s) > kRounding;
        ASSERT_NEAR(density_at(found[row], x), is_before ? (1 - kFactor) * s + kFactor * b : s,
                    kRounding)
            << n << " " << row << " " << x;
        mixed += is_before && s > 0, hidden += b > 0 && !is_before;
      }
  }
  EXPECT_GT(mixed, 500);
  EXPECT_GT(hidden, 500);
}

TEST(SolidMethods, ABackgroundNeitherCastsShadowsNorHasStrokes) {
  for (int n = 0; n < kTrees / 40; ++n) {
    Scene scene = before_another(n);
    scene.light = Direction{30, 40};
    scene.ground_z = -1;
    DrawOptions options;
    const Drawn with = drawn(scene, options);  // of no factor, so that it does not show
    const auto strokes = Drawing(scene, kGrid, options).strokes({});
    Scene without = scene;
    without.solids[1].background = false;
    empty(without.solids[1]);
    EXPECT_TRUE(same_but_for_rounding(with, drawn(without, options))) << n;
    const auto expected = Drawing(without, kGrid, options).strokes({});
    ASSERT_FALSE(strokes.empty());
    ASSERT_EQ(strokes.size(), expected.size()) << n;
    for (std::size_t i = 0; i < strokes.size(); ++i)
      ASSERT_EQ(strokes[i].points.size(), expected[i].points.size()) << n;
  }
}

TEST(SolidMethods, CoherenceChangesTheWorkAndNotThePicture) {
  SolidCounts none, span, behind;
  for (int n = 0; n < kTrees; ++n) {
    const Scene scene = TreeMaker(static_cast<std::uint64_t>(n) + 1).make();
    const auto with = [&](Coherence coherence) {
      DrawOptions options;
      options.coherence = coherence;
      options.threads = 1 + n % 2;
      return drawn(scene, options);
    };
    const Drawn all = with(Coherence::all);
    const Drawn of[] = {with(Coherence::none), with(Coherence::span),
                        with(Coherence::span_and_behind)};
    for (const Drawn& one : of) ASSERT_EQ(one, all) << n;
    none += of[0].counts, span += of[1].counts, behind += of[2].counts;
  }
  EXPECT_EQ(none.spans, span.spans);
  EXPECT_GT(none.crossings, 0u);
  // The expression is followed once a span and once a crossing, or less.
  EXPECT_EQ(none.decisions, none.spans + none.crossings);
  EXPECT_LT(span.decisions, none.decisions);
  EXPECT_LT(behind.decisions, span.decisions);
  EXPECT_LT(behind.updates, none.updates);
}

/// Draws the scene on lines so near to one another that most of what they show is kept from the one
/// before, and each by itself.
void draw_keeping_and_anew(const Scene& scene, int n, SolidCounts& kept, SolidCounts& anew) {
  constexpr double kNear = 1.0 / 32;
  DrawOptions all, behind;
  behind.coherence = Coherence::span_and_behind;
  all.threads = behind.threads = 1;
  const Drawn one = drawn(scene, all, kNear), other = drawn(scene, behind, kNear);
  ASSERT_EQ(one, other) << n << ": " << difference(one, other);
  kept += one.counts, anew += other.counts;
}

TEST(SolidMethods, WhatIsKeptFromLineToLineIsWhatLinesShowByThemselves) {
  SolidCounts kept, anew;
  for (int n = 0; n < kTrees; ++n)
    ASSERT_NO_FATAL_FAILURE(
        draw_keeping_and_anew(TreeMaker(static_cast<std::uint64_t>(n) + 1).make(), n, kept, anew));
  EXPECT_LT(kept.spans, anew.spans / 4);
}

TEST(SolidMethods, ShadowsAreKeptAsLinesShowThemByThemselves) {
  SolidCounts kept, anew;
  for (int n = 0; n < kTrees; ++n)
    ASSERT_NO_FATAL_FAILURE(draw_keeping_and_anew(
        TreeMaker(static_cast<std::uint64_t>(n) + 1).make_lit(), n, kept, anew));
}

}  // namespace
}  // namespace overstrike::oracle
