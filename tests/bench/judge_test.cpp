// The yardstick measures rightly, and who judges can find fault.
#include "tests/bench/judge.h"

#include <gtest/gtest.h>

#include "tests/bench/run_ends.h"
#include "tests/bench/z_buffer.h"

namespace overstrike::bench {
namespace {

constexpr int kSize = 64;

/// Scene C at all rows of a small grid, as both see it.
struct Picture {
  Prepared prepared = prepare(scene_c(0), square_grid(kSize));
  std::vector<int> rows;
  std::vector<std::vector<DensityRun>> runs;
  std::vector<Shown> ours, z_buffer;

  Picture() {
    for (int row = 0; row < kSize; ++row) rows.push_back(row);
    runs = runs_of_rows(prepared, rows);
    const Triangles triangles = triangles_of(*prepared.canonical);
    ZBuffer buffer(triangles, prepared.view, 1);
    for (int row = 0; row < kSize; ++row) {
      ours.push_back(shown_by(runs[static_cast<std::size_t>(row)], kSize));
      z_buffer.emplace_back();
      for (const std::uint32_t t : buffer.row(row))
        z_buffer.back().push_back(t == kNothing ? kNone : triangles.faces[t]);
    }
  }
};

TEST(Judge, FindsNoFaultWhereThereIsNone) {
  const Picture p;
  EXPECT_EQ(wrong_ppm(p.prepared, p.rows, {p.ours, p.z_buffer}), (std::vector<double>{0, 0}));
  EXPECT_LT(worst_run_end(p.prepared, p.rows, p.runs), 1e-10);
}

TEST(Judge, CountsEveryWrongCell) {
  Picture p;
  for (std::size_t i = 0; i < 10; ++i)
    ++p.z_buffer[3 * i][5 * i];  // the next face; of paper, the first
  const std::vector<double> wrong = wrong_ppm(p.prepared, p.rows, {p.ours, p.z_buffer});
  EXPECT_EQ(wrong[0], 0);
  EXPECT_DOUBLE_EQ(wrong[1], 10e6 / (kSize * kSize));
}

TEST(Judge, FindsFaultWithWhatAllAgreeOn) {
  Picture p;
  for (Shown& row : p.ours)
    for (Index& face : row) face = 0;
  EXPECT_GT(wrong_ppm(p.prepared, p.rows, {p.ours, p.ours})[0], 0.9e6);
}

TEST(Judge, MeasuresHowFarARunEndIsMoved) {
  Picture p;
  for (std::vector<DensityRun>& row : p.runs)
    for (DensityRun& run : row) run.x0 += 1e-3, run.x1 += 1e-3;
  EXPECT_NEAR(worst_run_end(p.prepared, p.rows, p.runs), 1e-3, 1e-10);
}

TEST(Judge, SeesShadows) {
  const Prepared lit = prepare(lit_scene_c(0), square_grid(kSize));
  const std::vector<int> rows = sampled_rows(lit.view.grid, 16);
  std::vector<std::vector<DensityRun>> runs = runs_of_rows(lit, rows);
  EXPECT_EQ(wrong_ppm(lit, rows, runs, 100), 0);
  for (std::vector<DensityRun>& row : runs)
    for (DensityRun& run : row)
      if (run.kind == Kind::shadow || run.kind == Kind::ground_shadow) run.kind = Kind::lit;
  EXPECT_GT(wrong_ppm(lit, rows, runs, 100), 0);
}

}  // namespace
}  // namespace overstrike::bench
