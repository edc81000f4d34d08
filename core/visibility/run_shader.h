#pragma once
// From what is seen on a level to runs of density: tones, shadows, smooth shading.
#include <vector>

#include "core/picture.h"
#include "core/visibility/front_table.h"
#include "core/visibility/receiver_shadows.h"
#include "core/visibility/span_split.h"

namespace overstrike {

/// How far a run's density may bend from a straight line, for a geometric tolerance in grid units:
/// a hundredth of it, and never more than a quarter of an 8-bit step.
double density_tolerance_of(double tolerance);

/// One a thread.
class RunShader {
 public:
  /// `density_tolerance`: a run whose density bends farther than this from a straight line is
  /// split.
  RunShader(const FrontTable& table, const ReceiverShadows& shadows, const FaceOrder& order,
            double density_tolerance)
      : table_(table), shadows_(shadows), order_(order), density_tolerance_(density_tolerance) {}

  /// Appends the runs of one level.
  void shade(double y, const std::vector<SpanPiece>& pieces, std::vector<DensityRun>& runs);

 private:
  /// Density over the grid: (q . (x, y, 1)) / (w . (x, y, 1)), which stays between those of the
  /// corners. (A triangle seen nearly edge-on has a gradient of few digits.)
  struct Gradient {
    Vec3 q, w;
    double least, most;
    double at(double x, double y) const {
      const double density = (q.x * x + q.y * y + q.z) / (w.x * x + w.y * y + w.z);
      return density >= least ? (density <= most ? density : most) : least;
    }
  };
  void shaded(double y, const SpanPiece& piece, const ReceiverShadow& shadow,
              std::vector<DensityRun>& runs);
  void part(double y, const SpanPiece& piece, bool shadowed, std::vector<DensityRun>& runs);
  /// Away from shadows.
  void toned(double y, const SpanPiece& piece, std::vector<DensityRun>& runs);
  void smooth(double y, const SpanPiece& piece, std::vector<DensityRun>& runs);
  void bent(DensityRun run, const Gradient& gradient, double y, int depth,
            std::vector<DensityRun>& runs) const;
  bool gradient_of(Index face, Index corner, Gradient& out) const;

  const FrontTable& table_;
  const ReceiverShadows& shadows_;
  const FaceOrder& order_;
  double density_tolerance_;
  Index spans_of_ = kNone;  ///< the face whose shadow spans are in spans_
  ShadowCaster::Scratch scratch_;
  ReceiverShadow::Scratch solids_;
  std::vector<ShadowSpan> spans_, ground_spans_;
  bool ground_spans_known_ = false;  ///< of the present level
  std::vector<double> ribs_;
};

}  // namespace overstrike
