#include "tests/hard/laws.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include "tests/oracle/random_scenes.h"

namespace overstrike::hard {
namespace {

/// Subjects of one law that are reported in full.
constexpr int kReported = 5;

/// Field by field: a run has bytes that belong to no field.
bool same_bits(const DensityRun& a, const DensityRun& b) {
  const double as[] = {a.x0, a.x1, a.density0, a.density1};
  const double bs[] = {b.x0, b.x1, b.density0, b.density1};
  return std::memcmp(as, bs, sizeof as) == 0 && a.surface == b.surface && a.body == b.body &&
         a.kind == b.kind;
}

double density_at(const DensityRun& r, double x) {
  return r.density0 + (r.density1 - r.density0) * ((x - r.x0) / (r.x1 - r.x0));
}

/// Density of a line at x; 0 in its gaps. Lines are asked from left to right.
class Walk {
 public:
  explicit Walk(const std::vector<DensityRun>& line) : line_(line) {}
  double at(double x) {
    while (next_ < line_.size() && line_[next_].x1 <= x) ++next_;
    if (next_ == line_.size() || x < line_[next_].x0) return 0;
    return density_at(line_[next_], x);
  }

 private:
  const std::vector<DensityRun>& line_;
  std::size_t next_ = 0;
};

}  // namespace

std::vector<Subject> subjects(const Sample& sample) {
  std::vector<Subject> all;
  int number = 0;
  for (const Case& c : corpus())
    if (number++ % sample.cases == 0 && c.scene.bodies.size() <= sample.most_bodies)
      all.push_back({c.name, c.scene});
  for (int n = 0; n < oracle::kRandomScenes * oracle::kViews; n += sample.random_scenes) {
    const int scene = n / oracle::kViews, view = n % oracle::kViews;
    all.push_back({oracle::describe(scene, view),
                   oracle::seen_from(oracle::random_scene(scene), scene, view)});
  }
  return all;
}

Drawing drawn(const Scene& scene, int threads, const Grid& grid) {
  DrawOptions options;
  options.tolerance = kTolerance;
  options.threads = threads;
  return {scene, grid, options};
}

Runs runs_of(Drawing& drawing, const ScanFamily& family) {
  Runs lines;
  drawing.runs(family,
               [&](const RunRow& row) { lines.emplace_back(row.runs.begin(), row.runs.end()); });
  return lines;
}

Runs runs_of(const Scene& scene, const ScanFamily& family) {
  Drawing drawing = drawn(scene);
  return runs_of(drawing, family);
}

std::vector<float> cells_of(Drawing& drawing) {
  std::vector<float> cells;
  drawing.cells([&](const CellRow& row) {
    cells.insert(cells.end(), row.density.begin(), row.density.end());
  });
  return cells;
}

std::string first_difference(const Runs& a, const Runs& b) {
  if (a.size() != b.size()) return "other numbers of lines";
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!std::equal(a[i].begin(), a[i].end(), b[i].begin(), b[i].end(), same_bits))
      return "line " + std::to_string(i) + " differs";
  return {};
}

std::string first_difference(const std::vector<float>& a, const std::vector<float>& b) {
  if (a.size() != b.size()) return "other numbers of cells";
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::memcmp(&a[i], &b[i], sizeof a[i]) != 0)
      return "cell " + std::to_string(i) + " differs";
  return {};
}

std::vector<Stretch> differences(const std::vector<DensityRun>& a, const std::vector<DensityRun>& b,
                                 double density_error) {
  std::set<double> ends;
  for (const auto* runs : {&a, &b})
    for (const DensityRun& r : *runs) ends.insert(r.x0), ends.insert(r.x1);
  Walk walk_a(a), walk_b(b);
  std::vector<Stretch> found;
  double from = ends.empty() ? 0 : *ends.begin();
  for (const double to : ends) {
    if (to == from) continue;
    const double middle = from + (to - from) / 2;
    if (std::fabs(walk_a.at(middle) - walk_b.at(middle)) > density_error) {
      if (!found.empty() && found.back().to == from)
        found.back().to = to;
      else
        found.push_back({from, to});
    }
    from = to;
  }
  return found;
}

void expect_law(const std::vector<Subject>& all, const std::string& law,
                const std::function<std::string(const Scene&)>& broken) {
  int count = 0;
  for (const Subject& s : all) {
    const std::string what = broken(s.scene);
    if (what.empty()) continue;
    if (++count <= kReported) ADD_FAILURE() << law << ": " << s.name << ": " << what;
  }
  EXPECT_EQ(count, 0) << "subjects that break the law: " << law;
}

}  // namespace overstrike::hard
