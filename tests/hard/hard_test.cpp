// The law: what is drawn of every hard case, in every pose, is what the oracle sees.
#include <gtest/gtest.h>

#include "tests/hard/corpus.h"
#include "tests/hard/variant.h"
#include "tests/oracle/trial.h"

namespace overstrike::hard {
namespace {

using oracle::Effort;
using oracle::Trial;

#ifdef OVERSTRIKE_HARD_LONG
constexpr std::size_t kPosesOfCase = 96;
constexpr Effort kEffort{60, 20, 60, 40};
constexpr std::size_t kMostBodies = 1'000'000, kLeastPoses = 16;
#else
constexpr std::size_t kPosesOfCase = 8;
constexpr Effort kEffort{30, 8, 30, 20};
constexpr std::size_t kMostBodies = 10'000, kLeastPoses = 1;
#endif
constexpr int kLinesThroughVertices = 6;
/// The oracle looks at every face for every point: cases of more faces than this get as much fewer
/// points and poses.
constexpr std::size_t kManyFaces = 2000;

/// Rows, rows on whole numbers, columns on whole numbers, and slanted lines.
constexpr ScanFamily kFamilies[] = {{0, 1, 0.5}, {0, 1, 0}, {90, 1, -32}, {33, 5.3, 0.71}};

int share(int count, std::size_t faces) {
  const std::size_t less = std::max<std::size_t>(1, faces / kManyFaces);
  return std::max(1, count / static_cast<int>(less));
}

Effort effort_for(std::size_t faces) {
  return {share(kEffort.points, faces), share(kEffort.ends, faces), share(kEffort.gaps, faces),
          share(kEffort.beside, faces)};
}

/// As many poses as the case can afford: as it stands, then seeded ones.
std::vector<Variant> poses_for(const Case& hard, std::size_t faces) {
  const auto& all = all_variants();
  const std::size_t count =
      std::max(kLeastPoses, static_cast<std::size_t>(share(kPosesOfCase, faces)));
  if (count >= all.size()) return all;
  std::vector<Variant> chosen{all.front()};
  std::seed_seq seed(hard.name.begin(), hard.name.end());
  std::mt19937_64 bits(seed);
  while (chosen.size() < count) chosen.push_back(all[bits() % all.size()]);
  return chosen;
}

void expect_warnings(const Case& hard, const std::vector<Diagnostic>& warnings) {
  for (const std::string& text : hard.warns)
    EXPECT_TRUE(
        std::any_of(warnings.begin(), warnings.end(),
                    [&](const Diagnostic& d) { return d.message.find(text) != std::string::npos; }))
        << hard.name << ": no warning says '" << text << "'";
  if (!hard.warns.empty()) return;
  for (const Diagnostic& d : warnings) ADD_FAILURE() << hard.name << " warns: " << d.message;
}

/// Of the points chosen where a case is hard, so many may lie so near an edge that either side is
/// right.
constexpr double kMostSkipped = 0.1;

/// The number of points that were skipped.
int judge(const Case& hard, const Variant& variant, const Effort& effort) {
  Trial trial(posed(hard.scene, variant), kGrid, kTolerance, hard.name + ", " + describe(variant),
              kFamilies, kLinesThroughVertices);
  expect_warnings(hard, trial.warnings());
  for (const std::string& failure : trial.judge(effort)) ADD_FAILURE() << failure;
  return trial.skipped();
}

class HardCase : public testing::TestWithParam<std::string> {};

TEST_P(HardCase, IsWhatTheOracleSees) {
  const Case& hard = find_case(GetParam());
  if (hard.scene.bodies.size() > kMostBodies) GTEST_SKIP() << "only in the long test";
  const std::size_t faces = face_count(hard);
  const Effort effort = effort_for(faces);
  int skipped = 0, points = 0;
  for (const Variant& variant : poses_for(hard, faces)) {
    skipped += judge(hard, variant, effort);
    points += effort.points + effort.gaps + effort.beside;
  }
  EXPECT_LE(skipped, kMostSkipped * points);
}

std::vector<std::string> names() {
  std::vector<std::string> all;
  for (const Case& c : corpus()) all.push_back(c.name);
  return all;
}

INSTANTIATE_TEST_SUITE_P(Corpus, HardCase, testing::ValuesIn(names()), [](const auto& named) {
  std::string name = named.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace overstrike::hard
