#include "core/visibility/operand_windows.h"

#include "core/visibility/far_line.h"
#include "core/visibility/operand_reach.h"

namespace overstrike {
namespace {

/// Grid units: far more than what rounding and slacks (kMostSlack) move anything by, so that the
/// window's own borders lie where nothing is looked at.
constexpr double kMargin = 1;

GridWindow window_of(const WorldBox& box, const View& view) {
  GridWindow window{HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL};
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 p((corner & 1) != 0 ? box.high.x : box.low.x,
                 (corner & 2) != 0 ? box.high.y : box.low.y,
                 (corner & 4) != 0 ? box.high.z : box.low.z);
    const Vec4 h = view.matrix * Vec4(p, 1.0);
    if (view.perspective && !(h.z > 0)) return {};
    const Vec2 at = view.perspective ? Vec2(h) / h.z : Vec2(h);
    if (is_far_away(at)) return {};
    window.x0 = std::min(window.x0, at.x - kMargin),
    window.x1 = std::max(window.x1, at.x + kMargin);
    window.y0 = std::min(window.y0, at.y - kMargin),
    window.y1 = std::max(window.y1, at.y + kMargin);
  }
  return window;
}

}  // namespace

std::vector<GridWindow> operand_windows(const Canonical& canonical, const View& view,
                                        std::span<const FrontBody> bodies) {
  std::vector<std::vector<WorldBox>> bounds, reach;
  for (const auto& solid : canonical.solids) bounds.emplace_back(solid->expression.operands());
  const auto each = [&](const auto& visit) {
    for (Index b = 0; b < canonical.memberships.size(); ++b)
      if (canonical.memberships[b].solid != kNone) visit(b, canonical.memberships[b]);
  };
  each([&](Index b, const Membership& member) {
    bounds[member.solid][member.operand] = {bodies[b].low, bodies[b].high};
  });
  for (std::size_t s = 0; s < canonical.solids.size(); ++s) {
    const CanonicalSolid& solid = *canonical.solids[s];
    reach.emplace_back(bounds[s].size());
    add_reach(solid.nodes, bounds[s], reach[s]);
    if (solid.uncut) add_reach(solid.uncut->nodes, bounds[s], reach[s]);
  }
  bool any = false;
  std::vector<GridWindow> windows(canonical.bodies.size());
  each([&](Index b, const Membership& member) {
    const WorldBox box =
        common(bounds[member.solid][member.operand], reach[member.solid][member.operand]);
    if (box.low == bodies[b].low && box.high == bodies[b].high) return;
    windows[b] = box.empty() ? GridWindow{1, 0, 1, 0} : window_of(box, view);
    any = true;
  });
  if (!any) windows.clear();
  return windows;
}

}  // namespace overstrike
