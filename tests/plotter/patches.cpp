#include "tests/plotter/patches.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/geometry/trig.h"
#include "devices/plotter/plotter.h"

namespace overstrike {
namespace {

/// Scan lines of a family over a grid.
struct Lines {
  ScanFamily family;
  Vec2 along{cos_deg(family.angle_deg), sin_deg(family.angle_deg)};
  Vec2 across{-along.y, along.x};

  double position(std::int64_t i) const { return family.offset + double(i) * family.spacing; }

  /// Where line i crosses the rectangle; empty when first >= second.
  std::pair<double, double> crossing(std::int64_t i, Vec2 low, Vec2 high) const {
    double from = -1e9, to = 1e9;
    for (int axis = 0; axis < 2; ++axis) {
      const double foot = across[axis] * position(i);
      if (std::abs(along[axis]) < 1e-12) {
        if (foot < low[axis] || foot >= high[axis]) return {0, 0};
        continue;
      }
      const double a = (low[axis] - foot) / along[axis], b = (high[axis] - foot) / along[axis];
      from = std::max(from, std::min(a, b));
      to = std::min(to, std::max(a, b));
    }
    return {from, to};
  }
};

std::vector<DensityRun> runs_on(const Lines& lines, std::int64_t i,
                                const std::vector<Patch>& patches) {
  std::vector<DensityRun> runs;
  for (const Patch& patch : patches) {
    const auto [from, to] = lines.crossing(i, patch.low, patch.high);
    if (!(from < to)) continue;
    const auto density = [&](double t) {
      const double x = lines.across.x * lines.position(i) + lines.along.x * t;
      return patch.left +
             (patch.right - patch.left) * (x - patch.low.x) / (patch.high.x - patch.low.x);
    };
    runs.push_back({from, to, density(from), density(to), 0, 0, Kind::lit});
  }
  std::sort(runs.begin(), runs.end(), [](const auto& a, const auto& b) { return a.x0 < b.x0; });
  return runs;
}

void hatch(Device& device, const Layout& layout, std::size_t family,
           const std::vector<Patch>& patches) {
  const Lines lines{layout.hatches[family]};
  const double reach = layout.grid.columns + layout.grid.rows;
  const auto last = static_cast<std::int64_t>(reach / lines.family.spacing) + 1;
  for (std::int64_t i = -last; i <= last; ++i) {
    const std::vector<DensityRun> runs = runs_on(lines, i, patches);
    if (!runs.empty()) device.hatch(family, {i, runs});
  }
}

}  // namespace

std::string plotted(const Settings& settings, const std::vector<Patch>& patches,
                    const std::vector<Stroke>& strokes) {
  std::string bytes;
  const auto device = plotter_kind().make(settings, "-", open_memory(bytes));
  const Layout layout = device->layout();
  device->begin();
  device->strokes(strokes);
  for (std::size_t f = 0; f < layout.hatches.size(); ++f) hatch(*device, layout, f, patches);
  device->end();
  return bytes;
}

}  // namespace overstrike
