#include "core/visibility/loose_rows.h"

namespace overstrike {

std::size_t LooseRows::turn_to(double y) {
  y_ = y;
  if (resolver_) resolver_->cut_away().clear();
  const std::span<const LevelBands::Item> edges = edges_.near(y);
  if (edges.data() == band_.data() && edges.size() == band_.size()) return ends_.size();
  band_ = edges;
  ends_.clear();
  const auto body_at = [&](std::size_t i) { return edges_[edges[i].number].body; };
  for (std::size_t i = 1; i <= edges.size(); ++i)
    if (i == edges.size() || body_at(i) != body_at(i - 1)) ends_.push_back(i);
  return ends_.size();
}

/// Solids that show what was cut away of them are resolved level by level.
bool LooseRows::may_be_kept(Index body) const {
  if (options_.coherence != Coherence::all || body <= table_.ground_body()) return false;
  return !table_.canonical.solids[body - table_.solid_body(0)]->uncut;
}

SolidRows& LooseRows::rows_of(Index body) {
  const Index solid = body - table_.solid_body(0);
  if (solids_.empty()) solids_.resize(table_.canonical.solids.size());
  if (!solids_[solid]) {
    const Canonical& c = table_.canonical;
    solids_[solid] = std::make_unique<Kept>(c, options_, c.solids[solid]->expression, faces_, *this,
                                            table_.columns);
  }
  return solids_[solid]->rows;
}

SolidLine LooseRows::line(Index number) const {
  const LooseEdge& edge = edges_[number];
  const Index body = table_.canonical.faces[edge.faces[0]].body;
  const float slack = static_cast<float>(table_.bodies[body].line_error.of(edge.line));
  return {edge.line, slack, edge.faces, table_.windows.empty() ? nullptr : &table_.windows[body]};
}

LooseResolver& LooseRows::resolver() {
  if (!resolver_) resolver_.emplace(table_, faces_, options_);
  return *resolver_;
}

const std::vector<SpanPiece>& LooseRows::pieces(std::size_t i) {
  const std::size_t first = first_edge(i);
  const std::span<const LevelBands::Item> edges = band_.subspan(first, ends_[i] - first);
  const Index number = body(i);
  pieces_.clear();
  if (may_be_kept(number) && rows_of(number).is_worth_while()) {
    rows_of(number).on_level(y_, edges, pieces_);
  } else {
    for (const LevelBands::Item& item : edges)
      if (item.meets(y_)) resolver().add(edges_[item.number], y_);
    resolver().resolve(number, y_, pieces_);
  }
  return pieces_;
}

const std::vector<SpanPiece>& LooseRows::pieces_of(Index number) {
  const CanonicalBody& body = table_.canonical.bodies[number];
  LooseEdge edge;
  for (Index e = body.first_edge; e < body.end_edge; ++e)
    if (to_loose_edge(table_, table_.canonical.edges[e], number, edge)) resolver().add(edge, y_);
  pieces_.clear();
  resolver().resolve(number, y_, pieces_);
  return pieces_;
}

}  // namespace overstrike
