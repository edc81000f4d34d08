#include "devices/plotter/hatching.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/geometry/trig.h"

namespace overstrike {
namespace {

/// Rounding moves a line by at most half a unit (HatchLine): two neighbours part by at most this.
constexpr double kRoundingSlack = 1;
/// Parts closer than a plotter unit, the least that the plotter can draw, touch.
constexpr double kTouching = 1;

/// Where level `level` begins; level 0 and the levels' end reach on without limit.
double border(const Hatching& hatching, int level) {
  if (level <= 0) return -std::numeric_limits<double>::infinity();
  if (level >= hatching.levels) return std::numeric_limits<double>::infinity();
  return (level - 0.5) / (hatching.levels - 1);
}

/// Where the run's density reaches `d`, which lies between the densities of its ends.
double crossing(const DensityRun& run, double d) {
  const double t = (d - run.density0) / (run.density1 - run.density0);
  return run.x0 + t * (run.x1 - run.x0);
}

/// The part of the run whose density lies in [low, high); empty (x0 >= x1) when none does.
HatchPiece part_in_band(const DensityRun& run, double low, double high) {
  const double darkest = std::max(run.density0, run.density1);
  const double lightest = std::min(run.density0, run.density1);
  if (darkest < low || lightest >= high) return {run.x0, run.x0};
  const bool rising = run.density1 > run.density0;
  HatchPiece part{run.x0, run.x1};
  if (lightest < low) (rising ? part.x0 : part.x1) = crossing(run, low);
  if (darkest >= high) (rising ? part.x1 : part.x0) = crossing(run, high);
  return part;
}

}  // namespace

double level_density(const Hatching& hatching, int level) {
  return static_cast<double>(level) / (hatching.levels - 1);
}

int nearest_level(const Hatching& hatching, double density) {
  int level = 0;
  while (level + 1 < hatching.levels && density >= border(hatching, level + 1)) ++level;
  return level;
}

ScanFamily hatch_family(const Hatching& hatching, int level) {
  assert(level >= 1 && level < hatching.levels);
  const double even = hatching.pen_width / level_density(hatching, level);
  const double spacing = level == hatching.levels - 1 ? std::max(even - kRoundingSlack, 1.0) : even;
  return {hatching.angle_deg, spacing, spacing / 2};
}

HatchLine::HatchLine(const ScanFamily& family, std::int64_t index)
    : along_(cos_deg(family.angle_deg), sin_deg(family.angle_deg)),
      foot_(Vec2{-along_.y, along_.x} * (family.offset + double(index) * family.spacing)) {}

Vec2 HatchLine::nearest_unit(double x) const {
  const Vec2 p = glm::floor(foot_ + along_ * x + 0.5);
  if (std::abs(along_.x) >= std::abs(along_.y)) {
    const double y = foot_.y + (p.x - foot_.x) * (along_.y / along_.x);
    return {p.x, std::floor(y + 0.5)};
  }
  const double across = foot_.x + (p.y - foot_.y) * (along_.x / along_.y);
  return {std::floor(across + 0.5), p.y};
}

void hatch_pieces(const Hatching& hatching, int level, std::span<const DensityRun> runs,
                  std::vector<HatchPiece>& pieces) {
  pieces.clear();
  const double low = border(hatching, level), high = border(hatching, level + 1);
  for (const DensityRun& run : runs) {
    const HatchPiece part = part_in_band(run, low, high);
    if (!(part.x0 < part.x1)) continue;
    if (!pieces.empty() && part.x0 - pieces.back().x1 < kTouching) {
      pieces.back().x1 = part.x1;
    } else {
      pieces.push_back(part);
    }
  }
  std::erase_if(pieces, [&](const HatchPiece& p) { return !(p.x1 - p.x0 > hatching.pen_width); });
  for (HatchPiece& p : pieces) {
    p.x0 += hatching.pen_width / 2;
    p.x1 -= hatching.pen_width / 2;
  }
}

}  // namespace overstrike
