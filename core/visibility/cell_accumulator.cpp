#include "core/visibility/cell_accumulator.h"

#include <algorithm>
#include <cmath>

namespace overstrike {
namespace {

struct Moments {
  double area;
  Vec2 centroid;
};

/// Twice-signed sums over a fan from the first corner.
Moments moments(std::span<const Vec2> polygon) {
  double area = 0;
  Vec2 sum(0);
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Vec2 a = polygon[i] - polygon[0], b = polygon[i + 1] - polygon[0];
    const double twice = a.x * b.y - a.y * b.x;
    area += twice / 2;
    sum += (a + b) * (twice / 6);
  }
  if (area == 0) return {0, polygon.empty() ? Vec2(0) : polygon[0]};
  return {std::fabs(area), polygon[0] + sum / area};
}

/// The part of a polygon with sign * (x - at) >= 0.
void cut_at(std::span<const Vec2> polygon, double at, double sign, std::vector<Vec2>& result) {
  result.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    const double fa = sign * (a.x - at), fb = sign * (b.x - at);
    if (fa >= 0) result.push_back(a);
    if ((fa < 0 && fb > 0) || (fa > 0 && fb < 0))
      result.push_back({at, a.y + (b.y - a.y) * (fa / (fa - fb))});
  }
}

}  // namespace

CellAccumulator::CellAccumulator(int columns)
    : columns_(columns), value_(columns + 1, 0.0), step_(columns + 2, 0.0), result_(columns) {}

void CellAccumulator::clear() { std::fill(value_.begin(), value_.end(), 0.0); }

void CellAccumulator::add_rectangle(double x0, double x1, double density) {
  x0 = std::max(x0, 0.0), x1 = std::min<double>(x1, columns_);
  if (!(x0 < x1) || density == 0) return;
  const int first = static_cast<int>(x0), last = static_cast<int>(x1);
  if (first == last) {
    value_[first] += density * (x1 - x0);
    return;
  }
  int from = first;
  if (x0 > first) value_[first] += density * (first + 1 - x0), ++from;
  std::fill(value_.begin() + from, value_.begin() + last, density);
  if (x1 > last) value_[last] += density * (x1 - last);
}

void CellAccumulator::add_border(double xa, double ya, double xb, double yb, double density) {
  if (!(ya < yb) || density == 0) return;
  // Outside of the grid a line is as good as its margin.
  const double most = columns_;
  const double slope = (xb - xa) / (yb - ya);
  const auto y_at = [&](double margin) {
    const bool passes = (xa < margin) != (xb < margin);
    return passes ? std::clamp(ya + (margin - xa) / slope, ya, yb) : yb;
  };
  const auto [first, second] = std::minmax({y_at(0), y_at(most)});
  const double cuts[4] = {ya, first, second, yb};
  for (int i = 0; i < 3; ++i) {
    const double y0 = cuts[i], y1 = cuts[i + 1];
    if (!(y0 < y1)) continue;
    const double x0 = y0 == ya ? xa : xa + (y0 - ya) * slope;
    const double x1 = y1 == yb ? xb : xa + (y1 - ya) * slope;
    add_piece(std::clamp(x0, 0.0, most), y0, std::clamp(x1, 0.0, most), y1, density);
  }
}

/// A line within the grid: the area right of it in each cell it passes, then full height.
void CellAccumulator::add_piece(double xa, double ya, double xb, double yb, double density) {
  const double height = (yb - ya) * density;
  if (xa > xb) std::swap(xa, xb);
  const int first = static_cast<int>(xa), last = static_cast<int>(xb);
  if (first == last) {
    const double right = height * (first + 1 - (xa + xb) / 2);
    step_[first] += right;
    step_[first + 1] += height - right;
    return;
  }
  const double per_column = height / (xb - xa);
  double before = 0;  // area right of the line in the cell before
  for (int i = first; i <= last; ++i) {
    const double in0 = std::max<double>(xa, i), in1 = std::min<double>(xb, i + 1);
    // The strip of heights passed before this cell lies wholly right of the line here; in the cell,
    // the mean of the rest.
    const double passed = (in0 - xa) * per_column, here = (in1 - in0) * per_column;
    const double right = passed + here * (i + 1 - (in0 + in1) / 2);
    step_[i] += right - before;
    before = right;
  }
  step_[last + 1] += height - before;
}

void CellAccumulator::settle(double x0, double x1) {
  const int first = static_cast<int>(std::clamp<double>(std::floor(x0), 0, columns_));
  const int last = static_cast<int>(std::clamp<double>(std::floor(x1) + 1, 0, columns_));
  double sum = 0;
  for (int i = first; i <= last; ++i) {
    sum += step_[i];
    value_[i] += sum;
    step_[i] = 0;
  }
  if (last + 1 < static_cast<int>(step_.size())) step_[last + 1] = 0;
}

void CellAccumulator::add_smooth(std::span<const Vec2> polygon, const EyeFace& face,
                                 double y_offset) {
  if (polygon.size() < 3) return;
  double low = polygon[0].x, high = polygon[0].x;
  for (const Vec2& p : polygon) low = std::min(low, p.x), high = std::max(high, p.x);
  const double lowest = low;
  low = std::max(low, 0.0), high = std::min<double>(high, columns_);
  const auto add = [&](int column, std::span<const Vec2> piece) {
    if (piece.size() < 3) return;
    const Moments m = moments(piece);
    if (m.area == 0) return;
    const double density = face.density_at(m.centroid.x, m.centroid.y + y_offset);
    value_[column] += m.area * std::clamp(density, 0.0, 1.0);
  };
  const int first = static_cast<int>(low);
  if (high <= first + 1 && low == lowest && first < columns_) {
    add(first, polygon);
    return;
  }
  for (int i = first; i < columns_ && i < high; ++i) {
    cut_at(polygon, i, 1, right_);
    cut_at(right_, i + 1, -1, cell_);
    add(i, cell_);
  }
}

void CellAccumulator::add_run(const DensityRun& run, double height) {
  const double slope = (run.density1 - run.density0) / (run.x1 - run.x0);
  for (int i = static_cast<int>(run.x0); i < columns_ && i < run.x1; ++i) {
    const double low = std::max<double>(run.x0, i), high = std::min<double>(run.x1, i + 1);
    value_[i] += height * (high - low) * (run.density0 + slope * ((low + high) / 2 - run.x0));
  }
}

std::span<const float> CellAccumulator::finish() {
  for (int i = 0; i < columns_; ++i)
    result_[i] = static_cast<float>(std::clamp(value_[i], 0.0, 1.0));
  return result_;
}

}  // namespace overstrike
