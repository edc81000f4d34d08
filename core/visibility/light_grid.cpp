#include "core/visibility/light_grid.h"

#include <algorithm>
#include <cmath>

#include "core/visibility/depth.h"

namespace overstrike {

LightFrame::LightFrame(const Vec3& towards_light) : light(towards_light) {
  // Across the axis that the light is farthest from.
  const Vec3 size = glm::abs(light);
  const Vec3 axis = size.x <= size.y && size.x <= size.z ? Vec3(1, 0, 0)
                    : size.y <= size.z                   ? Vec3(0, 1, 0)
                                                         : Vec3(0, 0, 1);
  right = glm::normalize(glm::cross(axis, light));
  up = glm::cross(light, right);
}

std::vector<Vec2> LightFrame::convex_outline(const Canonical& c, const CanonicalFace& face) const {
  std::vector<Vec2> outline;
  for (const Index v : c.loop(face.first_loop)) outline.emplace_back((*this)(c.vertices[v]));
  const std::size_t n = outline.size();
  double area = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = outline[i] - outline[0], b = outline[(i + 1) % n] - outline[0];
    area += a.x * b.y - a.y * b.x;
  }
  if (area < 0) std::reverse(outline.begin(), outline.end());
  double turns = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = outline[(i + 1) % n] - outline[i],
               b = outline[(i + 2) % n] - outline[(i + 1) % n];
    if (a.x * b.y - a.y * b.x <= 0) return {};
    turns += (a.y < 0) != (b.y < 0);
  }
  return turns == 2 ? outline : std::vector<Vec2>{};
}

LightGrid::LightGrid(const Canonical& c, const LightFrame& frame) {
  Vec2 low(1e300), high(-1e300);
  for (Index f = 0; f < c.faces.size(); ++f) {
    const CanonicalFace& face = c.faces[f];
    const int side = side_of_direction(c.planes[face.plane], face.flipped, frame.light);
    if (side == 0 || (side < 0 && c.bodies[face.body].closed)) continue;
    Box box{Vec2(1e300), Vec2(-1e300), -1e300, f};
    for (const Index v : c.loop(face.first_loop)) {
      const Vec3 p = frame(c.vertices[v]);
      box.low = glm::min(box.low, Vec2(p)), box.high = glm::max(box.high, Vec2(p));
      box.highest = std::max(box.highest, p.z);
    }
    low = glm::min(low, box.low), high = glm::max(high, box.high);
    boxes_.push_back(box);
  }
  side_ = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(boxes_.size()))), 1, 1024);
  origin_ = low;
  cell_ = glm::max((high - low) / static_cast<double>(side_), Vec2(1e-300));

  start_.assign(static_cast<std::size_t>(side_) * side_ + 1, 0);
  const auto each = [&](const auto& visit) {
    for (Index i = 0; i < boxes_.size(); ++i)
      for (int r = row(boxes_[i].low.y); r <= row(boxes_[i].high.y); ++r)
        for (int k = column(boxes_[i].low.x); k <= column(boxes_[i].high.x); ++k)
          visit(i, r * side_ + k);
  };
  each([&](Index, int cell) { ++start_[cell + 1]; });
  for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
  items_.resize(start_.back());
  std::vector<Index> at(start_.begin(), start_.end() - 1);
  each([&](Index i, int cell) { items_[at[cell]++] = i; });
  stamp_.assign(boxes_.size(), 0);
}

int LightGrid::column(double x) const {
  return static_cast<int>(std::clamp((x - origin_.x) / cell_.x, 0.0, side_ - 1.0));
}
int LightGrid::row(double y) const {
  return static_cast<int>(std::clamp((y - origin_.y) / cell_.y, 0.0, side_ - 1.0));
}

void LightGrid::over(const Vec2& low, const Vec2& high, double lowest,
                     const std::function<void(Index)>& visit) {
  if (boxes_.empty()) return;
  ++turn_;
  found_.clear();
  for (int r = row(low.y); r <= row(high.y); ++r)
    for (int k = column(low.x); k <= column(high.x); ++k)
      for (Index i = start_[r * side_ + k]; i < start_[r * side_ + k + 1]; ++i) {
        const Index item = items_[i];
        if (stamp_[item] == turn_) continue;
        stamp_[item] = turn_;
        const Box& box = boxes_[item];
        if (box.highest > lowest && box.low.x < high.x && low.x < box.high.x &&
            box.low.y < high.y && low.y < box.high.y)
          found_.push_back(box.face);
      }
  std::sort(found_.begin(), found_.end());
  for (const Index face : found_) visit(face);
}

}  // namespace overstrike
