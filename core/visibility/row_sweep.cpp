#include "core/visibility/row_sweep.h"

#include <algorithm>
#include <limits>

namespace overstrike {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// So many are laid out sooner than looked at for what is hidden.
constexpr std::size_t kFewItems = 64;

/// Neighbours of one face become one piece.
void append(std::vector<SpanPiece>& pieces, const SpanPiece& piece) {
  if (!pieces.empty() && pieces.back().x1 == piece.x0 && pieces.back().face == piece.face) {
    pieces.back().x1 = piece.x1;
    pieces.back().slack1 = piece.slack1;
  } else {
    pieces.push_back(piece);
  }
}

}  // namespace

SweepTable::SweepTable(const Canonical& canonical, const View& view, int threads)
    : fronts(canonical, view, FrontUse::picture, threads),
      loose(fronts),
      bodies(fronts.rows, fronts.bodies.size(), [&](std::size_t i) {
        const FrontBody& body = fronts.bodies[i];
        return body.seen && !body.loose ? std::pair(body.top, body.bottom) : std::pair(1.0, 0.0);
      }) {}

RowSweep::RowSweep(const SweepTable& table)
    : table_(table), faces_(table.fronts), walker_(table.fronts), cover_(table.fronts.columns) {}

void RowSweep::resolve(double y, std::vector<SpanPiece>& pieces) {
  not_walkable_.clear();
  if (!plan_holds(y)) make_plan(y);
  // Again when a front turns out not to be walkable: the body is taken by its edges then.
  for (const std::size_t before = pieces.size(); !follow_plan(y, pieces); pieces.resize(before))
    make_plan(y);
}

bool RowSweep::plan_holds(double y) {
  if (!(from_ <= y && y < until_)) return false;
  double before = -kInfinity;
  bool holds = true;
  for (std::size_t i = 0; i < events_.size(); ++i) {
    const double x = events_[i].x_at(y);
    event_x_[i] = x;
    holds = holds && (events_[i].same ? x == before : x > before);
    before = x;
  }
  return holds;
}

void RowSweep::make_plan(double y) {
  collect(y);
  // A plan for less than a line is made anew for the next one, and need not know what is hidden.
  if (items_.size() > kFewItems && until_ - from_ < 1) drop_hidden();
  add_ends();
  lay_out();
}

void RowSweep::collect(double y) {
  items_.clear(), sides_.clear();
  const std::size_t band = table_.bodies.band(y);
  const auto [loose_from, loose_until] = table_.loose.levels_near(y);
  from_ = std::max(table_.bodies.low(band), loose_from);
  until_ = std::min(table_.bodies.high(band), loose_until);
  meeting_bodies_.clear();
  for (const LevelBands::Item& item : table_.bodies[band]) {
    if (item.meets(y)) {
      meeting_bodies_.push_back(item.number);
    } else if (y < item.low) {
      until_ = std::min(until_, item.low);
    } else {
      from_ = std::max(from_, item.high);
    }
  }
  for (std::size_t i = 0; i < meeting_bodies_.size(); ++i) {
    fetch_ahead(i);
    collect_front(meeting_bodies_[i], y);
  }
  const std::span<const LevelBands::Item> edges = table_.loose.near(y);
  for (std::size_t i = 0; i < edges.size();) {
    if (!loose_) loose_.emplace(table_.fronts, faces_);
    const Index body = table_.loose[edges[i].number].body;
    for (; i < edges.size() && table_.loose[edges[i].number].body == body; ++i)
      if (edges[i].meets(y)) loose_->add(table_.loose[edges[i].number], y);
    const std::size_t first = sides_.size();
    loose_->resolve(y, sides_);
    add_stretches(body, first);
    until_ = from_;
  }
}

/// Small bodies lie all over the memory: what the next ones need is on its way while this one is
/// looked at.
void RowSweep::fetch_ahead(std::size_t at) const {
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

void RowSweep::collect_front(Index body, double y) {
  const FrontBody& front = table_.fronts.bodies[body];
  const Outline outline = walker_.outline_at(body, y);
  if (outline.kind == Outline::Kind::none) {
    until_ = from_;
    return;
  }
  const bool known =
      outline.kind == Outline::Kind::one &&
      std::find(not_walkable_.begin(), not_walkable_.end(), body) == not_walkable_.end();
  if (!known) return collect_loose(body, y);
  const LevelLine &left = *outline.left, &right = *outline.right;
  from_ = std::max({from_, left.y0, right.y0});
  until_ = std::min({until_, left.y1, right.y1});
  if (front.broken) until_ = from_;
  const double x0 = left.x_at(y), x1 = right.x_at(y);
  if (!(x0 < x1)) {
    until_ = from_;
    // More than rounding: an outline that crosses itself.
    const double slack = front.line_error.of(left) + front.line_error.of(right);
    if (x0 - x1 > slack) collect_loose(body, y);
    return;
  }
  items_.push_back({body, outline, kNone, kNone, kNone, x0, x1, front.near_z, front.far_z});
}

void RowSweep::collect_loose(Index number, double y) {
  if (!loose_) loose_.emplace(table_.fronts, faces_);
  const CanonicalBody& body = table_.fronts.canonical.bodies[number];
  LooseEdge edge;
  for (Index e = body.first_edge; e < body.end_edge; ++e)
    if (to_loose_edge(table_.fronts, table_.fronts.canonical.edges[e], number, edge))
      loose_->add(edge, y);
  const std::size_t first = sides_.size();
  loose_->resolve(y, sides_);
  add_stretches(number, first);
  until_ = from_;
}

void RowSweep::add_stretches(Index body, std::size_t first) {
  const FrontBody& front = table_.fronts.bodies[body];
  for (std::size_t end = first; end < sides_.size(); ++end) {
    if (sides_[end].face != kNone) continue;
    const RowSide &left = sides_[first], &right = sides_[end];
    if (left.x < right.x)
      items_.push_back({body,
                        {},
                        static_cast<Index>(first),
                        static_cast<Index>(end + 1),
                        static_cast<Index>(first),
                        left.x,
                        right.x,
                        front.near_z,
                        front.far_z});
    first = end + 1;
  }
}

/// Takes out what lies behind a single front wherever it is. The depths that decide are those that
/// order_of() compares, so that nothing is left out that would be seen.
void RowSweep::drop_hidden() {
  cover_.clear();
  for (const Item& item : items_) cover_.cover(item.x0, item.x1, item.far);
  const auto hidden = [&](const Item& item) { return cover_.hides(item.x0, item.x1, item.near); };
  if (std::erase_if(items_, hidden) > 0) until_ = from_;
}

void RowSweep::add_ends() {
  ends_.clear();
  ends_.push_back({0, kNone, false, {0, 0, 0, 0, false}});
  ends_.push_back({table_.fronts.columns, kNone, false, {table_.fronts.columns, 0, 0, 0, false}});
  for (Index i = 0; i < items_.size(); ++i) {
    const Item& item = items_[i];
    const auto end = [&](const LevelLine* line, Index side, double x, bool begins) {
      if (line == nullptr) return ItemEnd{x, i, begins, {x, 0, 0, sides_[side].slack, false}};
      const LineError& error = table_.fronts.bodies[item.body].line_error;
      const float slack = static_cast<float>(error.of(*line));
      return ItemEnd{x, i, begins, {line->x0, line->y0, line->slope, slack, false}};
    };
    ends_.push_back(end(item.outline.left, item.first, item.x0, true));
    ends_.push_back(end(item.outline.right, item.end - 1, item.x1, false));
  }
}

/// Goes over the ends from left to right and notes, between each two that differ, what is seen.
void RowSweep::lay_out() {
  by_x_.clear();
  for (std::size_t i = 0; i < ends_.size(); ++i)
    by_x_.push_back({ends_[i].x, static_cast<Index>(i)});
  std::sort(by_x_.begin(), by_x_.end());
  events_.clear(), event_x_.clear(), segments_.clear(), contenders_.clear(), active_.clear();
  bool chosen = false, inside = false;
  Index first_contender = 0;
  for (std::size_t i = 0; i < by_x_.size(); ++i) {
    const ItemEnd& end = ends_[by_x_[i].second];
    const Index event = static_cast<Index>(i);
    events_.push_back(end.event);
    events_.back().same = i > 0 && by_x_[i - 1].first == end.x;
    event_x_.push_back(end.x);
    if (end.item == kNone) {
      inside = !inside;
    } else if (end.begins) {
      active_.push_back(end.item);
      chosen = chosen && order(contenders_[first_contender], end.item) > 0;
    } else {
      std::erase(active_, end.item);
      chosen = chosen && std::find(contenders_.begin() + first_contender, contenders_.end(),
                                   end.item) == contenders_.end();
    }
    if (i + 1 == by_x_.size() || by_x_[i + 1].first == end.x || !inside || active_.empty())
      continue;
    if (!chosen) first_contender = static_cast<Index>(contenders_.size()), choose();
    chosen = true;
    segments_.push_back(
        {event, event + 1, first_contender, static_cast<Index>(contenders_.size())});
  }
}

/// Appends the winner, before which no other surely lies, and what may meet it.
void RowSweep::choose() {
  Index winner = active_.front();
  for (std::size_t turns = 0; turns < active_.size(); ++turns) {
    const Index before = winner;
    for (const Index i : active_)
      if (i != winner && order(i, winner) > 0) winner = i;
    if (winner == before) break;
  }
  contenders_.push_back(winner);
  for (const Index i : active_)
    if (i != winner && order(winner, i) <= 0) contenders_.push_back(i);
}

bool RowSweep::follow_plan(double y, std::vector<SpanPiece>& pieces) {
  if (from_ < until_) {
    sides_.clear();
    for (Item& item : items_) item.first = kNone;
  }
  for (const Segment& s : segments_) {
    const Interval over{event_x_[s.from], event_x_[s.to], events_[s.from].slack,
                        events_[s.to].slack};
    const std::span contenders(contenders_.data() + s.first_contender,
                               contenders_.data() + s.end_contender);
    for (const Index i : contenders)
      if (items_[i].first == kNone && !walk(items_[i], y)) return false;
    if (contenders.size() == 1) {
      show(items_[contenders[0]], over, pieces);
    } else {
      merge(y, contenders, over, pieces);
    }
  }
  return true;
}

/// Sides that rounding has put out of order are put where their neighbour is; more than that is a
/// face that is inside out, which its body's edges must tell about.
bool RowSweep::walk(Item& item, double y) {
  const std::span<const FrontSide> front = walker_.front_at(item.body, y, item.outline);
  if (front.empty()) {
    not_walkable_.push_back(item.body);
    return false;
  }
  item.first = item.at = static_cast<Index>(sides_.size());
  sides_.resize(sides_.size() + front.size());
  RowSide* side = sides_.data() + item.first;
  const double last = front.back().x_at(y);
  double x = front.front().x_at(y);
  float slack = front.front().slack;
  bool ordered = true;
  for (const FrontSide& s : front) {
    const double at = s.x_at(y);
    ordered = ordered && x - at <= slack + s.slack;
    x = std::min(std::max(x, at), last), slack = s.slack;
    *side++ = {x, s.face, s.slack};
  }
  if (!ordered) {
    not_walkable_.push_back(item.body);
    return false;
  }
  item.end = static_cast<Index>(sides_.size());
  return true;
}

void RowSweep::show(Item& item, const Interval& over, std::vector<SpanPiece>& pieces) {
  Index at = item.at;
  while (at + 2 < item.end && sides_[at + 1].x <= over.x0) ++at;
  double x = over.x0;
  float slack = over.slack0;
  const auto show_to = [&](double end, float end_slack) {
    if (x == over.x0) {
      append(pieces, {x, end, sides_[at].face, slack, end_slack});
    } else {
      pieces.push_back({x, end, sides_[at].face, slack, end_slack});
    }
  };
  for (; at + 2 < item.end && sides_[at + 1].x < over.x1; ++at) {
    const RowSide& next = sides_[at + 1];
    if (next.x > x) show_to(next.x, next.slack);
    x = std::max(x, next.x), slack = next.slack;
  }
  show_to(over.x1, over.slack1);
  item.at = at;
}

void RowSweep::Contender::look(const RowSide* sides, const FaceOrder& order, double y) {
  face = sides[at].face;
  const DepthPlane& d = order.depth_of(face);
  slope = d.a, constant = d.b * y + d.c;
  slope_error = d.ea, constant_error = d.eb * std::fabs(y) + d.ec;
}

/// Goes over the spans between the sides of all contenders. As everywhere, spans of rounding's
/// making are left to their neighbours; but a whole interval has none.
void RowSweep::merge(double y, std::span<const Index> contenders, const Interval& over,
                     std::vector<SpanPiece>& pieces) {
  meeting_.clear();
  for (const Index i : contenders) {
    Item& item = items_[i];
    while (item.at + 2 < item.end && sides_[item.at + 1].x <= over.x0) ++item.at;
    meeting_.push_back({i, item.at, item.end});
    meeting_.back().look(sides_.data(), faces_, y);
  }
  double x = over.x0;
  double slack = over.slack0;
  while (x < over.x1) {
    double next = over.x1;
    float next_slack = over.slack1;
    for (const Contender& c : meeting_) {
      const RowSide& after = sides_[c.at + 1];
      if (c.at + 2 < c.end && after.x < next) next = after.x, next_slack = after.slack;
    }
    if (next - x > slack + next_slack || (next == over.x1 && x == over.x0)) {
      compare(y, {x, next, static_cast<float>(slack), next_slack}, pieces);
      slack = std::max<double>(next_slack, slack - (next - x));
      x = next;
    } else {
      slack = std::max<double>(slack, next_slack);
      if (next == over.x1) {
        if (!pieces.empty() && pieces.back().x1 == x) pieces.back().x1 = next;
        x = next;
      }
    }
    for (Contender& c : meeting_) {
      const Index before = c.at;
      while (c.at + 2 < c.end && sides_[c.at + 1].x <= next) ++c.at;
      if (c.at != before) c.look(sides_.data(), faces_, y);
    }
  }
  for (const Contender& c : meeting_) items_[c.item].at = c.at;
}

/// The contender that is nearest at x, where doubles can tell; else null.
const RowSweep::Contender* RowSweep::surely_nearest(double x) const {
  const Contender* best = &meeting_[0];
  for (const Contender& c : std::span(meeting_).subspan(1)) {
    const double difference = c.depth(x) - best->depth(x);
    if (std::fabs(difference) <= c.error(x) + best->error(x)) return nullptr;
    if (difference > 0) best = &c;
  }
  return best;
}

void RowSweep::compare(double y, const Interval& over, std::vector<SpanPiece>& pieces) {
  // What is surely nearest at both ends is so between them.
  const double low = over.x0 + over.slack0, high = over.x1 - over.slack1;
  if (low < high) {
    const Contender* nearest = surely_nearest(low);
    if (nearest != nullptr && nearest == surely_nearest(high))
      return append(pieces, {over.x0, over.x1, nearest->face, over.slack0, over.slack1});
  }
  span_faces_.clear();
  for (const Contender& c : meeting_) span_faces_.push_back(c.face);
  split_.clear();
  split_at_crossings(faces_, span_faces_, over.x0, over.x1, y, over.slack0, over.slack1, split_);
  for (const SpanPiece& piece : split_) append(pieces, piece);
}

}  // namespace overstrike
