#include "core/scene/solid_expression.h"

namespace overstrike {
namespace {

/// A node of the tree whose operands are being gone over; on a stack of our own, as trees may be
/// deeper than the machine's.
struct Open {
  Index node, next;  ///< next: the operand to come
  Index term;        ///< that its operands belong to
  bool complement;   ///< the complement of the node is meant
  bool first;        ///< of a difference: the next operand is what the others are taken from
};

/// Whether all members are needed: of an intersection, of a difference, of a union's complement.
bool needs_all(SetOperation operation, bool complement) {
  return (operation != SetOperation::unite) != complement;
}

}  // namespace

SolidExpression::SolidExpression(std::span<const SolidNode> nodes, Index operands) {
  struct Found {
    Index operand;
    Leaf leaf;
  };
  std::vector<Found> found;
  std::vector<char> all;  // per term
  std::vector<Index> members;
  const auto add_term = [&](Index parent, bool of_all) {
    if (parent != kNoTerm) ++members[parent];
    terms_.push_back({parent, 1, 0});
    all.push_back(of_all), members.push_back(0);
    return static_cast<Index>(terms_.size() - 1);
  };
  std::vector<Open> open;
  /// `into`: the term that the node is a member of, of which all are needed or one.
  const auto enter = [&](Index node, Index into, bool complement) {
    const SetOperation operation = nodes[node].operation;
    if (operation == SetOperation::operand) {
      ++members[into];
      found.push_back({nodes[node].body, {into, complement}});
      return;
    }
    if (nodes[node].end == node + 1) {
      ++members[into];
      terms_[into].at_rest += complement;
      return;
    }
    const bool of_all = needs_all(operation, complement);
    const bool joins = into != kNoTerm && (all[into] != 0) == of_all;
    open.push_back({node, node + 1, joins ? into : add_term(into, of_all), complement,
                    operation == SetOperation::subtract});
  };
  if (nodes.empty() || nodes[0].end == 1) add_term(kNoTerm, false);
  if (!nodes.empty()) enter(0, terms_.empty() ? kNoTerm : 0, false);
  while (!open.empty()) {
    Open& top = open.back();
    if (top.next >= nodes[top.node].end) {
      open.pop_back();
      continue;
    }
    const Index child = top.next, into = top.term;
    const bool taken = nodes[top.node].operation == SetOperation::subtract && !top.first;
    const bool complement = top.complement != taken;
    top.next = nodes[child].end, top.first = false;
    enter(child, into, complement);
  }
  first_leaf_.assign(operands + 1, 0);
  for (const Found& f : found) ++first_leaf_[f.operand + 1];
  for (Index i = 0; i < operands; ++i) first_leaf_[i + 1] += first_leaf_[i];
  std::vector<Index> place(first_leaf_.begin(), first_leaf_.end() - 1);
  leaves_.resize(found.size());
  for (const Found& f : found) {
    leaves_[place[f.operand]++] = f.leaf;
    terms_[f.leaf.term].at_rest += f.leaf.complement;
  }
  // Terms come before their members.
  for (Index t = terms(); t-- > 0;) {
    if (all[t] != 0) terms_[t].needed = members[t];
    if (t > 0) terms_[terms_[t].parent].at_rest += terms_[t].at_rest >= terms_[t].needed;
  }
}

SolidExpression::State::State(const SolidExpression& expression)
    : expression_(&expression), in_(expression.operands(), 0) {
  for (const Term& term : expression.terms_) counts_.push_back(term.at_rest);
}

void SolidExpression::State::flip(Index operand) {
  const bool now = in_[operand] == 0;
  in_[operand] = now;
  for (Index i = expression_->first_leaf_[operand]; i < expression_->first_leaf_[operand + 1];
       ++i) {
    const Leaf& leaf = expression_->leaves_[i];
    bool rises = now != leaf.complement;
    for (Index t = leaf.term; t != kNoTerm;) {
      const Term& term = expression_->terms_[t];
      const bool before = counts_[t] >= term.needed;
      counts_[t] += rises ? 1 : -1u;
      const bool after = counts_[t] >= term.needed;
      if (before == after) break;
      rises = after;
      t = term.parent;
    }
  }
}

}  // namespace overstrike
