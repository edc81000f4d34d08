#include "scenes/readers/openscad/join_lines.h"

#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace overstrike::openscad {
namespace {

constexpr double kNear = 0x1p-10;

/// Numbers for places that are near one another; the first that came is the place.
class Places {
 public:
  Index number(const Vec2& p) {
    const std::pair<double, double> cell(std::floor(p.x / kNear), std::floor(p.y / kNear));
    for (int dx = -1; dx <= 1; ++dx)
      for (int dy = -1; dy <= 1; ++dy) {
        const auto found = cells_.find({cell.first + dx, cell.second + dy});
        if (found != cells_.end() && is_near(points[found->second], p)) return found->second;
      }
    points.push_back(p);
    return cells_[cell] = static_cast<Index>(points.size() - 1);
  }

  std::vector<Vec2> points;

 private:
  static bool is_near(const Vec2& a, const Vec2& b) {
    return std::fabs(a.x - b.x) <= kNear && std::fabs(a.y - b.y) <= kNear;
  }
  std::map<std::pair<double, double>, Index> cells_;
};

class Joiner {
 public:
  explicit Joiner(const std::vector<Line>& lines) {
    for (const Line& line : lines) {
      const Index from = places_.number(line.from), to = places_.number(line.to);
      if (from == to) continue;
      ends_.emplace_back(from, to);
    }
    at_.resize(places_.points.size());
    used_.assign(ends_.size(), false);
    for (Index i = 0; i < ends_.size(); ++i) {
      at_[ends_[i].first].push_back(i);
      at_[ends_[i].second].push_back(i);
    }
  }

  std::vector<Loop2> join() {
    for (Index place = 0; place < at_.size(); ++place)
      if (at_[place].size() == 1) follow(place);
    for (Index line = 0; line < ends_.size(); ++line)
      if (!used_[line]) follow(ends_[line].first);
    return std::move(loops_);
  }

 private:
  void follow(Index place) {
    Loop2 loop{places_.points[place]};
    const Index start = place;
    while (const std::optional<Index> line = unused(place)) {
      used_[*line] = true;
      place = ends_[*line].first == place ? ends_[*line].second : ends_[*line].first;
      if (place == start) break;
      loop.push_back(places_.points[place]);
    }
    if (loop.size() >= 3) loops_.push_back(std::move(loop));
  }

  std::optional<Index> unused(Index place) const {
    for (const Index line : at_[place])
      if (!used_[line]) return line;
    return std::nullopt;
  }

  Places places_;
  std::vector<std::pair<Index, Index>> ends_;
  std::vector<std::vector<Index>> at_;  ///< per place its lines
  std::vector<bool> used_;
  std::vector<Loop2> loops_;
};

}  // namespace

std::vector<Loop2> join_lines(const std::vector<Line>& lines) { return Joiner(lines).join(); }

}  // namespace overstrike::openscad
