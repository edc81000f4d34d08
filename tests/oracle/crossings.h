#pragma once
// How well a crossing of a scan line is conditioned: by how much its place along the line moves, in
// grid units, when what crosses there moves by one.
//
//  - An edge's image (of a face, of a shadow on its receiver, of a cut): 1 / |sin| of the angle
//    between the image and the scan line.
//  - A shadow's boundary also 1 / |n.L|: light that grazes the receiver draws the shadow out.
//  - Two planes that cross in depth: (|grad z_a| + |grad z_b|) / |d(z_a - z_b)/ds|, for a depth
//  that
//    is off by one grid unit's worth of slope moves the crossing by that much.
#include <vector>

#include "core/visibility/canonical.h"
#include "core/visibility/view.h"
#include "tests/oracle/oracle.h"

namespace overstrike::oracle {

/// A scan line: the points origin + s * direction of the grid; the direction is of unit length.
struct Line {
  Vec2 origin, direction;
  Vec2 at(double s) const { return origin + s * direction; }
};

class Crossings {
 public:
  Crossings(const Canonical& canonical, const View& view);

  /// The condition numbers of everything that may cross the line at `s` where `left` gives way to
  /// `right`, ascending. Empty: nothing does.
  std::vector<double> conditions(const Line& line, double s, const Seen& left,
                                 const Seen& right) const;

  /// True when something that may part `left` from `right` crosses the line within `error` grid
  /// units of `s`, times its condition number.
  bool may_be_off(const Line& line, double s, const Seen& left, const Seen& right,
                  double error) const;

  /// A place on a line where something may change, and its condition number.
  struct Place {
    double s, condition;
  };
  /// Every place on the line where an edge of the scene crosses it, or what may change on the plane
  /// of `seen`: shadows and other planes. Ascending.
  std::vector<Place> places(const Line& line, const Seen& seen) const;

 private:
  struct Search;
  Vec3 image(const Vec3& p) const;
  Vec4 image(const Plane& plane) const;
  void edges(Search& search) const;
  void shadow_edges(Search& search, const Plane& receiver) const;
  void depths(Search& search, const Plane& with) const;
  Plane plane_of(const Seen& seen) const;
  void outlines(Search& search, const Seen& left, const Seen& right) const;
  void everything(Search& search, const Seen& left, const Seen& right) const;

  const Canonical& in_;
  const View& view_;
  Mat4 planes_to_grid_;
};

}  // namespace overstrike::oracle
