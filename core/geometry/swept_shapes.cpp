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

RoundCounts round_counts(const Revolution& revolution, double chord) {
  const int points = static_cast<int>(revolution.profile.size());
  if (revolution.sides > 0) return {revolution.sides, points, true};
  double widest = 0;
  for (const Vec2& point : revolution.profile) widest = std::max(widest, point.x);
  const int sides = chords_for(widest, chord, revolution.angle_deg);
  return {sides, points, sagitta(widest, sides, revolution.angle_deg) <= chord};
}

Polyhedron faces_of(const Revolution& revolution, double chord, bool normals) {
  ProfileChain chain;
  chain.points = without_repeats(revolution.profile);
  if (!is_counter_clockwise(chain.points)) std::reverse(chain.points.begin(), chain.points.end());
  const int sides = round_counts(revolution, chord).sides;
  const std::vector<Index> lines = line_numbers({chain.points}).front();
  const Index count = static_cast<Index>(chain.points.size());
  for (Index i = 0; i < count; ++i) {
    const Index next = (i + 1) % count;
    const Vec2 &from = chain.points[i], &to = chain.points[next];
    const Vec2 normal{to.y - from.y, from.x - to.x};
    chain.edges.push_back({i, next, normal, normal, lines[i], from.y == to.y});
  }
  return revolve(chain, sides, revolution.angle_deg, normals);
}

}  // namespace overstrike
