#include "core/visibility/row_plan.h"

#include <algorithm>
#include <limits>

namespace overstrike {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// So many are laid out sooner than looked at for what is hidden.
constexpr std::size_t kFewItems = 64;

}  // namespace

SweepTable::SweepTable(const Canonical& canonical, const View& view, int threads,
                       const SolidOptions& solid_options)
    : fronts(canonical, view, FrontUse::picture, threads),
      loose(fronts),
      bodies(fronts.rows, fronts.bodies.size(),
             [&](std::size_t i) {
               const FrontBody& body = fronts.bodies[i];
               return body.seen && !body.loose ? std::pair(body.top, body.bottom)
                                               : std::pair(1.0, 0.0);
             }),
      solids(solid_options) {}

bool RowPlan::holds(double y, std::vector<double>& event_x) const {
  if (!(from <= y && y < until)) return false;
  double before = -kInfinity;
  bool same_order = true;
  for (std::size_t i = 0; i < events.size(); ++i) {
    const double x = events[i].line.x_at(y);
    event_x[i] = x;
    same_order = same_order && (events[i].same ? x == before : x > before);
    before = x;
  }
  return same_order;
}

bool RowPlan::same_stretch(const Segment& mine, const RowPlan& before, const Segment& old) const {
  if (events[mine.from].line != before.events[old.from].line ||
      events[mine.to].line != before.events[old.to].line)
    return false;
  const std::span now = contenders_of(mine), then = before.contenders_of(old);
  return std::equal(now.begin(), now.end(), then.begin(), then.end(),
                    [&](Index i, Index j) { return items[i].body == before.items[j].body; });
}

void RowPlan::take_kept(const RowPlan& before, double y, const std::vector<double>& event_x) {
  if (!(y < before.kept_until)) return;
  const auto left_of = [&](const Segment& s, double x) { return event_x[s.from] < x; };
  auto mine = segments.begin();
  for (const Segment& old : before.segments) {
    if (!old.is_kept(y)) continue;
    const double x = before.events[old.from].line.x_at(y);
    mine = std::lower_bound(mine, segments.end(), x, left_of);
    if (mine == segments.end()) return;
    if (!same_stretch(*mine, before, old)) continue;
    mine->kept_from = old.kept_from, mine->kept_until = old.kept_until;
    mine->first_kept = old.first_kept, mine->end_kept = old.end_kept;
    kept_until = std::max(kept_until, old.kept_until);
  }
}

void RowPlan::forget_kept() {
  for (Segment& s : segments) s.kept_until = s.kept_from;
  kept_until = -HUGE_VAL;
}

int RowPlanner::order(Index a, Index b) const {
  return order_of(table_.fronts.bodies[plan_->items[a].body],
                  table_.fronts.bodies[plan_->items[b].body], table_.fronts.view.eye);
}

void RowPlanner::make(double y, std::span<const Index> not_walkable, RowPlan& plan,
                      std::vector<RowSide>& sides, std::vector<double>& event_x) {
  plan_ = &plan, not_walkable_ = not_walkable, sides_ = &sides;
  collect(y);
  // A plan for less than a line is made anew for the next one, and need not know what is hidden.
  if (plan_->items.size() > kFewItems && plan_->until - plan_->from < 1) drop_hidden();
  add_ends();
  lay_out(event_x);
}

const std::vector<SpanPiece>* RowPlanner::alone(double y) {
  if (!table_.bodies[table_.bodies.band(y)].empty() || loose_.turn_to(y) != 1) return nullptr;
  return &loose_.pieces(0);
}

void RowPlanner::collect(double y) {
  plan_->items.clear(), sides_->clear();
  const std::size_t loose = loose_.turn_to(y);
  const std::size_t band = table_.bodies.band(y);
  const auto [loose_from, loose_until] = table_.loose.levels_near(y);
  plan_->from = std::max(table_.bodies.low(band), loose_from);
  plan_->until = std::min(table_.bodies.high(band), loose_until);
  meeting_bodies_.clear();
  for (const LevelBands::Item& item : table_.bodies[band]) {
    if (item.meets(y)) {
      meeting_bodies_.push_back(item.number);
    } else if (y < item.low) {
      plan_->until = std::min(plan_->until, item.low);
    } else {
      plan_->from = std::max(plan_->from, item.high);
    }
  }
  for (std::size_t i = 0; i < meeting_bodies_.size(); ++i) {
    fetch_ahead(i);
    collect_front(meeting_bodies_[i], y);
  }
  for (std::size_t i = 0; i < loose; ++i) add_stretches(loose_.body(i), loose_.pieces(i));
  if (loose > 0) plan_->until = plan_->from;
}

/// Small bodies lie all over the memory: what the next ones need is on its way while this one is
/// looked at.
void RowPlanner::fetch_ahead(std::size_t at) const {
  constexpr std::size_t kFar = 12, kNear = 6;
  const FrontTable& fronts = table_.fronts;
  if (at + kFar < meeting_bodies_.size()) {
    const FrontBody& far = fronts.bodies[meeting_bodies_[at + kFar]];
    __builtin_prefetch(&far);
    __builtin_prefetch(&far.low);
  }
  if (at + kNear >= meeting_bodies_.size()) return;
  const FrontBody& near = fronts.bodies[meeting_bodies_[at + kNear]];
  if (!near.small) return;
  const char* const sides =
      reinterpret_cast<const char*>(fronts.small_sides.data() + near.first_left);
  const std::size_t size = (near.end_right - near.first_left) * sizeof(SmallSide);
  for (std::size_t line = 0; line < size; line += 64) __builtin_prefetch(sides + line);
}

void RowPlanner::collect_front(Index body, double y) {
  const FrontBody& front = table_.fronts.bodies[body];
  const Outline outline = walker_.outline_at(body, y);
  if (outline.kind == Outline::Kind::none) {
    plan_->until = plan_->from;
    return;
  }
  const bool known =
      outline.kind == Outline::Kind::one &&
      std::find(not_walkable_.begin(), not_walkable_.end(), body) == not_walkable_.end();
  if (!known) return collect_loose(body);
  const LevelLine &left = *outline.left, &right = *outline.right;
  plan_->from = std::max({plan_->from, left.y0, right.y0});
  plan_->until = std::min({plan_->until, left.y1, right.y1});
  if (front.broken) plan_->until = plan_->from;
  const double x0 = left.x_at(y), x1 = right.x_at(y);
  if (!(x0 < x1)) {
    plan_->until = plan_->from;
    // More than rounding: an outline that crosses itself.
    const double slack = front.line_error.of(left) + front.line_error.of(right);
    if (x0 - x1 > slack) collect_loose(body);
    return;
  }
  plan_->items.push_back({body, outline, kNone, kNone, kNone, x0, x1, front.near_z, front.far_z});
}

void RowPlanner::collect_loose(Index body) {
  add_stretches(body, loose_.pieces_of(body));
  plan_->until = plan_->from;
}

void RowPlanner::add_stretches(Index body, const std::vector<SpanPiece>& pieces) {
  const FrontBody& front = table_.fronts.bodies[body];
  std::size_t first = sides_->size();
  append_sides(pieces, *sides_);
  for (std::size_t end = first; end < sides_->size(); ++end) {
    if ((*sides_)[end].face != kNone) continue;
    const double x0 = (*sides_)[first].x, x1 = (*sides_)[end].x;
    const auto from = static_cast<Index>(first), to = static_cast<Index>(end + 1);
    if (x0 < x1)
      plan_->items.push_back({body, {}, from, to, from, x0, x1, front.near_z, front.far_z});
    first = end + 1;
  }
}

/// Takes out what lies behind a single front wherever it is. The depths that decide are those that
/// order_of() compares, so that nothing is left out that would be seen.
void RowPlanner::drop_hidden() {
  cover_.clear();
  for (const RowPlan::Item& item : plan_->items) cover_.cover(item.x0, item.x1, item.far);
  const auto hidden = [&](const RowPlan::Item& item) {
    return cover_.hides(item.x0, item.x1, item.near);
  };
  if (std::erase_if(plan_->items, hidden) > 0) plan_->until = plan_->from;
}

void RowPlanner::add_ends() {
  const double columns = table_.fronts.columns;
  ends_.clear();
  ends_.push_back({0, kNone, false, {0, 0, kInfinity, 0, 0}});
  ends_.push_back({columns, kNone, false, {columns, 0, kInfinity, 0, 0}});
  for (Index i = 0; i < plan_->items.size(); ++i) {
    const RowPlan::Item& item = plan_->items[i];
    const auto end = [&](const LevelLine* line, Index side, double x, bool begins) {
      if (line == nullptr)
        return ItemEnd{x, i, begins, {x, 0, -kInfinity, 0, (*sides_)[side].slack}};
      const LineError& error = table_.fronts.bodies[item.body].line_error;
      const float slack = static_cast<float>(error.of(*line));
      return ItemEnd{x, i, begins, {line->x0, line->y0, line->y1, line->slope, slack}};
    };
    ends_.push_back(end(item.outline.left, item.first, item.x0, true));
    ends_.push_back(end(item.outline.right, item.end - 1, item.x1, false));
  }
}

/// Goes over the ends from left to right and notes, between each two that differ, what is seen.
void RowPlanner::lay_out(std::vector<double>& event_x) {
  by_x_.clear();
  for (std::size_t i = 0; i < ends_.size(); ++i)
    by_x_.push_back({ends_[i].x, static_cast<Index>(i)});
  std::sort(by_x_.begin(), by_x_.end());
  plan_->events.clear(), event_x.clear(), plan_->segments.clear(), plan_->contenders.clear(),
      active_.clear();
  plan_->kept_until = -kInfinity;
  bool chosen = false, inside = false;
  Index first_contender = 0;
  for (std::size_t i = 0; i < by_x_.size(); ++i) {
    const ItemEnd& end = ends_[by_x_[i].second];
    const Index event = static_cast<Index>(i);
    plan_->events.push_back({end.line, i > 0 && by_x_[i - 1].first == end.x});
    event_x.push_back(end.x);
    if (end.item == kNone) {
      inside = !inside;
    } else if (end.begins) {
      active_.push_back(end.item);
      chosen = chosen && order(plan_->contenders[first_contender], end.item) > 0;
    } else {
      std::erase(active_, end.item);
      chosen = chosen && std::find(plan_->contenders.begin() + first_contender,
                                   plan_->contenders.end(), end.item) == plan_->contenders.end();
    }
    if (i + 1 == by_x_.size() || by_x_[i + 1].first == end.x || !inside || active_.empty())
      continue;
    if (!chosen) first_contender = static_cast<Index>(plan_->contenders.size()), choose();
    chosen = true;
    plan_->segments.push_back(
        {event, event + 1, first_contender, static_cast<Index>(plan_->contenders.size())});
  }
}

/// Appends the winner, before which no other surely lies, and what may meet it.
void RowPlanner::choose() {
  Index winner = active_.front();
  for (std::size_t turns = 0; turns < active_.size(); ++turns) {
    const Index before = winner;
    for (const Index i : active_)
      if (i != winner && order(i, winner) > 0) winner = i;
    if (winner == before) break;
  }
  plan_->contenders.push_back(winner);
  for (const Index i : active_)
    if (i != winner && order(winner, i) <= 0) plan_->contenders.push_back(i);
}

}  // namespace overstrike
