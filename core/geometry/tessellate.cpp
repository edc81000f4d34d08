#include "core/geometry/tessellate.h"
#include "core/float_environment.h"

#include <algorithm>

#include "core/float_environment.h"
#include "core/geometry/shape_faces.h"

namespace overstrike {
namespace {

template <class... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <class... Functions>  // clang before 17 does not deduce the arguments of aggregates
Overloaded(Functions...)->Overloaded<Functions...>;

constexpr double kMostFacets = 0x1p20;
/// A chord of this part of a shape's size takes more than kMostSides round any circle of the size;
/// from there chords are tried in steps that leave the facets a few in a hundred short of the most.
constexpr double kFinestOfSize = 0x1p-26;
constexpr double kCoarser = 1.0625;

}  // namespace

void drop_lone_planes(Polyhedron& p) {
  std::vector<Index> numbers = p.plane_groups;
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  if (numbers.size() == p.plane_groups.size()) {
    p.plane_groups.clear();
    return;
  }
  for (Index& plane : p.plane_groups)
    plane = static_cast<Index>(std::lower_bound(numbers.begin(), numbers.end(), plane) -
                               numbers.begin());
}

Polyhedron tessellate(const Shape& shape, double chord, bool normals) {
  const FloatEnvironment ours;
  const auto round = [&](const auto& s) { return faces_of(s, chord, normals); };
  return std::visit(Overloaded{[&](const Frustum& s) { return round(s); },
                               [&](const Ellipsoid& s) { return round(s); },
                               [&](const Torus& s) { return round(s); },
                               [&](const Revolution& s) { return round(s); },
                               [&](const Mesh& s) {
                                 Polyhedron p = s.polyhedron;
                                 if (!normals) p.corner_normals.clear();
                                 return p;
                               },
                               [](const auto& s) { return faces_of(s); }},
                    shape);
}

double drawable_chord(const Shape& shape, double chord) {
  const auto drawable = [&](double tried) {
    const auto within = [&](const auto& s) {
      const RoundCounts counts = round_counts(s, tried);
      return counts.fine && static_cast<double>(counts.sides) * counts.rings <= kMostFacets;
    };
    return std::visit(Overloaded{[&](const Frustum& s) { return within(s); },
                                 [&](const Ellipsoid& s) { return within(s); },
                                 [&](const Torus& s) { return within(s); },
                                 [&](const Revolution& s) { return within(s); },
                                 [](const auto&) { return true; }},
                      shape);
  };
  if (!is_curved(shape) || drawable(chord)) return chord;
  const Bounds box = bounds(shape, Affine{});
  const double size = glm::length(box.high - box.low);
  double coarser = size * kFinestOfSize;
  while (coarser < size && !drawable(coarser)) coarser *= kCoarser;
  return std::max(chord, coarser);
}

bool is_curved(const Shape& shape) {
  return std::visit(Overloaded{[](const Frustum& s) { return s.sides == 0; },
                               [](const Ellipsoid& s) { return s.sides == 0 && s.rings == 0; },
                               [](const Torus&) { return true; },
                               [](const Revolution& s) { return s.sides == 0; },
                               [](const auto&) { return false; }},
                    shape);
}

std::string_view shape_name(const Shape& shape) {
  return std::visit(
      Overloaded{
          [](const Box&) { return "box"; },
          [](const Frustum& s) {
            const bool apex = s.bottom_radius == 0 || s.top_radius == 0;
            if (s.bottom_radius == s.top_radius) return s.sides == 0 ? "cylinder" : "prism";
            if (apex) return s.sides == 0 ? "cone" : "pyramid";
            return "frustum";
          },
          [](const Wedge&) { return "wedge"; }, [](const Tetrahedron&) { return "tetrahedron"; },
          [](const Ellipsoid& s) {
            const Vec3& r = s.radii;
            return r.x == r.y && r.y == r.z ? "sphere" : "ellipsoid";
          },
          [](const Torus&) { return "torus"; }, [](const Extrusion&) { return "extrusion"; },
          [](const Revolution&) { return "revolution"; }, [](const Sweep&) { return "sweep"; },
          [](const Mesh& s) { return s.source.empty() ? "polyhedron" : "mesh"; },
          [](const FlatPolygon&) { return "polygon"; }},
      shape);
}

}  // namespace overstrike
