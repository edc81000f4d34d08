#pragma once
// One hard case in another pose: turned, scaled and moved as a whole, with camera, light and
// ground.
#include <string>
#include <vector>

#include "core/scene/scene.h"

namespace overstrike::hard {

constexpr int kTurns = 16;

struct Variant {
  int turn = 0;      ///< 0: as it stands; 1: by a quarter about z; else a seeded rotation
  double scale = 1;  ///< about the origin
  double move = 0;   ///< in sizes of the scene, in a direction that goes with the turn
  bool is_as_it_stands() const { return turn == 0 && scale == 1 && move == 0; }
};

std::string describe(const Variant& variant);

/// Every turn at scales 1e-9, 1 and 1e9, and moved by 1e3, 1e6 and 1e8 sizes.
const std::vector<Variant>& all_variants();

/// Scenes with a ground turn about z only. The camera becomes one from an eye to a target; as it
/// stands, the scene is the same to the last bit.
Scene posed(const Scene& scene, const Variant& variant);

/// The length of the diagonal of what the scene shows.
double size_of(const Scene& scene);

}  // namespace overstrike::hard
