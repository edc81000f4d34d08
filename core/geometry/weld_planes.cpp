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
  Welder(std::span<const PlaneSample> samples, std::span<const Vec3> points,
         std::span<const Index> corners)
      : samples_(samples), points_(points), corners_(corners), group_(samples.size(), kNoGroup) {
    Vec3 low(1e300), high(-1e300);
    for (const PlaneSample& s : samples) {
      low = glm::min(low, s.fit.middle), high = glm::max(high, s.fit.middle);
      worst_error_ = std::fmax(worst_error_, s.error);
    }
    reference_ = low + (high - low) * (Vec3(0.5) + kAside);
    measure();
  }

  WeldedPlanes weld(std::span<const std::pair<Index, Index>> neighbours) {
    std::vector<Index> slivers;
    for (const Index i : by_area()) {
      if (!(tilt_[i] <= kSliverTilt)) {
        slivers.push_back(i);
      } else {
        const Index found = search(i);
        group_[i] = found == kNoGroup ? add_group(i) : found;
        if (found == kNoGroup) classes_.at(class_[i]).insert(rank_[i]);
      }
    }
    join_slivers(slivers, neighbours);
    return {std::move(group_), std::move(representative_)};
  }

 private:
  void measure() {
    const std::size_t n = samples_.size();
    distance_.resize(n), slack_.resize(n), tilt_.resize(n), class_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      const PlaneFit& fit = samples_[i].fit;
      const Vec3 away = reference_ - fit.middle;
      distance_[i] = std::fabs(glm::dot(fit.normal, away));
      tilt_[i] = fit.tilt(worst_error_);
      slack_[i] = kSearchSlack * (worst_error_ + tilt_[i] * std::sqrt(glm::dot(away, away)));
      class_[i] = slack_[i] > 0 ? std::ilogb(slack_[i]) >> 2 : -1000;
      if (tilt_[i] <= kSliverTilt) classes_.try_emplace(class_[i], n);
    }
    std::vector<std::pair<double, Index>> order(n);
    for (std::size_t i = 0; i < n; ++i) order[i] = {distance_[i], static_cast<Index>(i)};
    std::sort(order.begin(), order.end());
    by_rank_.resize(n), rank_.resize(n), near_.resize(n);
    for (std::size_t r = 0; r < n; ++r) {
      by_rank_[r] = order[r].second;
      near_[r] = {order[r].first, slack_[order[r].second]};
      rank_[order[r].second] = static_cast<Index>(r);
    }
  }

  /// The largest first; ties by geometry, which the sort seldom has to fetch.
  std::vector<Index> by_area() const {
    struct Key {
      double area, distance;
      Index sample;
    };
    std::vector<Key> keys(samples_.size());
    for (std::size_t i = 0; i < keys.size(); ++i)
      keys[i] = {samples_[i].fit.area, distance_[i], static_cast<Index>(i)};
    const auto rest = [&](const Key& k) {
      const PlaneFit& f = samples_[k.sample].fit;
      return std::tuple(f.middle.x, f.middle.y, f.middle.z, f.normal.x, f.normal.y, f.normal.z);
    };
    std::sort(keys.begin(), keys.end(), [&](const Key& a, const Key& b) {
      if (a.area != b.area) return a.area > b.area;
      return a.distance != b.distance ? a.distance < b.distance : rest(a) < rest(b);
    });
    std::vector<Index> order(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) order[i] = keys[i].sample;
    return order;
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
    const bool one_body = s.body == r.body && s.body != PlaneSample::kNoBody;
    const double s_error = one_body ? s.own_error : s.error;
    const double r_error = one_body ? r.own_error : r.error;
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
    const auto consider = [&](std::size_t r) {
      if (std::fabs(distance_[sample] - near_[r].distance) > slack_[sample] + near_[r].slack)
        return;
      if (matches(sample, by_rank_[r])) best = std::min(best, group_[by_rank_[r]]);
    };
    for (const auto& [exponent, members] : classes_) {
      const double reach = slack_[sample] + std::ldexp(1.0, 4 * (exponent + 1));
      for (std::size_t r = members.up(rank_[sample]); r != RankSet::kNothing;
           r = members.up(r + 1)) {
        if (near_[r].distance - distance_[sample] > reach) break;
        consider(r);
        if (r + 1 == by_rank_.size()) break;
      }
      for (std::size_t r = members.down(rank_[sample]); r != RankSet::kNothing;
           r = members.down(r - 1)) {
        if (distance_[sample] - near_[r].distance > reach) break;
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
  std::span<const Vec3> points_;
  std::span<const Index> corners_;
  Vec3 reference_{0.0};
  double worst_error_ = 0;
  std::vector<double> distance_;  ///< of the reference point from the plane
  std::vector<double> slack_;     ///< what rounding can do to it
  std::vector<double> tilt_;
  std::vector<int> class_;   ///< slack_'s magnitude, in powers of 16
  std::vector<Index> rank_;  ///< by distance
  std::vector<Index> by_rank_;
  struct Near {
    double distance, slack;
  };
  std::vector<Near> near_;          ///< by rank, side by side for the search
  std::map<int, RankSet> classes_;  ///< the ranks of representatives, by class
  std::vector<Index> group_;
  std::vector<Index> representative_;
};

}  // namespace

WeldedPlanes weld_planes(std::span<const PlaneSample> samples, std::span<const Vec3> points,
                         std::span<const std::pair<Index, Index>> neighbours,
                         std::span<const Index> corners) {
  if (samples.empty()) return {};
  return Welder(samples, points, corners).weld(neighbours);
}

}  // namespace overstrike
