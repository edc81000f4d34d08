#include "core/geometry/region_outlines.h"

#include <algorithm>
#include <tuple>

#include "core/geometry/polygon.h"

namespace overstrike {
namespace {

constexpr Index kNone = 0xFFFFFFFFu;

/// Pieces and points are set on the lattice where one comes so near to the other, in half sides.
/// Before anything is moved a path is within 1 of its segments and a point of its site. A straight
/// line for a path moves what it stands for by up to 2, its ends by 1 more, a point by 1: what was
/// farther apart than 4 keeps its side. 6, as the square asked about lacks its upper borders.
constexpr double kNear = 6;

bool before(const Vec2& a, const Vec2& b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); }

std::vector<Index> common(std::span<const Index> a, std::span<const Index> b) {
  std::vector<Index> both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

class Outlines {
 public:
  Outlines(const std::vector<Border>& borders, const SnapRounded& arrangement)
      : borders_(borders), a_(arrangement), fixed_(arrangement.middles.size(), false) {}

  Region run() {
    link();
    trace();
    for (Loop& loop : loops_) find_runs(loop);
    fix_what_is_near();
    Region region;
    for (const Loop& loop : loops_) {
      Loop2 points = straightened(loop);
      if (points.size() > 2) region.loops.push_back(std::move(points));
    }
    std::sort(region.loops.begin(), region.loops.end(), [](const Loop2& a, const Loop2& b) {
      return std::lexicographical_compare(
          a.begin(), a.end(), b.begin(), b.end(),
          [](const Vec2& p, const Vec2& q) { return before(p, q); });
    });
    return region;
  }

 private:
  struct Loop {
    std::vector<Index> borders;
    /// Per border: the run of borders that are parts of one segment, one after the other.
    std::vector<Index> runs;
  };

  // ---- linking

  /// At each site a border is followed by the next one clockwise from itself, between which the
  /// region lies; so that loops leave apart what only meets in a point.
  void link() {
    leaving_.assign(fixed_.size(), 0);
    struct Ray {
      Index site, border;
      bool leaves;
    };
    std::vector<Ray> rays;
    for (Index b = 0; b < borders_.size(); ++b) {
      rays.push_back({borders_[b].from, b, true}), rays.push_back({borders_[b].to, b, false});
      ++leaving_[borders_[b].from];
    }
    const auto far_end = [&](const Ray& r) {
      return a_.middles[r.leaves ? borders_[r.border].to : borders_[r.border].from];
    };
    const auto counter_clockwise = [&](const Ray& r, const Ray& s) {
      const Vec2 &middle = a_.middles[r.site], p = far_end(r), q = far_end(s);
      const bool p_left = before(p, middle), q_left = before(q, middle);
      return p_left != q_left ? q_left : turn_of(middle, p, q) > 0;
    };
    std::sort(rays.begin(), rays.end(), [&](const Ray& r, const Ray& s) {
      return r.site != s.site ? r.site < s.site : counter_clockwise(r, s);
    });
    next_.resize(borders_.size());
    for (std::size_t first = 0, end = 0; first < rays.size(); first = end) {
      while (end < rays.size() && rays[end].site == rays[first].site) ++end;
      for (std::size_t i = first; i < end; ++i)
        if (!rays[i].leaves) next_[rays[i].border] = rays[i == first ? end - 1 : i - 1].border;
    }
  }

  /// Loops that come back to a site are cut there.
  void trace() {
    std::vector<bool> used(borders_.size(), false);
    std::vector<Index> place(fixed_.size(), kNone);  // of sites that loops share: in `way`
    std::vector<Index> way;
    for (Index first = 0; first < borders_.size(); ++first) {
      for (Index b = first; !used[b]; b = next_[b]) {
        used[b] = true;
        cut_loop(way, place, borders_[b].from);
        if (leaving_[borders_[b].from] > 1)
          place[borders_[b].from] = static_cast<Index>(way.size());
        way.push_back(b);
      }
      for (const Index b : way) place[borders_[b].from] = kNone;
      if (!way.empty()) loops_.push_back({std::move(way), {}});
      way.clear();
    }
  }

  /// What lies on the way since it was at `site`, if it was.
  void cut_loop(std::vector<Index>& way, std::vector<Index>& place, Index site) {
    const Index since = place[site];
    if (since == kNone) return;
    const auto first = way.begin() + since;
    for (auto b = first; b != way.end(); ++b) place[borders_[*b].from] = kNone;
    loops_.push_back({{first, way.end()}, {}});
    way.erase(first, way.end());
  }

  // ---- bends that only rounding made

  /// A corner that no segment goes through, or that loops share.
  bool is_corner(Index before, Index after) const {
    return leaving_[borders_[after].from] > 1 ||
           common(borders_[before].sources, borders_[after].sources).empty();
  }

  void find_runs(Loop& loop) {
    const std::size_t count = loop.borders.size();
    const auto border = [&](std::size_t i) { return loop.borders[i % count]; };
    std::size_t start = 0;
    while (start < count && !is_corner(border(start + count - 1), border(start))) ++start;
    std::rotate(loop.borders.begin(), loop.borders.begin() + start % count, loop.borders.end());
    std::vector<Index> sources;
    for (std::size_t i = 0; i < count; ++i) {
      const Border& b = borders_[border(i)];
      if (!sources.empty() && leaving_[b.from] == 1)
        sources = common(sources, b.sources);
      else
        sources.clear();
      if (sources.empty()) {
        ++run_count_;
        sources.assign(b.sources.begin(), b.sources.end());
      }
      loop.runs.push_back(run_count_ - 1);
    }
  }

  /// Where things come so near one another that moving them could change sides.
  void fix_what_is_near() {
    struct Step {
      Index border, run, run_before;
    };
    fixed_runs_.assign(run_count_, false);
    std::vector<Segment2> pieces, points;
    std::vector<Step> steps;
    for (const Loop& loop : loops_)
      for (std::size_t i = 0; i < loop.borders.size(); ++i) {
        const Border& b = borders_[loop.borders[i]];
        const Vec2 &from = a_.middles[b.from], &to = a_.middles[b.to];
        pieces.push_back({from, to}), points.push_back({from, from});
        steps.push_back(
            {loop.borders[i], loop.runs[i], i == 0 ? loop.runs.back() : loop.runs[i - 1]});
      }
    near_pairs(pieces, points, kNear / 2 * a_.side, [&](Index p, Index q) {
      const Step& at = steps[q];
      const Index run = steps[p].run, site = borders_[at.border].from;
      if (run == at.run || run == at.run_before) return;
      if (borders_[steps[p].border].from == site || borders_[steps[p].border].to == site) return;
      if (!passes(pieces[p], a_.middles[site], kNear * a_.side)) return;
      fixed_runs_[run] = true;
      fixed_[site] = true;
      if (at.run == at.run_before) fixed_runs_[at.run] = true;
    });
    for (const Step& step : steps)
      if (fixed_runs_[step.run])
        fixed_[borders_[step.border].from] = fixed_[borders_[step.border].to] = true;
  }

  Vec2 point_of(Index site) const { return fixed_[site] ? a_.middles[site] : a_.points[site]; }

  Loop2 straightened(const Loop& loop) const {
    struct Corner {
      Vec2 point;
      bool shared;
    };
    std::vector<Corner> corners;
    for (std::size_t i = 0; i < loop.borders.size(); ++i) {
      const Index site = borders_[loop.borders[i]].from;
      const bool bend = loop.runs[i] == (i == 0 ? loop.runs.back() : loop.runs[i - 1]);
      if (!bend || fixed_runs_[loop.runs[i]])
        corners.push_back({point_of(site), leaving_[site] > 1});
    }
    if (corners.size() < 3) return {};
    // The first in order is a corner in truth.
    std::rotate(
        corners.begin(),
        std::min_element(corners.begin(), corners.end(),
                         [](const Corner& a, const Corner& b) { return before(a.point, b.point); }),
        corners.end());
    Loop2 points;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec2& next = corners[(i + 1) % corners.size()].point;
      if (i == 0 || corners[i].shared || turn_of(points.back(), corners[i].point, next) != 0)
        points.push_back(corners[i].point);
    }
    return points;
  }

  const std::vector<Border>& borders_;
  const SnapRounded& a_;
  std::vector<bool> fixed_;     ///< per site: stays in the middle of its square
  std::vector<Index> leaving_;  ///< per site: borders
  std::vector<Index> next_;     ///< per border
  std::vector<Loop> loops_;
  Index run_count_ = 0;
  std::vector<bool> fixed_runs_;
};

}  // namespace

Region outlines_of(const std::vector<Border>& borders, const SnapRounded& arrangement) {
  return Outlines(borders, arrangement).run();
}

}  // namespace overstrike
