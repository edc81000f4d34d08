#include "core/visibility/solid_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace overstrike {
namespace {

constexpr double kNotClamped = std::numeric_limits<double>::quiet_NaN();

/// What a resolved span costs in all, in spans of a level that is resolved by itself: by measuring
/// nine prisms on 128 to 4096 levels.
constexpr double kPrice = 4;
/// So many levels' spans may be lost by trying, the first level's among them, and are saved up.
constexpr double kMostLost = 4;
constexpr int kLeastRest = 8, kMostRest = 256;

/// Nodes are surely apart when they are by so many of their slacks, and surely together when they
/// are within so small a part of the smaller one: where spans are looked for (passing.h) the
/// comparison is with the sum of both.
constexpr double kApart = 8, kTogether = 1.0 / 4, kSlacksAlike = 4;

}  // namespace

SolidRows::SolidRows(const SolidExpression& expression, const LayerOrder& order,
                     const SolidLines& lines, double reach, SolidTools& tools)
    : expression_(expression),
      order_(order),
      lines_(lines),
      reach_(reach),
      tools_(tools),
      certifier_(order, reach) {}

void SolidRows::begin_at(double border, std::span<const Index> faces) {
  border_ = border, at_left_ = faces;
}

void SolidRows::on_level(double y, std::span<const LevelBands::Item> near,
                         std::vector<SpanPiece>& pieces) {
  if (!(y >= y_)) restart();
  step_ = y - y_, resolved_ = 0;
  // An empty band begins where the next one does.
  if (near.data() != band_.data() || near.size() != band_.size())
    find_pending(near), next_start_ = y;
  if (y >= next_start_ || y >= next_due_) {
    drop_ended(y);
    put_in_order(y);
    add_started(y);
    resolve_due(y);
    show_resolved(y, pieces);
    next_due_ = met_.due(), borders_known_ = false;
  } else {
    if (!borders_known_) note_borders();
    borders_.show(y, order_, pieces);
  }
  learn();
  y_ = y, band_ = near;
}

bool SolidRows::is_worth_while() {
  if (levels_to_rest_ == 0) return true;
  if (--levels_to_rest_ > 0) return false;
  restart();
  return true;
}

/// What was kept pays for what was resolved. Until that has paid, each rest is longer than the one
/// before.
void SolidRows::learn() {
  const auto spans = static_cast<double>(met_.size());
  credit_ += spans - kPrice * static_cast<double>(resolved_);
  if (credit_ > kMostLost * spans) credit_ = kMostLost * spans, next_rest_ = kLeastRest;
  if (credit_ >= -kMostLost * spans) return;
  levels_to_rest_ = std::max(next_rest_, kLeastRest);
  next_rest_ = std::min(2 * levels_to_rest_, kMostRest);
}

/// To the level above all others.
void SolidRows::restart() {
  credit_ = 0;
  for (std::size_t i = 0; i < met_.size(); ++i) free_.push_back(met_.node(i));
  met_.clear();
  y_ = -HUGE_VAL, band_ = {}, pending_.clear();
  if (border_ == 0) return;
  for (const double x : {-border_, border_}) {
    LevelLine line;
    line.x0 = x, line.y0 = 0, line.y1 = HUGE_VAL, line.slope = 0;
    add({line, 0, {kNone, kNone}, nullptr}, HUGE_VAL, 0);
  }
}

/// Takes out nodes that the level does not meet any more. What is next to them is touched.
void SolidRows::drop_ended(double y) {
  for (std::size_t at = met_.next_due(0, y); at < met_.size();) {
    if (met_.y1(at) <= y) {
      free_.push_back(met_.node(at));
      const bool had_span = met_.has_span(at);
      met_.erase(at);
      if (at > 0) met_.touch(at - 1);
      // From the one before it on, spans are resolved until one is as it was.
      if ((at == 0 || !had_span) && at < met_.size()) met_.touch(at);
    } else {
      // The span before it ends on another line then.
      if (clamp(at, y) && at > 0) met_.touch(at - 1);
      ++at;
    }
    at = met_.next_due(at, y);
  }
}

SlackLine SolidRows::line_of(const Node& n, double y1) {
  const LevelLine& line = n.line.line;
  if (!std::isnan(n.clamped_to)) return {n.clamped_to, line.y0, y1, 0, 0};
  return {line.x0, line.y0, y1, line.slope, n.line.slack};
}

/// The border of its window where the level meets the line beyond that, or NaN.
double SolidRows::clamped(const SolidLine& line, double y) {
  if (line.within == nullptr) return kNotClamped;
  const double x = line.line.x_at(y);
  const double clamped = std::clamp(x, line.within->x0, line.within->x1);
  return clamped == x ? kNotClamped : clamped;
}

/// Puts the node there, or on its edge. True when it was not there before.
bool SolidRows::clamp(std::size_t at, double y) {
  Node& n = node(at);
  const double to = clamped(n.line, y);
  if (to == n.clamped_to || (std::isnan(to) && std::isnan(n.clamped_to))) return false;
  n.clamped_to = to;
  met_.set_line(at, line_of(n, met_.y1(at)));
  return true;
}

/// By place, then as sort_passing() has them.
bool SolidRows::before(std::size_t at, std::size_t other) {
  if (met_.x(at) != met_.x(other)) return met_.x(at) < met_.x(other);
  return node(at).line.faces < node(other).line.faces;
}

/// Few are out of order. What moves, and what that moves past, is touched, and what comes before.
void SolidRows::put_in_order(double y) {
  met_.turn_to(y);
  for (std::size_t i = met_.next_out_of_order(1); i < met_.size();
       i = met_.next_out_of_order(i + 1))
    for (std::size_t at = i; at > 0 && before(at, at - 1); --at) {
      met_.swap(at);
      met_.touch(at), met_.touch(at - 1);
      if (at > 1) met_.touch(at - 2);
    }
}

/// Of the band's edges, those that begin below the level before, the first one last.
void SolidRows::find_pending(std::span<const LevelBands::Item> near) {
  pending_.clear();
  for (const LevelBands::Item& item : near)
    if (item.low > y_) pending_.push_back(item);
  std::sort(pending_.begin(), pending_.end(), [](const auto& a, const auto& b) {
    return a.low != b.low ? a.low > b.low : a.number > b.number;
  });
}

void SolidRows::add_started(double y) {
  for (; !pending_.empty() && pending_.back().low <= y; pending_.pop_back()) {
    const LevelBands::Item& item = pending_.back();
    const SolidLine line = lines_.line(item.number);
    const double y1 = std::min(line.line.y1, item.high);
    if (line.line.y0 <= y && y < y1) add(line, y1, y);
  }
  next_start_ = pending_.empty() ? HUGE_VAL : pending_.back().low;
}

void SolidRows::add(const SolidLine& line, double y1, double y) {
  if (free_.empty()) {
    free_.push_back(static_cast<Index>(nodes_.size()));
    nodes_.emplace_back();
  }
  const Index number = free_.back();
  free_.pop_back();
  Node& n = nodes_[number];
  n.line = line, n.clamped_to = clamped(line, y), n.resolved_at = -HUGE_VAL;
  const SlackLine placed = line_of(n, y1);
  const double x = placed.x_at(y);
  std::size_t at = met_.first_from(x);
  while (at < met_.size() && met_.x(at) == x && node(at).line.faces < line.faces) ++at;
  met_.insert(at, number, placed, y);
  if (at > 0) met_.touch(at - 1);
}

void SolidRows::resolve_due(double y) {
  tools_.sweep.record_in(&tools_.record);
  for (std::size_t i = met_.next_due(0, y); i < met_.size(); i = met_.next_due(i, y))
    i = resolve_from(met_.first_beside(i), y);
}

/// The sweep begins where the span before a node ends, or where the order there is in doubt, as
/// many spans before that as it takes. The node after it is the result.
std::size_t SolidRows::begin_before(std::size_t at, double y) {
  SolidSweep& sweep = tools_.sweep;
  sweep.begin(expression_, order_, y, reach_);
  while (at > 0) {
    const std::size_t left = met_.first_beside(at - 1);
    const double high = met_.x(at) - met_.slack(at);
    if (sweep.resume(node(at - 1).active, met_.x(left), high)) return at;
    sweep.begin(expression_, order_, y, reach_);
    at = left;
  }
  for (const Index face : at_left_) sweep.pass({face, kNone});
  return at;
}

/// Goes over spans as passing.h has it, from a node that meets the level apart from those before
/// it, until a node is reached that is as it was. Its number is the result.
std::size_t SolidRows::resolve_from(std::size_t touched, double y) {
  std::size_t first = begin_before(touched, y);
  double slack = met_.slack(first);
  for (std::size_t at = first;; ++at) {
    const Node& n = node(at);
    if (n.line.faces[0] != kNone) tools_.sweep.pass(n.line.faces);
    met_.set_until(at, met_.y1(at)), met_.set_shows(at, EdgeOrder::kNoSpan);
    if (n.line.within != nullptr) keep_clamped(at, y);
    keep_together(first, at, y);
    if (at + 1 == met_.size()) return at + 1;
    const double next_slack = met_.slack(at + 1), apart = met_.x(at + 1) - met_.x(first);
    if (apart > slack + next_slack) {
      resolve_span(first, at, slack, y);
      const double carried = slack - apart;
      slack = std::max(next_slack, carried);
      first = at + 1;
      // It may have begun left of what is touched.
      if (carried < 0 && first > touched && goes_on_as_before(first, n.active, y)) return first;
    } else {
      slack = std::max(slack, next_slack);
    }
  }
}

/// The nodes from there that meet the level in one place are as they were, and leave the layers as
/// they were after them.
bool SolidRows::goes_on_as_before(std::size_t at, const std::vector<Index>& active, double y) {
  std::vector<std::uint32_t>& mark = tools_.mark;
  const std::uint32_t turn = ++tools_.turn;
  std::size_t count = active.size();
  for (const Index face : active) mark[face] = turn;
  for (;; ++at) {
    const Node& n = node(at);
    if (met_.is_due(at, y)) return false;
    for (const Index face : n.line.faces) {
      if (face == kNone) continue;
      const bool is_in = mark[face] == turn;
      mark[face] = is_in ? 0 : turn;
      is_in ? --count : ++count;
    }
    if (at + 1 == met_.size()) return true;
    if (met_.has_span(at))
      return n.active.size() == count &&
             std::all_of(n.active.begin(), n.active.end(),
                         [&](Index face) { return mark[face] == turn; });
  }
}

/// Nodes that meet the level in one place are kept while they surely do.
void SolidRows::keep_together(std::size_t first, std::size_t at, double y) {
  if (at == first) return;
  const SlackLine line = met_.line(at), head = met_.line(first);
  if (line.slack > kSlacksAlike * head.slack) return met_.set_until(at, y);
  const double within = kTogether * std::min(line.slack, head.slack);
  SureLevels sure{y, std::min(met_.until(at), head.y1), y};
  const auto apart = [&](double level) { return line.x_at(level) - head.x_at(level); };
  const bool together = sure.certify(0, [&](double level) { return within - apart(level); }) &&
                        sure.certify(0, [&](double level) { return within + apart(level); });
  met_.set_until(at, together ? sure.until : y);
}

void SolidRows::keep_clamped(std::size_t at, double y) {
  const Node& n = node(at);
  const LevelLine& line = n.line.line;
  const GridWindow& in = *n.line.within;
  SureLevels sure{y, met_.until(at), y};
  const auto x_at = [&](double level) { return line.x_at(level); };
  bool is_sure = false;
  if (n.clamped_to == in.x0) {
    is_sure = sure.certify(0, [&](double level) { return in.x0 - x_at(level); });
  } else if (n.clamped_to == in.x1) {
    is_sure = sure.certify(0, [&](double level) { return x_at(level) - in.x1; });
  } else {
    is_sure = sure.certify(0, [&](double level) { return x_at(level) - in.x0; }) &&
              sure.certify(0, [&](double level) { return in.x1 - x_at(level); });
  }
  met_.set_until(at, is_sure ? sure.until : y);
}

/// Resolves the span between the nodes [left, at] and the next one.
void SolidRows::resolve_span(std::size_t left, std::size_t at, double slack, double y) {
  Node& n = node(at);
  ++resolved_;
  SpanRecord& record = tools_.record;
  record.clear(), n.parts.clear(), n.pieces.clear();
  const SpanPiece over{met_.x(left), met_.x(at + 1), kNone, static_cast<float>(slack),
                       met_.slack(at + 1)};
  tools_.sweep.span(over, n.pieces);
  tools_.sweep.copy_active(n.active);
  n.resolved_at = y;
  for (const SpanRecord::Part& part : record.parts)
    if (n.parts.empty() || n.parts.back().seen != part.seen)
      n.parts.push_back({part.seen, part.crossing});
  met_.set_until(at, certify_span(left, at, y));
  const bool is_one = n.parts.size() == 1 && met_.until(at) > y;
  met_.set_shows(at, is_one ? n.parts[0].seen : EdgeOrder::kSeveral);
}

/// The result: the level before which the span surely shows what it shows.
double SolidRows::certify_span(std::size_t left, std::size_t at, double y) {
  const SlackLine to = met_.line(at + 1);
  SureLevels sure{y, std::min(met_.until(at), to.y1), y + step_};
  if (!(sure.until > y)) return y;
  SlackLine from = met_.line(at);
  for (std::size_t i = left; i <= at; ++i) {
    const SlackLine line = met_.line(i);
    from.slack = std::max(from.slack, line.slack);
    sure.until = std::min(sure.until, line.y1);
    const double margin = kApart * (static_cast<double>(line.slack) + to.slack);
    if (!sure.certify(margin, [&](double l) { return to.x_at(l) - line.x_at(l); })) return y;
  }
  return certifier_.certify(from, to, tools_.record, sure) ? sure.until : y;
}

/// Shows a level on which nodes have been put in order: spans that were resolved on it as they
/// were, others by what is kept of them.
void SolidRows::show_resolved(double y, std::vector<SpanPiece>& pieces) {
  PieceMaker shown(pieces);
  std::size_t end = 0;  // of the spans that were gone over
  for (std::size_t i = 0; (i = met_.next_showing_other(end, shown.face())) < met_.size();
       end = i + 1) {
    const std::size_t left = met_.first_beside(i);
    const double x = met_.x(left);
    if (met_.shows(i) != EdgeOrder::kSeveral) {
      shown.turn(x, met_.slack(left), most_slack(left, i), met_.shows(i));
      continue;
    }
    const Node& n = node(i);
    if (n.resolved_at == y) {
      shown.turn(x, met_.slack(left), 0, kNone);
      for (const SpanPiece& piece : n.pieces) shown.append(piece);
      continue;
    }
    shown.turn(x, met_.slack(left), most_slack(left, i), n.parts[0].seen);
    for (std::size_t part = 1; part < n.parts.size(); ++part) {
      const auto& [near, far] = n.parts[part].crossing;
      shown.turn(order_.crossing(near, far, y), 0, 0, n.parts[part].seen);
    }
  }
  const std::size_t last = met_.first_beside(met_.size());
  if (last < met_.size()) shown.turn(met_.x(last), met_.slack(last), 0, kNone);
}

float SolidRows::most_slack(std::size_t left, std::size_t at) const {
  float slack = met_.slack(at);
  for (std::size_t i = left; i < at; ++i) slack = std::max(slack, met_.slack(i));
  return slack;
}

/// For levels at which nothing is due.
void SolidRows::note_borders() {
  borders_.clear();
  borders_known_ = true;
  for (std::size_t i = 0; (i = met_.next_showing_other(i, borders_.face())) < met_.size(); ++i) {
    const std::size_t left = met_.first_beside(i);
    if (met_.shows(i) != EdgeOrder::kSeveral) {
      add_border(left, i + 1, met_.shows(i));
      continue;
    }
    const std::vector<Part>& parts = node(i).parts;
    if (parts[0].seen != borders_.face()) add_border(left, i + 1, parts[0].seen);
    for (std::size_t part = 1; part < parts.size(); ++part)
      borders_.add_crossing(parts[part].crossing, parts[part].seen);
  }
  const std::size_t last = met_.first_beside(met_.size());
  if (borders_.face() != kNone) add_border(last, met_.size(), kNone);
}

/// At the nodes [left, end), which meet the level in one place.
void SolidRows::add_border(std::size_t left, std::size_t end, Index face) {
  borders_.add(face);
  for (std::size_t i = left; i < end; ++i) borders_.add_line(met_.line(i), node(i).line.faces);
}

}  // namespace overstrike
