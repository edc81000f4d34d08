#include "core/visibility/face_index.h"

#include <algorithm>

namespace overstrike {
namespace {

std::size_t count_seen(const ProjectedScene& scene) {
  std::size_t count = 0;
  for (Index f = 0; f < scene.canonical.faces.size(); ++f) count += scene.seen(f);
  return count;
}

/// Of all loops: a face that was clipped may be in several parts, or name a hole first.
FaceBox box_of(const ProjectedScene& scene, Index face) {
  const CanonicalFace& f = scene.canonical.faces[face];
  FaceBox box{Vec2(1e300), Vec2(-1e300), 1e300, -1e300, face};
  for (Index l = f.first_loop; l < f.end_loop; ++l)
    for (const Index v : scene.canonical.loop(l)) {
      const GridPoint& p = scene.points[v];
      box.low = glm::min(box.low, p.xy() - p.error),
      box.high = glm::max(box.high, p.xy() + p.error);
      box.far = std::min(box.far, p.at.z - p.depth_error);
      box.near = std::max(box.near, p.at.z + p.depth_error);
    }
  return box;
}

}  // namespace

FaceIndex::FaceIndex(const ProjectedScene& scene)
    : grid_(scene.view.grid.columns, scene.view.grid.rows, count_seen(scene)) {
  const Grid& page = scene.view.grid;
  for (Index f = 0; f < scene.canonical.faces.size(); ++f) {
    if (!scene.seen(f)) continue;
    const FaceBox box = box_of(scene, f);
    if (box.high.x >= 0 && box.high.y >= 0 && box.low.x <= page.columns && box.low.y <= page.rows)
      boxes_.push_back(box);
  }
  std::sort(boxes_.begin(), boxes_.end(), [](const FaceBox& a, const FaceBox& b) {
    return a.near != b.near ? a.near > b.near : a.face < b.face;
  });
  fill();
}

/// Boxes go in nearest first, so that every cell's list is in that order.
void FaceIndex::fill() {
  start_.assign(grid_.size() + 1, 0);
  const auto each = [&](const auto& visit) {
    for (Index i = 0; i < boxes_.size(); ++i)
      grid_.in_box(boxes_[i].low, boxes_[i].high, [&](std::size_t cell) { visit(i, cell); });
  };
  each([&](Index, std::size_t cell) { ++start_[cell + 1]; });
  for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
  items_.resize(start_.back());
  std::vector<Index> at(start_.begin(), start_.end() - 1);
  each([&](Index i, std::size_t cell) { items_[at[cell]++] = i; });
}

}  // namespace overstrike
