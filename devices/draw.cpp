#include "devices/draw.h"

#include <chrono>

namespace overstrike {
namespace {

/// Adds the time that it lives to a sum of milliseconds.
class Stopwatch {
 public:
  explicit Stopwatch(double& sum_ms) : sum_ms_(sum_ms) {}
  ~Stopwatch() {
    const std::chrono::duration<double, std::milli> spent = Clock::now() - start_;
    sum_ms_ += spent.count();
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  double& sum_ms_;
  Clock::time_point start_ = Clock::now();
};

void draw_strokes(Drawing& drawing, Device& device, double& output_ms) {
  const std::vector<Stroke> strokes = drawing.strokes(StrokeOptions{});
  const Stopwatch watch(output_ms);
  device.strokes(strokes);
}

void draw_hatches(Drawing& drawing, const Layout& layout, Device& device) {
  for (std::size_t family = 0; family < layout.hatches.size(); ++family) {
    drawing.runs(layout.hatches[family], [&](const RunRow& row) { device.hatch(family, row); });
  }
}

}  // namespace

DrawReport draw(const Scene& scene, Device& device, DrawOptions options) {
  const Layout layout = device.layout();
  if (options.tolerance <= 0) options.tolerance = layout.tolerance;
  Drawing drawing(scene, layout.grid, options);
  double output_ms = 0;  // what Drawing cannot see: calls that are no sinks of its own
  {
    const Stopwatch watch(output_ms);
    device.begin();
  }
  if (layout.strokes) draw_strokes(drawing, device, output_ms);
  draw_hatches(drawing, layout, device);
  if (layout.cells) drawing.cells([&](const CellRow& row) { device.cells(row); });
  {
    const Stopwatch watch(output_ms);
    device.end();
  }
  DrawReport report{drawing.timings(), drawing.warnings()};
  report.timings.output_ms += output_ms;
  const std::vector<Diagnostic> said = device.warnings();
  report.warnings.insert(report.warnings.end(), said.begin(), said.end());
  return report;
}

}  // namespace overstrike
