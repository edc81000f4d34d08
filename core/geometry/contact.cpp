// Where loops touch that should not: a sweep over edges by their least x.
#include <algorithm>

#include "core/geometry/polygon.h"

namespace overstrike {
namespace {

struct LoopEdge {
  Vec2 a, b;
  std::size_t loop, number, edges_of_loop;
  double low() const { return std::min(a.x, b.x); }
  double high() const { return std::max(a.x, b.x); }
};

bool within_box(const Vec2& p, const Vec2& a, const Vec2& b) {
  return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y &&
         p.y <= std::max(a.y, b.y);
}

/// Closed segments with at least one common point.
bool meet(const LoopEdge& e, const LoopEdge& f) {
  if (std::max(e.a.y, e.b.y) < std::min(f.a.y, f.b.y)) return false;
  if (std::max(f.a.y, f.b.y) < std::min(e.a.y, e.b.y)) return false;
  const int ea = turn_of(f.a, f.b, e.a), eb = turn_of(f.a, f.b, e.b);
  const int fa = turn_of(e.a, e.b, f.a), fb = turn_of(e.a, e.b, f.b);
  if (ea * eb < 0 && fa * fb < 0) return true;
  return (ea == 0 && within_box(e.a, f.a, f.b)) || (eb == 0 && within_box(e.b, f.a, f.b)) ||
         (fa == 0 && within_box(f.a, e.a, e.b)) || (fb == 0 && within_box(f.b, e.a, e.b));
}

/// Neighbours e then f: do they run over each other?
bool fold_back(const LoopEdge& e, const LoopEdge& f) {
  return turn_of(e.a, e.b, f.b) == 0 && (within_box(f.b, e.a, e.b) || within_box(e.a, f.a, f.b));
}

bool in_contact(const LoopEdge& e, const LoopEdge& f) {
  if (e.loop != f.loop) return meet(e, f);
  if ((e.number + 1) % e.edges_of_loop == f.number) return fold_back(e, f);
  if ((f.number + 1) % e.edges_of_loop == e.number) return fold_back(f, e);
  return meet(e, f);
}

/// A point that both edges have, but for rounding. Precondition: they meet.
Vec2 near_contact(const LoopEdge& e, const LoopEdge& f) {
  for (const Vec2& p : {f.a, f.b})
    if (turn_of(e.a, e.b, p) == 0 && within_box(p, e.a, e.b)) return p;
  for (const Vec2& p : {e.a, e.b})
    if (turn_of(f.a, f.b, p) == 0 && within_box(p, f.a, f.b)) return p;
  const Vec2 along = e.b - e.a, other = f.b - f.a, between = f.a - e.a;
  const double part =
      (between.x * other.y - between.y * other.x) / (along.x * other.y - along.y * other.x);
  return e.a + along * part;
}

}  // namespace

std::optional<Contact> find_contact(const std::vector<Loop2>& loops) {
  std::vector<LoopEdge> edges;
  for (std::size_t l = 0; l < loops.size(); ++l)
    for (std::size_t i = 0; i < loops[l].size(); ++i)
      edges.push_back({loops[l][i], loops[l][(i + 1) % loops[l].size()], l, i, loops[l].size()});
  std::stable_sort(edges.begin(), edges.end(),
                   [](const LoopEdge& e, const LoopEdge& f) { return e.low() < f.low(); });
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const LoopEdge& e = edges[i];
    std::erase_if(open, [&](std::size_t j) { return edges[j].high() < e.low(); });
    for (std::size_t j : open)
      if (in_contact(edges[j], e))
        return Contact{std::min(e.loop, edges[j].loop), std::max(e.loop, edges[j].loop),
                       near_contact(edges[j], e)};
    open.push_back(i);
  }
  return std::nullopt;
}

}  // namespace overstrike
