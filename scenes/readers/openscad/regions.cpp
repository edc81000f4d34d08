#include "scenes/readers/openscad/regions.h"

#include <algorithm>
#include <limits>

namespace overstrike::openscad {
namespace {

double area_of(const Loop2& loop) {
  double twice = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 a = loop[i] - loop[0], b = loop[(i + 1) % loop.size()] - loop[0];
    twice += a.x * b.y - a.y * b.x;
  }
  return std::fabs(twice) / 2;
}

bool is_corner(const Loop2& loop, const Vec2& p) {
  return std::find(loop.begin(), loop.end(), p) != loop.end();
}

/// Loops of which none crosses another; where they touch, a corner that does not decides.
bool lies_in(const Loop2& inner, const Loop2& outer) {
  for (const Vec2& p : inner)
    if (!is_corner(outer, p)) return contains(outer, p);
  return contains(outer, (inner[0] + inner[1]) / 2.0);
}

/// Each hole goes with the smallest outline that it lies in.
OrderedRegion touching_pieces(const std::vector<Loop2>& loops) {
  OrderedRegion result{loops, {}};
  std::vector<double> area(loops.size());
  for (std::size_t i = 0; i < loops.size(); ++i) {
    area[i] = area_of(loops[i]);
    if (is_counter_clockwise(loops[i])) result.pieces.push_back({i, {}});
  }
  for (std::size_t i = 0; i < loops.size(); ++i) {
    if (is_counter_clockwise(loops[i])) continue;
    Piece* best = nullptr;
    for (Piece& piece : result.pieces)
      if ((best == nullptr || area[piece.outline] < area[best->outline]) &&
          area[piece.outline] > area[i] && lies_in(loops[i], loops[piece.outline]))
        best = &piece;
    if (best != nullptr) best->holes.push_back(i);
  }
  return result;
}

}  // namespace

Region placed(const Region& region, const Affine& a) {
  Region result = region;
  for (std::vector<Vec2>& loop : result.loops)
    for (Vec2& p : loop)
      p = Vec2(a.linear[0][0] * p.x + a.linear[1][0] * p.y + a.offset.x,
               a.linear[0][1] * p.x + a.linear[1][1] * p.y + a.offset.y);
  return result;
}

OrderedRegion pieces_of(const Region& region) {
  std::vector<Loop2> loops;
  for (const Loop2& loop : region.loops) {
    Loop2 clean = without_repeats(loop);
    if (clean.size() >= 3) loops.push_back(std::move(clean));
  }
  return find_contact(loops) ? touching_pieces(loops) : in_order(loops);
}

void add_faces(Polyhedron& p, const OrderedRegion& region, Index first_vertex, bool turned) {
  std::vector<Index> start;
  for (const Loop2& loop : region.loops) {
    start.push_back(first_vertex);
    first_vertex += static_cast<Index>(loop.size());
  }
  const auto add = [&](std::size_t number) {
    std::vector<Index> loop(region.loops[number].size());
    for (std::size_t i = 0; i < loop.size(); ++i) loop[i] = start[number] + static_cast<Index>(i);
    if (turned) std::reverse(loop.begin(), loop.end());
    p.add_loop(loop);
  };
  for (const Piece& piece : region.pieces) {
    add(piece.outline);
    for (const std::size_t hole : piece.holes) add(hole);
    p.end_face();
  }
}

}  // namespace overstrike::openscad
