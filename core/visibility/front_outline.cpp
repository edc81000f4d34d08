#include "core/visibility/front_outline.h"

#include <algorithm>
#include <limits>

namespace overstrike {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A body whose outline begins twice at more than this part of its levels gets an active edge list
/// at all of them.
constexpr double kMostManifold = 1.0 / 8;
/// Sides that are looked at one by one on every level, rather than walked once for several; and the
/// levels over which that pays.
constexpr std::size_t kFewSides = 16;
constexpr double kFewLevels = 8;

/// The outline's left is somewhere right of its right: it crosses itself.
bool crossed(const std::vector<OutlineSide>& left, const std::vector<OutlineSide>& right,
             const LineError& error) {
  const auto x_at = [](const OutlineSide& s, double y) {
    return y == s.line.y1 ? s.x1 : s.line.x_at(y);
  };
  for (std::size_t i = 0, j = 0; i < left.size() && j < right.size();) {
    const OutlineSide &l = left[i], &r = right[j];
    const double slack = error.of(l.line) + error.of(r.line);
    for (const double y : {std::max(l.line.y0, r.line.y0), std::min(l.line.y1, r.line.y1)})
      if (x_at(l, y) - x_at(r, y) > slack) return true;
    l.line.y1 < r.line.y1 ? ++i : ++j;
  }
  return false;
}

}  // namespace

void OutlineFinder::clear() { left_.clear(), right_.clear(), inner_.clear(); }

/// Between two seen faces.
void OutlineFinder::add_inner_side(const FrontBody& front, const Side& side, Index next,
                                   Index other) {
  const Index from = c_.corners[side.corner], to = c_.corners[next];
  if (table_.points[from].y == table_.points[to].y) return;
  const LevelLine line = table_.line(front, from, to, side.face, other);
  if (!(line.y0 < line.y1)) return;
  // What goes down in a face's loop has the face on its right, when it is seen from its front.
  const bool down = table_.points[from].y < table_.points[to].y;
  const bool ahead = down != table_.from_behind(side.face);
  inner_.push_back({line, ahead ? other : side.face, ahead ? side.face : other});
}

void OutlineFinder::add_side(const FrontBody& front, const Side& side, Index next, Index other) {
  const Index from = c_.corners[side.corner], to = c_.corners[next];
  const Vec2 &a = table_.points[from], &b = table_.points[to];
  if (a.y == b.y) return;
  const LevelLine line = table_.line(front, from, to, side.face, other);
  if (!(line.y0 < line.y1)) return;
  const bool down = a.y < b.y;
  const double end = front.far ? line.x_at(line.y1) : (down ? b.x : a.x);
  // Seen from outside a loop runs counter-clockwise, y points down: what goes down begins the face.
  (down != table_.from_behind(side.face) ? left_ : right_).push_back({line, end, side});
}

/// Of a seen face. Copies share their twins, so that these are nearer at hand than edges.
void OutlineFinder::find_sides(const CanonicalBody& body, const FrontBody& front, Index face) {
  const CanonicalFace& f = c_.faces[face];
  const Twin* const twins = c_.twins.data() + body.first_twin;
  const signed char* const seen = table_.sides.data() + body.first_face;
  const Index own = face - body.first_face;
  const bool picture = table_.use == FrontUse::picture;
  for (Index l = f.first_loop; l < f.end_loop; ++l) {
    const Index first = c_.first_corner(l), end = c_.loop_ends[l];
    for (Index i = first; i < end; ++i) {
      const Index other = twins[i - body.first_corner].face;
      const Index next = i + 1 == end ? first : i + 1;
      if (other == kNone || seen[other] == 0) {
        add_side(front, {i, face}, next, other == kNone ? kNone : body.first_face + other);
      } else if (own < other && picture && inner_.size() <= kFewSides) {
        add_inner_side(front, {i, face}, next, body.first_face + other);
      }
    }
  }
}

/// Closed loops begin as often as they end, so that the beginnings tell for both.
void OutlineFinder::note_manifold_levels(Index number) {
  FrontBody& front = table_.bodies[number];
  const std::size_t before = table_.manifold.size();
  double end = -kInfinity, sum = 0;
  for (const OutlineSide& side : left_) {
    if (side.line.y0 < end) {
      const double high = std::min(end, side.line.y1);
      table_.manifold.push_back({side.line.y0, high});
      sum += high - side.line.y0;
    }
    end = std::max(end, side.line.y1);
  }
  front.top = left_.empty() ? 0 : left_.front().line.y0;
  front.bottom = left_.empty() ? 0 : end;
  front.loose = sum > kMostManifold * (front.bottom - front.top);
  if (front.loose) table_.manifold.resize(before);
  front.first_manifold = static_cast<Index>(before);
  front.end_manifold = static_cast<Index>(table_.manifold.size());
  const auto broken = [](const std::vector<OutlineSide>& sides) {
    for (std::size_t i = 1; i < sides.size(); ++i)
      if (sides[i].line.y0 != sides[i - 1].line.y1) return true;
    return false;
  };
  front.broken = broken(left_) || broken(right_);
}

void OutlineFinder::keep_outline(Index number) {
  FrontBody& front = table_.bodies[number];
  const auto by_level = [](const OutlineSide& a, const OutlineSide& b) {
    return a.line.y0 != b.line.y0 ? a.line.y0 < b.line.y0 : a.side.corner < b.side.corner;
  };
  std::sort(left_.begin(), left_.end(), by_level);
  std::sort(right_.begin(), right_.end(), by_level);
  note_manifold_levels(number);
  front.loose = front.loose || (!front.broken && crossed(left_, right_, front.line_error));
  if (front.loose) return;
  const bool low = front.bottom - front.top <= kFewLevels || number == table_.ground_body();
  front.small = table_.use == FrontUse::picture && low && !front.broken && !left_.empty() &&
                left_.size() + right_.size() + inner_.size() <= kFewSides;
  if (front.small) return keep_small(front);
  const auto append = [&](const std::vector<OutlineSide>& sides, Index& first, Index& end) {
    first = static_cast<Index>(table_.outlines.size());
    table_.outlines.insert(table_.outlines.end(), sides.begin(), sides.end());
    end = static_cast<Index>(table_.outlines.size());
  };
  append(left_, front.first_left, front.end_left);
  append(right_, front.first_right, front.end_right);
}

void OutlineFinder::keep_small(FrontBody& front) {
  std::vector<SmallSide>& sides = table_.small_sides;
  front.first_left = static_cast<Index>(sides.size());
  for (const OutlineSide& s : left_) sides.push_back({s.line, kNone, s.side.face});
  front.first_right = static_cast<Index>(sides.size());
  for (const OutlineSide& s : right_) sides.push_back({s.line, s.side.face, kNone});
  front.end_right = static_cast<Index>(sides.size());
  sides.insert(sides.end(), inner_.begin(), inner_.end());
  front.end_left = static_cast<Index>(sides.size());
}

void OutlineFinder::find(Index number) {
  const CanonicalBody& body = c_.bodies[number];
  const FrontBody& front = table_.bodies[number];
  if (!front.seen || front.loose) return;
  clear();
  for (Index f = body.first_face; f < body.end_face; ++f)
    if (table_.seen(f)) find_sides(body, front, f);
  keep_outline(number);
}

void OutlineFinder::find_ground(std::span<const Vec2> polygon) {
  clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    if (a.y == b.y) continue;
    const bool down = a.y < b.y;
    const Side side{kNone, table_.ground()};
    (down ? right_ : left_)
        .push_back({down ? LevelLine(a, b) : LevelLine(b, a), down ? b.x : a.x, side});
  }
  keep_outline(table_.ground_body());
}

}  // namespace overstrike
