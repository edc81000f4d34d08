#pragma once
// Rebuilding a polyhedron face by face.
#include <algorithm>

#include "core/geometry/polyhedron.h"

namespace overstrike {

/// Appends face f of `in` to `out`, which has the same vertices.
inline void append_face(Polyhedron& out, const Polyhedron& in, Index f, bool reversed) {
  for (Index l = in.first_loop(f); l < in.face_ends[f]; ++l) {
    const std::size_t start = out.indices.size();
    out.add_loop(in.loop(l));
    if (reversed) std::reverse(out.indices.begin() + start, out.indices.end());
    if (in.corner_normals.empty()) continue;
    for (Index i = in.first_index(l); i < in.loop_ends[l]; ++i)
      out.corner_normals.push_back(in.corner_normals[i]);
    if (reversed) std::reverse(out.corner_normals.begin() + start, out.corner_normals.end());
  }
  out.end_face();
  if (!in.plane_groups.empty()) out.plane_groups.push_back(in.plane_groups[f]);
}

}  // namespace overstrike
