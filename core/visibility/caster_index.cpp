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
  const auto each = [&](const auto& visit) {
    for (Index i = 0; i < regions_.size(); ++i) {
      const LightRegion& r = regions_[i];
      if (!(r.low.x <= r.high.x)) continue;
      for (int row = row_of(r.low.y), last = row_of(r.high.y); row <= last; ++row)
        for (int column = column_of(r.low.x); column <= column_of(r.high.x); ++column)
          visit(i, row * side_ + column);
    }
  };
  each([&](Index, int cell) { ++start_[cell + 1]; });
  for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
  items_.resize(start_.back());
  std::vector<Index> at(start_.begin(), start_.end() - 1);
  each([&](Index i, int cell) { items_[at[cell]++] = i; });
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
  std::vector<LightRegion> regions;
  for (Index f = body.first_face; f < body.end_face; ++f) {
    if (!light_.seen(f)) continue;
    of.faces.push_back(f);
    regions.emplace_back();
    for (Index l = c.faces[f].first_loop; l < c.faces[f].end_loop; ++l)
      for (const Index v : c.loop(l)) regions.back().add(light_.points[v]);
    of.crossed.push_back(is_crossed(f));
  }
  of.grid = RegionGrid(std::move(regions), 0.5);
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

void CasterIndex::find_planes(Index number, OfBody& of) const {
  const Canonical& c = light_.canonical;
  const CanonicalBody& body = c.bodies[number];
  of.plane_start.assign(body.end_vertex - body.first_vertex + 1, 0);
  const auto each = [&](const auto& visit) {
    for (Index f = body.first_face; f < body.end_face; ++f)
      for (Index l = c.faces[f].first_loop; l < c.faces[f].end_loop; ++l)
        for (const Index v : c.loop(l)) visit(v - body.first_vertex, f);
  };
  each([&](Index v, Index) { ++of.plane_start[v + 1]; });
  for (std::size_t i = 1; i < of.plane_start.size(); ++i)
    of.plane_start[i] += of.plane_start[i - 1];
  of.planes.resize(of.plane_start.back());
  std::vector<Index> at(of.plane_start.begin(), of.plane_start.end() - 1);
  each([&](Index v, Index f) { of.planes[at[v]++] = c.faces[f].plane; });
}

bool CasterIndex::touches(Index body, Index vertex, Index plane) const {
  OfBody& of = of_body_[body];
  std::call_once(of.planes_once, [&] { find_planes(body, of); });
  const Index v = vertex - light_.canonical.bodies[body].first_vertex;
  const auto first = of.planes.begin() + of.plane_start[v];
  const auto end = of.planes.begin() + of.plane_start[v + 1];
  return std::find(first, end, plane) != end;
}

}  // namespace overstrike
