#include "tests/fuzz/core/tiny_solids.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/visibility/prepare_shape.h"

namespace overstrike::fuzz {
namespace {

/// The oracle tries all changes in one plane: 2 to the number of operands.
constexpr std::size_t kMostNodes = 12;
constexpr unsigned kDeepest = 3, kMostOperands = 3;

class Planter {
 public:
  Planter(ByteSource& bytes, Scene& scene) : bytes_(bytes), scene_(scene) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
      if (prepare_shape(*scene.bodies[i].shape, 1, false).closed)
        closed_.push_back(static_cast<std::uint32_t>(i));
    taken_.assign(scene.bodies.size(), 0);
  }

  void add() {
    if (closed_.empty()) return;
    Solid solid;
    add_node(solid.nodes, 0);
    scene_.solids.push_back(std::move(solid));
  }

 private:
  void add_node(std::vector<SolidNode>& nodes, unsigned depth) {
    const std::size_t at = nodes.size();
    const unsigned kind = bytes_.byte();
    const bool leaf = depth == kDeepest || nodes.size() >= kMostNodes || (depth > 0 && kind % 2);
    if (leaf) {
      const std::uint32_t body = operand(closed_[kind / 2 % closed_.size()]);
      nodes.push_back({SetOperation::operand, body, static_cast<std::uint32_t>(at + 1)});
      return;
    }
    constexpr SetOperation kOperations[] = {SetOperation::subtract, SetOperation::unite,
                                            SetOperation::intersect};
    nodes.push_back({kOperations[kind / 2 % 3], 0, 0});
    for (unsigned i = 1 + bytes_.below(kMostOperands); i > 0; --i) add_node(nodes, depth + 1);
    nodes[at].end = static_cast<std::uint32_t>(nodes.size());
  }

  /// The body where it is free, else a copy of it.
  std::uint32_t operand(std::uint32_t body) {
    if (std::exchange(taken_[body], 1) == 0) return body;
    scene_.bodies.push_back(Body(scene_.bodies[body]));
    return static_cast<std::uint32_t>(scene_.bodies.size() - 1);
  }

  ByteSource& bytes_;
  Scene& scene_;
  std::vector<std::uint32_t> closed_;
  std::vector<char> taken_;  ///< of the bodies that were there at first
};

/// Appends the node at `at` of `from`.
void append_turned(const std::vector<SolidNode>& from, std::uint32_t at, std::size_t bodies,
                   std::vector<SolidNode>& to) {
  SolidNode node = from[at];
  const std::size_t made = to.size();
  if (node.operation == SetOperation::operand)
    node.body = static_cast<std::uint32_t>(bodies - 1 - node.body);
  to.push_back(node);
  std::vector<std::uint32_t> members;
  if (node.operation != SetOperation::operand)
    for (std::uint32_t i = at + 1; i < node.end; i = from[i].end) members.push_back(i);
  const std::ptrdiff_t kept = node.operation == SetOperation::subtract ? 1 : 0;
  if (!members.empty()) std::reverse(members.begin() + kept, members.end());
  for (const std::uint32_t member : members) append_turned(from, member, bodies, to);
  to[made].end = static_cast<std::uint32_t>(to.size());
}

}  // namespace

void add_solids(ByteSource& bytes, Scene& scene) {
  const unsigned solids = bytes.below(3);
  if (solids == 0) return;
  Planter planter(bytes, scene);
  for (unsigned i = 0; i < solids; ++i) planter.add();
}

Scene in_opposite_order(const Scene& scene) {
  Scene turned = scene;
  std::reverse(turned.bodies.begin(), turned.bodies.end());
  std::reverse(turned.solids.begin(), turned.solids.end());
  for (Solid& solid : turned.solids) {
    std::vector<SolidNode> nodes;
    append_turned(solid.nodes, 0, scene.bodies.size(), nodes);
    solid.nodes = std::move(nodes);
  }
  return turned;
}

}  // namespace overstrike::fuzz
