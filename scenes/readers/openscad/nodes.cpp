#include "scenes/readers/openscad/nodes.h"

#include <algorithm>

#include "scenes/readers/nearest.h"

namespace overstrike::openscad {
namespace {

/// Flat formats of `import`.
bool is_flat_file(std::string name) {
  for (char& c : name)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return name.ends_with(".dxf") || name.ends_with(".svg");
}

/// Of a placement what it does to the plane z = 0.
Affine in_plane(const Affine& a) {
  Affine flat;
  for (int c = 0; c < 2; ++c)
    for (int r = 0; r < 2; ++r) flat.linear[c][r] = a.linear[c][r];
  flat.offset = Vec3(a.offset.x, a.offset.y, 0);
  return flat;
}

bool is_finite(const Affine& a) {
  const Vec3 sum = a.linear[0] + a.linear[1] + a.linear[2] + a.offset;
  return std::isfinite(sum.x) && std::isfinite(sum.y) && std::isfinite(sum.z);
}

class Resolver {
 public:
  Resolver(const Tree& tree, Reporter& reporter) : tree_(tree), reporter_(reporter) {
    nodes_.states.resize(tree.nodes.size());
  }

  Nodes resolve() {
    find_words(tree_.root, kNoNode);
    find_places();
    return std::move(nodes_);
  }

  /// With the states of the nodes above.
  Nodes resolve_backgrounds(const Nodes& above) {
    nodes_.states = above.states;
    nodes_.backgrounds = above.backgrounds;
    // What is found in a background comes behind it.
    for (std::size_t i = 0; i < nodes_.backgrounds.size(); ++i) {
      const Background one = nodes_.backgrounds[i];
      find_words(one.node, one.parent);
      is_background_.push_back(one.node);
    }
    std::sort(is_background_.begin(), is_background_.end());
    find_places();
    std::erase_if(nodes_.backgrounds, [&](const Background& b) { return !state(b.node).drawn; });
    for (const Background& b : nodes_.backgrounds) state(b.node).drawn = false;
    return std::move(nodes_);
  }

 private:
  NodeState& state(Index i) { return nodes_.states[i]; }

  bool is_background(Index i) const {
    return std::binary_search(is_background_.begin(), is_background_.end(), i);
  }

  void find_places() {
    for (auto i = nodes_.order.rbegin(); i != nodes_.order.rend(); ++i) find_dimension(*i);
    drop_other_dimensions();
    for (const Index i : nodes_.order) place(i);
  }

  void find_words(Index root, Index parent) {
    std::vector<Index> above;
    const Index end = tree_.nodes[root].end;
    for (Index i = root; i < end;) {
      while (!above.empty() && tree_.nodes[above.back()].end <= i) above.pop_back();
      const Node& node = tree_.nodes[i];
      if (i != root && node.background && !node.disabled)
        nodes_.backgrounds.push_back({i, above.back()});
      if (i != root && (node.background || node.disabled)) {
        i = node.end;
        continue;
      }
      state(i).word = find_word(node.name);
      if (state(i).word == nullptr || state(i).word->kind == WordKind::refused) {
        refuse(node, state(i).word);
        i = node.end;
        continue;
      }
      NodeState& s = state(i);
      s.drawn = true;
      s.parent = above.empty() ? parent : above.back();
      if (s.parent != kNoNode)
        s.in_consumer =
            state(s.parent).in_consumer || state(s.parent).word->role == WordRole::consumer;
      nodes_.order.push_back(i);
      above.push_back(i);
      ++i;
    }
  }

  void refuse(const Node& node, const Word* word) {
    if (reporter_.full()) return reporter_.error(node.at, "not drawn");
    if (word != nullptr) {
      reporter_.error(node.at,
                      in_quotes(node.name) + " cannot be drawn: " + std::string(word->refusal));
    } else if (is_program_word(node.name)) {
      reporter_.error(node.at, in_quotes(node.name) + " belongs to a program, not to a .csg file",
                      "name the file .scad, and OpenSCAD is asked what it makes");
    } else {
      reporter_.error(node.at, "unknown node " + in_quotes(node.name),
                      did_you_mean(node.name, word_names()));
    }
  }

  /// A node's dimension is its first child's that has one: children come later in the order, and
  /// the first writes last.
  void find_dimension(Index i) {
    NodeState& s = state(i);
    if (s.word->dimension != 0) s.dimension = s.word->dimension;
    if (s.word->kind == WordKind::import) {
      const Arguments arguments(tree_, i, *s.word, reporter_);
      s.dimension = is_flat_file(arguments.text("file", "")) ? 2 : 3;
    }
    if (s.parent != kNoNode && !is_background(i) && s.dimension != 0 &&
        state(s.parent).word->dimension == 0)
      state(s.parent).dimension = s.dimension;
  }

  void drop_other_dimensions() {
    std::vector<Index> kept;
    for (const Index i : nodes_.order) {
      NodeState& s = state(i);
      if (is_background(i)) {
        drop_unseen_background(i);
      } else if (s.parent != kNoNode) {
        s.drawn = state(s.parent).drawn;
        const int wanted = inner_dimension(state(s.parent));
        if (s.drawn && s.dimension != 0 && s.dimension != wanted) {
          s.drawn = false;
          s.misfit = true;
          reporter_.warning(tree_.nodes[i].at,
                            std::string(s.dimension == 2 ? "a flat shape" : "a solid") + " among " +
                                (wanted == 2 ? "flat shapes" : "solids") + " is left out");
        }
      }
      if (s.drawn) kept.push_back(i);
    }
    nodes_.order = std::move(kept);
  }

  void drop_unseen_background(Index i) {
    NodeState& s = state(i);
    const bool has_place = s.parent == kNoNode || state(s.parent).drawn;
    s.drawn = s.dimension == 3 && !s.in_consumer && has_place;
    if (s.drawn || s.dimension == 0 || !has_place) return;
    reporter_.warning(tree_.nodes[i].at,
                      in_quotes("%" + tree_.nodes[i].name) + " is left out: " +
                          (s.in_consumer ? "it is no part of the shape that is made here"
                                         : "a flat background is not drawn"));
  }

  static int inner_dimension(const NodeState& parent) {
    const WordKind kind = parent.word->kind;
    if (kind == WordKind::linear_extrude || kind == WordKind::rotate_extrude) return 2;
    return kind == WordKind::projection ? 3 : parent.dimension;
  }

  void place(Index i) {
    NodeState& s = state(i);
    s.loose = true;
    if (s.parent != kNoNode) {
      const NodeState& above = state(s.parent);
      const bool structure = above.word->role == WordRole::structure;
      s.loose = structure && above.loose && unites(*above.word);
      s.color = above.color;
      if (structure) s.place = above.place;
    }
    const Arguments arguments(tree_, i, *s.word, reporter_);
    if (s.word->kind == WordKind::place) {
      std::optional<Placement> own = arguments.matrix();
      if (!own) return;
      if (s.dimension == 2)
        own->affine = in_plane(own->affine), own->error = in_plane_error(own->error);
      s.place = s.place * *own;
      if (!is_finite(s.place.affine)) arguments.error("the place is not finite");
    } else if (s.word->kind == WordKind::tint && !s.color) {
      const Vec4 color = arguments.color();
      if (color.x >= 0) s.color = glm::clamp(Vec3(color), Vec3(0.0), Vec3(1.0));
    }
  }

  static Affine in_plane_error(const Affine& a) {
    Affine flat = in_plane(a);
    flat.linear[2] = Vec3(0.0);
    return flat;
  }

  const Tree& tree_;
  Reporter& reporter_;
  Nodes nodes_;
  std::vector<Index> is_background_;  ///< sorted
};

}  // namespace

SetOperation operation_of(const Word& word) {
  return word.kind == WordKind::subtract    ? SetOperation::subtract
         : word.kind == WordKind::intersect ? SetOperation::intersect
                                            : SetOperation::unite;
}

bool unites(const Word& word) { return operation_of(word) == SetOperation::unite; }

Nodes resolve(const Tree& tree, Reporter& reporter) { return Resolver(tree, reporter).resolve(); }

Nodes resolve_backgrounds(const Tree& tree, const Nodes& nodes, Reporter& reporter) {
  return Resolver(tree, reporter).resolve_backgrounds(nodes);
}

}  // namespace overstrike::openscad
