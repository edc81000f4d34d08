// The laws: however a solid is resolved, the same is drawn, to the bit.
#include <gtest/gtest.h>

#include "core/drawing.h"
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

Drawn drawn(const Scene& scene, const DrawOptions& options) {
  Drawn result;
  Drawing drawing(scene, kGrid, options);
  drawing.runs({0, 0.5, 0.25}, [&](const RunRow& row) {
    result.runs.push_back(static_cast<double>(row.index));
    for (const DensityRun& r : row.runs)
      result.runs.insert(result.runs.end(),
                         {r.x0, r.x1, r.density0, r.density1, static_cast<double>(r.surface)});
  });
  result.counts = drawing.timings().solids;
  return result;
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

}  // namespace
}  // namespace overstrike::oracle
