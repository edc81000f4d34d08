#pragma once
// What is surely hidden on one level, told before anything is sorted or compared.
#include <algorithm>
#include <array>
#include <limits>

namespace overstrike {

/// The level in cells, and of each the largest depth that some single front has before it all over.
/// Where many small bodies lie behind one another, that hides most of them.
///
/// A cell is the set of all x whose product with the scale has, rounded as it is, one whole part.
/// Rounding keeps order, so that no bound is needed: what lies in cells between those of two x lies
/// between the two.
class LevelCover {
 public:
  explicit LevelCover(double columns) : columns_(columns), scale_(kCells / columns) { clear(); }

  void clear() { far_.fill(-std::numeric_limits<double>::infinity()); }

  /// A front covers x0 <= x <= x1, and nothing of it is farther than `far`.
  void cover(double x0, double x1, double far) {
    const int end = cell(x1);
    for (int i = x0 < 0 ? 0 : cell(x0) + 1; i < end; ++i) far_[i] = std::max(far_[i], far);
  }

  /// What lies between x0 and x1, nowhere nearer than `near`, has a front before it everywhere.
  bool hides(double x0, double x1, double near) const {
    const int last = cell(x1);
    for (int i = cell(x0); i <= last; ++i)
      if (!(near < far_[i])) return false;
    return true;
  }

 private:
  /// Cells of a quarter of a column in pictures of 512; the largest depths fill half of a
  /// first-level cache.
  static constexpr int kCells = 2048;

  int cell(double x) const { return x > 0 ? static_cast<int>(std::min(x, columns_) * scale_) : 0; }

  double columns_, scale_;
  std::array<double, kCells + 2> far_;  ///< what rounding adds on the right is never covered
};

}  // namespace overstrike
