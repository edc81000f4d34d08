#pragma once
// The faces of solids' operands over one receiver, along the light: the lines along which the
// shadow of a solid may end there, and where along a line there is shadow.
//
// What a solid is along the light changes where a face begins or ends, and where two faces exchange
// their order. So its shadow may end along the sides of its operands' faces (OperandEdge), and
// along the lines on the receiver over which two faces are equally high (cast_order.h).
#include <array>
#include <vector>

#include "core/visibility/cast_order.h"
#include "core/visibility/cell_grid.h"
#include "core/visibility/shadows.h"
#include "core/visibility/sight_line.h"
#include "core/visibility/solid_sight.h"

namespace overstrike {

/// A line on a receiver along which shadow may end.
struct CastLine {
  LineEnd a, b;
  /// Planes of faces that are equally high over it by construction; kNoPlanes: of none.
  std::array<Index, 2> crossed = kNoPlanes;
  std::array<double, 2> crossed_at = {};  ///< their heights at the ends
};

class SolidsOver {
 public:
  /// `eye` is of the scene's view, `receiver` the plane on which the shadow lies. All must outlive
  /// this.
  SolidsOver(const ProjectedScene& scene, const DepthMap& eye, const Canonical& casting,
             const Plane& receiver, const Shadow& shadow);

  /// Sides of faces first, then crossings.
  std::vector<CastLine> lines();
  /// Adds the parts of the line that lie in a solid's shadow on its right (0) and left (1) side;
  /// `sliver` as in SolidSight.
  void add_shadowed(const CastLine& line, double sliver, std::array<Intervals, 2>& parts);

 private:
  struct Edge {
    LineEnd a, b;
  };
  /// A face, its borders over the receiver (edges_[members_[first .. end)]) and where they lie.
  struct Over {
    Index face, solid;
    std::size_t first, end;
    Vec2 low{1e300}, high{-1e300};
    double facing = 0;  ///< |n . L|
  };
  /// A point of a face's border over which another face is as high.
  struct Piercing {
    double along;
    Vec3 at;
    double error;  ///< in the grid
  };
  LineEnd end_at(const Vec3& p, double along_light) const;
  void gather(const Shadow& shadow);
  void put_into_cells();
  static bool meet(const Over& over, const Vec2& low, const Vec2& high);
  /// In a search that began with ++turn_.
  bool first_time(Index face);
  const Plane& plane_of(const Over& over) const {
    return casting_.planes[casting_.faces[over.face].plane];
  }
  bool may_cross(const Over& f, const Over& g) const;
  void cross(const Over& f, const Over& g, std::vector<CastLine>& lines);
  void pierce(const Over& border, const Over& f, const Over& g,
              std::vector<Piercing>& result) const;
  double lead_over(const LineEnd& end, const Over& f, const Over& g) const;
  Lead lead(const LineEnd& end, const Over& over) const;
  void add_face(const CastLine& line, const Ruler& ruler, const Over& over);
  void pass_over(const Ruler& ruler, const Over& over, Passage& passage);

  const Canonical& casting_;
  const View& view_;
  std::vector<Edge> edges_;
  std::vector<std::size_t> members_;
  std::vector<Over> faces_;  ///< by face
  CastOrder order_;
  DepthPlane unit_;  ///< the height over the receiver of what is one unit of the world above it
  CellGrid cells_;
  std::vector<Index> start_, items_;  ///< of the cells
  std::vector<std::uint32_t> stamps_;
  std::uint32_t turn_ = 0;
  SolidSight sight_;
  std::vector<SolidSight::Part> shown_;
  std::vector<double> crossings_[2];
  std::vector<Piercing> ours_, theirs_;
};

}  // namespace overstrike
