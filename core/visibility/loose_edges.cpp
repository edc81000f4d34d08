#include "core/visibility/loose_edges.h"

#include <algorithm>

namespace overstrike {
namespace {

std::vector<LooseEdge> edges_of(const FrontTable& table) {
  std::vector<LooseEdge> edges;
  LooseEdge edge;
  const auto add = [&](Index b, Index as) {
    const CanonicalBody& body = table.canonical.bodies[b];
    for (Index e = body.first_edge; e < body.end_edge; ++e)
      if (to_loose_edge(table, table.canonical.edges[e], b, edge))
        edges.push_back(edge), edges.back().body = as;
  };
  for (const Index b : table.loose) add(b, b);
  for (const Index b : table.operands)
    add(b, table.solid_body(table.canonical.memberships[b].solid));
  return edges;
}

}  // namespace

bool to_loose_edge(const FrontTable& table, const WingedEdge& edge, Index body, LooseEdge& out) {
  const bool left = table.seen(edge.left), right = table.seen(edge.right);
  if (!left && !right) return false;
  if (table.points[edge.from].y == table.points[edge.to].y) return false;
  out.line = table.line(table.bodies[body], edge.from, edge.to, edge.left, edge.right);
  if (!(out.line.y0 < out.line.y1)) return false;
  out.faces = {left ? edge.left : edge.right, left && right ? edge.right : kNone};
  out.body = body;
  return true;
}

LooseEdges::LooseEdges(const FrontTable& table)
    : edges_(edges_of(table)), bands_(table.rows, edges_.size(), [&](std::size_t i) {
        return std::pair(edges_[i].line.y0, edges_[i].line.y1);
      }) {}

void LooseResolver::add(const LooseEdge& edge, double y) {
  if (!(edge.line.y0 <= y && y < edge.line.y1)) return;
  const Index body = table_.canonical.faces[edge.faces[0]].body;
  const float slack = static_cast<float>(table_.bodies[body].line_error.of(edge.line));
  passing_.push_back({edge.line.x_at(y), slack, edge.faces});
}

void LooseResolver::resolve(Index body, double y, std::vector<RowSide>& sides) {
  if (passing_.empty()) return;
  sort_passing(passing_);
  pieces_.clear();
  if (body > table_.ground_body()) {
    solid_.begin(table_.canonical.solids[body - table_.solid_body(0)]->expression, order_, y,
                 table_.columns);
    sweep(
        passing_, [&](const auto& faces) { solid_.pass(faces); },
        [&](double x0, double x1, double slack0, double slack1) {
          solid_.span({x0, x1, kNone, static_cast<float>(slack0), static_cast<float>(slack1)},
                      pieces_);
        });
  } else {
    sweep(
        passing_, [&](const auto& faces) { active_.pass(faces); },
        [&](double x0, double x1, double slack0, double slack1) {
          span(x0, x1, y, slack0, slack1);
        });
    active_.clear();
  }
  passing_.clear();
  append(sides);
}

void LooseResolver::span(double x0, double x1, double y, double slack0, double slack1) {
  if (active_.faces().empty()) return;
  if (active_.crossing()) {
    split_at_crossings(order_, active_.faces(), x0, x1, y, slack0, slack1, pieces_);
  } else {
    pieces_.push_back({x0, x1, active_.seen_at(x0 + (x1 - x0) / 2, y), static_cast<float>(slack0),
                       static_cast<float>(slack1)});
  }
}

void LooseResolver::append(std::vector<RowSide>& sides) const {
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const SpanPiece& p = pieces_[i];
    const bool continues = i > 0 && pieces_[i - 1].x1 == p.x0;
    if (i > 0 && !continues) sides.push_back({pieces_[i - 1].x1, kNone, pieces_[i - 1].slack1});
    if (!(continues && sides.back().face == p.face)) sides.push_back({p.x0, p.face, p.slack0});
  }
  if (!pieces_.empty()) sides.push_back({pieces_.back().x1, kNone, pieces_.back().slack1});
}

}  // namespace overstrike
