#pragma once
// Bytes -> a scene whose coordinates come from a tiny set, so that degeneracy is the rule: faces
// share planes, edges lie on edges and on scan lines, the eye stands in planes and on vertices.
#include <string>

#include "core/scene/scene.h"
#include "tests/fuzz/fuzz.h"

namespace overstrike::fuzz {

/// Laws that cost much are tried when the input says so.
struct Asked {
  bool threads = false;  ///< two threads draw what one draws
  bool order = false;    ///< the order of the bodies does not count
  bool means = false;    ///< cells are the means of many lines
  bool method = false;   ///< NN74's method draws what the resolver draws
};

struct TinyScene {
  Scene scene;
  Asked asked;
};

/// Any bytes are a scene of one to four bodies, none of which validate() refuses, and perhaps
/// solids over them. Bytes that are missing are 0.
TinyScene tiny_scene(ByteSource bytes);

/// The scene as a scene file, with all digits.
std::string to_yaml(const Scene& scene);

}  // namespace overstrike::fuzz
