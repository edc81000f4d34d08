#pragma once
// Phase III: painting along scan lines.
//
// Steps, for one line:
//  1. Ground shadows are painted first.
//  2. Bodies whose contour the line meets, between their left and their right chain.
//  3. Of those that overlap on this line the farther is painted before the nearer. In the plane of
//     the line and the eye the bodies are convex and apart, so that their order has no cycle,
//     whatever the picture has.
//  4. A body's faces: from the one along the left chain, across interior edges, to the right chain.
//  5. On each face its shadow polygons.
#include <memory>
#include <vector>

#include "core/visibility/nn74/eye_phase.h"
#include "core/visibility/run_source.h"

namespace overstrike::nn74 {

/// A scan line under the brush. Pieces are sorted and disjoint; later ones cover earlier ones.
class PaintedLine {
 public:
  explicit PaintedLine(const Picture& picture) : picture_(picture) {}

  void clear() { pieces_.clear(); }
  /// face == kNone: the ground's shadow. What lies in the same plane is covered only by what wins
  /// the tie.
  void paint(double x0, double x1, Index face, bool shadowed);
  void append_to(std::vector<DensityRun>& runs) const;

 private:
  struct Piece {
    double x0, x1;
    Index face;
    bool shadowed;
  };
  bool keeps(const Piece& old, Index face) const;
  DensityRun run_of(const Piece& piece) const;

  const Picture& picture_;
  std::vector<Piece> pieces_, painted_;
};

/// Resolves lines of one picture, in any order. One a thread.
class Painter : public RunScanner {
 public:
  /// `bands` holds the bodies that meet each band of kBandHeight.
  Painter(const Picture& picture, const std::vector<std::vector<Index>>& bands);
  void resolve(double y, std::vector<DensityRun>& runs) override;

 private:
  /// A body on the line.
  struct Interval {
    double x0, x1;
    Index body;
  };
  void gather(double y);
  void order();
  void paint_body(const Interval& body, double y);
  void paint_shadows(Index face, double x0, double x1, double y);

  const Picture& picture_;
  const std::vector<std::vector<Index>>& bands_;
  PaintedLine line_;
  std::vector<Interval> on_line_;
  std::vector<Index> far_to_near_;  ///< in on_line_
  std::vector<std::vector<Index>> nearer_;
  std::vector<Index> farther_count_;
};

/// NN74 as a method: phases II and III.
class PaintSource : public RunSource {
 public:
  /// `seen` must outlive this.
  PaintSource(const Canonical& seen, const View& view, const LightPhase& light);
  std::unique_ptr<RunScanner> scanner() const override;

 private:
  Picture picture_;
  std::vector<std::vector<Index>> bands_;
};

}  // namespace overstrike::nn74
