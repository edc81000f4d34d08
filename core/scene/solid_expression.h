#pragma once
// A Boolean expression, evaluated along a way through its operands (depth, for solids) without
// expanding it (sums of products are exponential in the depth of the tree).
//
// Differences become intersections with complements, and complements are pushed down to the
// operands (De Morgan); unions of unions and intersections of intersections become one. What is
// left are *terms* that are true while at least so many of their members are: one of a union, all
// of an intersection. Where an operand is entered or left its terms count, and only a term that
// changes tells the one above (TK 3.3.4 counts the same way, over products).
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/polyhedron.h"
#include "core/scene/set_operation.h"

namespace overstrike {

/// What never changes; shared between threads.
class SolidExpression {
 public:
  static constexpr Index kNoTerm = 0xFFFFFFFFu;

  /// The `body` of a leaf is the number of its operand, 0 to `operands` - 1; leaves of one number
  /// are the same set. A node without operands is empty.
  SolidExpression(std::span<const SolidNode> nodes, Index operands);

  Index operands() const { return static_cast<Index>(first_leaf_.size() - 1); }
  Index terms() const { return static_cast<Index>(terms_.size()); }
  /// How many terms lie above one another at most.
  Index depth() const { return depth_; }
  /// The term of the operand's last leaf, or the root where it has none; the terms above one have
  /// smaller numbers.
  Index last_term(Index operand) const {
    const std::span<const Leaf> all = leaves(operand);
    return all.empty() ? 0 : all.back().term;
  }

  struct Term {
    Index parent;   ///< kNoTerm: the root, which is term 0
    Index needed;   ///< true while so many members are, or more; 1, or all of several
    Index at_rest;  ///< members that are true outside of everything
  };
  struct Leaf {
    Index term;
    bool complement;
  };
  /// Terms come before their members.
  const Term& term(Index t) const { return terms_[t]; }
  std::span<const Leaf> leaves(Index operand) const {
    return {leaves_.data() + first_leaf_[operand], leaves_.data() + first_leaf_[operand + 1]};
  }
  std::size_t leaf_count() const { return leaves_.size(); }

  /// One place on its way along a line of sight. Outside of everything at first. One a thread.
  class State {
   public:
    explicit State(const SolidExpression& expression);
    /// How often a term has counted so far.
    std::uint64_t updates() const { return updates_; }
    /// True when the place is in the solid.
    bool inside() const { return counts_[0] >= expression_->terms_[0].needed; }
    bool in(Index operand) const { return in_[operand] != 0; }
    /// Enters the operand, or leaves it.
    void flip(Index operand);

   private:
    const SolidExpression* expression_;
    std::vector<Index> counts_;  ///< per term: how many of its members are true
    std::vector<char> in_;       ///< per operand
    std::uint64_t updates_ = 0;
  };

 private:
  friend class State;
  Index depth_ = 0;
  std::vector<Term> terms_;
  std::vector<Leaf> leaves_;       ///< by operand
  std::vector<Index> first_leaf_;  ///< per operand, and one past the last
};

}  // namespace overstrike
