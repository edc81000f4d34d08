#include "core/visibility/solid_forms.h"

#include "core/visibility/solid_products.h"

namespace overstrike {
namespace {

/// Per solid, its operands'.
std::vector<std::vector<WorldBox>> bounds_of_operands(const Canonical& c) {
  std::vector<std::vector<WorldBox>> bounds;
  for (const auto& solid : c.solids) bounds.emplace_back(solid->expression.operands());
  for (Index b = 0; b < c.memberships.size(); ++b) {
    const Membership& member = c.memberships[b];
    if (member.solid == kNone) continue;
    const CanonicalBody& body = c.bodies[b];
    for (Index v = body.first_vertex; v < body.end_vertex; ++v)
      bounds[member.solid][member.operand].add(c.vertices[v]);
  }
  return bounds;
}

bool is_two_terms_deep(const SolidExpression& expression) {
  for (Index t = 1; t < expression.terms(); ++t)
    if (expression.term(t).parent != 0) return false;
  return true;
}

std::string name_of(const CanonicalSolid& solid) {
  return solid.name.empty() ? "the solid" : "solid '" + solid.name + "'";
}

[[noreturn]] void refuse_products(const CanonicalSolid& solid) {
  throw InputError(solid.place,
                   name_of(solid) + " has " + std::to_string(solid.expression.leaf_count()) +
                       " operands, and as a sum of products more than " +
                       std::to_string(SolidProducts::kMostElements) +
                       " elements: their number doubles with each difference of differences",
                   "boolean tree draws it");
}

SolidExpression as_products(const CanonicalSolid& solid, std::span<const WorldBox> bounds) {
  const auto products = SolidProducts::of(solid.expression, bounds);
  if (!products) refuse_products(solid);
  return SolidExpression(products->nodes(), solid.expression.operands());
}

}  // namespace

std::vector<SolidNode> uncut(const std::vector<SolidNode>& nodes) {
  std::vector<SolidNode> kept;
  std::vector<Index> place(nodes.size() + 1);  // of each node, or of the next one that is kept
  std::vector<char> is_taken(nodes.size(), 0);
  for (Index i = 0; i < nodes.size();) {
    place[i] = static_cast<Index>(kept.size());
    if (is_taken[i] != 0) {
      for (Index below = i; below < nodes[i].end; ++below) place[below] = place[i];
      i = nodes[i].end;
      continue;
    }
    kept.push_back(nodes[i]);
    if (nodes[i].operation == SetOperation::subtract && nodes[i].end > i + 1) {
      kept.back().operation = SetOperation::unite;
      for (Index taken = nodes[i + 1].end; taken < nodes[i].end; taken = nodes[taken].end)
        is_taken[taken] = 1;
    }
    ++i;
  }
  place[nodes.size()] = static_cast<Index>(kept.size());
  for (SolidNode& node : kept) node.end = place[node.end];
  return kept;
}

std::size_t most_updates(const SolidExpression& expression, const SolidExpression& in) {
  std::vector<std::size_t> up(expression.terms(), 1);  // from each term up to the root, with both
  for (Index t = 1; t < expression.terms(); ++t) up[t] = up[expression.term(t).parent] + 1;
  std::size_t sum = 0;
  for (Index operand = 0; operand < expression.operands(); ++operand) {
    if (in.leaves(operand).empty()) continue;
    for (const SolidExpression::Leaf& leaf : expression.leaves(operand)) sum += up[leaf.term];
  }
  return sum;
}

bool has_few_updates(const SolidExpression& expression) {
  if (!is_two_terms_deep(expression)) return false;
  if (expression.term(0).needed == 1) return true;
  for (Index operand = 0; operand < expression.operands(); ++operand)
    if (expression.leaves(operand).size() > 1) return false;
  return true;
}

std::optional<SolidExpression> fewer_updates(const SolidExpression& tree,
                                             std::span<const WorldBox> bounds) {
  const auto products = SolidProducts::of(tree, bounds, kMostElementsPerLeaf * tree.leaf_count());
  if (!products) return std::nullopt;
  SolidExpression sum(products->nodes(), tree.operands());
  if (most_updates(sum, sum) >= most_updates(tree, sum)) return std::nullopt;
  return sum;
}

std::vector<std::shared_ptr<const CanonicalSolid>> solids_in_form(
    const Canonical& canonical, BooleanForm form, std::optional<double> translucent) {
  std::vector<std::shared_ptr<const CanonicalSolid>> solids = canonical.solids;
  std::vector<std::vector<WorldBox>> bounds;
  const auto bounds_of = [&](std::size_t s) -> std::span<const WorldBox> {
    if (bounds.empty()) bounds = bounds_of_operands(canonical);
    return bounds[s];
  };
  for (std::size_t s = 0; s < solids.size(); ++s) {
    const CanonicalSolid& tree = *canonical.solids[s];
    std::optional<SolidExpression> sum;
    if (!tree.background) {
      if (form == BooleanForm::automatic && !has_few_updates(tree.expression))
        sum = fewer_updates(tree.expression, bounds_of(s));
      if (form == BooleanForm::products) sum = as_products(tree, bounds_of(s));
    }
    const double shown = translucent.value_or(tree.translucent);
    if (!sum && !(shown > 0) && !tree.background) continue;
    auto solid = std::make_shared<CanonicalSolid>(tree);
    // The tree stays, and with it where operands matter: so no form moves an end by a rounding.
    if (sum) solid->expression = std::move(*sum);
    solid->translucent = shown;
    if (!(shown > 0)) {
      solid->uncut.reset();
    } else if (!tree.background) {
      std::vector<SolidNode> nodes = uncut(tree.nodes);
      SolidExpression expression(nodes, tree.expression.operands());
      solid->uncut = UncutSolid{std::move(nodes), std::move(expression)};
    }
    solids[s] = std::move(solid);
  }
  return solids;
}

}  // namespace overstrike
