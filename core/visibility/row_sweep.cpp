#include "core/visibility/row_sweep.h"

#include <algorithm>

namespace overstrike {
namespace {

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

RowSweep::RowSweep(const SweepTable& table)
    : faces_(table.fronts),
      columns_(table.fronts.columns),
      walker_(table.fronts),
      planner_(table, faces_, walker_),
      keeper_(faces_, table.fronts.columns) {}

void RowSweep::resolve(double y, std::vector<SpanPiece>& pieces) {
  not_walkable_.clear();
  step_ = y - last_y_, last_y_ = y;
  credit_ = std::min(credit_ + 1, kMostCredit);
  if (!plan_.holds(y, event_x_)) {
    if (show_alone(y, pieces)) return;
    make_plan(y);
  }
  // Again when a front turns out not to be walkable: the body is taken by its edges then.
  for (const std::size_t before = pieces.size(); !follow_plan(y, pieces); pieces.resize(before))
    make_plan(y);
}

/// As follow_plan() would show one connected stretch after the other.
bool RowSweep::show_alone(double y, std::vector<SpanPiece>& pieces) {
  const std::vector<SpanPiece>* const alone = planner_.alone(y);
  if (alone == nullptr) return false;
  // A plan from before must not hold any more: what was cut away is of this level now.
  plan_.until = plan_.from;
  double x = 0;
  for (SpanPiece piece : *alone) {
    if (piece.x0 < x) piece.x0 = x, piece.slack0 = 0;
    if (piece.x1 > columns_) piece.x1 = columns_, piece.slack1 = 0;
    if (!(piece.x0 < piece.x1)) continue;
    append(pieces, piece);
    x = piece.x1;
  }
  return true;
}

void RowSweep::make_plan(double y) {
  std::swap(plan_, last_plan_);
  planner_.make(y, not_walkable_, plan_, sides_, event_x_);
  plan_.take_kept(last_plan_, y, event_x_);
  fronts_from_ = -HUGE_VAL, fronts_until_ = plan_.kept_until > y ? -HUGE_VAL : HUGE_VAL;
}

bool RowSweep::follow_plan(double y, std::vector<SpanPiece>& pieces) {
  if (plan_.lasts()) {
    sides_.clear();
    for (RowPlan::Item& item : plan_.items) item.first = kNone;
  }
  if (y < plan_.kept_until && !(fronts_from_ <= y && y < fronts_until_) && !look_at_fronts(y))
    return false;
  for (RowPlan::Segment& s : plan_.segments) {
    const Interval over{event_x_[s.from], event_x_[s.to], plan_.events[s.from].line.slack,
                        plan_.events[s.to].line.slack};
    if (s.is_kept(y)) {
      show_kept(s, y, over, pieces);
      credit_ = std::min(credit_ + 1, kMostCredit);
      continue;
    }
    const std::span contenders = plan_.contenders_of(s);
    for (const Index i : contenders)
      if (plan_.items[i].first == kNone && !walk(plan_.items[i], y)) return false;
    if (contenders.size() == 1) {
      show(plan_.items[contenders[0]], over, pieces);
    } else {
      merge(y, contenders, over, pieces);
    }
    if (credit_ > 0 && y >= s.try_at && step_ > 0) keep(s, y);
  }
  return true;
}

/// What is kept may be used while the fronts of all contenders can be walked and their sides stay
/// in order. False when one cannot be walked.
bool RowSweep::look_at_fronts(double y) {
  fronts_from_ = -HUGE_VAL, fronts_until_ = HUGE_VAL;
  for (const RowPlan::Segment& s : plan_.segments) {
    if (!s.is_kept(y)) continue;
    for (const Index i : plan_.contenders_of(s))
      if (!look_at_front(plan_.items[i], y)) return false;
  }
  return true;
}

bool RowSweep::look_at_front(RowPlan::Item& item, double y) {
  std::optional front = walker_.steady_front(item.body);
  if (!front || !(front->from <= y && y < front->until)) {
    if (item.first == kNone && !walk(item, y)) return false;
    front = walker_.steady_front(item.body);
  }
  if (front) {
    fronts_from_ = std::max(fronts_from_, front->from);
    fronts_until_ = std::min(fronts_until_, front->until);
  } else {
    plan_.forget_kept();
  }
  return true;
}

/// Worth while when it lasts, which is learned: what was kept and shown pays for further trials.
void RowSweep::keep(RowPlan::Segment& segment, double y) {
  constexpr double kLeastLevels = 4;
  constexpr std::size_t kMostKept = std::size_t{1} << 12;
  const double least = y + kLeastLevels * step_;
  segment.try_at = least;
  const SlackLine &left = plan_.events[segment.from].line, &right = plan_.events[segment.to].line;
  if (std::min(left.y1, right.y1) < least) return;
  credit_ -= kPriceOfTrial;
  steady_.clear();
  for (const Index i : plan_.contenders_of(segment)) {
    const std::optional front = walker_.steady_front(plan_.items[i].body);
    if (!front) return;
    steady_.push_back(front->sides);
    fronts_from_ = std::max(fronts_from_, front->from);
    fronts_until_ = std::min(fronts_until_, front->until);
  }
  if (kept_.size() > kMostKept) kept_.clear(), plan_.forget_kept();
  segment.first_kept = static_cast<Index>(kept_.size());
  segment.kept_until = keeper_.keep(y, least, left, right, steady_, kept_);
  segment.kept_from = y;
  segment.end_kept = static_cast<Index>(kept_.size());
  plan_.kept_until = std::max(plan_.kept_until, segment.kept_until);
}

void RowSweep::show_kept(const RowPlan::Segment& segment, double y, const Interval& over,
                         std::vector<SpanPiece>& pieces) const {
  double x = over.x0;
  float slack = over.slack0;
  for (Index i = segment.first_kept; i < segment.end_kept; ++i) {
    const KeptPiece& k = kept_[i];
    const bool crosses = k.next != kNone;
    const double end = crosses ? faces_.crossing(k.face, k.next, y) : k.end.x_at(y);
    const float end_slack = crosses ? 0 : k.end.slack;
    append(pieces, {x, end, k.face, slack, end_slack});
    x = end, slack = end_slack;
  }
}

/// Sides that rounding has put out of order are put where their neighbour is; more than that is a
/// face that is inside out, which its body's edges must tell about.
bool RowSweep::walk(RowPlan::Item& item, double y) {
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

void RowSweep::show(RowPlan::Item& item, const Interval& over, std::vector<SpanPiece>& pieces) {
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
    RowPlan::Item& item = plan_.items[i];
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
  for (const Contender& c : meeting_) plan_.items[c.item].at = c.at;
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
