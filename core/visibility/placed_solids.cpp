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

void refuse_open(const Body& body, const PreparedShape& shape) {
  if (shape.closed) return;
  throw InputError(body.place, name_of(body) +
                                   " is not closed, so that it has no inside to unite, "
                                   "subtract or intersect: " +
                                   open_edges(shape));
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

}  // namespace

std::vector<PlacedShape> with_solids(const Scene& scene, const PlacedShapes& placed,
                                     Canonical& canonical) {
  struct Leaf {
    Index solid = kNone, number = 0;
  };
  std::vector<Leaf> leaf_of(scene.bodies.size());
  std::vector<std::vector<Index>> operand_of(scene.solids.size());
  for (Index s = 0; s < scene.solids.size(); ++s)
    for (const SolidNode& node : scene.solids[s].nodes) {
      if (node.operation != SetOperation::operand) continue;
      leaf_of[node.body] = {s, static_cast<Index>(operand_of[s].size())};
      operand_of[s].push_back(kNone);
    }
  std::vector<PlacedShape> bodies;
  std::vector<Index> operands(scene.solids.size(), 0);
  std::map<std::pair<Index, Key>, Index> known;
  EqualShapes shapes;
  for (const PlacedShape& one : placed.all()) {
    const Leaf& leaf = leaf_of[one.source];
    Membership member{leaf.solid, 0};
    if (leaf.solid != kNone) {
      const Body& body = placed.body(one);
      refuse_open(body, *one.shape);
      const auto [at, is_new] = known.try_emplace(
          {leaf.solid, key_of(one, shapes.first_of(*one.shape), body)}, operands[leaf.solid]);
      operand_of[leaf.solid][leaf.number] = member.operand = at->second;
      if (!is_new) continue;
      ++operands[leaf.solid];
    }
    bodies.push_back(one);
    canonical.memberships.push_back(member);
  }
  for (std::size_t s = 0; s < scene.solids.size(); ++s) {
    std::vector<SolidNode> nodes = scene.solids[s].nodes;
    Index leaf = 0;
    for (SolidNode& node : nodes) {
      if (node.operation != SetOperation::operand) continue;
      Index& operand = operand_of[s][leaf++];
      // What could not be drawn is empty: an operand that is never entered.
      if (operand == kNone) operand = operands[s]++;
      node.body = operand;
    }
    SolidExpression expression(nodes, operands[s]);
    canonical.solids.push_back(
        std::make_shared<const CanonicalSolid>(CanonicalSolid{std::move(nodes),
                                                              std::move(expression),
                                                              scene.solids[s].name,
                                                              scene.solids[s].place,
                                                              scene.solids[s].translucent,
                                                              {}}));
  }
  return bodies;
}

}  // namespace overstrike
