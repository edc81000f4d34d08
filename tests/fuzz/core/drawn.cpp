#include "tests/fuzz/core/drawn.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/geometry/trig.h"
#include "core/visibility/run_source.h"
#include "tests/fuzz/fuzz.h"

namespace overstrike::fuzz {
namespace {

/// Ends are clipped to the grid along the line; across it they may be off by the rounding of a
/// coordinate of at most 32.
constexpr double kBorder = 32 * 0x1p-50;
/// Densities are interpolated between corners within 0..1: a few roundings.
constexpr double kDensityRounding = 0x1p-50;

oracle::Line line_of(const ScanFamily& family, std::int64_t index) {
  const Vec2 direction(cos_deg(family.angle_deg), sin_deg(family.angle_deg));
  const double offset = family.offset + static_cast<double>(index) * family.spacing;
  return {offset * Vec2(-direction.y, direction.x), direction};
}

/// To where the line is looked at: beside itself by what the size of the turned grid makes of it.
void move_beside(DrawnLine& drawn) {
  const Vec2& along = drawn.line.direction;
  const double c = std::fabs(along.x), s = std::fabs(along.y);
  drawn.beside =
      beside_line(c * kGrid.columns + s * kGrid.rows, s * kGrid.columns + c * kGrid.rows);
  drawn.line.origin += drawn.beside * Vec2(-along.y, along.x);
}

void clip_to_grid(DrawnLine& drawn) {
  drawn.from = -INFINITY, drawn.to = INFINITY;
  for (int axis = 0; axis < 2; ++axis) {
    const double most = axis == 0 ? kGrid.columns : kGrid.rows;
    const double o = drawn.line.origin[axis], d = drawn.line.direction[axis];
    if (d == 0) continue;
    drawn.from = std::max(drawn.from, std::min(-o / d, (most - o) / d));
    drawn.to = std::min(drawn.to, std::max(-o / d, (most - o) / d));
  }
}

bool is_density(double d) { return d >= -kDensityRounding && d <= 1 + kDensityRounding; }

void expect_sound(const DrawnLine& drawn) {
  double last = drawn.from - kBorder;
  for (const DensityRun& run : drawn.runs) {
    expect(std::isfinite(run.x0) && std::isfinite(run.x1), "runs are finite");
    expect(run.x0 < run.x1, "runs are not empty");
    expect(run.x0 >= last, "runs are sorted, disjoint and begin in the grid");
    expect(is_density(run.density0) && is_density(run.density1), "densities lie within 0 and 1");
    last = run.x1;
  }
  expect(last <= drawn.to + kBorder, "runs end in the grid");
}

/// The mean density of each cell along one line.
std::vector<double> means_along(const DrawnLine& drawn) {
  std::vector<double> cells(static_cast<std::size_t>(kGrid.columns), 0.0);
  for (const DensityRun& run : drawn.runs)
    for (auto i = static_cast<std::size_t>(std::max(0.0, run.x0)); i < cells.size(); ++i) {
      const double low = std::max(run.x0, static_cast<double>(i));
      const double high = std::min(run.x1, static_cast<double>(i) + 1);
      if (low >= high) break;
      const double t = ((low + high) / 2 - run.x0) / (run.x1 - run.x0);
      cells[i] += (high - low) * (run.density0 + t * (run.density1 - run.density0));
    }
  return cells;
}

}  // namespace

double place_error_of(const Canonical& canonical, const View& view) {
  Vec3 reach(0);
  for (const Vec3& p : canonical.vertices) reach = glm::max(reach, glm::abs(p));
  Vec4 size = glm::abs(view.matrix[3]);
  for (int column = 0; column < 3; ++column) size += glm::abs(view.matrix[column]) * reach[column];
  double w = 1;
  if (view.perspective) {
    const Plane& near = *view.near_plane;
    w = std::fabs((view.matrix * Vec4(near.normal * near.offset, 1)).z);
  }
  const double most = std::max(view.grid.columns, view.grid.rows);
  return 4 * 0x1p-52 * (std::max(size.x, size.y) + size.z * most) / w;
}

Prepared::Prepared(const Scene& scene) : view(make_view(scene, kGrid)) {
  std::vector<Diagnostic> warnings;
  canonical = std::make_shared<const Canonical>(canonicalize(scene, view, kTolerance, warnings));
}

Drawing Prepared::drawing(int threads, Coherence coherence) const {
  DrawOptions options;
  options.tolerance = kTolerance;
  options.threads = threads;
  options.coherence = coherence;
  return Drawing(canonical, view, options);
}

std::vector<DrawnLine> draw_lines(Drawing& drawing, const ScanFamily& family) {
  std::vector<DrawnLine> lines;
  drawing.runs(family, [&](const RunRow& row) {
    expect(lines.empty() || row.index == lines.back().index + 1, "lines come in order");
    DrawnLine drawn{line_of(family, row.index), 0, row.index, 0, 0, {}};
    clip_to_grid(drawn);
    drawn.runs.assign(row.runs.begin(), row.runs.end());
    expect_sound(drawn);
    move_beside(drawn);
    lines.push_back(std::move(drawn));
  });
  return lines;
}

std::vector<std::vector<float>> draw_cells(Drawing& drawing) {
  std::vector<std::vector<float>> rows;
  drawing.cells([&](const CellRow& row) {
    expect(row.row == static_cast<std::int64_t>(rows.size()), "rows come in order");
    for (const float d : row.density) expect(d >= 0 && d <= 1, "cells lie within 0 and 1");
    rows.emplace_back(row.density.begin(), row.density.end());
  });
  expect(rows.size() == static_cast<std::size_t>(kGrid.rows), "every row is drawn");
  return rows;
}

void draw_strokes(Drawing& drawing, std::size_t bodies) {
  for (const Stroke& stroke : drawing.strokes({})) {
    expect(stroke.points.size() >= 2, "a stroke has two ends");
    expect(stroke.body < bodies || stroke.body == kNoSurface, "a stroke's body exists");
    for (const Vec2& p : stroke.points) {
      expect(std::isfinite(p.x) && std::isfinite(p.y), "strokes are finite");
      expect(p.x >= -kBorder && p.x <= kGrid.columns + kBorder && p.y >= -kBorder &&
                 p.y <= kGrid.rows + kBorder,
             "strokes stay on the page");
    }
  }
}

bool same_bits(const DensityRun& a, const DensityRun& b) {
  return a.x0 == b.x0 && a.x1 == b.x1 && a.density0 == b.density0 && a.density1 == b.density1 &&
         a.surface == b.surface && a.body == b.body && a.kind == b.kind;
}

void expect_means(Drawing& drawing, double place_error) {
  constexpr int kLines = 32;  // to a row
  const auto cells = draw_cells(drawing);
  const auto lines = draw_lines(drawing, {0, 1.0 / kLines, 0.5 / kLines});
  std::vector<std::vector<double>> along;
  for (const DrawnLine& line : lines) along.push_back(means_along(line));
  for (std::size_t row = 0; row < cells.size(); ++row)
    for (std::size_t column = 0; column < cells[row].size(); ++column) {
      double mean = 0, change = 0;
      for (std::size_t i = row * kLines; i < (row + 1) * kLines; ++i) {
        mean += along[i][column] / kLines;
        if (i > row * kLines) change += std::fabs(along[i][column] - along[i - 1][column]);
      }
      // Each line stands for a strip; between two lines the density may pass what it has there
      // once, to bare paper or black, unseen. As the tolerance does, four borders in a cell count.
      const double missed = (change + 2) / kLines + 4 * place_error;
      expect(std::fabs(mean - cells[row][column]) <= kTolerance + missed,
             "cells are the mean of many lines: row " + std::to_string(row) + " column " +
                 std::to_string(column) + " is " + std::to_string(cells[row][column]) +
                 ", the lines' mean " + std::to_string(mean));
    }
}

}  // namespace overstrike::fuzz
