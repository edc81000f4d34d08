#include "core/scene/solid_expression.h"

#include <algorithm>

namespace overstrike {
namespace {

constexpr Index kNoTerm = SolidExpression::kNoTerm;

/// The terms of a tree, each after the one that it is a member of, and their leaves.
struct Found {
  struct Term {
    Index parent;
    bool of_all;  ///< all members are needed, or one
    Index members = 0;
    Index full = 0;  ///< members that are complements of the empty set
  };
  struct Leaf {
    Index operand, term;
    bool complement;
  };
  std::vector<Term> terms;
  std::vector<Leaf> leaves;

  explicit Found(std::span<const SolidNode> tree);

 private:
  /// A node of the tree whose operands are being gone over; on a stack of our own, as trees may be
  /// deeper than the machine's.
  struct Open {
    Index node, next;  ///< next: the operand to come
    Index term;        ///< that its operands belong to
    bool complement;   ///< the complement of the node is meant
    bool first;        ///< of a difference: the next operand is what the others are taken from
  };
  Index add_term(Index parent, bool of_all);
  void enter(Index node, Index into, bool complement);

  std::span<const SolidNode> nodes;
  std::vector<Open> open;
};

/// Whether all members are needed: of an intersection, of a difference, of a union's complement.
bool needs_all(SetOperation operation, bool complement) {
  return (operation != SetOperation::unite) != complement;
}

Found::Found(std::span<const SolidNode> tree) : nodes(tree) {
  if (nodes.empty() || nodes[0].end == 1) add_term(kNoTerm, false);
  if (!nodes.empty()) enter(0, terms.empty() ? kNoTerm : 0, false);
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
}

Index Found::add_term(Index parent, bool of_all) {
  if (parent != kNoTerm) ++terms[parent].members;
  terms.push_back({parent, of_all});
  return static_cast<Index>(terms.size() - 1);
}

/// `into`: the term that the node is a member of.
void Found::enter(Index node, Index into, bool complement) {
  const SetOperation operation = nodes[node].operation;
  if (operation == SetOperation::operand) {
    ++terms[into].members;
    leaves.push_back({nodes[node].body, into, complement});
    return;
  }
  if (nodes[node].end == node + 1) {
    ++terms[into].members;
    terms[into].full += complement;
    return;
  }
  const bool of_all = needs_all(operation, complement);
  const bool joins = into != kNoTerm && terms[into].of_all == of_all;
  open.push_back({node, node + 1, joins ? into : add_term(into, of_all), complement,
                  operation == SetOperation::subtract});
}

/// Their numbers on heavy paths: right after each term comes that of its member terms that has most
/// terms below it, with those, and then the others.
std::vector<Index> path_numbers(const std::vector<Found::Term>& terms) {
  const std::size_t count = terms.size();
  std::vector<Index> size(count, 1), heaviest(count, kNoTerm);
  for (std::size_t t = count; t-- > 1;) {
    const Index parent = terms[t].parent;
    size[parent] += size[t];
    Index& heavy = heaviest[parent];
    if (heavy == kNoTerm || size[t] >= size[heavy]) heavy = static_cast<Index>(t);
  }
  std::vector<Index> number(count, 0), next(count);  // next: of a term's other members
  for (std::size_t t = 0; t < count; ++t) {
    if (t > 0) {
      const Index parent = terms[t].parent;
      const bool goes_on = heaviest[parent] == t;
      number[t] = goes_on ? number[parent] + 1 : next[parent];
      if (!goes_on) next[parent] += size[t];
    }
    next[t] = number[t] + 1 + (heaviest[t] == kNoTerm ? 0 : size[heaviest[t]]);
  }
  return number;
}

}  // namespace

SolidExpression::SolidExpression(std::span<const SolidNode> nodes, Index operands)
    : first_leaf_(operands + 1, 0) {
  const Found found(nodes);
  const std::vector<Index> number = path_numbers(found.terms);
  terms_.resize(number.size());
  for (std::size_t t = 0; t < number.size(); ++t) {
    const Found::Term& f = found.terms[t];
    terms_[number[t]] = {f.parent == kNoTerm ? kNoTerm : number[f.parent], f.of_all ? f.members : 1,
                         f.full, 0};
  }
  for (const Found::Leaf& f : found.leaves) ++first_leaf_[f.operand + 1];
  for (Index i = 0; i < operands; ++i) first_leaf_[i + 1] += first_leaf_[i];
  std::vector<Index> place(first_leaf_.begin(), first_leaf_.end() - 1);
  leaves_.resize(found.leaves.size());
  for (const Found::Leaf& f : found.leaves) {
    leaves_[place[f.operand]++] = {number[f.term], f.complement};
    terms_[number[f.term]].at_rest += f.complement;
  }
  for (Index t = terms(); t-- > 1;)
    terms_[terms_[t].parent].at_rest += terms_[t].at_rest >= terms_[t].needed;
  for (Index t = 0; t < terms(); ++t) {
    if (t == 0 || terms_[t].parent != t - 1) paths_.push_back({t, terms_[t].parent});
    paths_.back().last = t;
    terms_[t].path = static_cast<Index>(paths_.size() - 1);
  }
}

SolidExpression::State::State(const SolidExpression& expression)
    : expression_(&expression),
      decides_(expression.paths_.size()),
      decisive_(expression.terms()),
      operands_(expression.operands(), 0) {
  for (Index i = 0; i < expression.operands(); ++i)
    if (expression.leaves(i).empty()) operands_[i] = kFlipped;
  const std::vector<Term>& terms = expression.terms_;
  for (const Term& term : terms) counts_.push_back(term.at_rest);
  for (Index t = expression.terms(); t-- > 0;) {
    const bool is_last = expression.paths_[terms[t].path].last == t;
    if (!is_last) counts_[t] -= terms[t + 1].at_rest >= terms[t + 1].needed;
    if (!is_last && counts_[t] == terms[t].needed - 1) continue;
    decisive_.insert(t);
    decides_[terms[t].path] = t;
  }
}

void SolidExpression::State::count(Index operand) {
  const bool now = in(operand);
  std::uint64_t updates = 0;
  operands_[operand] ^= kCounted;
  for (const Leaf& leaf : expression_->leaves(operand)) {
    const bool rises = now != leaf.complement;
    for (Index t = leaf.term; t != kNoTerm;) {
      const Term& term = expression_->terms_[t];
      const Path& path = expression_->paths_[term.path];
      const Index before = counts_[t], after = before + (rises ? 1 : -1u);
      counts_[t] = after;
      ++updates;
      const bool top_changes =
          t == path.last
              ? decides_[term.path] == t && (before >= term.needed) != (after >= term.needed)
              : changes_top(t, before, after);
      if (!top_changes) break;
      t = path.above;
    }
  }
  updates_ += updates;
}

/// Whether the top of its path does what a member of the term has done, which is not the next term
/// of the path: has become true, or false.
bool SolidExpression::State::changes_top(Index t, Index before, Index after) {
  // One of a union or all of an intersection are needed: with one less than that true, the next
  // term of the path decides, and with more or fewer it does not.
  const Term& term = expression_->terms_[t];
  const Index in_doubt = term.needed - 1;
  if (before != in_doubt && after != in_doubt) return false;
  const bool rises = before < after;
  Index& decides = decides_[term.path];
  if (before == in_doubt) {
    decisive_.insert(t);
    if (decides < t) return false;
    const bool changes = says(decides) != rises;
    decides = t;
    return changes;
  }
  decisive_.erase(t);
  if (decides != t) return false;
  decides = static_cast<Index>(decisive_.up(t));
  return says(decides) == rises;
}

}  // namespace overstrike
