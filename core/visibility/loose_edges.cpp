#include "core/visibility/loose_edges.h"

#include <algorithm>
#include <cmath>

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

/// Not level but for rounding of its ends' heights, by `across`, but so nearly that this moves it
/// along the level by more than is kept from what lies beside it.
bool is_nearly_level(const LevelLine& line, double across) {
  constexpr double kSure = 4;
  return across * std::fabs(line.slope) >= kMostSlack && line.y1 - line.y0 > kSure * across;
}

/// The nearly level edge in which a front and a back meet: where their planes cross, to an ulp.
/// They lie on one hand of it, and up to where their planes cross the farther one is before the
/// other. As it is where that is farther from its ends than their own rounding may move it, twice
/// what it does of the rounded line: of faces that lie almost in one plane.
LevelLine crossing_of_faces(const FrontTable& table, const std::array<Index, 2>& faces,
                            const LevelLine& rough, double across) {
  const Index p = table.plane_of(faces[0]), q = table.plane_of(faces[1]);
  if (p == q) return rough;
  const ExactPlane f = table.depths.exact(p), g = table.depths.exact(q);
  const double x0 = crossing_exactly(f, g, rough.y0), x1 = crossing_exactly(f, g, rough.y1);
  const double most = 2 * across * std::fabs(rough.slope);
  const bool near =
      std::fabs(x0 - rough.x0) <= most && std::fabs(x1 - rough.x_at(rough.y1)) <= most;
  return near ? LevelLine({x0, rough.y0}, {x1, rough.y1}) : rough;
}

}  // namespace

bool to_loose_edge(const FrontTable& table, const WingedEdge& edge, Index body, LooseEdge& out) {
  const bool left = table.seen(edge.left), right = table.seen(edge.right);
  if (!left && !right) return false;
  if (table.points[edge.from].y == table.points[edge.to].y) return false;
  out.line = table.line(table.bodies[body], edge.from, edge.to, edge.left, edge.right);
  if (!(out.line.y0 < out.line.y1)) return false;
  out.faces = {left ? edge.left : edge.right, left && right ? edge.right : kNone};
  const double across = table.bodies[body].line_error.per_slope;
  const bool fold = left && right && table.sides[edge.left] != table.sides[edge.right];
  if (is_nearly_level(out.line, across) && fold && !table.bodies[body].far)
    out.line = crossing_of_faces(table, out.faces, out.line, across);
  out.body = body;
  return true;
}

LooseEdges::LooseEdges(const FrontTable& table)
    : edges_(edges_of(table)), bands_(table.rows, edges_.size(), [&](std::size_t i) {
        const LevelLine& line = edges_[i].line;
        if (table.windows.empty()) return std::pair(line.y0, line.y1);
        const GridWindow& in = table.windows[table.canonical.faces[edges_[i].faces[0]].body];
        return std::pair(std::max(line.y0, in.y0), std::min(line.y1, in.y1));
      }) {}

void LooseResolver::add(const LooseEdge& edge, double y) {
  if (!(edge.line.y0 <= y && y < edge.line.y1)) return;
  const Index body = table_.canonical.faces[edge.faces[0]].body;
  const float slack = static_cast<float>(table_.bodies[body].line_error.of(edge.line));
  Passing passing{edge.line.x_at(y), slack, edge.faces};
  if (!table_.windows.empty()) {
    // Beyond its window the body is not there.
    const GridWindow& in = table_.windows[body];
    const double x = std::clamp(passing.x, in.x0, in.x1);
    if (x != passing.x) passing.x = x, passing.slack = 0;
  }
  passing_.push_back(passing);
}

void LooseResolver::resolve(Index body, double y, std::vector<SpanPiece>& pieces) {
  if (passing_.empty()) return;
  sort_passing(passing_);
  const auto over = [](double x0, double x1, double slack0, double slack1) {
    return SpanPiece{x0, x1, kNone, static_cast<float>(slack0), static_cast<float>(slack1)};
  };
  if (body > table_.ground_body()) {
    const CanonicalSolid& solid = *table_.canonical.solids[body - table_.solid_body(0)];
    solid_.begin(solid.expression, order_, y, table_.columns,
                 solid.uncut ? &solid.uncut->expression : nullptr);
    sweep(
        passing_, [&](const auto& faces) { solid_.pass(faces); },
        [&](auto... ends) { solid_.span(over(ends...), pieces, cut_away_); });
  } else {
    sweep(
        passing_, [&](const auto& faces) { active_.pass(faces); },
        [&](auto... ends) { span(over(ends...), y, pieces); });
    active_.clear();
  }
  passing_.clear();
}

void LooseResolver::span(const SpanPiece& over, double y, std::vector<SpanPiece>& pieces) {
  if (active_.faces().empty()) return;
  if (active_.crossing()) {
    split_at_crossings(order_, active_.faces(), over.x0, over.x1, y, over.slack0, over.slack1,
                       pieces);
  } else {
    const Index seen = active_.seen_at(over.x0 + (over.x1 - over.x0) / 2, y);
    pieces.push_back({over.x0, over.x1, seen, over.slack0, over.slack1});
  }
}

void append_sides(const std::vector<SpanPiece>& pieces, std::vector<RowSide>& sides) {
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const SpanPiece& p = pieces[i];
    const bool continues = i > 0 && pieces[i - 1].x1 == p.x0;
    if (i > 0 && !continues) sides.push_back({pieces[i - 1].x1, kNone, pieces[i - 1].slack1});
    if (!(continues && sides.back().face == p.face)) sides.push_back({p.x0, p.face, p.slack0});
  }
  if (!pieces.empty()) sides.push_back({pieces.back().x1, kNone, pieces.back().slack1});
}

}  // namespace overstrike
