#include "core/visibility/front_walk.h"

#include <algorithm>

namespace overstrike {

FrontWalker::FrontWalker(const FrontTable& table)
    : table_(table), fronts_(table.bodies.size()), cursors_(table.bodies.size()) {
  for (std::size_t b = 0; b < cursors_.size(); ++b)
    cursors_[b] = {table.bodies[b].first_left, table.bodies[b].first_right};
}

/// To the last side of [first, end) that begins at y or above, or to `first`.
void FrontWalker::seek(Index& cursor, Index first, Index end, double y) const {
  const std::vector<OutlineSide>& sides = table_.outlines;
  constexpr Index kFewSteps = 4;
  for (Index steps = 0; cursor + 1 < end && sides[cursor + 1].line.y0 <= y; ++cursor)
    if (++steps > kFewSteps) break;
  const bool found =
      sides[cursor].line.y0 <= y && (cursor + 1 == end || sides[cursor + 1].line.y0 > y);
  if (found) return;
  const auto after =
      std::upper_bound(sides.begin() + first, sides.begin() + end, y,
                       [](double level, const OutlineSide& s) { return level < s.line.y0; });
  cursor = static_cast<Index>(after - sides.begin());
  if (cursor > first) --cursor;
}

/// The side of an unbroken chain that meets the level, or null.
const LevelLine* FrontWalker::chain_at(Index first, Index end, double y) const {
  while (first < end && table_.small_sides[first].line.y1 <= y) ++first;
  if (first == end || y < table_.small_sides[first].line.y0) return nullptr;
  return &table_.small_sides[first].line;
}

Outline FrontWalker::small_outline(const FrontBody& front, double y) const {
  Outline outline;
  outline.left = chain_at(front.first_left, front.first_right, y);
  outline.right = chain_at(front.first_right, front.end_right, y);
  if (outline.left != nullptr && outline.right != nullptr) outline.kind = Outline::Kind::one;
  return outline;
}

/// From side to side by the face between them.
bool FrontWalker::list_small(const FrontBody& front, double y) {
  const SmallSide* meeting[16];
  std::size_t count = 0;
  for (Index i = front.first_left; i < front.end_left; ++i) {
    const SmallSide& s = table_.small_sides[i];
    if (s.line.y0 <= y && y < s.line.y1) meeting[count++] = &s;
  }
  for (Index face = kNone; count > 0;) {
    std::size_t i = 0;
    while (i < count && meeting[i]->left != face) ++i;
    if (i == count) return false;
    const SmallSide& s = *meeting[i];
    meeting[i] = meeting[--count];
    face = s.right;
    sides_.push_back({s.line.x0, s.line.y0, s.line.y1, s.line.slope, face,
                      static_cast<float>(front.line_error.of(s.line))});
    if (face == kNone) return true;
  }
  return false;
}

Outline FrontWalker::outline_at(Index body, double y) {
  const FrontBody& front = table_.bodies[body];
  if (!(front.top <= y && y < front.bottom)) return {};
  if (front.small) return small_outline(front, y);
  Cursor& at = cursors_[body];
  seek(at.left, front.first_left, front.end_left, y);
  seek(at.right, front.first_right, front.end_right, y);
  const auto meets = [y](const OutlineSide& s) { return s.line.y0 <= y && y < s.line.y1; };
  const OutlineSide& left = table_.outlines[at.left];
  const OutlineSide& right = table_.outlines[at.right];
  Outline outline{Outline::Kind::one, &left.line, &right.line, left.side, right.side.corner};
  if (!front.broken) {
    if (!meets(left) || !meets(right)) outline.kind = Outline::Kind::none;
    return outline;
  }
  // Sides that overlap in their levels, if only by rounding: the last to begin may have ended.
  const auto in = [&](const ManifoldLevels& m) { return m.low <= y && y < m.high; };
  if (!meets(left) || !meets(right) ||
      std::any_of(table_.manifold.begin() + front.first_manifold,
                  table_.manifold.begin() + front.end_manifold, in))
    outline.kind = Outline::Kind::several;
  return outline;
}

std::span<const FrontSide> FrontWalker::front_at(Index body, double y, const Outline& outline) {
  sides_.clear();
  if (table_.bodies[body].small) {
    if (!list_small(table_.bodies[body], y)) sides_.clear();
    return sides_;
  }
  Front& front = fronts_[body];
  if (front.turn == turn_ && front.from <= y && y < front.until)
    return {kept_.data() + front.first, front.count};
  front.from = table_.bodies[body].top, front.until = table_.bodies[body].bottom;
  front.steady = Steady::unknown;
  if (!walk(body, y, outline, front)) {
    front.turn = 0;
    return {};
  }
  keep(front);
  return {kept_.data() + front.first, front.count};
}

void FrontWalker::keep(Front& front) {
  front.count = static_cast<Index>(sides_.size());
  if (front.turn != turn_ || front.room < front.count) {
    constexpr std::size_t kMostKept = std::size_t{1} << 18;
    if (kept_.size() > kMostKept) kept_.clear(), ++turn_;
    front.first = static_cast<Index>(kept_.size());
    front.room = front.count + front.count / 4;
    front.turn = turn_;
    kept_.resize(kept_.size() + front.room);
  }
  std::copy(sides_.begin(), sides_.end(), kept_.begin() + front.first);
}

/// Sides move along straight lines: what holds at both ends of the levels holds between. Rounding
/// of x_at is less than a quarter of the slack, which bounds it together with the errors of points.
bool FrontWalker::stays_in_order(const Front& front) const {
  for (Index i = front.first; i < front.first + front.count; ++i) {
    const FrontSide& s = kept_[i];
    if (i == front.first) continue;
    const FrontSide& before = kept_[i - 1];
    const double most = (before.slack + s.slack) / 4;
    for (const double y : {front.from, front.until})
      if (!(before.x_at(y) - s.x_at(y) <= most)) return false;
  }
  return true;
}

std::optional<FrontWalker::SteadyFront> FrontWalker::steady_front(Index body) {
  Front& front = fronts_[body];
  if (table_.bodies[body].small || front.turn != turn_) return {};
  if (front.steady == Steady::unknown)
    front.steady = stays_in_order(front) ? Steady::yes : Steady::no;
  if (front.steady == Steady::no) return {};
  return SteadyFront{{kept_.data() + front.first, front.count}, front.from, front.until};
}

void FrontWalker::add(const FrontBody& body, const LevelLine& line, Index face, Front& front) {
  front.from = std::max(front.from, line.y0);
  front.until = std::min(front.until, line.y1);
  sides_.push_back(
      {line.x0, line.y0, line.y1, line.slope, face, static_cast<float>(body.line_error.of(line))});
}

/// The corner where the side begins by which the level leaves the face; kNone when it meets more
/// than two sides. (Each side is met or not by its ends alone, so that their number is even.)
Index FrontWalker::exit_of(Index face, Index entry, double y) const {
  const Canonical& c = table_.canonical;
  const Index loop = c.faces[face].first_loop;
  const Index first = c.first_corner(loop), end = c.loop_ends[loop];
  const auto above = [&](Index corner) { return table_.points[c.corners[corner]].y <= y; };
  const auto next = [&](Index corner) { return corner + 1 == end ? first : corner + 1; };
  Index a = next(entry), found = kNone;
  bool a_above = above(a);
  for (; a != entry; a = next(a)) {
    const bool b_above = above(next(a));
    if (a_above != b_above) {
      if (found != kNone) return kNone;
      found = a;
    }
    a_above = b_above;
  }
  return found;
}

/// Between two sides that a level meets lies one corner of a triangle; it takes the place of the
/// upper end of the side or of the lower one.
bool FrontWalker::walk_triangles(const CanonicalBody& body, const LineError& error, double y,
                                 const Outline& outline, Front& front) {
  const Canonical& c = table_.canonical;
  const Vec2* const points = table_.points.data();
  const Index* const corners = c.corners.data();
  const Twin* const twins = c.twins.data() + body.first_twin - body.first_corner;
  Side side = outline.first;
  const bool behind = table_.from_behind(side.face);
  const auto first_of = [&](Index face) {
    return body.first_corner + 3 * (face - body.first_face);
  };
  const auto after = [](Index corner, Index first) {
    return corner - first == 2 ? first : corner + 1;
  };
  Index first = first_of(side.face);
  Vec2 top = points[corners[side.corner]], bottom = points[corners[after(side.corner, first)]];
  if (behind) std::swap(top, bottom);
  double from = front.from, until = front.until;
  const double constant = error.constant;
  const double per_slope = static_cast<double>(error.per_slope) + error.beside;
  const auto add = [&](Index face) {
    from = std::max(from, top.y), until = std::min(until, bottom.y);
    const double height = bottom.y - top.y, slope = (bottom.x - top.x) / height;
    double slack = constant + std::min(per_slope, height) * std::fabs(slope);
    if (slack > kSmallSlack) slack = error.of(LevelLine(top, bottom));
    sides_.push_back({top.x, top.y, bottom.y, slope, face, static_cast<float>(slack)});
  };
  for (Index steps = body.first_face; steps < body.end_face; ++steps) {
    add(side.face);
    const Index next = after(side.corner, first), last = after(next, first);
    const Vec2& apex = points[corners[last]];
    const bool above = apex.y <= y;
    (above ? top : bottom) = apex;
    const Index exit = above != behind ? next : last;
    const Twin twin = twins[exit];
    if (twin.face == kNone || !table_.seen(twin.face + body.first_face)) {
      add(kNone);
      front.from = from, front.until = until;
      return exit == outline.last_corner;
    }
    side = {twin.corner + body.first_corner, twin.face + body.first_face};
    first = first_of(side.face);
  }
  return false;
}

bool FrontWalker::walk(Index number, double y, const Outline& outline, Front& front) {
  const Canonical& c = table_.canonical;
  const FrontBody& seen = table_.bodies[number];
  const CanonicalBody& body = c.bodies[number];
  if (seen.triangles) return walk_triangles(body, seen.line_error, y, outline, front);
  const auto line_of = [&](Index corner, Index face, Index other) {
    const Index loop = c.faces[face].first_loop;
    const Index next = corner + 1 == c.loop_ends[loop] ? c.first_corner(loop) : corner + 1;
    return table_.line(seen, c.corners[corner], c.corners[next], face, other);
  };
  Side side = outline.first;
  Index before = seen.far ? c.twin(body, side.corner).face : kNone;
  for (Index steps = body.first_face; steps < body.end_face; ++steps) {
    add(seen, line_of(side.corner, side.face, before), side.face, front);
    const Index exit = exit_of(side.face, side.corner, y);
    if (exit == kNone) return false;
    const Twin twin = c.twin(body, exit);
    if (!table_.seen(twin.face)) {
      add(seen, line_of(exit, side.face, twin.face), kNone, front);
      return exit == outline.last_corner;
    }
    before = side.face;
    side = {twin.corner, twin.face};
  }
  return false;
}

}  // namespace overstrike
