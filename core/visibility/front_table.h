#pragma once
// Phase II for scan lines: what of each body faces the eye.
//
// The *front* of a body is the set of its faces that are seen from outside. It is bounded by
// *outline* sides: sides of seen faces whose other side is not seen. Seen faces all turn the same
// way in the grid, so at a level y a point is covered by as many of them as outline sides begin to
// its left less those that end: where one outline side begins the front and one ends it, every
// point between lies under exactly one seen face, and walking from face to face along the level
// finds them in order (NN74, scan). Nothing is asked of the body's shape for that; convex bodies
// have such a front at every level, others at some or none.
//
// A body that has no such front at too many levels, or that is seen from both sides, is *loose*:
// its edges are laid out for an active edge list (loose_edges.h).
#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "core/unset_vector.h"
#include "core/visibility/canonical.h"
#include "core/visibility/depth.h"
#include "core/visibility/view.h"

namespace overstrike {

/// A straight line of the grid that is met by the levels y0 <= y < y1.
struct LevelLine {
  double x0, y0, y1;
  double slope;  ///< dx/dy

  LevelLine() = default;
  /// Precondition: the first point lies above the second, y_top < y_bottom.
  LevelLine(const Vec2& top, const Vec2& bottom)
      : x0(top.x), y0(top.y), y1(bottom.y), slope((bottom.x - top.x) / (bottom.y - top.y)) {}
  /// Evaluated from the end, never accumulated: jumping to a level equals stepping to it.
  double x_at(double y) const { return x0 + (y - y0) * slope; }
};

/// Bound on the error of LevelLine::x_at. A line may be off by `constant` along the levels and by
/// `per_slope` across them; the latter moves its crossing to where it is at a level as far away,
/// but not past its ends. So nearly level lines are as uncertain as they are wide, and no more.
///
/// Levels are looked at a height `beside` them (run_source.h): between lines that meet in a corner
/// on a level lies what the level does not meet. That counts up to kSmallSlack along the level, and
/// what is wider is shown: it is as true as what is seen on its hands.
///
/// The constants are those of the body's farthest point. Where a body passes the eye that is far
/// outside of the grid; a line that is not has a bound of its own, which is asked for where the
/// body's is more than kSmallSlack: what no device and no test tells.
///
/// A line that is nearly level is uncertain by as much as it is wide, which may be the whole
/// picture. Wherever it is met within that shows what a level a hair away shows; what lies beside
/// it is sure and must not be left out for its sake, as what is narrower than two slacks is. So no
/// more than kMostSlack counts.
constexpr double kSmallSlack = 1e-9, kMostSlack = 1e-3;
struct LineError {
  float constant = 0, per_slope = 0, beside = 0;
  /// Of what x^ and y^ round: everywhere. Of what w^ does: for each unit that the line passes the
  /// grid's origin by, as that takes points towards the origin or away from it.
  float everywhere = 0, radial = 0;

  /// Rounds the bounds up.
  LineError() = default;
  LineError(double for_all, double for_slope, double for_height)
      : constant(up(for_all)),
        per_slope(up(for_slope)),
        beside(up(for_height)),
        everywhere(HUGE_VALF) {}
  LineError(double for_all, double for_slope, double for_height, double for_sums, double for_w)
      : constant(up(for_all)),
        per_slope(up(for_slope)),
        beside(up(for_height)),
        everywhere(up(for_sums)),
        radial(up(for_w)) {}

  double of(const LevelLine& line) const {
    const double height = line.y1 - line.y0, error = of(height, line.slope);
    if (error <= kSmallSlack) return error;
    const double s = std::fabs(line.slope);
    const double by_rounding = std::min(own(line), off_by(height, s, per_slope));
    return std::min({by_rounding + std::min(beside * s, kSmallSlack), error, kMostSlack});
  }
  /// By the body's bounds, and more than of(line) where that is more than kSmallSlack.
  double of(double height, double slope) const {
    return off_by(height, std::fabs(slope), static_cast<double>(per_slope) + beside);
  }

 private:
  static float up(double bound) { return static_cast<float>(bound * (1 + 0x1p-20)); }
  double off_by(double height, double steep, double across) const {
    return constant + std::min(across, height) * steep;
  }
  /// To these come the quotients' own rounding and that of x_at, of which this is four times as
  /// much: FrontWalker relies on that.
  double own(const LevelLine& line) const {
    constexpr double kRounding = 24 * 0x1p-52;
    const double s = std::fabs(line.slope);
    const double x = std::fmax(std::fabs(line.x0), std::fabs(line.x_at(line.y1)));
    const double y = std::fmax(std::fabs(line.y0), std::fabs(line.y1));
    return everywhere * (1 + s) + radial * std::fabs(line.x0 - line.slope * line.y0) +
           kRounding * (x + s * y);
  }
};

/// A side of a seen face: it begins at the corner and ends at the next one of its loop.
struct Side {
  Index corner, face;
};

struct OutlineSide {
  LevelLine line;
  double x1;  ///< where it ends, at line.y1
  Side side;
};

/// What a face looks like away from shadows.
struct FaceTone {
  double density;  ///< of a smooth face: the mean of its corners
  Index body;
  Kind kind;
  bool smooth;
};

/// What is thinner than this part of its size may lie in a plane with a face of another body on
/// either side of it: it is looked at as if it were flat.
constexpr double kThinBody = 0x1p-20;

/// A side of a body with few of them, and the seen faces on either hand (kNone: none).
struct SmallSide {
  LevelLine line;
  Index left, right;
};

/// In two lines of cache: what a level asks of every body near it, and what is asked of two that
/// overlap on it.
struct alignas(64) FrontBody {
  double top = 0, bottom = 0;  ///< levels between which something is seen
  LineError line_error;
  /// In FrontTable::outlines, by y0. Of a small body in FrontTable::small_sides, the right chain
  /// after the left one and the sides within after both, up to end_left.
  Index first_left = 0, end_left = 0;
  Index first_right = 0, end_right = 0;
  Index first_manifold = 0, end_manifold = 0;  ///< in FrontTable::manifold
  bool seen : 1 = false;
  bool loose : 1 = false;
  bool small : 1 = false;
  bool triangles : 1 = false;  ///< all its faces are
  /// Its outline is not one chain of sides on the left and one on the right.
  bool broken : 1 = false;
  bool simple : 1 = false;    ///< known not to pass through itself
  bool on_planes : 1 = true;  ///< CanonicalBody::on_planes
  bool far : 1 = false;       ///< some of its points lie beyond kFarAway
  /// A seen face's outline turns the other way than its plane says, as of needles whose vertices'
  /// rounding is as large as they are thick. Looked for where bodies are off their planes, and in
  /// views of outlines.
  bool turned : 1 = false;

  Vec3 low, high;        ///< bounds in the world
  double near_z, far_z;  ///< of the depths of the seen faces
};
static_assert(sizeof(FrontBody) == 128);

/// Levels low <= y < high at which a body's outline begins more than once.
struct ManifoldLevels {
  double low, high;
};

/// A rectangle of the grid, all of it at first; none where x0 > x1.
struct GridWindow {
  double x0 = -HUGE_VAL, x1 = HUGE_VAL, y0 = -HUGE_VAL, y1 = HUGE_VAL;
  bool none() const { return x0 > x1; }
};

/// What a table is for: a picture, with tones and the ground; or outlines and depths alone, as the
/// light's view needs them.
enum class FrontUse : std::uint8_t { picture, outlines };

struct FrontTable;
/// See far_line.h.
LevelLine far_line(const FrontTable& table, const std::array<Index, 2>& ends,
                   const std::array<Index, 2>& faces);

struct FrontTable {
  /// On up to `threads` threads (0: all processors); the same whatever their number.
  FrontTable(const Canonical& canonical, const View& view, FrontUse use, int threads);
  FrontTable(const FrontTable&) = delete;
  FrontTable& operator=(const FrontTable&) = delete;

  const Canonical& canonical;
  View view;
  FrontUse use;
  double columns, rows;
  UnsetVector<Vec2> points;        ///< of the vertices
  std::vector<signed char> sides;  ///< per face: the side it is seen from, 1 its front, -1 its back
                                   ///< (of open bodies), 0 not at all
  UnsetVector<FaceTone> tones;     ///< of the faces that are seen, for a picture
  UnsetVector<FrontBody> bodies;   ///< after the ground the solids; their operands are bodies too
  std::vector<Index> loose;        ///< the bodies that are, but for operands
  std::vector<Index> operands;     ///< the bodies that are operands, matter and are seen, by solid
  std::vector<GridWindow> windows;  ///< per body, where it matters; of none where all do everywhere
  std::vector<OutlineSide> outlines;
  std::vector<SmallSide> small_sides;
  std::vector<ManifoldLevels> manifold;  ///< of bodies that are not loose
  std::vector<Plane> further_planes;     ///< the ground's and the plane at infinity
  DepthMap depths;

  /// The line of the side between two vertices of a body that are not on one level, and the faces
  /// on its two hands (kNone: none). Of a far body only what the levels of the picture meet; it may
  /// be none.
  LevelLine line(const FrontBody& body, Index a, Index b, Index face, Index other) const {
    if (body.far) return far_line(*this, {a, b}, {face, other});
    const Vec2 &p = points[a], &q = points[b];
    return p.y < q.y ? LevelLine(p, q) : LevelLine(q, p);
  }
  bool seen(Index face) const { return face != kNone && sides[face] != 0; }
  bool from_behind(Index face) const { return sides[face] < 0; }
  /// The ground is the face after the canonical ones, and the body after them.
  Index ground() const { return static_cast<Index>(canonical.faces.size()); }
  Index ground_body() const { return static_cast<Index>(canonical.bodies.size()); }
  /// Solids are the bodies after that.
  Index solid_body(Index solid) const { return ground_body() + 1 + solid; }
  Index plane_of(Index face) const {
    return face == ground() ? static_cast<Index>(canonical.planes.size())
                            : canonical.faces[face].plane;
  }
};

/// Twice the area of a face in the grid: positive where its loops run as those of a face do that is
/// seen from its front.
double area_of(const FrontTable& table, Index face);

}  // namespace overstrike
