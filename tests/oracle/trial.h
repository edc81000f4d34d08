#pragma once
// One view of one scene, drawn by core and judged by the oracle: at random points of scan lines,
// and at the ends of runs.
#include <random>
#include <string>
#include <vector>

#include "core/drawing.h"
#include "tests/oracle/crossings.h"
#include "tests/oracle/oracle.h"

namespace overstrike::oracle {

/// Run ends are this near to the true crossing, times its condition number (grid units).
constexpr double kEndError = 1e-9;
/// What is thinner than that, a run of rounding's making, is not seen at all.
constexpr double kThinnest = kEndError;
/// Where light grazes a face, |n.L| below this, the condition number of its shadows (crossings.h)
/// times kEndError is a grid unit and more: lit, shade and shadow are not told apart there.
constexpr double kGrazing = kEndError;
/// Densities of flat faces differ by rounding only.
constexpr double kFlatDensityError = 1e-9;
/// Smooth densities are linear along a run to within this: half a step of 8 bits.
constexpr double kSmoothDensityError = 0.5 / 255;
/// At most this part of the random points may differ and be excused by a true edge nearby.
constexpr double kMaxSkipped = 0.01;

/// Points and run ends judged in each view of each scene; a long test of its own takes more.
#ifdef OVERSTRIKE_ORACLE_LONG
constexpr int kPoints = 600, kEnds = 200;
#else
constexpr int kPoints = 30, kEnds = 5;
#endif

/// A stretch of a scan line: a run, or the gap between two.
struct Stretch {
  double from, to;
  const DensityRun* run;  ///< null: paper
  Seen seen(double s) const;
};

struct ScannedLine {
  Line line;
  double from, to;  ///< where the line lies in the grid
  std::vector<DensityRun> runs;
  /// But for those thinner than kThinnest, which count as part of what is left of them.
  std::vector<Stretch> stretches() const;
};

class Trial {
 public:
  /// Draws rows, lines at odd offsets and lines across.
  Trial(const Scene& scene, const Grid& grid, double tolerance, std::string name);
  /// Failures are reported to GoogleTest.
  void judge(int points, int ends);
  int skipped() const { return skipped_; }

 private:
  /// What is drawn in the numbers of the input: clipping at the near plane numbers what is left.
  /// Of the faces that a body has in one plane the first stands for all then.
  void learn_numbers();
  Index first_in_plane(Index body, const Plane& plane, bool flipped) const;
  DensityRun in_numbers_of_input(DensityRun run) const;
  Seen oracle_at(const Vec2& p) const;
  Kind told_apart(Kind kind, Index face) const;

  void scan(Drawing& drawing, const ScanFamily& family);
  void fail(const std::string& what);
  double uniform(double low, double high);
  const ScannedLine& any_line() { return lines_[bits_() % lines_.size()]; }
  void judge_point();
  void judge_ends(int count);
  void judge_end(const Line& line, const Stretch& left, const Stretch& right);

  Grid grid_;
  std::string name_;
  std::vector<Diagnostic> warnings_;
  View view_;
  Canonical canonical_;
  Oracle oracle_;
  Crossings crossings_;
  std::vector<Index> body_of_drawn_, face_of_drawn_, face_of_input_;
  std::mt19937_64 bits_;
  std::vector<ScannedLine> lines_;
  int skipped_ = 0, failures_ = 0;
};

}  // namespace overstrike::oracle
