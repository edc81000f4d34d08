#include "core/geometry/revolve.h"

#include <algorithm>

#include "core/geometry/circle.h"

namespace overstrike {
namespace {

class Revolver {
 public:
  Revolver(const ProfileChain& chain, int facets, double angle_deg, bool normals)
      : chain_(chain),
        facets_(facets),
        angle_deg_(angle_deg),
        full_(angle_deg == 360),
        normals_(normals) {
    for (int k = 0; k <= facets; ++k) directions_.push_back(part_of_turn(k, facets, angle_deg));
    for (const ProfileEdge& edge : chain.edges) lines_ = std::max(lines_, edge.line + 1);
    std::vector<bool> has_corner(chain.points.size(), !full_);
    for (const ProfileEdge& edge : chain.edges)
      if (!edge.flat && !(on_axis(edge.from) && on_axis(edge.to)))
        has_corner[edge.from] = has_corner[edge.to] = true;
    for (Index i = 0; i < chain.points.size(); ++i) add_ring(chain.points[i], has_corner[i]);
  }

  Polyhedron run() {
    for (const ProfileEdge& edge : chain_.edges) {
      if (on_axis(edge.from) && on_axis(edge.to)) continue;
      if (edge.flat)
        add_flat(edge);
      else
        for (int k = 0; k < facets_; ++k) add_facet(edge, k);
    }
    if (!full_) add_ends();
    number_planes();
    return std::move(out_);
  }

 private:
  bool on_axis(Index point) const { return chain_.points[point].x == 0; }

  /// The middle of a full disc is no corner of it.
  void add_ring(const Vec2& point, bool has_corner) {
    starts_.push_back(static_cast<Index>(out_.vertices.size()));
    if (point.x == 0) {
      if (has_corner) out_.add_vertex({0, 0, point.y});
      return;
    }
    const int count = full_ ? facets_ : facets_ + 1;
    for (int k = 0; k < count; ++k)
      out_.add_vertex({point.x * directions_[k].x, point.x * directions_[k].y, point.y});
  }

  Index vertex(Index point, int k) const {
    if (on_axis(point)) return starts_[point];
    return starts_[point] + static_cast<Index>(full_ ? k % facets_ : k);
  }

  void add_normal(const Vec2& normal, const Vec2& direction) {
    if (!normals_) return;
    out_.corner_normals.push_back(
        glm::normalize(Vec3{normal.x * direction.x, normal.x * direction.y, normal.y}));
  }

  void end_face(Index plane) {
    out_.end_face();
    out_.plane_groups.push_back(plane);
  }

  /// Between directions k and k + 1: four corners, or three where the edge meets the axis. An
  /// apex has no normal of its own: it takes that of the middle of each facet.
  void add_facet(const ProfileEdge& edge, int k) {
    std::vector<Index> corners;
    const auto add = [&](Index point, int side, const Vec2& normal) {
      corners.push_back(vertex(point, side));
      if (!normals_) return;
      add_normal(normal, on_axis(point) ? part_of_turn(2 * k + 1, 2 * facets_, angle_deg_)
                                        : directions_[side]);
    };
    add(edge.from, k, edge.normal_from);
    if (!on_axis(edge.from)) add(edge.from, k + 1, edge.normal_from);
    add(edge.to, k + 1, edge.normal_to);
    if (!on_axis(edge.to)) add(edge.to, k, edge.normal_to);
    out_.add_loop(corners);
    const bool level = chain_.points[edge.from].y == chain_.points[edge.to].y;
    end_face(level ? edge.line
                   : lines_ + edge.line * static_cast<Index>(facets_) + static_cast<Index>(k));
  }

  std::vector<Index> arc(Index point, bool backwards) const {
    std::vector<Index> corners;
    const int count = on_axis(point) ? 1 : full_ ? facets_ : facets_ + 1;
    for (int k = 0; k < count; ++k) corners.push_back(vertex(point, k));
    if (backwards) std::reverse(corners.begin(), corners.end());
    return corners;
  }

  /// A disc, a ring, or a sector of one.
  void add_flat(const ProfileEdge& edge) {
    std::vector<std::vector<Index>> loops{arc(edge.from, false), arc(edge.to, true)};
    if (full_) {
      if (chain_.points[edge.from].x < chain_.points[edge.to].x) std::swap(loops[0], loops[1]);
      if (on_axis(edge.from) || on_axis(edge.to)) loops.pop_back();
    } else {
      loops[0].insert(loops[0].end(), loops[1].begin(), loops[1].end());
      loops.pop_back();
    }
    for (const std::vector<Index>& loop : loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) add_normal(edge.normal_from, {1, 0});
      out_.add_loop(loop);
    }
    end_face(edge.line);
  }

  void add_ends() {
    std::vector<Index> all(chain_.points.size());
    for (Index i = 0; i < all.size(); ++i) all[i] = i;
    if (chain_.ends.empty()) return add_ends({all});
    for (const std::vector<std::vector<Index>>& end : chain_.ends) add_ends(end);
  }

  void add_ends(const std::vector<std::vector<Index>>& loops) {
    const Index plane = lines_ * static_cast<Index>(facets_ + 1);
    add_end(loops, 0, {0, -1, 0}, plane);
    const Vec2 last = directions_.back();
    add_end(loops, facets_, {-last.y, last.x, 0}, angle_deg_ == 180 ? plane : plane + 1);
  }

  /// Seen from outside, the last one runs backwards.
  void add_end(const std::vector<std::vector<Index>>& loops, int k, const Vec3& normal,
               Index plane) {
    for (const std::vector<Index>& loop : loops) {
      std::vector<Index> corners;
      for (const Index point : loop) corners.push_back(vertex(point, k));
      if (k != 0) std::reverse(corners.begin(), corners.end());
      if (normals_) out_.corner_normals.insert(out_.corner_normals.end(), corners.size(), normal);
      out_.add_loop(corners);
    }
    end_face(plane);
  }

  /// Plane numbers from 0, or none where no two faces share one.
  void number_planes() {
    std::vector<Index> numbers(lines_ * static_cast<std::size_t>(facets_ + 1) + 2, kUnnumbered);
    Index count = 0;
    for (Index& plane : out_.plane_groups) {
      if (numbers[plane] == kUnnumbered) numbers[plane] = count++;
      plane = numbers[plane];
    }
    if (count == out_.plane_groups.size()) out_.plane_groups.clear();
  }

  static constexpr Index kUnnumbered = 0xFFFFFFFFu;
  const ProfileChain& chain_;
  const int facets_;
  const double angle_deg_;
  const bool full_, normals_;
  Index lines_ = 0;
  std::vector<Vec2> directions_;
  std::vector<Index> starts_;
  Polyhedron out_;
};

}  // namespace

Polyhedron revolve(const ProfileChain& chain, int facets, double angle_deg, bool normals) {
  return Revolver(chain, facets, angle_deg, normals).run();
}

}  // namespace overstrike
