#include "core/visibility/row_sweep.h"

#include <algorithm>
#include <limits>

namespace overstrike {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

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

SweepTable::SweepTable(const Canonical& canonical, const View& view)
    : fronts(canonical, view),
      loose(fronts),
      bodies(fronts.rows, fronts.bodies.size(), [&](std::size_t i) {
        const FrontBody& body = fronts.bodies[i];
        return body.seen && !body.loose ? std::pair(body.top, body.bottom) : std::pair(1.0, 0.0);
      }) {}

RowSweep::RowSweep(const SweepTable& table)
    : table_(table), faces_(table.fronts), walker_(table.fronts) {}

void RowSweep::resolve(double y, std::vector<SpanPiece>& pieces) {
  not_walkable_.clear();
  // Again when a front turns out not to be walkable: the body is taken by its edges then.
  for (const std::size_t before = pieces.size();; pieces.resize(before)) {
    collect(y);
    if (sweep(y, pieces)) return;
  }
}

void RowSweep::add_item(const Item& item) {
  if (!(item.x0 < item.x1) || item.x1 <= 0 || item.x0 >= table_.fronts.columns) return;
  items_.push_back(item);
}

void RowSweep::collect(double y) {
  items_.clear(), sides_.clear();
  const std::size_t band = table_.bodies.band(y);
  for (const Index body : table_.bodies[band]) {
    const Outline outline = walker_.outline_at(body, y);
    if (outline.kind == Outline::Kind::none) continue;
    const bool walkable =
        outline.kind == Outline::Kind::one &&
        std::find(not_walkable_.begin(), not_walkable_.end(), body) == not_walkable_.end();
    if (!walkable) {
      collect_loose(body, y);
      continue;
    }
    const LineError& error = table_.fronts.bodies[body].line_error;
    add_item({outline.left->line.x_at(y), outline.right->line.x_at(y),
              static_cast<float>(error.of(outline.left->line)),
              static_cast<float>(error.of(outline.right->line)), body, kNone, kNone, 0, outline});
  }
  const std::span<const Index> edges = table_.loose.in_band(band);
  for (std::size_t i = 0; i < edges.size();) {
    if (!loose_) loose_.emplace(table_.fronts, faces_);
    const Index body = table_.loose[edges[i]].body;
    for (; i < edges.size() && table_.loose[edges[i]].body == body; ++i)
      loose_->add(table_.loose[edges[i]], y);
    const std::size_t first = sides_.size();
    loose_->resolve(y, sides_);
    add_stretches(body, first);
  }
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
}

void RowSweep::add_stretches(Index body, std::size_t first) {
  for (std::size_t end = first; end < sides_.size(); ++end) {
    if (sides_[end].face != kNone) continue;
    const RowSide &left = sides_[first], &right = sides_[end];
    add_item({left.x,
              right.x,
              left.slack,
              right.slack,
              body,
              static_cast<Index>(first),
              static_cast<Index>(end + 1),
              static_cast<Index>(first),
              {}});
    first = end + 1;
  }
}

bool RowSweep::sweep(double y, std::vector<SpanPiece>& pieces) {
  by_x_.resize(items_.size());
  for (Index i = 0; i < by_x_.size(); ++i) by_x_[i] = i;
  std::sort(by_x_.begin(), by_x_.end(), [&](Index a, Index b) {
    return items_[a].x0 != items_[b].x0 ? items_[a].x0 < items_[b].x0 : a < b;
  });
  active_.clear();
  chosen_ = false;
  const double columns = table_.fronts.columns;
  double x = 0;
  float slack = 0;
  for (std::size_t next = 0; x < columns;) {
    double event = next < by_x_.size() ? items_[by_x_[next]].x0 : kInfinity;
    float event_slack = next < by_x_.size() ? items_[by_x_[next]].slack0 : 0;
    for (const Index i : active_)
      if (items_[i].x1 < event) event = items_[i].x1, event_slack = items_[i].slack1;
    if (event > x) {
      const double end = std::min(event, columns);
      if (!interval(y, x, end, slack, end < columns ? event_slack : 0, pieces)) return false;
      if (event == kInfinity) return true;
      x = event, slack = event_slack;
    }
    const std::size_t before = active_.size();
    std::erase_if(active_, [&](Index i) { return items_[i].x1 <= event; });
    chosen_ = chosen_ && active_.size() == before;
    for (; next < by_x_.size() && items_[by_x_[next]].x0 <= event; ++next) {
      const Index item = by_x_[next];
      active_.push_back(item);
      chosen_ = chosen_ && winner_ != kNone && order(winner_, item) > 0;
    }
  }
  return true;
}

/// The winner: no other lies surely before it. What may meet it contends.
void RowSweep::choose() {
  winner_ = active_.front();
  for (std::size_t turns = 0; turns < active_.size(); ++turns) {
    const Index before = winner_;
    for (const Index i : active_)
      if (i != winner_ && order(i, winner_) > 0) winner_ = i;
    if (winner_ == before) break;
  }
  contenders_.assign(1, winner_);
  for (const Index i : active_)
    if (i != winner_ && order(winner_, i) <= 0) contenders_.push_back(i);
  chosen_ = true;
}

bool RowSweep::interval(double y, double x0, double x1, float slack0, float slack1,
                        std::vector<SpanPiece>& pieces) {
  if (active_.empty()) return true;
  if (!chosen_) choose();
  for (const Index i : contenders_)
    if (items_[i].first == kNone && !walk(items_[i], y)) return false;
  if (contenders_.size() == 1) {
    show(items_[winner_], x0, x1, slack0, slack1, pieces);
  } else {
    merge(y, x0, x1, slack0, slack1, pieces);
  }
  return true;
}

/// Sides that rounding has put out of order are put where their neighbour is.
bool RowSweep::walk(Item& item, double y) {
  const std::vector<FrontSide>& front = walker_.front_at(item.body, y, item.outline);
  if (front.empty()) {
    not_walkable_.push_back(item.body);
    return false;
  }
  item.first = item.at = static_cast<Index>(sides_.size());
  double x = item.x0;
  for (const FrontSide& side : front) {
    x = std::min(std::max(x, side.x_at(y)), item.x1);
    sides_.push_back({x, side.face, side.slack});
  }
  item.end = static_cast<Index>(sides_.size());
  return true;
}

void RowSweep::show(Item& item, double x0, double x1, float slack0, float slack1,
                    std::vector<SpanPiece>& pieces) {
  Index at = item.at;
  while (at + 2 < item.end && sides_[at + 1].x <= x0) ++at;
  double x = x0;
  float slack = slack0;
  const auto show_to = [&](double end, float end_slack) {
    if (x == x0) {
      append(pieces, {x, end, sides_[at].face, slack, end_slack});
    } else {
      pieces.push_back({x, end, sides_[at].face, slack, end_slack});
    }
  };
  for (; at + 2 < item.end && sides_[at + 1].x < x1; ++at) {
    const RowSide& next = sides_[at + 1];
    if (next.x > x) show_to(next.x, next.slack);
    x = std::max(x, next.x), slack = next.slack;
  }
  show_to(x1, slack1);
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
void RowSweep::merge(double y, double x0, double x1, float slack0, float slack1,
                     std::vector<SpanPiece>& pieces) {
  meeting_.clear();
  for (const Index i : contenders_) {
    Item& item = items_[i];
    while (item.at + 2 < item.end && sides_[item.at + 1].x <= x0) ++item.at;
    meeting_.push_back({i, item.at, item.end});
    meeting_.back().look(sides_.data(), faces_, y);
  }
  double x = x0;
  double slack = slack0;
  while (x < x1) {
    double next = x1;
    float next_slack = slack1;
    for (const Contender& c : meeting_) {
      const RowSide& after = sides_[c.at + 1];
      if (c.at + 2 < c.end && after.x < next) next = after.x, next_slack = after.slack;
    }
    if (next - x > slack + next_slack || (next == x1 && x == x0)) {
      compare(y, x, next, static_cast<float>(slack), next_slack, pieces);
      slack = std::max<double>(next_slack, slack - (next - x));
      x = next;
    } else {
      slack = std::max<double>(slack, next_slack);
      if (next == x1) {
        if (!pieces.empty() && pieces.back().x1 == x) pieces.back().x1 = x1;
        x = x1;
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

void RowSweep::compare(double y, double x0, double x1, float slack0, float slack1,
                       std::vector<SpanPiece>& pieces) {
  // What is surely nearest at both ends is so between them.
  const double low = x0 + slack0, high = x1 - slack1;
  if (low < high) {
    const Contender* nearest = surely_nearest(low);
    if (nearest != nullptr && nearest == surely_nearest(high))
      return append(pieces, {x0, x1, nearest->face, slack0, slack1});
  }
  span_faces_.clear();
  for (const Contender& c : meeting_) span_faces_.push_back(c.face);
  split_.clear();
  split_at_crossings(faces_, span_faces_, x0, x1, y, slack0, slack1, split_);
  for (const SpanPiece& piece : split_) append(pieces, piece);
}

}  // namespace overstrike
