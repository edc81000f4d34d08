#pragma once
// Core's one door: a scene prepared for one grid, asked for cells, runs and strokes.
#include <functional>
#include <memory>
#include <vector>

#include "core/error.h"
#include "core/picture.h"
#include "core/scene/scene.h"
#include "core/visibility/solid_options.h"

namespace overstrike {

struct Canonical;
struct View;

enum class Method : std::uint8_t { automatic, line, nn74 };

struct StrokeOptions {
  bool contours = true;
  bool creases = true;
  bool intersections = true;
  bool shadow_outlines = true;
  bool patterns = true;
  bool segments = true;
};

struct DrawOptions {
  Method method = Method::automatic;
  double tolerance =
      0.05;  ///< grid units; the promise of DESIGN: chords, area averages, stroke simplification
  int threads = 0;                       ///< 0: all processors
  double margin = 0.02;                  ///< of a fitted window
  Coherence coherence = Coherence::all;  ///< of Boolean solids
  /// Called now and then with 0..1 of the present work, always from one thread.
  std::function<void(double)> progress;
};

/// NN74's phases: I light, II eye, III scan; and output, which the caller adds. Milliseconds.
struct Timings {
  double light_ms = 0, eye_ms = 0, scan_ms = 0, output_ms = 0;
  SolidCounts solids;
};

class Drawing {
 public:
  /// Phases I and II. Throws InputError when the method cannot draw the scene.
  Drawing(const Scene& scene, const Grid& grid, const DrawOptions& options);
  /// The same from the canonical input of a view, which is shared and not copied; by the line
  /// resolver, whatever options.method says.
  Drawing(std::shared_ptr<const Canonical> canonical, const View& view, const DrawOptions& options);
  ~Drawing();
  Drawing(Drawing&&) noexcept;

  /// Every row of the grid in order, top to bottom; the sink runs on one thread at a time and may
  /// throw.
  void cells(const std::function<void(const CellRow&)>& sink);
  /// Every line of the family that meets the grid, in order of index, clipped to the grid.
  void runs(const ScanFamily& family, const std::function<void(const RunRow&)>& sink);
  std::vector<Stroke> strokes(const StrokeOptions& options);

  const std::vector<Diagnostic>& warnings() const;
  /// Sinks' own time is counted as output, not as scan.
  const Timings& timings() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace overstrike
