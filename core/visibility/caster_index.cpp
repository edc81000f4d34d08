#include "core/visibility/caster_index.h"

#include <algorithm>
#include <cmath>

#include "core/geometry/even_odd.h"

namespace overstrike {

RegionGrid::RegionGrid(std::vector<LightRegion> regions, double cells_per_thing)
    : regions_(std::move(regions)) {
  LightRegion all;
  for (const LightRegion& r : regions_)
    if (r.low.x <= r.high.x) all.add(r.low), all.add(r.high);
  side_ = std::clamp(
      static_cast<int>(std::sqrt(static_cast<double>(regions_.size()) * cells_per_thing)), 1, 1024);
  origin_ = all.low;
  scale_ = Vec2(side_) / glm::max(all.high - all.low, Vec2(1e-300));
  start_.assign(static_cast<std::size_t>(side_) * side_ + 1, 0);
  struct Cells {
    std::uint16_t row, end_row, column, end_column;
  };
  std::vector<Cells> cells(regions_.size());
  const auto each = [&](const Cells& c, const auto& visit) {
    for (int first = c.row * side_; first < c.end_row * side_; first += side_)
      for (int cell = first + c.column; cell < first + c.end_column; ++cell) visit(cell);
  };
  for (Index i = 0; i < regions_.size(); ++i) {
    const LightRegion& r = regions_[i];
    if (!(r.low.x <= r.high.x)) continue;
    const auto end = [](int last) { return static_cast<std::uint16_t>(last + 1); };
    const auto first = [](int at) { return static_cast<std::uint16_t>(at); };
    cells[i] = {first(row_of(r.low.y)), end(row_of(r.high.y)), first(column_of(r.low.x)),
                end(column_of(r.high.x))};
    each(cells[i], [&](int cell) { ++start_[cell + 1]; });
  }
  for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
  items_.resize(start_.back());
  std::vector<Index> at(start_.begin(), start_.end() - 1);
  for (Index i = 0; i < regions_.size(); ++i)
    each(cells[i], [&](int cell) { items_[at[cell]++] = i; });
}

CasterIndex::CasterIndex(const FrontTable& light)
    : light_(light), of_body_(std::make_unique<OfBody[]>(light.canonical.bodies.size())) {
  std::vector<LightRegion> regions(light.canonical.bodies.size());
  for (std::size_t b = 0; b < regions.size(); ++b) {
    const CanonicalBody& body = light.canonical.bodies[b];
    if (!light.bodies[b].seen) continue;
    for (Index v = body.first_vertex; v < body.end_vertex; ++v) regions[b].add(light.points[v]);
  }
  bodies_ = RegionGrid(std::move(regions), 8);
}

const CasterIndex::OfBody& CasterIndex::of_body(Index body) const {
  OfBody& of = of_body_[body];
  std::call_once(of.faces_once, [&] { find_faces(body, of); });
  return of;
}

void CasterIndex::find_faces(Index number, OfBody& of) const {
  const Canonical& c = light_.canonical;
  const CanonicalBody& body = c.bodies[number];
  for (Index f = body.first_face; f < body.end_face; ++f)
    if (light_.seen(f)) of.faces.push_back(f);
  std::vector<LightRegion> regions;
  regions.reserve(of.faces.size());
  of.crossed.assign(of.faces.size(), 0);
  for (const Index f : of.faces) {
    LightRegion region;
    // The corners of all loops follow each other.
    for (Index i = c.first_corner(c.faces[f].first_loop); i < c.first_corner(c.faces[f].end_loop);
         ++i)
      region.add(light_.points[c.corners[i]]);
    if (!light_.bodies[number].triangles) of.crossed[regions.size()] = is_crossed(f);
    regions.push_back(region);
  }
  of.grid = RegionGrid(std::move(regions), 0.25);
}

bool CasterIndex::is_crossed(Index face) const {
  const Canonical& c = light_.canonical;
  const CanonicalFace& f = c.faces[face];
  if (f.end_loop - f.first_loop == 1 && c.loop(f.first_loop).size() == 3) return false;
  std::vector<std::vector<Vec2>> loops;
  for (Index l = f.first_loop; l < f.end_loop; ++l) {
    loops.emplace_back();
    for (const Index v : c.loop(l)) loops.back().push_back(light_.points[v]);
  }
  return !even_odd(loops).simple;
}

}  // namespace overstrike
