#pragma once
// What matters to which band of a picture's levels.
#include <span>
#include <vector>

#include "core/geometry/polyhedron.h"
#include "core/large_pages.h"
#include "core/unset_vector.h"

namespace overstrike {

/// Things that stretch over levels, by bands from 0 that are about as high as they are; what passes
/// through several is in all of them, in order of its number.
class LevelBands {
 public:
  struct Item {
    double low, high;
    Index number;
    bool meets(double y) const { return low <= y && y < high; }
  };
  /// `at(i)` gives the levels {low, high} of thing i; low > high: it is nowhere.
  template <class At>
  LevelBands(double levels, std::size_t count, const At& at) {
    // Each is asked once: what it is read from may be far larger than its levels.
    std::vector<Item> items;
    for (std::size_t i = 0; i < count; ++i) {
      const auto [low, high] = at(i);
      if (low <= high && high >= 0 && low <= levels)
        items.push_back({low, high, static_cast<Index>(i)});
    }
    height_ = height(items);
    start_.resize(2 + static_cast<std::size_t>(levels > 0 ? levels / height_ : 0), 0);
    const auto each = [&](const auto& visit) {
      for (const Item& item : items)
        for (std::size_t b = band(item.low), last = band(item.high); b <= last; ++b) visit(b, item);
    };
    each([&](std::size_t b, const Item&) { ++start_[b + 1]; });
    for (std::size_t b = 1; b < start_.size(); ++b) start_[b] += start_[b - 1];
    items_.resize(start_.back());
    prefer_large_pages(items_);
    std::vector<std::size_t> next(start_.begin(), start_.end() - 1);
    each([&](std::size_t b, const Item& item) { items_[next[b]++] = item; });
  }

  /// The band of a level; the first or last one for what lies outside.
  std::size_t band(double y) const {
    const double last = static_cast<double>(start_.size() - 2);
    const double b = y / height_;
    return b > 0 ? static_cast<std::size_t>(b < last ? b : last) : 0;
  }
  /// The levels of a band, low <= y < high; the first and last go on without end.
  double low(std::size_t band) const {
    return band == 0 ? -kEndless : static_cast<double>(band) * height_;
  }
  double high(std::size_t band) const {
    return band + 2 == start_.size() ? kEndless : static_cast<double>(band + 1) * height_;
  }
  std::span<const Item> operator[](std::size_t band) const {
    return {items_.data() + start_[band], items_.data() + start_[band + 1]};
  }

 private:
  static constexpr double kEndless = 1e300;
  /// A power of two, so that division by it is exact.
  static double height(const std::vector<Item>& items) {
    double sum = 0, number = 1;
    for (const Item& item : items) sum += item.high - item.low, ++number;
    constexpr double kLeast = 1, kMost = 16;
    double height = kLeast;
    while (height < kMost && height < sum / number) height *= 2;
    return height;
  }
  double height_ = 1;
  std::vector<std::size_t> start_;
  UnsetVector<Item> items_;
};

}  // namespace overstrike
