// Extrusion and revolution: plane regions moved straight up or turned.
#include <algorithm>

#include "core/geometry/circle.h"
#include "core/geometry/polygon.h"
#include "core/geometry/revolve.h"
#include "core/geometry/shape_faces.h"

namespace overstrike {
namespace {

/// Every loop's points at one height; returns the number of the first vertex of each loop.
std::vector<Index> add_level(Polyhedron& p, const OrderedRegion& region, double z) {
  std::vector<Index> first;
  for (const Loop2& loop : region.loops) {
    first.push_back(static_cast<Index>(p.vertices.size()));
    for (const Vec2& point : loop) p.add_vertex({point.x, point.y, z});
  }
  return first;
}

void add_caps(Polyhedron& p, const OrderedRegion& region, const std::vector<Index>& first,
              bool downwards, Index plane) {
  const auto add = [&](std::size_t loop) {
    std::vector<Index> corners(region.loops[loop].size());
    for (std::size_t i = 0; i < corners.size(); ++i)
      corners[i] = first[loop] + static_cast<Index>(i);
    if (downwards) std::reverse(corners.begin(), corners.end());
    p.add_loop(corners);
  };
  for (const Piece& piece : region.pieces) {
    add(piece.outline);
    for (std::size_t hole : piece.holes) add(hole);
    p.end_face();
    p.plane_groups.push_back(plane);
  }
}

}  // namespace

Polyhedron faces_of(const Extrusion& extrusion) {
  const OrderedRegion region = in_order(extrusion.region.loops);
  Polyhedron p;
  const std::vector<Index> below = add_level(p, region, 0);
  const std::vector<Index> above = add_level(p, region, extrusion.height);
  add_caps(p, region, below, true, 0);
  add_caps(p, region, above, false, 1);
  const std::vector<std::vector<Index>> lines = line_numbers(region.loops);
  for (std::size_t l = 0; l < region.loops.size(); ++l) {
    const Index count = static_cast<Index>(lines[l].size());
    for (Index i = 0; i < count; ++i) {
      const Index next = (i + 1) % count;
      p.add_face({below[l] + i, below[l] + next, above[l] + next, above[l] + i});
      p.plane_groups.push_back(2 + lines[l][i]);
    }
  }
  drop_lone_planes(p);
  return p;
}

namespace {

std::vector<Loop2> loops_of(const Revolution& revolution) {
  std::vector<Loop2> loops{without_repeats(revolution.profile)};
  for (const Loop2& loop : revolution.more_loops) loops.push_back(without_repeats(loop));
  return loops;
}

/// The solid on the left of every edge.
ProfileChain chain_of(const OrderedRegion& region) {
  ProfileChain chain;
  const std::vector<std::vector<Index>> lines = line_numbers(region.loops);
  std::vector<std::vector<Index>> numbers;
  for (std::size_t l = 0; l < region.loops.size(); ++l) {
    const Loop2& loop = region.loops[l];
    const Index first = static_cast<Index>(chain.points.size());
    numbers.emplace_back();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const std::size_t next = i + 1 == loop.size() ? 0 : i + 1;
      const Vec2 &from = loop[i], &to = loop[next];
      const Vec2 normal{to.y - from.y, from.x - to.x};
      numbers.back().push_back(first + static_cast<Index>(i));
      chain.points.push_back(from);
      chain.edges.push_back({numbers.back().back(), first + static_cast<Index>(next), normal,
                             normal, lines[l][i], from.y == to.y});
    }
  }
  for (const Piece& piece : region.pieces) {
    chain.ends.push_back({numbers[piece.outline]});
    for (const std::size_t hole : piece.holes) chain.ends.back().push_back(numbers[hole]);
  }
  return chain;
}

}  // namespace

RoundCounts round_counts(const Revolution& revolution, double chord) {
  int points = 0;
  double widest = 0;
  for (const Loop2& loop : loops_of(revolution)) {
    points += static_cast<int>(loop.size());
    for (const Vec2& point : loop) widest = std::max(widest, point.x);
  }
  if (revolution.sides > 0) return {revolution.sides, points, true};
  const int sides = chords_for(widest, chord, revolution.angle_deg);
  return {sides, points, sagitta(widest, sides, revolution.angle_deg) <= chord};
}

Polyhedron faces_of(const Revolution& revolution, double chord, bool normals) {
  const int sides = round_counts(revolution, chord).sides;
  return revolve(chain_of(in_order(loops_of(revolution))), sides, revolution.angle_deg, normals);
}

}  // namespace overstrike
