#pragma once
// A Boolean expression, evaluated along a way through its operands (depth, for solids) without
// expanding it (sums of products are exponential in the depth of the tree).
//
// Differences become intersections with complements, and complements are pushed down to the
// operands (De Morgan); unions of unions and intersections of intersections become one. What is
// left are *terms* that are true while at least so many of their members are: one of a union, all
// of an intersection. Where an operand is entered or left its terms count, and only a term that
// changes tells the one above (TK 3.3.4 counts the same way, over products).
//
// So that a chain of terms does not pass on every change from its end to its top, terms are
// gathered in *paths*: each goes on in that of its member terms that has most terms below it.
// Given its other members, a term says what the next one of its path says, or it is *decisive*:
// true or false whatever that says. The top of a path says what its first decisive term does, and a
// change of another one changes nothing above. Paths lie at most log2(terms) above one another
// (heavy paths: Sleator and Tarjan, A data structure for dynamic trees, 1983).
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/polyhedron.h"
#include "core/geometry/rank_set.h"
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

  struct Term {
    Index parent;   ///< kNoTerm: the root, which is term 0
    Index needed;   ///< true while so many members are, or more; 1, or all of several
    Index at_rest;  ///< members that are true outside of everything
    Index path;
  };
  struct Leaf {
    Index term;
    bool complement;
  };
  /// Terms come before their members, and a path's terms one after the other.
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
    bool inside() const { return says(decides_[0]); }
    bool in(Index operand) const { return in_[operand] != 0; }
    /// Enters the operand, or leaves it.
    void flip(Index operand);

   private:
    bool says(Index decisive) const {
      return counts_[decisive] >= expression_->terms_[decisive].needed;
    }
    bool changes_top(Index t, Index before, Index after);

    const SolidExpression* expression_;
    std::vector<Index> counts_;   ///< per term: true members, the next one of its path apart
    std::vector<Index> decides_;  ///< per path: its first decisive term
    RankSet decisive_;            ///< terms
    std::vector<char> in_;        ///< per operand
    std::uint64_t updates_ = 0;
  };

 private:
  friend class State;
  struct Path {
    Index last;   ///< its last term, which is always decisive
    Index above;  ///< the term of which its first one is a member, or kNoTerm
  };

  std::vector<Term> terms_;
  std::vector<Path> paths_;
  std::vector<Leaf> leaves_;       ///< by operand
  std::vector<Index> first_leaf_;  ///< per operand, and one past the last
};

}  // namespace overstrike
