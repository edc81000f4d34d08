#pragma once
// Which part of the picture an operand matters in.
#include <span>
#include <vector>

#include "core/visibility/front_table.h"

namespace overstrike {

/// Per body: of an operand what encloses the bounds of where it matters to its solid
/// (operand_reach.h); none where it matters nowhere. `bodies` have their bounds in the world. What
/// is seen does not hang on what an operand shows beyond. Empty where all matter everywhere.
std::vector<GridWindow> operand_windows(const Canonical& canonical, const View& view,
                                        std::span<const FrontBody> bodies);

}  // namespace overstrike
