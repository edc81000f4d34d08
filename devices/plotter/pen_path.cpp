#include "devices/plotter/pen_path.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace overstrike {
namespace {

/// One end of a line: end 2 i is where line i begins, 2 i + 1 where it ends.
using End = std::size_t;
constexpr End kNone = std::numeric_limits<End>::max();

const PlotPoint& place(const std::vector<PlotLine>& lines, End end) {
  const PlotLine& line = lines[end / 2];
  return end % 2 == 0 ? line.front() : line.back();
}

bool before(const PlotPoint& a, const PlotPoint& b) { return a.y != b.y ? a.y < b.y : a.x < b.x; }

/// The ends of all lines in groups that meet in one place.
class Meetings {
 public:
  explicit Meetings(const std::vector<PlotLine>& lines)
      : used_(lines.size()), group_(2 * lines.size()) {
    for (End end = 0; end < 2 * lines.size(); ++end) ends_.push_back(end);
    std::stable_sort(ends_.begin(), ends_.end(),
                     [&](End a, End b) { return before(place(lines, a), place(lines, b)); });
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      if (i == 0 || place(lines, ends_[i - 1]) != place(lines, ends_[i])) groups_.push_back({i, i});
      group_[ends_[i]] = groups_.size() - 1;
      groups_.back().last = i + 1;
      groups_.back().odd = !groups_.back().odd;
    }
  }

  bool used(std::size_t line) const { return used_[line]; }
  void use(std::size_t line) { used_[line] = 1; }
  bool odd(End end) const { return groups_[group_[end]].odd; }

  /// The first end where `end` lies whose line is free.
  End free_end_at(End end) {
    Group& group = groups_[group_[end]];
    while (group.next < group.last && used_[ends_[group.next] / 2]) ++group.next;
    return group.next < group.last ? ends_[group.next] : kNone;
  }

 private:
  struct Group {
    std::size_t next, last;  ///< in ends_; lines of ends before `next` are used
    bool odd = false;
  };
  std::vector<char> used_;
  std::vector<std::size_t> group_;
  std::vector<End> ends_;
  std::vector<Group> groups_;
};

/// Appends the line from that end, without its first point if the chain already ends there.
void append(PlotLine& chain, PlotLine line, bool turned) {
  if (turned) std::reverse(line.begin(), line.end());
  chain.insert(chain.end(), line.begin() + (chain.empty() ? 0 : 1), line.end());
}

PlotLine chain_from(const std::vector<PlotLine>& lines, End end, Meetings& meetings) {
  PlotLine chain;
  while (end != kNone) {
    meetings.use(end / 2);
    append(chain, lines[end / 2], end % 2 == 1);
    end = meetings.free_end_at(end ^ 1);
  }
  return chain;
}

/// Free ends in square cells, for the search of the nearest one in growing rings.
class EndGrid {
 public:
  EndGrid(const std::vector<PlotLine>& lines, const std::vector<char>& drawn) : lines_(lines) {
    std::size_t count = 0;
    PlotPoint low{std::numeric_limits<int>::max(), std::numeric_limits<int>::max()};
    PlotPoint high{std::numeric_limits<int>::min(), std::numeric_limits<int>::min()};
    for (End end = 0; end < 2 * lines.size(); ++end) {
      if (drawn[end / 2]) continue;
      const PlotPoint& p = place(lines, end);
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
      ++count;
    }
    low_ = low;
    const double width = double(high.x) - low.x + 1, height = double(high.y) - low.y + 1;
    size_ = std::max(1.0, std::sqrt(width * height * kEndsInCell / double(count)));
    columns_ = static_cast<long>(width / size_) + 1;
    rows_ = static_cast<long>(height / size_) + 1;
    fill(drawn);
  }

  /// The free end nearest to p; between equals the one that came first.
  End nearest(const PlotPoint& p, const std::vector<char>& drawn) const {
    const long column = column_of(p.x), row = row_of(p.y);
    Found found;
    for (long ring = 0; ring <= std::max(columns_, rows_); ++ring) {
      // Whatever lies outside the rings so far is at least ring - 1 cells away from p's cell.
      const double least = double(ring - 1) * size_;
      if (found.end != kNone && ring > 0 && found.square < least * least) break;
      search_ring(p, column, row, ring, drawn, found);
    }
    return found.end;
  }

 private:
  static constexpr double kEndsInCell = 2;
  struct Found {
    End end = kNone;
    double square = std::numeric_limits<double>::infinity();
  };

  long column_of(int x) const {
    return std::clamp(static_cast<long>((double(x) - low_.x) / size_), 0L, columns_ - 1);
  }
  long row_of(int y) const {
    return std::clamp(static_cast<long>((double(y) - low_.y) / size_), 0L, rows_ - 1);
  }
  std::size_t cell_of(const PlotPoint& p) const {
    return static_cast<std::size_t>(row_of(p.y) * columns_ + column_of(p.x));
  }

  /// Counting sort of the ends into their cells.
  void fill(const std::vector<char>& drawn) {
    starts_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
    const auto each_free = [&](auto&& visit) {
      for (End end = 0; end < 2 * lines_.size(); ++end) {
        if (!drawn[end / 2]) visit(end, cell_of(place(lines_, end)));
      }
    };
    each_free([&](End, std::size_t cell) { ++starts_[cell + 1]; });
    for (std::size_t c = 1; c < starts_.size(); ++c) starts_[c] += starts_[c - 1];
    ends_.resize(starts_.back());
    std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
    each_free([&](End end, std::size_t cell) { ends_[next[cell]++] = end; });
  }

  void search_ring(const PlotPoint& p, long column, long row, long ring,
                   const std::vector<char>& drawn, Found& found) const {
    for (long r = std::max(0L, row - ring); r <= std::min(rows_ - 1, row + ring); ++r) {
      const bool whole = r == row - ring || r == row + ring;
      const long step = whole || ring == 0 ? 1 : 2 * ring;
      for (long c = column - ring; c <= column + ring; c += step) {
        if (c >= 0 && c < columns_) search_cell(p, r * columns_ + c, drawn, found);
      }
    }
  }

  void search_cell(const PlotPoint& p, long cell, const std::vector<char>& drawn,
                   Found& found) const {
    for (std::size_t i = starts_[cell]; i < starts_[cell + 1]; ++i) {
      const End end = ends_[i];
      if (drawn[end / 2]) continue;
      const PlotPoint& q = place(lines_, end);
      const double dx = double(q.x) - p.x, dy = double(q.y) - p.y;
      const double square = dx * dx + dy * dy;
      if (square < found.square || (square == found.square && end < found.end)) {
        found = {end, square};
      }
    }
  }

  const std::vector<PlotLine>& lines_;
  PlotPoint low_;
  double size_ = 1;
  long columns_ = 1, rows_ = 1;
  std::vector<std::size_t> starts_;
  std::vector<End> ends_;
};

}  // namespace

std::vector<PlotLine> joined(std::vector<PlotLine> lines) {
  std::erase_if(lines, [](const PlotLine& line) { return line.empty(); });
  Meetings meetings(lines);
  std::vector<PlotLine> chains;
  const auto chain = [&](End end) {
    if (!meetings.used(end / 2)) chains.push_back(chain_from(lines, end, meetings));
  };
  for (End end = 0; end < 2 * lines.size(); ++end) {
    if (meetings.odd(end)) chain(end);
  }
  for (End end = 0; end < 2 * lines.size(); end += 2) chain(end);
  return chains;
}

std::vector<PlotLine> ordered(std::vector<PlotLine> lines, PlotPoint start) {
  std::vector<PlotLine> order;
  std::vector<char> drawn(lines.size(), 0);
  std::size_t left = lines.size();
  while (left > 0) {
    // A new grid whenever half the lines are gone keeps the cells filled and the rings few.
    const EndGrid grid(lines, drawn);
    for (const std::size_t stop = left / 2; left > stop; --left) {
      const End end = grid.nearest(start, drawn);
      drawn[end / 2] = 1;
      PlotLine line = std::move(lines[end / 2]);
      if (end % 2 == 1) std::reverse(line.begin(), line.end());
      start = line.back();
      order.push_back(std::move(line));
    }
  }
  return order;
}

}  // namespace overstrike
