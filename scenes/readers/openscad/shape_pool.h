#pragma once
// Shapes that are equal by value, once.
#include <unordered_map>
#include <vector>

#include "core/scene/shapes.h"

namespace overstrike::openscad {

/// Equal operands in equal places are one operand to core, which knows them by their shape.
class ShapePool {
 public:
  /// The shape that is equal to this one and came first, or this one.
  ShapePtr shared(ShapePtr shape);

 private:
  std::unordered_multimap<std::size_t, ShapePtr> known_;
};

}  // namespace overstrike::openscad
