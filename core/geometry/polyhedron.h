#pragma once
// Faces over shared vertices, flat in memory: what every shape becomes.
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/vec.h"

namespace overstrike {

using Index = std::uint32_t;

/// A set of planar faces over shared vertices. A face is one or more loops: the first is its
/// outline, counter-clockwise seen from outside, further ones are holes, clockwise. Storage is
/// flat: loop l covers indices[loop_start(l) .. loop_ends[l]), face f covers loops [loop_of_face(f)
/// .. face_ends[f]).
struct Polyhedron {
  std::vector<Vec3> vertices;
  std::vector<Index> indices;
  std::vector<Index> loop_ends;
  std::vector<Index> face_ends;
  /// Empty, or one unit normal per entry of `indices` (for smooth shading).
  std::vector<Vec3> corner_normals;
  /// Empty, or one number per face: faces of one number lie in one plane by construction.
  std::vector<Index> plane_groups;

  std::size_t face_count() const { return face_ends.size(); }
  Index first_loop(Index face) const { return face == 0 ? 0 : face_ends[face - 1]; }
  Index first_index(Index loop) const { return loop == 0 ? 0 : loop_ends[loop - 1]; }
  std::span<const Index> loop(Index l) const {
    return {indices.data() + first_index(l), indices.data() + loop_ends[l]};
  }

  Index add_vertex(const Vec3& p) {
    vertices.push_back(p);
    return static_cast<Index>(vertices.size() - 1);
  }
  void add_loop(std::span<const Index> loop) {
    indices.insert(indices.end(), loop.begin(), loop.end());
    loop_ends.push_back(static_cast<Index>(indices.size()));
  }
  /// Closes a face over all loops added since the last face.
  void end_face() { face_ends.push_back(static_cast<Index>(loop_ends.size())); }
  void add_face(std::span<const Index> loop) {
    add_loop(loop);
    end_face();
  }
  void add_face(std::initializer_list<Index> loop) {
    add_face(std::span<const Index>(loop.begin(), loop.size()));
  }
};

}  // namespace overstrike
