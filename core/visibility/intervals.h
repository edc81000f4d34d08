#pragma once
// Sets of parameters along a line.
#include <utility>
#include <vector>

namespace overstrike {

using Interval = std::pair<double, double>;
/// Sorted, disjoint and not empty, unless said otherwise.
using Intervals = std::vector<Interval>;

/// Where a linear function is positive on [0, 1], that is ga at 0 and gb at 1; an end is exact
/// where the function is 0 there. Empty (first > second) where it is nowhere.
Interval positive_part(double ga, double gb);

/// Brings intervals in any order, overlapping or empty ones among them, into the normal form.
void unite(Intervals& intervals);

/// What lies in both sets.
Intervals common(const Intervals& a, const Intervals& b);

/// What lies in one of the sets and not in the other.
Intervals difference(const Intervals& a, const Intervals& b);

/// Sets what lies between odd and even of the crossings, which are sorted.
void pair_up(std::vector<double>& crossings, Intervals& result);

/// What is left of [whole.first, whole.second] outside of `holes`. Holes and gaps no longer than
/// `sliver` are taken for rounding and closed.
Intervals without(const Interval& whole, const Intervals& holes, double sliver);

}  // namespace overstrike
