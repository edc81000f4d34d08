#pragma once
// Meshes as people bring them: what is flawed is repaired where that is possible, and named always.
//
//   1. vertices of one position become one
//   2. repeated vertices, faces of fewer than three vertices or of no area, second copies of a face
//      go
//   3. faces that are planar and cross themselves are named; the even-odd rule draws them
//   4. faces that are not planar are split
//   5. faces are turned to agree with their neighbours (most of a shell's area decides)
//   6. closed shells that are inside out are turned, unless they are a cavity of another
//   7. open edges are named
#include <string>
#include <vector>

#include "core/geometry/winged_edges.h"

namespace overstrike {

struct RepairOptions {
  /// How far a coordinate may be from what was meant (Mesh::precision).
  double precision = 0;
  /// Borders and orientation are as they should be (a flat polygon).
  bool open = false;
  /// Empty, or the line of the file of each face.
  std::vector<int> lines;
};

struct Repaired {
  Polyhedron polyhedron;
  /// A face crosses itself: it is turned to one side in one part and to the other in another, so
  /// that the surface has no inside even where no edge is open.
  bool crosses_itself = false;
};

/// `flaws` gets one sentence for every kind of flaw. Faces are counted from 0, as in the input.
Repaired repaired(const Polyhedron& polyhedron, const RepairOptions& options,
                  std::vector<std::string>& flaws);

}  // namespace overstrike
