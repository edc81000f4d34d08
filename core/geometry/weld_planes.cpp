#include "core/geometry/weld_planes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "core/geometry/direction.h"
#include "core/geometry/rank_set.h"

namespace overstrike {
namespace {

constexpr Index kNoGroup = 0xFFFFFFFFu;

/// A plane that rounding can turn by more than this (radians) names no other plane: it is tried
/// against its neighbours only.
constexpr double kSliverTilt = 1.0 / 64;

/// Two fits of one plane each carry their own errors and, through the vertices, the other's: the
/// search looks this many times as far as one error reaches. It only widens the search; the
/// vertices decide.
constexpr double kSearchSlack = 4;

/// The reference point stands aside of the scene's middle by these parts of its size, which are in
/// no simple ratio to each other, so that the planes of regular scenes pass it at distances of
/// their own.
const Vec3 kAside(0.7548776662466927, 0.5698402909980532, 0.4301597090019468);

class Welder {
 public:
  Welder(std::span<const PlaneSample> samples, std::span<const VertexError> errors,
         std::span<const Vec3> points, std::span<const Index> corners)
      : samples_(samples),
        errors_(errors),
        points_(points),
        corners_(corners),
        group_(samples.size(), kNoGroup) {
    Vec3 low(1e300), high(-1e300);
    for (const PlaneSample& s : samples)
      low = glm::min(low, s.fit.middle), high = glm::max(high, s.fit.middle);
    for (const VertexError& e : errors) worst_error_ = std::fmax(worst_error_, e.in_world);
    reference_ = low + (high - low) * (Vec3(0.5) + kAside);
    measure();
  }

  WeldedPlanes weld(const NeighbourPairs& neighbours) {
    std::vector<Index> slivers;
    for (const Index i : by_area()) {
      if (!(tilt_[i] <= kSliverTilt)) {
        slivers.push_back(i);
      } else {
        const Index found = search(i);
        group_[i] = found == kNoGroup ? add_group(i) : found;
        if (found == kNoGroup) classes_.at(class_of(near_[rank_[i]].slack)).insert(rank_[i]);
      }
    }
    if (!slivers.empty()) join_slivers(slivers, neighbours());
    return {std::move(group_), std::move(representative_)};
  }

 private:
  void measure() {
    const std::size_t n = samples_.size();
    tilt_.resize(n), rank_.resize(n), by_rank_.resize(n), near_.resize(n);
    // Last in memory, so that their place is free for the next.
    std::vector<double> slack(n);
    std::vector<std::pair<double, Index>> order(n);
    for (std::size_t i = 0; i < n; ++i) {
      const PlaneFit& fit = samples_[i].fit;
      const Vec3 away = reference_ - fit.middle;
      order[i] = {std::fabs(glm::dot(fit.normal, away)), static_cast<Index>(i)};
      tilt_[i] = fit.tilt(worst_error_);
      slack[i] = kSearchSlack * (worst_error_ + tilt_[i] * std::sqrt(glm::dot(away, away)));
      if (tilt_[i] <= kSliverTilt) classes_.try_emplace(class_of(slack[i]), n);
    }
    std::sort(order.begin(), order.end());
    for (std::size_t r = 0; r < n; ++r) {
      by_rank_[r] = order[r].second;
      near_[r] = {order[r].first, slack[order[r].second]};
      rank_[order[r].second] = static_cast<Index>(r);
    }
  }

  /// The magnitude, in powers of 16.
  static int class_of(double slack) { return slack > 0 ? std::ilogb(slack) >> 2 : -1000; }

  /// The largest first; ties by geometry. Ranks are in order of distance, so that the sort need not
  /// fetch anything.
  std::vector<Index> by_area() const {
    struct Key {
      double area;
      Index rank;
    };
    std::vector<Index> order(samples_.size());
    std::vector<Key> keys(samples_.size());
    for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = {samples_[i].fit.area, rank_[i]};
    std::sort(keys.begin(), keys.end(), [](const Key& a, const Key& b) {
      return a.area != b.area ? a.area > b.area : a.rank < b.rank;
    });
    for (std::size_t first = 0, end; first < keys.size(); first = end) {
      const auto same = [&](std::size_t i) {
        return keys[i].area == keys[first].area &&
               near_[keys[i].rank].distance == near_[keys[first].rank].distance;
      };
      for (end = first + 1; end < keys.size() && same(end);) ++end;
      for (std::size_t i = first; i < end; ++i) order[i] = by_rank_[keys[i].rank];
      std::sort(order.begin() + first, order.begin() + end,
                [&](Index a, Index b) { return rest(a) < rest(b); });
    }
    return order;
  }
  std::tuple<double, double, double, double, double, double> rest(Index sample) const {
    const PlaneFit& f = samples_[sample].fit;
    return {f.middle.x, f.middle.y, f.middle.z, f.normal.x, f.normal.y, f.normal.z};
  }

  Index add_group(Index sample) {
    representative_.push_back(sample);
    return static_cast<Index>(representative_.size() - 1);
  }

  /// True when every vertex of the sample lies in the plane of the representative as far as
  /// rounding lets us know.
  bool speaks_for(Index sample, Index representative) const {
    const PlaneSample& s = samples_[sample];
    const PlaneSample& r = samples_[representative];
    const auto error = s.body == r.body ? &VertexError::in_body : &VertexError::in_world;
    const double s_error = errors_[s.body].*error, r_error = errors_[r.body].*error;
    const double tilt = r.fit.tilt(r_error);
    for (std::size_t i = s.first_point; i < s.end_point; ++i) {
      const Vec3 away = points_[corners_.empty() ? i : corners_[i]] - r.fit.middle;
      const double reach = tilt * std::sqrt(glm::dot(away, away));
      if (!(std::fabs(glm::dot(r.fit.normal, away)) <= s_error + r_error + reach)) return false;
    }
    return true;
  }

  bool matches(Index sample, Index representative) const {
    const Vec3 turn = glm::cross(samples_[sample].fit.normal, samples_[representative].fit.normal);
    const double most = kSearchSlack * (tilt_[sample] + tilt_[representative]);
    return glm::dot(turn, turn) <= most * most && speaks_for(sample, representative);
  }

  /// The group of the largest representative that it speaks for.
  Index search(Index sample) const {
    Index best = kNoGroup;
    const Near own = near_[rank_[sample]];
    const auto consider = [&](std::size_t r) {
      if (std::fabs(own.distance - near_[r].distance) > own.slack + near_[r].slack) return;
      if (matches(sample, by_rank_[r])) best = std::min(best, group_[by_rank_[r]]);
    };
    for (const auto& [exponent, members] : classes_) {
      const double reach = own.slack + std::ldexp(1.0, 4 * (exponent + 1));
      for (std::size_t r = members.up(rank_[sample]); r != RankSet::kNothing;
           r = members.up(r + 1)) {
        if (near_[r].distance - own.distance > reach) break;
        consider(r);
        if (r + 1 == by_rank_.size()) break;
      }
      for (std::size_t r = members.down(rank_[sample]); r != RankSet::kNothing;
           r = members.down(r - 1)) {
        if (own.distance - near_[r].distance > reach) break;
        consider(r);
        if (r == 0) break;
      }
    }
    return best;
  }

  void join_slivers(const std::vector<Index>& slivers,
                    std::span<const std::pair<Index, Index>> neighbours) {
    std::vector<std::pair<Index, Index>> beside;  // sliver, neighbour
    for (const auto& [a, b] : neighbours) {
      if (!(tilt_[a] <= kSliverTilt)) beside.emplace_back(a, b);
      if (!(tilt_[b] <= kSliverTilt)) beside.emplace_back(b, a);
    }
    std::sort(beside.begin(), beside.end());
    for (const Index i : slivers) {
      Index best = kNoGroup;
      for (auto it = std::lower_bound(beside.begin(), beside.end(), std::pair(i, Index{0}));
           it != beside.end() && it->first == i; ++it) {
        const Index group = group_[it->second];
        if (group < best && speaks_for(i, representative_[group])) best = group;
      }
      group_[i] = best == kNoGroup ? add_group(i) : best;
    }
  }

  std::span<const PlaneSample> samples_;
  std::span<const VertexError> errors_;
  std::span<const Vec3> points_;
  std::span<const Index> corners_;
  Vec3 reference_{0.0};
  double worst_error_ = 0;
  std::vector<double> tilt_;
  std::vector<Index> rank_;  ///< by the distance of the reference point from the plane
  std::vector<Index> by_rank_;
  struct Near {
    double distance;
    double slack;  ///< what rounding can do to it
  };
  std::vector<Near> near_;          ///< by rank, side by side for the search
  std::map<int, RankSet> classes_;  ///< the ranks of representatives, by their slack's class
  std::vector<Index> group_;
  std::vector<Index> representative_;
};

}  // namespace

WeldedPlanes weld_planes(std::span<const PlaneSample> samples, std::span<const VertexError> errors,
                         std::span<const Vec3> points, const NeighbourPairs& neighbours,
                         std::span<const Index> corners) {
  if (samples.empty()) return {};
  return Welder(samples, errors, points, corners).weld(neighbours);
}

}  // namespace overstrike
