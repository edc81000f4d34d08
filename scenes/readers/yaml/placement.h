#pragma once
// scale, mirror, rotate, at, transform and array -> affine maps.
#include <vector>

#include "core/geometry/vec.h"
#include "scenes/readers/yaml/fields.h"

namespace overstrike::yaml {

/// What the body's transform keys say: scale, then mirror, then rotate, then at; or the list of
/// `transform` from first to last.
Affine read_placement(const Fields& body);

/// Equal copies in a row or round an axis. Kept as said: a file may say more copies than memory
/// holds.
struct Array {
  int count = 1;
  bool polar = false;
  Vec3 step{0.0};      ///< of a row
  double degrees = 0;  ///< of a ring: between neighbours, or all round
  bool all_round = true;
  Vec3 axis{0, 0, 1}, center{0.0};

  /// Of copy 0 .. count - 1; that of copy 0 moves nothing.
  Affine place(int copy) const;
};

/// The `array` of a body: each copies what the ones before it made.
std::vector<Array> read_arrays(const Fields& body);

/// A scene holds at most so many bodies and groups, copies counted: about a third of a gigabyte.
constexpr std::size_t kMostCopies = 1'000'000;

}  // namespace overstrike::yaml
