#pragma once
// Boolean solids of tiny scenes.
#include "core/scene/scene.h"
#include "tests/fuzz/fuzz.h"

namespace overstrike::fuzz {

/// One or two solids, when the bytes say so, of trees over the scene's closed bodies and copies of
/// them: a body may be an operand in several places. What no tree took stands for itself. Without
/// bytes there is none.
void add_solids(ByteSource& bytes, Scene& scene);

/// The same bodies and solids, and operands but for those from which others are taken, in the
/// opposite order.
Scene in_opposite_order(const Scene& scene);

}  // namespace overstrike::fuzz
