#include <algorithm>

#include "core/geometry/trig.h"
#include "scenes/readers/openscad/extrude.h"
#include "scenes/readers/openscad/regions.h"

namespace overstrike::openscad {
namespace {

class RingBuilder {
 public:
  RingBuilder(double angle_deg, int fragments, OrderedRegion region)
      : angle_deg_(angle_deg), fragments_(fragments), region_(std::move(region)) {}

  Polyhedron build() {
    const int rings = is_full() ? fragments_ : fragments_ + 1;
    for (int ring = 0; ring < rings; ++ring) add_ring(ring);
    for (int ring = 0; ring < fragments_; ++ring) add_band(ring, (ring + 1) % rings);
    if (!is_full()) {
      add_end(0, false);
      add_end(rings - 1, true);
    }
    return std::move(p_);
  }

 private:
  bool is_full() const { return std::fabs(angle_deg_) == 360; }

  /// Corners on the axis are the first ring's in all rings.
  void add_ring(int ring) {
    const double turn = (is_full() ? 180.0 : 0.0) + angle_deg_ * ring / fragments_;
    std::vector<Index>& numbers = numbers_.emplace_back();
    std::size_t corner = 0;
    for (const Loop2& loop : region_.loops)
      for (const Vec2& p : loop) {
        numbers.push_back(p.x == 0 && ring > 0
                              ? numbers_[0][corner]
                              : p_.add_vertex({p.x * cos_deg(turn), p.x * sin_deg(turn), p.y}));
        ++corner;
      }
  }

  void add_band(int ring, int next) {
    const std::vector<Index>& near = numbers_[static_cast<std::size_t>(ring)];
    const std::vector<Index>& far = numbers_[static_cast<std::size_t>(next)];
    std::size_t first = 0;
    for (const Loop2& loop : region_.loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::size_t a = first + i, b = first + (i + 1) % loop.size();
        add_facet({near[a], far[a], far[b], near[b]});
      }
      first += loop.size();
    }
  }

  void add_facet(std::vector<Index> corners) {
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
    if (corners.size() < 3) return;
    p_.add_face(corners);
  }

  void add_end(int ring, bool turned) {
    const std::vector<Index>& numbers = numbers_[static_cast<std::size_t>(ring)];
    Polyhedron flat;
    add_faces(flat, region_, 0, turned);
    for (Index f = 0; f < flat.face_count(); ++f) {
      for (Index l = flat.first_loop(f); l < flat.face_ends[f]; ++l) {
        std::vector<Index> loop;
        for (const Index i : flat.loop(l)) loop.push_back(numbers[i]);
        p_.add_loop(loop);
      }
      p_.end_face();
    }
  }

  double angle_deg_;
  int fragments_;
  OrderedRegion region_;
  std::vector<std::vector<Index>> numbers_;  ///< per ring the vertex of each corner
  Polyhedron p_;
};

void turn_inside_out(Polyhedron& p) {
  for (Index l = 0; l < p.loop_ends.size(); ++l)
    std::reverse(p.indices.begin() + p.first_index(l), p.indices.begin() + p.loop_ends[l]);
}

}  // namespace

std::vector<Part> rotate_extrude(const Arguments& a, const Flat& flat) {
  double low = 0, high = 0;
  for (const auto& loop : flat.region.loops)
    for (const Vec2& p : loop) low = std::fmin(low, p.x), high = std::fmax(high, p.x);
  if (low < 0 && high > 0) {
    a.error("rotate_extrude needs a profile on one side of the axis, found x from " +
            std::to_string(low) + " to " + std::to_string(high));
    return {};
  }
  double angle = a.number("angle", 360);
  if (!std::isfinite(angle) || std::fabs(angle) > 360) angle = 360;
  const double widest = high - low;
  if (widest == 0 || angle == 0) return {};
  const int fragments = std::max(static_cast<int>(a.fragments(widest) * std::fabs(angle) / 360), 1);
  OrderedRegion region = pieces_of(flat.region);
  if (region.pieces.empty()) return {};
  Mesh mesh{RingBuilder(angle, fragments, std::move(region)).build(), {}, {}, 0};
  if ((low < 0) != (angle < 0)) turn_inside_out(mesh.polyhedron);
  Part part{nullptr, {}, flat.precision};
  if (a.has("start")) {
    const double start = a.number("start", 0) - (angle == 360 ? 180 : 0);
    part.place.linear =
        Mat3({cos_deg(start), sin_deg(start), 0}, {sin_deg(-start), cos_deg(start), 0}, {0, 0, 1});
  }
  part.shape = std::make_shared<const Shape>(std::move(mesh));
  return {std::move(part)};
}

}  // namespace overstrike::openscad
