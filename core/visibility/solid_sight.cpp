#include "core/visibility/solid_sight.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace overstrike {

/// Leads along the line, whose parameter stands for x; the line's own is 0. Where two are one, and
/// the line lies in both planes or in neither, the depths beside the line decide.
class SolidSight::Order final : public LayerOrder {
 public:
  /// `side` as in Part. `faces` are sorted.
  Order(std::span<const Face> faces, const Ruler& ruler, int side) : faces_(faces) {
    const Vec2 right = ruler.right() * (side == 0 ? 1.0 : -1.0);
    for (const Face& f : faces) {
      const auto& [at_a, at_b] = f.over.leads;
      const double error = std::max(at_a.error, at_b.error);
      leads_.push_back({at_b.value - at_a.value, 0, at_a.value, 0, 0, error});
      across_.push_back(glm::dot(f.over.slope, right));
    }
  }

  const DepthPlane& depth_of(Index face) const override {
    static const DepthPlane kLine{};
    return face == kEnd ? kLine : leads_[number_of(face)];
  }
  int compare(Index f, Index g, double t, double) const override {
    const DepthPlane &p = depth_of(f), &q = depth_of(g);
    const double difference = (p.a * t + p.c) - (q.a * t + q.c), error = p.ec + q.ec;
    if (std::fabs(difference) > error) return difference > 0 ? 1 : -1;
    if (f == kEnd || g == kEnd) return 0;
    const double beside = across_[number_of(f)] - across_[number_of(g)];
    return (beside > 0) - (beside < 0);
  }
  double crossing(Index f, Index g, double) const override {
    const DepthPlane &p = depth_of(f), &q = depth_of(g);
    return p.a == q.a ? std::numeric_limits<double>::quiet_NaN() : (q.c - p.c) / (p.a - q.a);
  }
  int enters(Index face) const override { return faces_[number_of(face)].over.enters; }
  bool at_end(Index face) const override {
    const DepthPlane& lead = leads_[number_of(face)];
    return lead.a == 0 && lead.c == 0;
  }

 private:
  std::size_t number_of(Index face) const {
    return static_cast<std::size_t>(
        std::partition_point(faces_.begin(), faces_.end(),
                             [&](const Face& f) { return f.over.face < face; }) -
        faces_.begin());
  }

  std::span<const Face> faces_;
  std::vector<DepthPlane> leads_;
  std::vector<double> across_;  ///< per face: how fast it comes nearer on the side of the line
};

SolidSight::SolidSight(const Canonical& canonical) : canonical_(canonical), sweep_(canonical) {}

void SolidSight::add(const FaceOver& face) {
  faces_.push_back({canonical_.memberships[canonical_.faces[face.face].body].solid, face});
}

void SolidSight::resolve(const Ruler& ruler, double sliver, Ends ends, std::vector<Part>& parts) {
  parts.clear();
  std::sort(faces_.begin(), faces_.end(), [](const Face& f, const Face& g) {
    return f.solid != g.solid ? f.solid < g.solid : f.over.face < g.over.face;
  });
  for (std::size_t first = 0, end = 0; first < faces_.size(); first = end) {
    for (end = first; end < faces_.size() && faces_[end].solid == faces_[first].solid;) ++end;
    const std::span<const Face> of_solid(faces_.data() + first, end - first);
    for (int side = 0; side < 2; ++side)
      resolve(of_solid, side, Order(of_solid, ruler, side), sliver, ends, parts);
  }
}

void SolidSight::resolve(std::span<const Face> faces, int side, const Order& order, double sliver,
                         Ends ends, std::vector<Part>& parts) {
  const float slack = static_cast<float>(sliver / 2);
  passing_.clear();
  for (const Face& f : faces)
    for (const Interval& over : f.over.passage.side[side]) {
      const double from = std::max(over.first, 0.0), to = std::min(over.second, 1.0);
      if (!(from < to)) continue;
      passing_.push_back({from, slack, {f.over.face, kNone}});
      passing_.push_back({to, slack, {f.over.face, kNone}});
    }
  if (passing_.empty()) return;
  sort_passing(passing_);
  const Index solid = faces.front().solid;
  sweep_.begin(canonical_.solids[solid]->expression, order, 0, 1);
  if (ends == Ends::in_line) sweep_.end_at_layer();
  pieces_.clear();
  sweep(
      passing_, [&](const auto& passed) { sweep_.pass(passed); },
      [&](double t0, double t1, double slack0, double slack1) {
        sweep_.span({t0, t1, kNone, static_cast<float>(slack0), static_cast<float>(slack1)},
                    pieces_);
      });
  for (const SpanPiece& piece : pieces_)
    parts.push_back({solid, side, {piece.x0, piece.x1}, piece.face, !order.at_end(piece.face)});
}

}  // namespace overstrike
