// Of the lines along which shadow may end on a receiver, the parts where it does.
//
//   1. Those of plain bodies are the boundaries that they left (shadow_count.h), those of solids
//   the
//      sides and crossings of their operands' faces (solids_over.h).
//   2. Along each, looked at from both of its sides, it is found where there is shadow, whoever
//      casts it.
//   3. The line is an outline where there is shadow on one side of it and none on the other.
//   4. Only what lies on the receiver's face is kept.
#include <algorithm>
#include <optional>

#include "core/visibility/candidate_lines.h"
#include "core/visibility/edge_resolver.h"
#include "core/visibility/shadow_count.h"
#include "core/visibility/solids_over.h"

namespace overstrike {
namespace {

/// The ground ends at the near plane.
void keep_beyond_near_plane(const ProjectedScene& scene, SightLine& line) {
  if (!scene.view.near_plane) return;
  const Interval beyond = positive_part(scene.height(scene.near_plane(), line.a.world),
                                        scene.height(scene.near_plane(), line.b.world));
  line.within = common(line.within, {{line.in_grid(beyond.first), line.in_grid(beyond.second)}});
}

/// Lines on one receiver after the other.
class Outlines {
 public:
  Outlines(const ProjectedScene& scene, const FaceIndex& index, std::vector<SightLine>& lines)
      : scene_(scene), resolver_(scene, index), lines_(lines) {
    const std::vector<char> curved = curved_bodies(scene.canonical);
    any_curved_ = std::find(curved.begin(), curved.end(), 1) != curved.end();
  }

  /// False where the receiver is not seen.
  bool begin(const Shadow& shadow) {
    receiver_ = shadow.receiver;
    if (on_ground() ? !scene_.has_ground() : !scene_.seen(receiver_)) return false;
    count_.emplace(scene_, shadow);
    return true;
  }
  const Plane& plane() const { return scene_.plane(plane_id()); }

  /// Of plain bodies, where no solid casts.
  void add(const CastLine& cast) {
    if (!count_along(cast)) return;
    SightLine line = line_of(cast);
    line.within = difference(shadowed_[0], shadowed_[1]);
    if (!line.within.empty()) keep_on_receiver(line);
    if (!line.within.empty()) lines_.push_back(std::move(line));
  }
  /// Where some do: that is asked only over the receiver.
  void add(const CastLine& cast, SolidsOver& solids) {
    SightLine line = line_of(cast);
    keep_on_receiver(line);
    if (line.within.empty() || !count_along(cast)) return;
    const Ruler ruler(cast.a.grid, cast.b.grid);
    const double sliver = sliver_of(ruler) / ruler.length();
    solids.add_shadowed(cast, sliver, shadowed_);
    line.within = common(line.within, difference(shadowed_[0], shadowed_[1]));
    // The two sides' ends differ by rounding.
    std::erase_if(line.within, [&](const Interval& i) { return i.second - i.first <= sliver; });
    if (!line.within.empty()) lines_.push_back(std::move(line));
  }

 private:
  bool on_ground() const { return receiver_ == scene_.canonical.faces.size(); }
  Index plane_id() const {
    return on_ground() ? scene_.ground() : scene_.canonical.faces[receiver_].plane;
  }

  SightLine line_of(const CastLine& cast) const {
    const Canonical& c = scene_.canonical;
    SightLine line{cast.a, cast.b, kNoPlanes, StrokeKind::shadow_outline,
                   on_ground() ? kNoSurface : c.faces[receiver_].body};
    line.planes[0] = plane_id();
    if (!on_ground()) line.solids[0] = c.membership(line.body).solid;
    line.pen = on_ground() ? 0 : c.bodies[line.body].pen;
    line.curved = any_curved_;
    return line;
  }

  void keep_on_receiver(SightLine& line) {
    if (on_ground())
      keep_beyond_near_plane(scene_, line);
    else
      line.within = common(line.within, resolver_.inside(line, receiver_));
  }

  /// Plain bodies' shadow. False where there is no line.
  bool count_along(const CastLine& cast) {
    if (Ruler(cast.a.grid, cast.b.grid).is_point()) return false;
    count_->shadowed(cast.a.grid, cast.b.grid, shadowed_);
    return true;
  }

  const ProjectedScene& scene_;
  EdgeResolver resolver_;
  std::vector<SightLine>& lines_;
  bool any_curved_ = false;
  Index receiver_ = kNone;
  std::optional<ShadowCount> count_;
  std::array<Intervals, 2> shadowed_;
};

}  // namespace

void add_shadow_outlines(const ProjectedScene& scene, const FaceIndex& index,
                         const Canonical& casting, const std::vector<Shadow>& shadows,
                         std::vector<SightLine>& lines) {
  Outlines outlines(scene, index, lines);
  std::optional<DepthMap> eye;
  for (const Shadow& shadow : shadows) {
    if (shadow.covered || !outlines.begin(shadow)) continue;
    std::optional<SolidsOver> solids;
    if (!shadow.operands.empty()) {
      if (!eye) eye.emplace(casting.planes, casting.planes, scene.view);
      solids.emplace(scene, *eye, casting, outlines.plane(), shadow);
      for (const CastLine& line : solids->lines()) outlines.add(line, *solids);
    }
    for (const ShadowEdge& e : shadow.edges) {
      const CastLine line{{e.a, to_grid(scene.view, e.a), kNone},
                          {e.b, to_grid(scene.view, e.b), kNone}};
      solids ? outlines.add(line, *solids) : outlines.add(line);
    }
  }
}

}  // namespace overstrike
