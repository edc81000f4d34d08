#include "core/visibility/scan_line.h"

#include <algorithm>
#include <cmath>

namespace overstrike {
namespace {

/// Where f and g have one depth on the line at y; NaN when they are parallel along it.
double crossing_of(const EyeTable& table, Index f, Index g, double y) {
  const DepthPlane& p = table.depths[table.faces[f].plane];
  const DepthPlane& q = table.depths[table.faces[g].plane];
  return -((p.b - q.b) * y + (p.c - q.c)) / (p.a - q.a);
}

}  // namespace

void split_at_crossings(const EyeTable& table, const std::vector<Index>& active, double x0,
                        double x1, double y, double slack0, double slack1,
                        std::vector<SpanPiece>& pieces) {
  double low = x0 + slack0, high = x1 - slack1;
  if (!(low < high)) low = high = x0 + (x1 - x0) / 2;
  const auto nearest_at = [&](double x) {
    Index best = kNone;
    for (const Index f : active)
      if (best == kNone || table.in_front(f, best, x, y)) best = f;
    return best;
  };
  Index seen = nearest_at(low);
  double start = x0;
  // Each turn takes the face that comes through first; depths are linear, so none comes through
  // twice.
  for (std::size_t turns = 0; seen != kNone && turns < active.size() && low < high; ++turns) {
    double first = high;
    Index next = kNone;
    for (const Index f : active) {
      if (f == seen || !table.in_front(f, seen, high, y) || table.compare(f, seen, low, y) > 0)
        continue;
      const double x = std::clamp(crossing_of(table, f, seen, y), low, high);
      if (std::isnan(x)) continue;
      const bool nearer =
          next == kNone || x < first || (x == first && table.in_front(f, next, high, y));
      if (nearer) first = x, next = f;
    }
    if (next == kNone) break;
    if (first > start) pieces.push_back({start, first, seen});
    start = std::max(start, first);
    low = std::max(low, first);
    seen = next;
  }
  if (start < x1) pieces.push_back({start, x1, seen});
}

double density_tolerance_of(double tolerance) { return std::min(tolerance / 100, 1.0 / 1024); }

LineScanner::LineScanner(const EyeTable& table, double density_tolerance)
    : table_(table), density_tolerance_(density_tolerance), active_(table) {}

void LineScanner::resolve(double y, const std::vector<Index>& edges,
                          std::vector<DensityRun>& runs) {
  first_run_ = runs.size();
  passing_.clear();
  for (const Index e : edges) {
    const ScanEdge& edge = table_.edges[e];
    if (edge.y0 <= y && y < edge.y1) passing_.push_back({edge.x_at(y), e});
  }
  std::sort(passing_.begin(), passing_.end(), [](const Passing& a, const Passing& b) {
    return a.x != b.x ? a.x < b.x : a.edge < b.edge;
  });
  double x = 0, slack = 0;
  for (const Passing& p : passing_) {
    const double next = std::min(p.x, table_.columns);
    const double next_slack = table_.edges[p.edge].x_error;
    // A span no wider than its ends are uncertain is of rounding's making, and may lie on the wrong
    // side of an edge in which two faces touch: nothing is asked there, and its neighbour takes it.
    if (next - x > slack + next_slack) {
      span(x, next, y, slack, next_slack, runs);
      // An edge passed before may truly lie right of this one.
      slack = std::max(next_slack, slack - (next - x));
      x = next;
    } else {
      slack = std::max(slack, next_slack);
    }
    if (p.x >= table_.columns) break;
    active_.pass(table_.edges[p.edge]);
  }
  if (x < table_.columns) span(x, table_.columns, y, slack, 0, runs);
  active_.clear();
}

void LineScanner::span(double x0, double x1, double y, double slack0, double slack1,
                       std::vector<DensityRun>& runs) {
  if (active_.faces().empty()) return;
  if (!active_.crossing()) {
    emit(x0, x1, y, active_.seen_at(x0 + (x1 - x0) / 2, y), runs);
    return;
  }
  pieces_.clear();
  split_at_crossings(table_, active_.faces(), x0, x1, y, slack0, slack1, pieces_);
  for (const SpanPiece& piece : pieces_) emit(piece.x0, piece.x1, y, piece.face, runs);
}

void LineScanner::emit(double x0, double x1, double y, Index face, std::vector<DensityRun>& runs) {
  if (face == kNone) return;
  const bool shadowed = active_.shadowed(face);
  if (face == table_.ground && !shadowed) return;
  const EyeFace& f = table_.faces[face];
  DensityRun run{x0, x1, f.in_shadow, f.in_shadow, f.surface, f.body, table_.kind(face, shadowed)};
  if (face == table_.ground) run.surface = run.body = kNoSurface;
  if (f.smooth && !shadowed) {
    run.density0 = f.density_at(x0, y), run.density1 = f.density_at(x1, y);
    emit_bent(run, f, y, 0, runs);
    return;
  }
  if (!shadowed) run.density0 = run.density1 = f.density;
  const bool continues = runs.size() > first_run_ && runs.back().x1 == x0 &&
                         runs.back().surface == run.surface && runs.back().kind == run.kind &&
                         runs.back().density1 == run.density0 &&
                         runs.back().density0 == run.density0;
  if (continues) {
    runs.back().x1 = x1;
  } else {
    runs.push_back(run);
  }
}

/// Halves the run until its middle lies on the chord; a perspective picture of a linear density
/// bends but one way, so that the middle tells.
void LineScanner::emit_bent(DensityRun run, const EyeFace& face, double y, int depth,
                            std::vector<DensityRun>& runs) {
  constexpr int kMostHalvings = 16;
  const double middle = run.x0 + (run.x1 - run.x0) / 2;
  const double density = face.density_at(middle, y);
  const bool straight =
      std::fabs(density - (run.density0 + run.density1) / 2) <= density_tolerance_;
  if (straight || depth == kMostHalvings || !(run.x0 < middle && middle < run.x1)) {
    run.density0 = std::clamp(run.density0, 0.0, 1.0),
    run.density1 = std::clamp(run.density1, 0.0, 1.0);
    runs.push_back(run);
    return;
  }
  DensityRun left = run, right = run;
  left.x1 = right.x0 = middle;
  left.density1 = right.density0 = density;
  emit_bent(left, face, y, depth + 1, runs);
  emit_bent(right, face, y, depth + 1, runs);
}

namespace {

class BandedScanner : public RunScanner {
 public:
  BandedScanner(const EyeTable& table, const Bands& bands, double density_tolerance)
      : bands_(bands), scanner_(table, density_tolerance) {}
  void resolve(double y, std::vector<DensityRun>& runs) override {
    scanner_.resolve(y, bands_.edges(bands_.at(y)), runs);
  }

 private:
  const Bands& bands_;
  LineScanner scanner_;
};

/// Grid units: few edges pass a band that do not matter to its lines, and few pass through many
/// bands.
constexpr double kBandHeight = 8;

}  // namespace

LineSource::LineSource(const EyeTable& table, double density_tolerance)
    : table_(table), density_tolerance_(density_tolerance), bands_(table, kBandHeight) {}

std::unique_ptr<RunScanner> LineSource::scanner() const {
  return std::make_unique<BandedScanner>(table_, bands_, density_tolerance_);
}

}  // namespace overstrike
