#include "scenes/readers/openscad/project.h"

#include "core/geometry/cut_polyhedron.h"
#include "core/geometry/region_sets.h"
#include "core/geometry/tessellate.h"

namespace overstrike::openscad {
namespace {

Polyhedron placed_faces(const Part& part, const Affine& place) {
  Polyhedron faces = tessellate(*part.shape, 1, false);
  const Affine all = place * part.place;
  for (Vec3& p : faces.vertices) p = all(p);
  return faces;
}

/// A face from above: its loops, by even and odd.
Region flattened(const Polyhedron& p, Index face) {
  Region region;
  for (Index l = p.first_loop(face); l < p.face_ends[face]; ++l) {
    std::vector<Vec2>& loop = region.loops.emplace_back();
    for (const Index v : p.loop(l)) loop.emplace_back(p.vertices[v]);
  }
  return region;
}

}  // namespace

Region slice(const Part& part, const Affine& place) {
  const CutPolyhedron cut = cut_polyhedron(placed_faces(part, place), Vec3(0, 0, 1), 0, true);
  std::vector<Region> caps;
  for (Index f = 0; f < cut.polyhedron.face_count(); ++f)
    if (is_cap(cut.face_source[f])) caps.push_back(flattened(cut.polyhedron, f));
  return combine(SetOperation::unite, caps);
}

Region shadow(const Part& part) {
  const Polyhedron faces = placed_faces(part, {});
  std::vector<Region> all;
  for (Index f = 0; f < faces.face_count(); ++f) all.push_back(flattened(faces, f));
  return combine(SetOperation::unite, all);
}

}  // namespace overstrike::openscad
