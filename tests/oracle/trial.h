#pragma once
// One view of one scene, drawn by core and judged by the oracle: at random points of scan lines,
// at the ends of runs, and where the scene says that it is hard: between and beside the places
// where something crosses a line, and on lines through vertices.
#include <memory>
#include <random>
#include <span>
#include <string>
#include <vector>

#include "core/drawing.h"
#include "tests/oracle/crossings.h"
#include "tests/oracle/oracle.h"

namespace overstrike::oracle {

/// Run ends are within kEndError of the true crossing, times its condition number. What is
/// thinner, a run of rounding's making, is not seen at all.
constexpr double kThinnest = kEndError;
/// Where light grazes a face, |n.L| below this, the condition number of its shadows (crossings.h)
/// times kEndError is a grid unit and more: lit, shade and shadow are not told apart there.
constexpr double kGrazing = kEndError;
/// Densities of flat faces differ by rounding only.
constexpr double kFlatDensityError = 1e-9;
/// Smooth densities are linear along a run to within this: half a step of 8 bits.
constexpr double kSmoothDensityError = 0.5 / 255;
/// Points nearer than this, times its condition number, to a place where something crosses are not
/// judged by themselves: twice what a run's end may be off.
constexpr double kBeside = 2 * kEndError;
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
  double width() const { return to - from; }
  Seen seen(double s) const;
};

struct ScannedLine {
  Line line;
  double from, to;  ///< where the line lies in the grid
  std::vector<DensityRun> runs;
  std::vector<Stretch> stretches() const;
};

/// What is judged of one view, by count.
struct Effort {
  int points = 0;  ///< random points of scan lines
  int ends = 0;    ///< ends of runs
  int gaps = 0;    ///< middles between neighbouring places where something may cross the line
  int beside = 0;  ///< points just outside the conditioned error of such a place
};

class Trial {
 public:
  /// Draws rows, lines at odd offsets and lines across.
  Trial(const Scene& scene, const Grid& grid, double tolerance, std::string name);
  /// Draws the families, and `through_vertices` lines through projected vertices.
  Trial(const Scene& scene, const Grid& grid, double tolerance, std::string name,
        std::span<const ScanFamily> families, int through_vertices);

  /// Failures are reported to GoogleTest.
  void judge(int points, int ends);
  /// Failures are returned, the first few of them.
  const std::vector<std::string>& judge(const Effort& effort);

  int skipped() const { return skipped_; }
  const std::vector<Diagnostic>& warnings() const { return warnings_; }
  const Canonical& canonical() const { return *canonical_; }

 private:
  /// What is drawn in the numbers of the input: clipping at the near plane numbers what is left.
  /// Of the faces that a body has in one plane the first stands for all then.
  void learn_numbers();
  Index first_in_plane(Index body, const Plane& plane, bool flipped) const;
  DensityRun in_numbers_of_input(DensityRun run) const;
  Seen oracle_at(const Vec2& p) const;
  Kind told_apart(Kind kind, Index face) const;

  std::vector<ScanFamily> lines_through_vertices(int count);
  void scan(Drawing& drawing, const ScanFamily& family);
  void fail(const std::string& what);
  double uniform(double low, double high);
  const ScannedLine& any_line() { return lines_[bits_() % lines_.size()]; }
  void judge_point();
  void judge_gap();
  void judge_beside();
  std::vector<Crossings::Place> places(const ScannedLine& scanned);
  void judge_at(const ScannedLine& scanned, double s);
  bool is_right(const Line& line, double s, const Seen& found) const;
  void judge_ends(int count);
  void judge_end(const Line& line, const Stretch& left, const Stretch& right);

  Grid grid_;
  std::string name_;
  std::vector<Diagnostic> warnings_;
  View view_;
  std::shared_ptr<const Canonical> canonical_;
  Oracle oracle_;
  Crossings crossings_;
  std::vector<Index> body_of_drawn_, face_of_drawn_, face_of_input_;
  std::mt19937_64 bits_;
  std::vector<ScannedLine> lines_;
  int skipped_ = 0;
  std::vector<std::string> failures_;
};

}  // namespace overstrike::oracle
