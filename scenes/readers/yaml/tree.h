#pragma once
// A YAML file as a tree with places: read by yaml-cpp's event parser, bounded in size and depth.
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/readers/source_text.h"

namespace overstrike::yaml {

enum class NodeKind : std::uint8_t { nothing, scalar, list, map };

/// A value. Aliases are further pointers to the value they name, so that walking a tree may meet a
/// node more than once; `expanded` says how often the walk of the whole subtree meets anything.
struct Node {
  NodeKind kind = NodeKind::nothing;
  bool quoted = false;
  int height = 1;            ///< levels of the subtree, with aliases followed
  std::size_t expanded = 1;  ///< nodes of the subtree, with aliases followed
  TextMark mark;
  std::string text;  ///< of a scalar
  /// Of a list its values; of a map key, value, key, value, ... as written, duplicates too.
  std::vector<const Node*> items;

  std::size_t entries() const { return items.size() / 2; }
  const Node& key(std::size_t i) const { return *items[2 * i]; }
  const Node& value(std::size_t i) const { return *items[2 * i + 1]; }
};

/// Deeper nesting than this is refused, so that walks may recurse: a chain of 200 differences is
/// 403 levels, and yaml-cpp itself goes no deeper than 500.
constexpr int kDeepest = 480;
/// More values than this, with aliases followed, are refused: about a gigabyte of nodes.
constexpr std::size_t kMostValues = 4'000'000;

class Tree {
 public:
  /// Reads the one document of `text`. What is wrong is reported, and then there is no root.
  Tree(std::string_view text, Reporter& reporter);
  Tree(const Tree&) = delete;

  /// The document's value, or null if it is empty or wrong.
  const Node* root() const { return root_; }

 private:
  friend class TreeBuilder;
  std::deque<Node> nodes_;
  const Node* root_ = nullptr;
};

/// What was found, for messages: "'abc'", "a list of 3", "a map", "nothing".
std::string describe(const Node& node);

}  // namespace overstrike::yaml
