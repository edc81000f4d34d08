#pragma once
// Scan lines: the line resolver for lines y = const (TK ch. 3 and 4), fed by an active edge list.
#include <vector>

#include "core/visibility/active_faces.h"
#include "core/visibility/bands.h"
#include "core/visibility/eye_table.h"
#include "core/visibility/run_source.h"

namespace overstrike {

/// The part [x0, x1) of a scan line over which `face` is seen (kNone: paper).
struct SpanPiece {
  double x0, x1;
  Index face;
};

/// Splits the span [x0, x1) at the exact crossings of the active faces, nearest first (TK 4.2.2),
/// and appends the pieces. `slack0`, `slack1` bound the errors of the ends: what differs only
/// within them is no crossing (edges that touch a face end on it to within rounding).
void split_at_crossings(const EyeTable& table, const std::vector<Index>& active, double x0,
                        double x1, double y, double slack0, double slack1,
                        std::vector<SpanPiece>& pieces);

/// How far a run's density may bend from a straight line, for a geometric tolerance in grid units:
/// a hundredth of it, and never more than a quarter of an 8-bit step.
double density_tolerance_of(double tolerance);

/// Resolves lines of one picture, in any order; lines in increasing order are cheap. One a thread.
class LineScanner {
 public:
  /// `density_tolerance`: a run whose density bends farther than this from a straight line is
  /// split.
  LineScanner(const EyeTable& table, double density_tolerance);

  /// The runs on the line at y, in [0, columns). `edges` holds at least the numbers of the edges
  /// active at y, in any order.
  void resolve(double y, const std::vector<Index>& edges, std::vector<DensityRun>& runs);

 private:
  struct Passing {
    double x;
    Index edge;
  };
  void span(double x0, double x1, double y, double slack0, double slack1,
            std::vector<DensityRun>& runs);
  void emit(double x0, double x1, double y, Index face, std::vector<DensityRun>& runs);
  void emit_bent(DensityRun run, const EyeFace& face, double y, int depth,
                 std::vector<DensityRun>& runs);

  const EyeTable& table_;
  double density_tolerance_;
  std::size_t first_run_ = 0;  ///< of the present line; runs before it are other lines'
  ActiveFaces active_;
  std::vector<Passing> passing_;
  std::vector<SpanPiece> pieces_;
};

/// The line resolver as a method.
class LineSource : public RunSource {
 public:
  /// `table` must outlive this.
  LineSource(const EyeTable& table, double density_tolerance);
  std::unique_ptr<RunScanner> scanner() const override;

 private:
  const EyeTable& table_;
  double density_tolerance_;
  Bands bands_;
};

}  // namespace overstrike
