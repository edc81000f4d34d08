#include "core/visibility/placed_solids.h"

#include <array>
#include <charconv>
#include <map>
#include <tuple>

#include "core/visibility/equal_shapes.h"

namespace overstrike {
namespace {

constexpr std::size_t kMostNamed = 4;

/// Six digits each, as files have them.
std::string text_of(const Vec3& p) {
  std::string text = "(";
  for (int i = 0; i < 3; ++i) {
    char digits[32];
    const auto end =
        std::to_chars(digits, digits + sizeof digits, p[i], std::chars_format::general, 6);
    text.append(digits, end.ptr) += i < 2 ? ", " : ")";
  }
  return text;
}

/// Where it is open, by the ends of edges that have one face.
std::string open_edges(const PreparedShape& shape) {
  std::string text;
  std::size_t open = 0;
  for (const EdgePair& e : shape.edges) {
    if (e.right != kNoFace || ++open > kMostNamed) continue;
    const std::vector<Vec3>& at = shape.polyhedron.vertices;
    text += (open > 1 ? ", " : "") + text_of(at[e.from]) + " to " + text_of(at[e.to]);
  }
  if (open == 0) return "faces of it cross themselves";
  if (open > kMostNamed) text += ", ...";
  return std::to_string(open) + (open > 1 ? " of its edges have" : " of its edges has") +
         " one face only: " + text;
}

std::string fault_of(const Body& body, const PreparedShape& shape) {
  return name_of(body) +
         " is not closed, so that it has no inside to unite, subtract or intersect: " +
         open_edges(shape);
}

/// What makes two operands the same set, drawn the same.
using Key = std::tuple<const PreparedShape*, bool, std::array<double, 12>, double, Shading, int>;
Key key_of(const PlacedShape& placed, const PreparedShape* shape, const Body& body) {
  const Affine& a = body.placement;
  std::array<double, 12> place;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) place[static_cast<std::size_t>(3 * i + j)] = a.linear[i][j];
  for (int j = 0; j < 3; ++j) place[static_cast<std::size_t>(9 + j)] = a.offset[j];
  return {shape, placed.flattened, place, body.density_factor, body.shading, body.pen};
}

/// Numbers the operands of all solids.
class Operands {
 public:
  Operands(const Scene& scene, std::vector<Diagnostic>& warnings)
      : scene_(scene),
        warnings_(warnings),
        leaf_of_(scene.bodies.size()),
        operand_of_(scene.solids.size()),
        count_(scene.solids.size(), 0) {
    for (Index s = 0; s < scene.solids.size(); ++s)
      for (const SolidNode& node : scene.solids[s].nodes) {
        if (node.operation != SetOperation::operand) continue;
        leaf_of_[node.body] = {s, static_cast<Index>(operand_of_[s].size())};
        operand_of_[s].push_back(kNone);
      }
  }

  /// What the body is a member of, where it is one to be drawn.
  std::optional<Membership> add(const PlacedShape& one, const Body& body) {
    const Leaf& leaf = leaf_of_[one.source];
    if (leaf.solid == kNone) return Membership{};
    if (!one.shape->closed && !is_left_out(leaf.solid, body, *one.shape))
      throw InputError(body.place, fault_of(body, *one.shape));
    if (!one.shape->closed) return std::nullopt;
    const auto [at, is_new] = known_.try_emplace(
        {leaf.solid, key_of(one, shapes_.first_of(*one.shape), body)}, count_[leaf.solid]);
    operand_of_[leaf.solid][leaf.number] = at->second;
    if (!is_new) return std::nullopt;
    return Membership{leaf.solid, count_[leaf.solid]++};
  }

  CanonicalSolid solid(Index s) {
    const Solid& given = scene_.solids[s];
    std::vector<SolidNode> nodes = given.nodes;
    Index leaf = 0;
    for (SolidNode& node : nodes) {
      if (node.operation != SetOperation::operand) continue;
      Index& operand = operand_of_[s][leaf++];
      // What could not be drawn is empty: an operand that is never entered.
      if (operand == kNone) operand = count_[s]++;
      node.body = operand;
    }
    std::optional<UncutSolid> whole;
    if (given.background) {
      SolidExpression expression(nodes, count_[s]);
      whole = UncutSolid{std::move(nodes), std::move(expression)};
      nodes = {{SetOperation::unite, 0, 1}};
    }
    SolidExpression expression(nodes, count_[s]);
    return {std::move(nodes),  std::move(expression), given.name,      given.place,
            given.translucent, std::move(whole),      given.background};
  }

 private:
  struct Leaf {
    Index solid = kNone, number = 0;
  };

  bool is_left_out(Index solid, const Body& body, const PreparedShape& shape) {
    if (!scene_.solids[solid].background) return false;
    warnings_.push_back(
        {Severity::warning, body.place, fault_of(body, shape) + ": not drawn", {}, {}});
    return true;
  }

  const Scene& scene_;
  std::vector<Diagnostic>& warnings_;
  std::vector<Leaf> leaf_of_;                   ///< per body
  std::vector<std::vector<Index>> operand_of_;  ///< per solid and leaf
  std::vector<Index> count_;                    ///< per solid
  std::map<std::pair<Index, Key>, Index> known_;
  EqualShapes shapes_;
};

}  // namespace

std::vector<PlacedShape> with_solids(const Scene& scene, const PlacedShapes& placed,
                                     Canonical& canonical, std::vector<Diagnostic>& warnings) {
  Operands operands(scene, warnings);
  std::vector<PlacedShape> bodies;
  for (const PlacedShape& one : placed.all()) {
    const std::optional<Membership> member = operands.add(one, placed.body(one));
    if (!member) continue;
    bodies.push_back(one);
    canonical.memberships.push_back(*member);
  }
  for (Index s = 0; s < scene.solids.size(); ++s)
    canonical.solids.push_back(std::make_shared<const CanonicalSolid>(operands.solid(s)));
  return bodies;
}

}  // namespace overstrike
