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
  ///
  /// Terms count when it is asked whether the place is inside, and only what is otherwise than when
  /// it was asked before: a way through a hundred operands that is undone, to begin another one
  /// through ninety-nine of them, costs one.
  class State {
   public:
    explicit State(const SolidExpression& expression);
    /// How often a term has counted so far.
    std::uint64_t updates() const { return updates_; }
    /// True when the place is in the solid.
    bool inside() {
      for (const Index operand : flipped_) {
        operands_[operand] &= ~kFlipped;
        const bool counted = (operands_[operand] & kCounted) != 0;
        if (in(operand) != counted) count(operand);
      }
      flipped_.clear();
      return says(decides_[0]);
    }
    bool in(Index operand) const { return (operands_[operand] & kIn) != 0; }
    /// Enters the operand, or leaves it.
    void flip(Index operand) {
      operands_[operand] ^= kIn;
      if ((operands_[operand] & kFlipped) != 0) return;
      operands_[operand] |= kFlipped;
      flipped_.push_back(operand);
    }

   private:
    static constexpr std::uint8_t kIn = 1;
    static constexpr std::uint8_t kCounted = 2;  ///< is in, as the terms have it
    static constexpr std::uint8_t kFlipped = 4;  ///< since it was asked; always without leaves

    bool says(Index decisive) const {
      return counts_[decisive] >= expression_->terms_[decisive].needed;
    }
    void count(Index operand);
    bool changes_top(Index t, Index before, Index after);

    const SolidExpression* expression_;
    std::vector<Index> counts_;   ///< per term: true members, the next one of its path apart
    std::vector<Index> decides_;  ///< per path: its first decisive term
    RankSet decisive_;            ///< terms
    std::vector<std::uint8_t> operands_;  ///< kIn and so on
    std::vector<Index> flipped_;  ///< those that are kFlipped, but for operands without leaves
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
