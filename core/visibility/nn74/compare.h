#pragma once
// Compares the pictures of two methods, line by line.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/drawing.h"

namespace overstrike::nn74::testing {

using Rows = std::vector<std::vector<DensityRun>>;

inline Rows runs_of(const Scene& scene, const Grid& grid, Method method, const ScanFamily& family) {
  DrawOptions options;
  options.method = method;
  options.threads = 1;
  Rows rows;
  Drawing(scene, grid, options).runs(family, [&](const RunRow& row) {
    rows.emplace_back(row.runs.begin(), row.runs.end());
  });
  return rows;
}

inline const DensityRun* run_at(const std::vector<DensityRun>& row, double x) {
  for (const DensityRun& run : row)
    if (run.x0 <= x && x < run.x1) return &run;
  return nullptr;
}

/// Where light grazes a face to within this, lit is as dark as shadow, and which it is hangs on the
/// last places of the input.
constexpr double kGrazing = 1e-9;

inline bool same(const DensityRun* a, const DensityRun* b) {
  if (a == nullptr || b == nullptr) return a == b;
  if (a->surface != b->surface || a->body != b->body) return false;
  if (a->kind == b->kind) return a->density0 == b->density0 && a->density1 == b->density1;
  const bool grazed = a->kind == Kind::lit || b->kind == Kind::lit;
  return grazed && std::fabs(a->density0 - b->density0) <= kGrazing;
}

inline std::string show(const DensityRun* run) {
  if (run == nullptr) return "paper";
  return std::string(to_string(run->kind)) + " of face " + std::to_string(run->surface) +
         " of body " + std::to_string(run->body);
}

/// The widest stretch of a line over which two rows differ.
struct Difference {
  double width = 0, at = 0;
};
inline Difference widest_difference(const std::vector<DensityRun>& a,
                                    const std::vector<DensityRun>& b) {
  std::vector<double> ends;
  for (const auto* row : {&a, &b})
    for (const DensityRun& run : *row) ends.push_back(run.x0), ends.push_back(run.x1);
  std::sort(ends.begin(), ends.end());
  Difference widest;
  double start = 0;
  bool differing = false;
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    const double middle = ends[i] + (ends[i + 1] - ends[i]) / 2;
    const bool differs = !same(run_at(a, middle), run_at(b, middle));
    if (differs && !differing) start = ends[i];
    differing = differs;
    if (differs && ends[i + 1] - start > widest.width) widest = {ends[i + 1] - start, middle};
  }
  return widest;
}

/// Grid units: what run ends are held to, times a condition of 1 (the scenes drawn here have no
/// borders nearly along a scan line, and no faces that the light nearly grazes).
constexpr double kEndsApart = 1e-9;

inline void expect_agreement(const Scene& scene, const Grid& grid, const ScanFamily& family) {
  const Rows nn74 = runs_of(scene, grid, Method::nn74, family);
  const Rows line = runs_of(scene, grid, Method::line, family);
  ASSERT_EQ(nn74.size(), line.size());
  std::size_t runs = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Difference d = widest_difference(nn74[i], line[i]);
    EXPECT_LE(d.width, kEndsApart)
        << "line " << i << " at " << d.at << ": " << show(run_at(nn74[i], d.at)) << ", should be "
        << show(run_at(line[i], d.at));
    runs += line[i].size();
  }
  EXPECT_GT(runs, 0u);
}

}  // namespace overstrike::nn74::testing
