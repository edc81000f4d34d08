#include "core/visibility/solid_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace overstrike {
namespace {

constexpr double kNotClamped = std::numeric_limits<double>::quiet_NaN();

/// Nodes are surely apart when they are by so many of their slacks, and surely together when they
/// are within so small a part of the smaller one: where spans are looked for (passing.h) the
/// comparison is with the sum of both.
/// What a resolved span costs in all, in spans of a level that is resolved by itself: by measuring
/// nine prisms on 128 to 4096 levels.
constexpr double kPrice = 4;
/// So many levels' spans may be lost by trying, the first level's among them, and are saved up.
constexpr double kMostLost = 4;
constexpr int kLeastRest = 8, kMostRest = 256;

constexpr double kApart = 8, kTogether = 1.0 / 4, kSlacksAlike = 4;

}  // namespace

SolidRows::SolidRows(const FrontTable& table, const FaceOrder& order, const LooseEdges& edges,
                     Index solid, const SolidOptions& options)
    : table_(table),
      order_(order),
      edges_(edges),
      expression_(table.canonical.solids[solid]->expression),
      sweep_(table.canonical, options) {
  sweep_.record_in(&record_);
}

void SolidRows::on_level(double y, std::span<const LevelBands::Item> near,
                         std::vector<SpanPiece>& pieces) {
  if (!(y >= y_)) restart();
  step_ = y - y_, resolved_ = 0;
  const bool starts = near.data() != band_ || y >= next_start_;
  if (starts || y >= next_due_) {
    drop_ended(y);
    put_in_order();
    if (starts) add_started(y, near);
    resolve_dirty(y);
    note_shown();
  }
  learn();
  y_ = y, band_ = near.data();
  for (const Shown& shown : shown_) show(shown, y, pieces);
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
  const auto spans = static_cast<double>(order_line_.size());
  credit_ += spans - kPrice * static_cast<double>(resolved_);
  if (credit_ > kMostLost * spans) credit_ = kMostLost * spans, next_rest_ = kLeastRest;
  if (credit_ >= -kMostLost * spans) return;
  levels_to_rest_ = std::max(next_rest_, kLeastRest);
  next_rest_ = std::min(2 * levels_to_rest_, kMostRest);
}

/// To the level above all others.
void SolidRows::restart() {
  credit_ = 0;
  for (const Index n : order_line_) free_.push_back(n);
  order_line_.clear(), shown_.clear();
  y_ = -HUGE_VAL, band_ = nullptr;
}

/// Sets the line that the node is on at the level. True when that is another than before.
bool SolidRows::evaluate(Node& n, double y) const {
  if (table_.windows.empty()) return false;
  const LevelLine& line = edges_[n.edge].line;
  const Index body = table_.canonical.faces[n.faces[0]].body;
  const GridWindow& in = table_.windows[body];
  const double x = line.x_at(y), clamped = std::clamp(x, in.x0, in.x1);
  const double to = clamped == x ? kNotClamped : clamped;
  const bool same = to == n.clamped_to || (std::isnan(to) && std::isnan(n.clamped_to));
  if (same) return false;
  n.dirty = true, n.clamped_to = to;
  n.line = clamped == x ? SlackLine{line.x0, line.y0, n.line.y1, line.slope,
                                    static_cast<float>(table_.bodies[body].line_error.of(line))}
                        : SlackLine{clamped, line.y0, n.line.y1, 0, 0};
  return true;
}

/// Takes out nodes that the level does not meet any more. What is next to them is touched.
void SolidRows::drop_ended(double y) {
  std::size_t kept = 0;
  bool touched = false;
  x_.clear();
  for (const Index i : order_line_) {
    Node& n = nodes_[i];
    if (n.line.y1 <= y) {
      free_.push_back(i);
      if (kept > 0) node(kept - 1).dirty = true;
      touched = true;
      continue;
    }
    // The span before it ends on another line then.
    if (evaluate(n, y) && kept > 0) node(kept - 1).dirty = true;
    n.dirty = n.dirty || touched || n.until <= y;
    touched = false;
    order_line_[kept++] = i;
    x_.push_back(n.line.x_at(y));
  }
  // Left of the last one nothing else is touched.
  if (touched && kept > 0) node(kept - 1).dirty = true;
  order_line_.resize(kept);
}

/// By place, then as sort_passing() has them.
bool SolidRows::before(std::size_t at, std::size_t other) {
  if (x_[at] != x_[other]) return x_[at] < x_[other];
  return node(at).faces < node(other).faces;
}

/// Few are out of order. What moves, and what that moves past, is touched, and what comes before.
void SolidRows::put_in_order() {
  for (std::size_t i = 1; i < order_line_.size(); ++i)
    for (std::size_t at = i; at > 0 && before(at, at - 1); --at) {
      std::swap(order_line_[at], order_line_[at - 1]);
      std::swap(x_[at], x_[at - 1]);
      node(at).dirty = node(at - 1).dirty = true;
      if (at > 1) node(at - 2).dirty = true;
    }
}

Index SolidRows::new_node(Index edge) {
  if (free_.empty()) {
    free_.push_back(static_cast<Index>(nodes_.size()));
    nodes_.emplace_back();
  }
  const Index number = free_.back();
  free_.pop_back();
  Node& n = nodes_[number];
  const LooseEdge& e = edges_[edge];
  const Index body = table_.canonical.faces[e.faces[0]].body;
  n.edge = edge, n.faces = e.faces;
  n.line = {e.line.x0, e.line.y0, e.line.y1, e.line.slope,
            static_cast<float>(table_.bodies[body].line_error.of(e.line))};
  n.clamped_to = kNotClamped;
  n.until = -HUGE_VAL, n.resolved_at = -HUGE_VAL;
  n.dirty = true, n.has_span = false;
  n.active.clear(), n.parts.clear(), n.pieces.clear();
  return number;
}

void SolidRows::add_started(double y, std::span<const LevelBands::Item> near) {
  next_start_ = HUGE_VAL;
  for (const LevelBands::Item& item : near) {
    if (item.low > y) next_start_ = std::min(next_start_, item.low);
    if (!(item.low > y_ && item.meets(y))) continue;
    const Index number = new_node(item.number);
    Node& n = nodes_[number];
    n.line.y1 = std::min(n.line.y1, item.high);
    if (!(edges_[item.number].line.y0 <= y && y < n.line.y1)) {
      free_.push_back(number);
      continue;
    }
    evaluate(n, y);
    const double x = n.line.x_at(y);
    auto at = static_cast<std::size_t>(std::lower_bound(x_.begin(), x_.end(), x) - x_.begin());
    while (at < x_.size() && x_[at] == x && node(at).faces < n.faces) ++at;
    order_line_.insert(order_line_.begin() + static_cast<std::ptrdiff_t>(at), number);
    x_.insert(x_.begin() + static_cast<std::ptrdiff_t>(at), x);
    if (at > 0) node(at - 1).dirty = true;
    if (at + 1 < x_.size()) node(at + 1).dirty = true;
  }
}

void SolidRows::resolve_dirty(double y) {
  for (std::size_t i = 0; i < order_line_.size();) {
    if (!node(i).dirty) {
      ++i;
      continue;
    }
    while (i > 0 && !node(i - 1).has_span) --i;
    i = resolve_from(i, y);
  }
}

/// The sweep begins where the span before a node ends, or where the order there is in doubt, as
/// many spans before that as it takes. The node after it is the result.
std::size_t SolidRows::begin_before(std::size_t at, double y) {
  sweep_.begin(expression_, order_, y, table_.columns);
  while (at > 0) {
    std::size_t left = at - 1;
    while (left > 0 && !node(left - 1).has_span) --left;
    if (sweep_.resume(node(at - 1).active, x_[left], x_[at])) return at;
    sweep_.begin(expression_, order_, y, table_.columns);
    at = left;
  }
  return at;
}

/// Goes over spans as passing.h has it, from a node that meets the level apart from those before
/// it, until a node is reached that is as it was. Its number is the result.
std::size_t SolidRows::resolve_from(std::size_t touched, double y) {
  std::size_t first = begin_before(touched, y);
  double slack = node(first).line.slack;
  for (std::size_t at = first;; ++at) {
    Node& n = node(at);
    sweep_.pass(n.faces);
    n.until = n.line.y1, n.has_span = false;
    n.parts.clear(), n.pieces.clear(), n.active.clear();
    if (!table_.windows.empty()) keep_clamped(n, y);
    keep_together(first, at, y);
    n.dirty = false;
    if (at + 1 == order_line_.size()) return at + 1;
    const Node& next = node(at + 1);
    if (x_[at + 1] - x_[first] > slack + next.line.slack) {
      resolve_span(first, at, slack, y);
      const double carried = slack - (x_[at + 1] - x_[first]);
      slack = std::max<double>(next.line.slack, carried);
      first = at + 1;
      // It may have begun left of what is touched.
      if (carried < 0 && first > touched && goes_on_as_before(first, node(at).active)) return first;
    } else {
      slack = std::max<double>(slack, next.line.slack);
    }
  }
}

/// The nodes from there that meet the level in one place are as they were, and leave the layers as
/// they were after them.
bool SolidRows::goes_on_as_before(std::size_t at, const std::vector<Index>& active) {
  if (mark_.empty()) mark_.resize(table_.canonical.faces.size(), 0);
  turn_ += 2;
  std::size_t count = active.size();
  for (const Index face : active) mark_[face] = turn_;
  for (;; ++at) {
    const Node& n = node(at);
    if (n.dirty) return false;
    for (const Index face : n.faces) {
      if (face == kNone) continue;
      const bool is_in = mark_[face] == turn_;
      mark_[face] = is_in ? 0 : turn_;
      is_in ? --count : ++count;
    }
    if (at + 1 == order_line_.size()) return true;
    if (n.has_span)
      return n.active.size() == count &&
             std::all_of(n.active.begin(), n.active.end(),
                         [&](Index face) { return mark_[face] == turn_; });
  }
}

/// Nodes that meet the level in one place are kept while they surely do.
void SolidRows::keep_together(std::size_t first, std::size_t at, double y) {
  Node &n = node(at), &head = node(first);
  if (at == first) return;
  if (n.line.slack > kSlacksAlike * head.line.slack) {
    n.until = y;
    return;
  }
  const double within = kTogether * std::min(n.line.slack, head.line.slack);
  SureLevels sure{y, std::min(n.until, head.line.y1), y};
  const auto apart = [&](double level) { return n.line.x_at(level) - head.line.x_at(level); };
  const bool together = sure.certify(0, [&](double level) { return within - apart(level); }) &&
                        sure.certify(0, [&](double level) { return within + apart(level); });
  n.until = together ? sure.until : y;
}

void SolidRows::keep_clamped(Node& n, double y) const {
  const LevelLine& line = edges_[n.edge].line;
  const GridWindow& in = table_.windows[table_.canonical.faces[n.faces[0]].body];
  SureLevels sure{y, n.until, y};
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
  n.until = is_sure ? sure.until : y;
}

/// Resolves the span between the nodes [left, at] and the next one.
void SolidRows::resolve_span(std::size_t left, std::size_t at, double slack, double y) {
  Node& n = node(at);
  const Node& next = node(at + 1);
  ++resolved_;
  record_.clear();
  sweep_.span({x_[left], x_[at + 1], kNone, static_cast<float>(slack), next.line.slack}, n.pieces);
  sweep_.copy_active(n.active);
  n.has_span = true, n.resolved_at = y;
  for (const SpanRecord::Part& part : record_.parts)
    if (n.parts.empty() || n.parts.back().seen != part.seen)
      n.parts.push_back({part.seen, part.crossing});
  certify_span(left, at, y);
}

void SolidRows::certify_span(std::size_t left, std::size_t at, double y) {
  Node& n = node(at);
  const Node& next = node(at + 1);
  SureLevels sure{y, std::min(n.until, next.line.y1), y + step_};
  n.until = y;
  if (!(sure.until > y)) return;
  SlackLine from = n.line;
  for (std::size_t i = left; i <= at; ++i) {
    const SlackLine& line = node(i).line;
    if (line.slack > from.slack) from.slack = line.slack;
    sure.until = std::min(sure.until, line.y1);
    const double margin = kApart * (static_cast<double>(line.slack) + next.line.slack);
    if (!sure.certify(margin, [&](double l) { return next.line.x_at(l) - line.x_at(l); })) return;
  }
  crossings_.clear();
  const double levels = std::max(std::fabs(y), std::fabs(sure.until));
  for (const SpanRecord::Part& part : record_.parts)
    if (part.crossing[0] != kNone) {
      const DepthPlane p = order_.depth_of(part.crossing[0]);
      crossings_.emplace_back(p, order_.depth_of(part.crossing[1]), table_.columns, levels);
    }
  Border border{&from, nullptr, {kNone, kNone}, from.slack, from.slack};
  for (std::size_t i = 0; i < record_.parts.size(); ++i) {
    Border end{&next.line, nullptr, {kNone, kNone}, -next.line.slack, next.line.slack};
    if (i + 1 < record_.parts.size()) {
      const DepthDifference& d = crossings_[i];
      end = {nullptr, &d, record_.parts[i + 1].crossing, 0,
             2 * kCrossingError + d.error / std::fabs(d.a)};
    }
    if (!certify_part(record_.parts[i], border, end, sure)) return;
    border = end;
  }
  n.until = sure.until;
}

/// Those that decided stay in their order, and before all that lie behind.
bool SolidRows::certify_part(const SpanRecord::Part& part, const Border& from, const Border& to,
                             SureLevels& sure) const {
  const Index* const faces = record_.faces.data();
  const auto stays = [&](Index near, Index far) {
    return stays_before(near, far, from, 1, sure) && stays_before(near, far, to, -1, sure);
  };
  for (std::size_t i = part.first; i + 1 < part.decided; ++i)
    if (!stays(faces[i], faces[i + 1])) return false;
  if (part.decided == part.first) return true;
  const Index last = faces[part.decided - 1];
  for (std::size_t i = part.decided; i < part.end; ++i)
    if (!stays(last, faces[i])) return false;
  return true;
}

/// `face` lies before `other` at the border and beyond it to its right (`into` 1) or left (-1).
/// Where the border is where the two cross, it is enough that they do so in that sense. Where it is
/// an edge in which they touch, what is exact half as far from it as levels look is so everywhere
/// farther, the rounding of x_at being less than a quarter of the slack.
bool SolidRows::stays_before(Index face, Index other, const Border& at, double into,
                             SureLevels& sure) const {
  if (order_.plane_of(face) == order_.plane_of(other)) return true;
  const DepthPlane p = order_.depth_of(face);
  const double levels = std::max(std::fabs(sure.y), std::fabs(sure.until));
  const DepthDifference d(p, order_.depth_of(other), table_.columns, levels);
  const auto crosses = [&](Index f, Index g) {
    return (f == at.crossing[0] && g == at.crossing[1]) ||
           (f == at.crossing[1] && g == at.crossing[0]);
  };
  if (at.line == nullptr) {
    if (crosses(face, other)) return d.a * into > 0;
    return sure.certify(d.margin(at.slack), [&](double y) { return d.at(at.x_at(y), y); });
  }
  SureLevels rough = sure;
  const auto value = [&](double y) { return d.at(at.x_at(y) + at.offset, y); };
  if (rough.certify(d.margin(at.slack), value)) {
    sure = rough;
    return true;
  }
  return d.a * into > 0 && d.error <= kCrossingError * std::fabs(d.a) &&
         order_.compare(face, other, at.x_at(sure.y) + at.offset / 2, sure.y) > 0 &&
         order_.compare(face, other, at.x_at(sure.until) + at.offset / 2, sure.until) > 0;
}

void SolidRows::note_shown() {
  shown_.clear();
  next_due_ = HUGE_VAL;
  std::size_t left = 0;
  for (std::size_t i = 0; i < order_line_.size(); ++i) {
    const Node& n = node(i);
    next_due_ = std::min(next_due_, n.until);
    if (!n.has_span) continue;
    const bool shows = std::any_of(n.parts.begin(), n.parts.end(),
                                   [](const Part& part) { return part.seen != kNone; });
    std::size_t right_end = i + 2;
    while (shows && right_end < order_line_.size() && !node(right_end - 1).has_span) ++right_end;
    if (shows) shown_.push_back({left, i + 1, right_end});
    left = i + 1;
  }
}

void SolidRows::show(const Shown& shown, double y, std::vector<SpanPiece>& pieces) {
  const Node& n = node(shown.left_end - 1);
  if (n.resolved_at == y) {
    pieces.insert(pieces.end(), n.pieces.begin(), n.pieces.end());
    return;
  }
  const SlackLine& left = node(shown.left).line;
  SpanPiece piece{left.x_at(y), 0, kNone, left.slack, 0};
  for (std::size_t i = shown.left + 1; i < shown.left_end; ++i) {
    const SlackLine& line = node(i).line;
    piece.x0 = std::min(piece.x0, line.x_at(y)), piece.slack0 = std::max(piece.slack0, line.slack);
  }
  for (std::size_t i = 0; i < n.parts.size(); ++i) {
    piece.face = n.parts[i].seen;
    if (i + 1 < n.parts.size()) {
      const auto& [near, far] = n.parts[i + 1].crossing;
      piece.x1 = order_.crossing(near, far, y), piece.slack1 = 0;
    } else {
      std::size_t first = shown.left_end;
      piece.x1 = node(first).line.x_at(y);
      for (std::size_t k = first + 1; k < shown.right_end; ++k) {
        const double x = node(k).line.x_at(y);
        if (x < piece.x1 || (x == piece.x1 && node(k).faces < node(first).faces))
          first = k, piece.x1 = x;
      }
      piece.slack1 = node(first).line.slack;
    }
    if (piece.face != kNone) pieces.push_back(piece);
    piece.x0 = piece.x1, piece.slack0 = piece.slack1;
  }
}

}  // namespace overstrike
