#include "core/visibility/operand_reach.h"

#include <cstdint>

namespace overstrike {
namespace {

using Index = std::uint32_t;

/// Per node, where its set may be.
std::vector<WorldBox> bounds_of_nodes(std::span<const SolidNode> nodes,
                                      std::span<const WorldBox> bounds) {
  std::vector<WorldBox> of(nodes.size());
  for (Index n = static_cast<Index>(nodes.size()); n-- > 0;) {
    const SolidNode& node = nodes[n];
    if (node.operation == SetOperation::operand) of[n] = bounds[node.body];
    if (node.end == n + 1) continue;
    of[n] = of[n + 1];
    if (node.operation == SetOperation::subtract) continue;
    for (Index i = nodes[n + 1].end; i < node.end; i = nodes[i].end)
      node.operation == SetOperation::unite ? of[n].add(of[i]) : of[n].keep(of[i]);
  }
  return of;
}

/// Narrows what the members of an intersection are given to what all others may be in.
void narrow_to_others(std::span<const SolidNode> nodes, Index intersection,
                      const std::vector<WorldBox>& bounds, std::vector<WorldBox>& reach) {
  std::vector<Index> members;
  for (Index i = intersection + 1; i < nodes[intersection].end; i = nodes[i].end)
    members.push_back(i);
  WorldBox before = WorldBox::everything(), after = WorldBox::everything();
  for (std::size_t i = 0; i < members.size(); ++i) {
    reach[members[i]].keep(before), before.keep(bounds[members[i]]);
    const Index last = members[members.size() - 1 - i];
    reach[last].keep(after), after.keep(bounds[last]);
  }
}

}  // namespace

void add_reach(std::span<const SolidNode> nodes, std::span<const WorldBox> bounds,
               std::span<WorldBox> reach) {
  const std::vector<WorldBox> sets = bounds_of_nodes(nodes, bounds);
  std::vector<WorldBox> of(nodes.size(), WorldBox::everything());
  for (Index n = 0; n < nodes.size(); ++n) {
    const SolidNode& node = nodes[n];
    if (node.operation == SetOperation::operand) {
      reach[node.body].add(of[n]);
      continue;
    }
    for (Index i = n + 1; i < node.end; i = nodes[i].end) {
      of[i] = of[n];
      if (node.operation == SetOperation::subtract && i > n + 1) of[i].keep(sets[n + 1]);
    }
    if (node.operation == SetOperation::intersect) narrow_to_others(nodes, n, sets, of);
  }
}

}  // namespace overstrike
