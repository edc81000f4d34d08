#include "core/visibility/solid_products.h"

#include <algorithm>

namespace overstrike {
namespace {

/// On the way: elements as numbers, twice the operand and one more for its complement.
struct Factor {
  std::vector<Index> elements;  ///< sorted
  WorldBox bounds = WorldBox::everything();
  std::uint64_t signature = 0;  ///< a bit for each element, some for several

  void sign() {
    signature = 0;
    for (const Index e : elements) signature |= std::uint64_t{1} << (e % 64);
  }
  /// All its elements are the other's too.
  bool holds_where(const Factor& other) const {
    return (signature & ~other.signature) == 0 &&
           std::includes(other.elements.begin(), other.elements.end(), elements.begin(),
                         elements.end());
  }
};
using Sum = std::vector<Factor>;

class Distribution {
 public:
  Distribution(std::span<const WorldBox> bounds, std::size_t most) : bounds_(bounds), most_(most) {}

  /// False where there are too many elements.
  bool add(Sum& sum, const Sum& other) const {
    sum.insert(sum.end(), other.begin(), other.end());
    return absorb(sum);
  }

  bool multiply(Sum& sum, const Sum& other) const {
    Sum products;
    std::size_t elements = 0;
    for (const Factor& a : sum)
      for (const Factor& b : other) {
        Factor both;
        std::set_union(a.elements.begin(), a.elements.end(), b.elements.begin(), b.elements.end(),
                       std::back_inserter(both.elements));
        both.bounds = common(a.bounds, b.bounds);
        if (!tidy(both)) continue;
        elements += both.elements.size() + 1;
        // Absorption leaves far less than it is given, at times.
        if (elements > kRoom * most_) return false;
        products.push_back(std::move(both));
      }
    sum = std::move(products);
    return absorb(sum);
  }

  /// The product of elements. Nothing where it is empty.
  Sum product(std::vector<Index> elements) const {
    Factor factor;
    std::sort(elements.begin(), elements.end());
    elements.erase(std::unique(elements.begin(), elements.end()), elements.end());
    for (const Index e : elements)
      if (e % 2 == 0) factor.bounds.keep(bounds_[e / 2]);
    factor.elements = std::move(elements);
    if (!tidy(factor)) return {};
    return {std::move(factor)};
  }

 private:
  static constexpr std::size_t kRoom = 4;

  /// Drops what changes nothing. False where the product is empty.
  bool tidy(Factor& factor) const {
    if (factor.bounds.empty()) return false;
    std::vector<Index>& e = factor.elements;
    const auto contradicts = [](Index a, Index b) { return (a ^ 1u) == b; };
    if (std::adjacent_find(e.begin(), e.end(), contradicts) != e.end()) return false;
    std::erase_if(e, [&](Index element) {
      return element % 2 != 0 && common(factor.bounds, bounds_[element / 2]).empty();
    });
    factor.sign();
    return true;
  }

  bool absorb(Sum& sum) const {
    std::sort(sum.begin(), sum.end(), [](const Factor& a, const Factor& b) {
      const auto size_a = a.elements.size(), size_b = b.elements.size();
      return size_a != size_b ? size_a < size_b : a.elements < b.elements;
    });
    std::size_t kept = 0, elements = 0;
    for (Factor& factor : sum) {
      const auto end = sum.begin() + static_cast<std::ptrdiff_t>(kept);
      if (std::any_of(sum.begin(), end, [&](const Factor& f) { return f.holds_where(factor); }))
        continue;
      elements += factor.elements.size();
      if (elements > most_) return false;
      if (&sum[kept] != &factor) sum[kept] = std::move(factor);
      ++kept;
    }
    sum.resize(kept);
    return true;
  }

  std::span<const WorldBox> bounds_;
  std::size_t most_;
};

/// What a term has for members.
struct Members {
  std::vector<Index> elements;
  std::vector<Sum> terms;
  bool always = false;  ///< one of them
  bool never = false;   ///< one of them
};

std::vector<Members> members_of(const SolidExpression& expression) {
  std::vector<Members> members(expression.terms());
  std::vector<Index> number(expression.terms(), 0), at_rest(expression.terms(), 0);
  for (Index operand = 0; operand < expression.operands(); ++operand)
    for (const SolidExpression::Leaf& leaf : expression.leaves(operand)) {
      members[leaf.term].elements.push_back(2 * operand + leaf.complement);
      ++number[leaf.term], at_rest[leaf.term] += leaf.complement;
    }
  for (Index t = 1; t < expression.terms(); ++t) {
    const SolidExpression::Term& term = expression.term(t);
    ++number[term.parent], at_rest[term.parent] += term.at_rest >= term.needed;
  }
  // What else is counted is a set without points, or the complement of one.
  for (Index t = 0; t < expression.terms(); ++t) {
    const SolidExpression::Term& term = expression.term(t);
    members[t].always = term.at_rest > at_rest[t];
    members[t].never = term.needed > number[t] + (term.at_rest - at_rest[t]);
  }
  return members;
}

/// The sum of a term, or false.
bool sum_of(const SolidExpression::Term& term, Members& members, const Distribution& distribution,
            Sum& sum) {
  if (term.needed != 1) {
    if (members.never) return true;
    sum = distribution.product(std::move(members.elements));
    // Those with few products first: what they leave is multiplied more often.
    std::stable_sort(members.terms.begin(), members.terms.end(),
                     [](const Sum& a, const Sum& b) { return a.size() < b.size(); });
    for (const Sum& term_sum : members.terms)
      if (!distribution.multiply(sum, term_sum)) return false;
    return true;
  }
  if (members.always) members.elements.clear(), members.terms = {distribution.product({})};
  for (const Index element : members.elements) {
    Sum one = distribution.product({element});
    sum.insert(sum.end(), one.begin(), one.end());
  }
  for (const Sum& term_sum : members.terms) sum.insert(sum.end(), term_sum.begin(), term_sum.end());
  return distribution.add(sum, {});
}

}  // namespace

std::optional<SolidProducts> SolidProducts::of(const SolidExpression& expression,
                                               std::span<const WorldBox> bounds, std::size_t most) {
  const Distribution distribution(bounds, most);
  std::vector<Members> members = members_of(expression);
  Sum sum;
  // Terms come before their members.
  for (Index t = expression.terms(); t-- > 0;) {
    sum.clear();
    if (!sum_of(expression.term(t), members[t], distribution, sum)) return std::nullopt;
    members[t] = {};
    if (t > 0) members[expression.term(t).parent].terms.push_back(std::move(sum));
  }
  SolidProducts result;
  for (const Factor& factor : sum) {
    Product& product = result.products_.emplace_back();
    for (const Index e : factor.elements) product.push_back({e / 2, e % 2 != 0});
  }
  return result;
}

std::size_t SolidProducts::elements() const {
  std::size_t sum = 0;
  for (const Product& product : products_) sum += product.size();
  return sum;
}

std::vector<SolidNode> SolidProducts::nodes() const {
  std::vector<SolidNode> nodes{{SetOperation::unite, 0, 0}};
  const auto add = [&](const Product& product, bool complement) {
    for (const Element& e : product)
      if (e.complement == complement)
        nodes.push_back({SetOperation::operand, e.operand, static_cast<Index>(nodes.size() + 1)});
  };
  for (const Product& product : products_) {
    const std::size_t at = nodes.size();
    nodes.insert(nodes.end(), {{SetOperation::subtract, 0, 0}, {SetOperation::intersect, 0, 0}});
    add(product, false);
    nodes[at + 1].end = static_cast<Index>(nodes.size());
    add(product, true);
    nodes[at].end = static_cast<Index>(nodes.size());
  }
  nodes[0].end = static_cast<Index>(nodes.size());
  return nodes;
}

}  // namespace overstrike
