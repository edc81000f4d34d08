#pragma once
// Which shapes stand where: every body's shape, prepared once for all its copies.
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "core/scene/scene.h"
#include "core/visibility/prepare_shape.h"
#include "core/visibility/view.h"

namespace overstrike {

/// For messages: "box 'hall'".
std::string name_of(const Body& body);

struct PlacedShape {
  Index source;    ///< in Scene::bodies
  bool flattened;  ///< by its place: the shape's vertices are placed already
  const PreparedShape* shape;
};

/// The shapes of all bodies that can be drawn, in their order. What is flawed is named in
/// `warnings`; curved shapes are tessellated to `chord_cells` grid units in the view.
class PlacedShapes {
 public:
  PlacedShapes(const Scene& scene, const View& view, double chord_cells,
               std::vector<Diagnostic>& warnings);

  const std::vector<PlacedShape>& all() const { return all_; }
  const Body& body(const PlacedShape& placed) const { return scene_.bodies[placed.source]; }
  /// From the shape's frame, counted from the view's origin.
  Affine placement(const PlacedShape& placed) const;

 private:
  void add(Index source);
  void warn(const Body& body, const std::string& what);
  double chord_of_shape(const Body& body, const Affine& placement);
  const PreparedShape& prepared(const Body& body, const Affine& placement);
  const PreparedShape& flattened(const PreparedShape& shape, const Affine& placement);

  const Scene& scene_;
  const View& view_;
  double chord_cells_;
  std::vector<Diagnostic>& warnings_;
  std::map<std::tuple<const Shape*, double, bool>, std::unique_ptr<PreparedShape>> shapes_;
  std::vector<std::unique_ptr<PreparedShape>> flattened_;
  std::vector<PlacedShape> all_;
};

}  // namespace overstrike
