#pragma once
// A rectangle of the picture cut into equal cells, to find what lies near a line.
#include <algorithm>
#include <cmath>

#include "core/geometry/vec.h"

namespace overstrike {

class CellGrid {
 public:
  /// About `wanted` cells over [0, columns] x [0, rows]; what lies outside counts to the nearest.
  CellGrid(double columns, double rows, std::size_t wanted) {
    constexpr double kMostCells = 1 << 18;
    const double cells = std::clamp(static_cast<double>(wanted), 1.0, kMostCells);
    const double side = std::sqrt(columns * rows / cells);
    columns_ = std::clamp(static_cast<int>(columns / side), 1, static_cast<int>(cells));
    rows_ = std::clamp(static_cast<int>(rows / side), 1, static_cast<int>(cells));
    width_ = columns / columns_;
    height_ = rows / rows_;
  }

  std::size_t size() const { return static_cast<std::size_t>(columns_) * rows_; }

  /// visit(cell) for every cell that the box meets.
  template <class Visit>
  void in_box(const Vec2& low, const Vec2& high, const Visit& visit) const {
    for (int r = row(low.y); r <= row(high.y); ++r)
      for (int k = column(low.x); k <= column(high.x); ++k) visit(cell(k, r));
  }

  /// visit(cell) for every cell that the line from p to q comes nearer to than `pad`, until it
  /// returns false.
  template <class Visit>
  void along(const Vec2& p, const Vec2& q, double pad, const Visit& visit) const {
    const Vec2 low = glm::min(p, q), high = glm::max(p, q);
    const double slope = q.x == p.x ? 0 : (q.y - p.y) / (q.x - p.x);
    const int first = column(low.x - pad), last = column(high.x + pad);
    for (int k = first; k <= last; ++k) {
      double top = low.y, bottom = high.y;
      if (first != last && q.x != p.x) {
        const double x0 = std::clamp(k * width_ - pad, low.x, high.x);
        const double x1 = std::clamp((k + 1) * width_ + pad, low.x, high.x);
        const double y0 = p.y + (x0 - p.x) * slope, y1 = p.y + (x1 - p.x) * slope;
        top = std::max(top, std::min(y0, y1)), bottom = std::min(bottom, std::max(y0, y1));
      }
      for (int r = row(top - pad); r <= row(bottom + pad); ++r)
        if (!visit(cell(k, r))) return;
    }
  }

 private:
  std::size_t cell(int k, int r) const { return static_cast<std::size_t>(r) * columns_ + k; }
  int column(double x) const {
    return static_cast<int>(std::clamp(x / width_, 0.0, columns_ - 1.0));
  }
  int row(double y) const { return static_cast<int>(std::clamp(y / height_, 0.0, rows_ - 1.0)); }

  int columns_ = 1, rows_ = 1;
  double width_ = 1, height_ = 1;
};

}  // namespace overstrike
