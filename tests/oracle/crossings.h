#pragma once
// How well a crossing of a scan line is conditioned: by how much its place along the line moves, in
// grid units, when what crosses there moves by one.
//
//  - An edge's image (of a face, of a shadow on its receiver, of a cut): 1 / |sin| of the angle
//    between the image and the scan line.
//  - A shadow's boundary also 1 / |n.L|: light that grazes the receiver draws the shadow out.
//  - Two planes that cross in depth: (|grad z_a| + |grad z_b|) / |d(z_a - z_b)/ds|, for a depth
//    that is off by one grid unit's worth of slope moves the crossing by that much. To the slopes
//    comes what the last places of the vertices leave open, in units of kEndError.
#include <vector>

#include "core/visibility/canonical.h"
#include "core/visibility/view.h"
#include "tests/oracle/oracle.h"

namespace overstrike::oracle {

/// What a grid position may be off by rounding (grid units).
constexpr double kEndError = 1e-9;
/// What a plane's offset may be off, in parts of the scene's largest coordinate: it comes from
/// vertices that are each rounded three times over, and is a rounded sum of rounded products.
constexpr double kOffsetRounding = 16 * 0x1p-53;

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

  /// True when a point of the grid is so near to where the depths of what is seen are equal, or to
  /// a shadow's border on it, that rounding of `error` grid units, times its condition number
  /// across that border, takes it over.
  bool may_be_off(const Vec2& p, const Seen& one, const Seen& other, double error) const;

  /// True when the point lies on an edge of each of two faces, to within `error` grid units:
  /// whether it is in the one, the other or both is a matter of rounding.
  bool on_both_borders(const Vec2& p, const Seen& one, const Seen& other, double error) const;

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
  bool same_plane(const Seen& one, const Seen& other) const;
  Plane plane_of(const Seen& seen) const;
  void outlines(Search& search, const Seen& left, const Seen& right) const;
  double depth_error(const Plane& plane, const Vec2& p, double error) const;
  double welded_by(const CanonicalFace& face) const;
  bool near_cut(const Vec2& p, Index body) const;
  bool on_border(const Vec2& p, const Seen& seen, double error) const;
  bool near_shadow(const Vec2& p, const Plane& receiver, double error) const;
  bool near_depth(const Vec2& p, const Plane& a, const Plane& b, double error) const;
  void everything(Search& search, const Seen& left, const Seen& right) const;

  const Canonical& in_;
  const View& view_;
  Mat4 planes_to_grid_;
  double offset_error_;  ///< kOffsetRounding of the scene, in the world
};

}  // namespace overstrike::oracle
