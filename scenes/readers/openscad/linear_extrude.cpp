#include <algorithm>
#include <numbers>

#include "core/geometry/trig.h"
#include "scenes/readers/openscad/extrude.h"
#include "scenes/readers/openscad/regions.h"

namespace overstrike::openscad {
namespace {

/// As core draws heights: a slip of the finger is not a million slices.
constexpr double kMostSlices = 4096;
/// No slice turns by more than this (degrees), or its sides would cross.
constexpr double kMostTwist = 120;
/// Of their mean: diagonals that differ by no more are equally long to OpenSCAD 2021.01, seen from
/// above. Its triangles tell this to one part in a hundred.
constexpr double kEqualDiagonals = 1e-5;

struct Extrude {
  double height;
  double twist;  ///< degrees, clockwise
  Vec2 scale;    ///< at the top
};

double square(double x) { return x * x; }

/// How far the point farthest from the axis travels along its helix.
double helix_length(double radius, const Extrude& e) {
  const double turn = std::fabs(e.twist) * std::numbers::pi / 180;
  return std::sqrt(square(turn * radius) + square(e.height));
}

/// The same on a cone: the arc of Archimedes' spiral from s to t (radians), whose radius is
/// `growth` a radian.
double spiral_length(double growth, double s, double t) {
  const auto length = [&](double x) {
    return 0.5 * growth * (x * std::sqrt(1 + x * x) + std::asinh(x));
  };
  return length(t) - length(s);
}

double conical_length(double radius, const Extrude& e) {
  const double turn = std::fabs(e.twist) * std::numbers::pi / 180, scale = e.scale.x;
  const double end = scale > 1 ? turn * scale / (scale - 1) : turn / (1 - scale);
  return std::hypot(spiral_length(radius / end, end - turn, end), e.height);
}

double twisted_slices(const Arguments& a, const Extrude& e, double path) {
  const double twist = std::fabs(e.twist);
  const double fewest = std::fmax(std::ceil(twist / kMostTwist), 1);
  if (a.fn() > 0) return std::fmax(std::ceil(twist / 360 * a.fn()), fewest);
  return std::fmax(std::fmin(std::ceil(twist / a.fa()), std::ceil(path / a.fs())), fewest);
}

/// Where not told: so many that no step along a corner's path is longer than $fs.
double wanted_slices(const Arguments& a, const Extrude& e, const Region& region) {
  if (a.has("slices")) return std::fmax(std::floor(a.number("slices", 1)), 1);
  double radius = 0, shift = 0;
  for (const auto& loop : region.loops)
    for (const Vec2& p : loop) {
      radius = std::fmax(radius, glm::length(p));
      shift = std::fmax(shift, glm::length(p - p * e.scale));
    }
  const bool uneven = e.scale.x != e.scale.y;
  double slices = 1;
  if (uneven)
    slices = a.fn() > 0 ? std::fmax(std::floor(a.fn()), 1)
                        : std::fmax(std::ceil(std::hypot(shift, e.height) / a.fs()), 1);
  if (e.twist == 0) return slices;
  const bool conical = !uneven && e.scale.x != 1;
  return std::fmax(
      slices, twisted_slices(a, e, conical ? conical_length(radius, e) : helix_length(radius, e)));
}

class SliceBuilder {
 public:
  SliceBuilder(const Extrude& extrude, int slices, OrderedRegion region)
      : extrude_(extrude), slices_(slices), region_(std::move(region)) {
    for (const Loop2& loop : region_.loops) corners_ += static_cast<Index>(loop.size());
  }

  Polyhedron build() {
    for (int level = 0; level <= slices_; ++level) add_level(level);
    add_faces(p_, region_, 0, true);
    for (int slice = 0; slice < slices_; ++slice) add_walls(slice);
    if (extrude_.scale.x > 0 && extrude_.scale.y > 0)
      add_faces(p_, region_, corners_ * static_cast<Index>(slices_), false);
    return std::move(p_);
  }

 private:
  void add_level(int level) {
    const double t = static_cast<double>(level) / slices_;
    const double turn = -extrude_.twist * t;
    const double sine = sin_deg(turn), cosine = cos_deg(turn);
    const Vec2 scale = level == slices_ ? extrude_.scale : Vec2(1.0) + (extrude_.scale - 1.0) * t;
    const double z = level == slices_ ? extrude_.height : extrude_.height * t;
    for (const Loop2& loop : region_.loops)
      for (const Vec2& p : loop)
        p_.add_vertex(
            {scale.x * (cosine * p.x - sine * p.y), scale.y * (sine * p.x + cosine * p.y), z});
  }

  void add_walls(int slice) {
    Index first = corners_ * static_cast<Index>(slice);
    const bool tip = slice == slices_ - 1 && extrude_.scale == Vec2(0.0);
    for (const Loop2& loop : region_.loops) {
      const Index n = static_cast<Index>(loop.size());
      const bool hole = !is_counter_clockwise(loop);
      for (Index i = 0; i < n; ++i) {
        const Index a = first + i, b = first + (i + 1) % n;
        if (tip) {
          p_.add_face({a, b, corners_ * static_cast<Index>(slices_)});
        } else {
          add_wall(a, b, hole, slice);
        }
      }
      first += n;
    }
  }

  /// Between corners a and b and those above; flat when nothing turns them against each other.
  void add_wall(Index a, Index b, bool hole, int slice) {
    const Index c = b + corners_, d = a + corners_;
    if (extrude_.twist == 0 && extrude_.scale.x == extrude_.scale.y)
      return p_.add_face({a, b, c, d});
    const bool edge_above = slice == slices_ - 1 && extrude_.scale.x * extrude_.scale.y == 0;
    if (splits_from_a(a, b, hole) != edge_above) {
      p_.add_face({a, b, c});
      p_.add_face({a, c, d});
    } else {
      p_.add_face({a, b, d});
      p_.add_face({b, c, d});
    }
  }

  /// Along the shorter diagonal, as OpenSCAD 2021.01 does, and where both are equally long, along
  /// the one that the twist goes with, round a hole against it. (Below an edge to which the top is
  /// scaled it takes the other one.)
  bool splits_from_a(Index a, Index b, bool hole) const {
    const double ac = distance_from_above(a, b + corners_);
    const double bd = distance_from_above(b, a + corners_);
    if (std::fabs(ac - bd) <= kEqualDiagonals * (ac + bd) / 2) return (extrude_.twist > 0) != hole;
    return ac < bd;
  }

  double distance_from_above(Index a, Index b) const {
    return glm::distance(Vec2(p_.vertices[a]), Vec2(p_.vertices[b]));
  }

  Extrude extrude_;
  int slices_;
  OrderedRegion region_;
  Index corners_ = 0;
  Polyhedron p_;
};

/// From the straight extrusion to one along v.
Mat3 along(const Vec3& v) {
  Mat3 shear(1.0);
  shear[2] = v / v.z;
  return shear;
}

}  // namespace

std::vector<Part> linear_extrude(const Arguments& a, const Flat& flat) {
  const Vec3 v = a.sizes("v", 3, 0);
  const bool leans = a.has("v") && v.z > 0;
  const double length = a.number("height", 100);
  const Vec3 scale = a.sizes("scale", 2, 1);
  Extrude e{leans ? length * v.z / glm::length(v) : length, a.number("twist", 0),
            glm::max(Vec2(scale), Vec2(0.0))};
  if (!(e.height > 0) || !std::isfinite(e.height) || flat.region.loops.empty()) return {};
  if (!std::isfinite(e.twist)) e.twist = 0;
  const double slices = wanted_slices(a, e, flat.region);
  if (slices > kMostSlices) {
    a.error("too many slices: " + roughly(slices), "at most 4096");
    return {};
  }
  OrderedRegion region = pieces_of(flat.region);
  if (region.pieces.empty()) return {};
  Part part{nullptr, {}, std::fmax(flat.precision, a.precision("height"))};
  if (leans) part.place.linear = along(v);
  if (a.boolean("center", false)) part.place.offset = part.place.linear[2] * (-e.height / 2);
  Mesh mesh{SliceBuilder(e, static_cast<int>(slices), std::move(region)).build(), {}, {}, 0};
  part.shape = std::make_shared<const Shape>(std::move(mesh));
  return {std::move(part)};
}

}  // namespace overstrike::openscad
