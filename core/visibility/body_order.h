#pragma once
// Which of two bodies hides the other, where that can be told without looking at their faces.
#include "core/visibility/front_table.h"

namespace overstrike {

/// 1 when `a` is in front of `b` on every line of sight that meets both, -1 for the contrary, 0
/// when faces must be compared. Exact: a plane across an axis parts them, and the eye is on one
/// side; or all depths of one are larger.
///
/// Where bodies touch the parting plane it parts them too, for only one of two bodies with an
/// inside can show a face in that plane. A body as thin as a sheet may show one there from either
/// side, and is compared, so that ties are decided by their rule.
int order_of(const FrontBody& a, const FrontBody& b, const Vec4& eye);

}  // namespace overstrike
