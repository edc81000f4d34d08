#pragma once
// The hard cases: one small scene file each, which says in its first lines what it provokes and
// what must come out.
#include <string>
#include <vector>

#include "core/picture.h"
#include "core/scene/scene.h"

namespace overstrike::hard {

/// The grid of every case: with a window of 32 in a parallel view, a cell is a unit and whole
/// coordinates lie on whole rows.
constexpr Grid kGrid{32, 32, 1, 1};
/// Few facets, in cells: the tolerance is not what is tried here.
constexpr double kTolerance = 0.5;

struct Case {
  std::string name;  ///< of the file, without its extension
  Scene scene;
  /// What a line "# warns: text" of the file asks for: a warning that contains the text.
  std::vector<std::string> warns;
  /// What a line "# apart: name, name" names: flawed bodies, whose damage is theirs alone.
  std::vector<std::string> apart;
  /// The finest detail that the picture hangs on, in sizes of the scene ("# finest: 1e-12"): a pose
  /// that rounds coarser is another picture.
  double finest = 1e-3;
};

/// Every case, in order of name.
const std::vector<Case>& corpus();
const Case& find_case(const std::string& name);

/// Faces of the canonical input as the case stands: what judging it costs goes by that.
std::size_t face_count(const Case& hard);

}  // namespace overstrike::hard
