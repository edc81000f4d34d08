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

/// A union of intersections, or either.
bool is_sum_of_products(const SolidExpression& expression) {
  for (Index t = 1; t < expression.terms(); ++t)
    if (expression.term(t).parent != 0 || expression.term(0).needed != 1) return false;
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

std::vector<std::shared_ptr<const CanonicalSolid>> solids_in_form(
    const Canonical& canonical, BooleanForm form, std::optional<double> translucent) {
  std::vector<std::shared_ptr<const CanonicalSolid>> solids = canonical.solids;
  std::vector<std::vector<WorldBox>> bounds;
  for (std::size_t s = 0; s < solids.size(); ++s) {
    const CanonicalSolid& tree = *canonical.solids[s];
    std::optional<SolidProducts> products;
    const bool few_do = form == BooleanForm::automatic && !is_sum_of_products(tree.expression);
    if (!tree.background && (form == BooleanForm::products || few_do)) {
      if (bounds.empty()) bounds = bounds_of_operands(canonical);
      products = SolidProducts::of(tree.expression, bounds[s],
                                   few_do ? kFewElementsPerLeaf * tree.expression.leaf_count()
                                          : SolidProducts::kMostElements);
      if (!products && !few_do) refuse_products(tree);
    }
    const double shown = translucent.value_or(tree.translucent);
    if (!products && !(shown > 0) && !tree.background) continue;
    auto solid = std::make_shared<CanonicalSolid>(tree);
    const Index operands = tree.expression.operands();
    // The tree stays, and with it where operands matter: so no form moves an end by a rounding.
    if (products) solid->expression = SolidExpression(products->nodes(), operands);
    solid->translucent = shown;
    if (!(shown > 0)) {
      solid->uncut.reset();
    } else if (!tree.background) {
      std::vector<SolidNode> nodes = uncut(tree.nodes);
      SolidExpression expression(nodes, operands);
      solid->uncut = UncutSolid{std::move(nodes), std::move(expression)};
    }
    solids[s] = std::move(solid);
  }
  return solids;
}

}  // namespace overstrike
