#include "scenes/readers/openscad/bodies.h"

#include <algorithm>
#include <cmath>

#include "scenes/readers/openscad/regions.h"
#include "scenes/readers/openscad/solid_tree.h"

namespace overstrike::openscad {
namespace {

/// A colour less saturated than this is grey to a pen.
constexpr double kGrey = 0.15;

/// Facets of a prism that turn by less than this stand for something round, as those of meshes do.
constexpr int kRoundSides = 13;  // 360 / 13 < 30 degrees

Shading shading_of(const Shape& shape) {
  const Frustum* const frustum = std::get_if<Frustum>(&shape);
  if (frustum != nullptr) return frustum->sides >= kRoundSides ? Shading::smooth : Shading::flat;
  return std::holds_alternative<Mesh>(shape) ? Shading::smooth : Shading::flat;
}

/// What is marked by % and has no colour is grey in OpenSCAD's preview (180 of 255), and all of it
/// half transparent.
constexpr double kBackgroundGrey = 180.0 / 255, kBackgroundFactor = 0.5;

class BodyAdder {
 public:
  BodyAdder(const Tree& tree, const Nodes& nodes, const std::vector<NodeShape>& shapes,
            const Reporter& reporter, Scene& scene)
      : tree_(tree), nodes_(nodes), shapes_(shapes), reporter_(reporter), scene_(scene) {}

  void add() {
    const Index end = tree_.nodes[tree_.root].end;
    for (Index i = tree_.root; i < end;) {
      const NodeState& state = nodes_.states[i];
      const bool structure = state.drawn && state.word->role == WordRole::structure;
      if (is_filled(i) && structure && unites(*state.word)) {
        ++i;
        continue;
      }
      if (is_filled(i)) add_loose(i, structure);
      i = tree_.nodes[i].end;
    }
  }

  void add_backgrounds() {
    factor_ = density_of(Vec3(kBackgroundGrey));
    for (const Background& background : nodes_.backgrounds) {
      if (!shapes_[background.node].filled) continue;
      Solid& solid = add_solid(background.node);
      solid.background = true;
      solid.translucent = kBackgroundFactor;
    }
  }

 private:
  bool is_filled(Index i) const { return nodes_.states[i].drawn && shapes_[i].filled; }

  void add_loose(Index i, bool structure) {
    if (nodes_.states[i].dimension == 2) {
      add_flat(i);
    } else if (structure) {
      add_solid(i);
    } else {
      for (const Part& part : shapes_[i].parts) add_part(i, part);
    }
  }

  Body body_of(Index i) const {
    const NodeState& state = nodes_.states[i];
    Body body;
    body.place = reporter_.place(tree_.nodes[i].at);
    body.density_factor = factor_;
    if (state.color) {
      body.density_factor = density_of(*state.color);
      body.pen = pen_of(*state.color);
    }
    return body;
  }

  Index add_part(Index i, const Part& part) {
    const Placement& place = nodes_.states[i].place;
    Body body = body_of(i);
    body.shape = part.shape;
    body.placement = place.affine * part.place;
    body.precision = placed_precision(part, place);
    body.shading = shading_of(*part.shape);
    scene_.bodies.push_back(std::move(body));
    return static_cast<Index>(scene_.bodies.size() - 1);
  }

  void add_flat(Index i) {
    const OrderedRegion region = pieces_of(shapes_[i].flat.region);
    for (const Piece& piece : region.pieces) {
      FlatPolygon polygon;
      const auto add_loop = [&](std::size_t number) {
        std::vector<Vec3>& loop = polygon.loops.emplace_back();
        for (const Vec2& p : region.loops[number]) loop.emplace_back(p, 0.0);
      };
      add_loop(piece.outline);
      for (const std::size_t hole : piece.holes) add_loop(hole);
      Body body = body_of(i);
      body.precision = shapes_[i].flat.precision;
      body.shape = std::make_shared<const Shape>(std::move(polygon));
      scene_.bodies.push_back(std::move(body));
    }
  }

  Solid& add_solid(Index root) {
    Solid& solid = scene_.solids.emplace_back();
    solid.place = reporter_.place(tree_.nodes[root].at);
    solid.nodes = solid_tree(tree_, nodes_, shapes_, root,
                             [this](Index i, const Part& part) { return add_part(i, part); });
    return solid;
  }

  const Tree& tree_;
  const Nodes& nodes_;
  const std::vector<NodeShape>& shapes_;
  const Reporter& reporter_;
  Scene& scene_;
  double factor_ = 1;  ///< of what has no colour
};

}  // namespace

double density_of(const Vec3& color) {
  const double luma = 0.2126 * color.x + 0.7152 * color.y + 0.0722 * color.z;
  return 1 - 0.75 * luma;
}

int pen_of(const Vec3& color) {
  const double high = std::max({color.x, color.y, color.z});
  const double low = std::min({color.x, color.y, color.z});
  const double range = high - low;
  if (range <= kGrey * high) return 1;
  if (color.x == high) {
    const double hue = (color.y - color.z) / range;  // in sectors of 60 degrees, -1 to 1
    return hue > 0.5 ? 3 : hue < -0.5 ? 6 : 2;
  }
  if (color.y == high) {
    const double hue = (color.z - color.x) / range;
    return hue > 0.5 ? 5 : hue < -0.5 ? 3 : 4;
  }
  return (color.x - color.y) / range > 0.5 ? 6 : 5;
}

void add_bodies(const Tree& tree, const Nodes& nodes, const std::vector<NodeShape>& shapes,
                const Reporter& reporter, Scene& scene) {
  BodyAdder(tree, nodes, shapes, reporter, scene).add();
}

void add_backgrounds(const Tree& tree, const Nodes& nodes, const std::vector<NodeShape>& shapes,
                     const Reporter& reporter, Scene& scene) {
  BodyAdder(tree, nodes, shapes, reporter, scene).add_backgrounds();
}

}  // namespace overstrike::openscad
