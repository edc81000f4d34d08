#include "scenes/readers/openscad/solid_tree.h"

namespace overstrike::openscad {
namespace {

class TreeMaker {
 public:
  TreeMaker(const Tree& tree, const Nodes& nodes, const std::vector<NodeShape>& shapes,
            const std::function<Index(Index, const Part&)>& operand)
      : tree_(tree), nodes_(nodes), shapes_(shapes), operand_(operand) {}

  std::vector<SolidNode> make(Index root) {
    for (Index i = root; i < tree_.nodes[root].end;) {
      close_before(i);
      const bool filled = i == root || (nodes_.states[i].drawn && shapes_[i].filled);
      const bool has_parts = !shapes_[i].parts.empty();
      if (i == root && has_parts) open(i);
      if (filled && !has_parts &&
          (i == root || nodes_.states[i].word->role == WordRole::structure)) {
        if (i == root || shapes_[i].filled_children > 1) open(i);
        ++i;
        continue;
      }
      if (filled) add_operands(i);
      i = tree_.nodes[i].end;
    }
    close_before(tree_.nodes[root].end);
    return std::move(made_);
  }

 private:
  void open(Index i) {
    open_.push_back({tree_.nodes[i].end, static_cast<Index>(made_.size())});
    made_.push_back({operation_of(*nodes_.states[i].word), 0, 0});
  }

  void close_before(Index i) {
    while (!open_.empty() && open_.back().end <= i) {
      made_[open_.back().node].end = static_cast<Index>(made_.size());
      open_.pop_back();
    }
  }

  void add_operands(Index i) {
    const std::vector<Part>& parts = shapes_[i].parts;
    if (parts.size() > 1) {
      const Index end = static_cast<Index>(made_.size() + 1 + parts.size());
      made_.push_back({SetOperation::unite, 0, end});
    }
    for (const Part& part : parts) {
      const Index number = operand_(i, part);
      made_.push_back({SetOperation::operand, number, static_cast<Index>(made_.size() + 1)});
    }
  }

  const Tree& tree_;
  const Nodes& nodes_;
  const std::vector<NodeShape>& shapes_;
  const std::function<Index(Index, const Part&)>& operand_;
  struct Open {
    Index end;   ///< in the file's tree
    Index node;  ///< in the solid's
  };
  std::vector<Open> open_;
  std::vector<SolidNode> made_;
};

}  // namespace

std::vector<SolidNode> solid_tree(const Tree& tree, const Nodes& nodes,
                                  const std::vector<NodeShape>& shapes, Index root,
                                  const std::function<Index(Index, const Part&)>& operand) {
  return TreeMaker(tree, nodes, shapes, operand).make(root);
}

}  // namespace overstrike::openscad
