#pragma once
// A Boolean solid as a sum of products (TK 3.3: segments of positive and negative elements).
//
// The terms of its expression are multiplied out from below. At once dropped are products that
// contain an operand and its complement, products whose positive elements lie apart by their
// bounds, negative elements that lie apart from the product's bounds, and products that contain all
// elements of another, which holds wherever they do (absorption). What is left are the same points,
// and as a tree two terms deep it is followed with TK's counters: `SolidExpression` counts for each
// product the elements that are true, and for the sum the products.
#include <optional>
#include <span>
#include <vector>

#include "core/scene/solid_expression.h"
#include "core/visibility/world_box.h"

namespace overstrike {

class SolidProducts {
 public:
  /// Ten nested differences of operands that are all different have 11 264 elements; eleven would
  /// have 24 576, with counters for every other one of them wherever an operand is entered.
  /// Products are compared with one another, a tenth of a second for so many.
  static constexpr std::size_t kMostElements = std::size_t{1} << 14;

  /// `bounds` has the operands'. Nothing where more than `most` elements are needed, on the way
  /// too.
  static std::optional<SolidProducts> of(const SolidExpression& expression,
                                         std::span<const WorldBox> bounds,
                                         std::size_t most = kMostElements);

  struct Element {
    Index operand;
    bool complement;
    bool operator==(const Element&) const = default;
  };
  using Product = std::vector<Element>;  ///< by operand
  /// Fewest elements first.
  const std::vector<Product>& products() const { return products_; }
  std::size_t elements() const;
  /// As a tree: a union of intersections, less the negative elements.
  std::vector<SolidNode> nodes() const;

 private:
  std::vector<Product> products_;
};

}  // namespace overstrike
