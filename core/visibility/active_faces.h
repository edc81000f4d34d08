#pragma once
// The active faces of an EyeTable's scan line, and the shadow counts over them.
#include "core/visibility/active_list.h"
#include "core/visibility/eye_table.h"

namespace overstrike {

class ActiveFaces : public ActiveList<EyeTable> {
 public:
  explicit ActiveFaces(const EyeTable& table)
      : ActiveList(table),
        table_(table),
        shadow_count_(table.covered.begin(), table.covered.end()) {}

  /// Passes an edge from left to right, or back.
  void pass(const ScanEdge& edge) {
    if (edge.winding == 0) return ActiveList::pass(edge.faces);
    shadow_count_[edge.shadow_slot] += edge.winding;
  }
  void pass_back(const ScanEdge& edge) {
    if (edge.winding == 0) return ActiveList::pass_back(edge.faces);
    shadow_count_[edge.shadow_slot] -= edge.winding;
  }
  void clear() {
    ActiveList::clear();
    shadow_count_.assign(table_.covered.begin(), table_.covered.end());
  }
  bool shadowed(Index face) const {
    const Index slot = table_.shadow_slot[table_.faces[face].surface];
    return slot != kNone && shadow_count_[slot] != 0;
  }

 private:
  const EyeTable& table_;
  std::vector<int> shadow_count_;
};

}  // namespace overstrike
